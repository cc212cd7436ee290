//! Which nodes may touch, and how.

use crate::bonds::Bonds;
use crate::contact_law::ContactLaw;
use crate::error::{SetupError, require};
use crate::grain::{GrainRow, Grains};
use crate::mesh::smallest_distance;
use gouge_common::geometry::{Domain, Open, Vec2};
use gouge_common::neighbors::{Neighbors, SearchSpheres};
use gouge_common::pair::Pair;

/// Smallest ratio of the contact radius to the node spacing at which grains cannot pass through each other.
pub const SMALLEST_RADIUS_RATIO: f64 = 1.2;

/// Contact between nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// Repulsion, damping and friction.
    pub law: ContactLaw,
    /// Stiffness in N/m^6 between nodes of different grains, by the materials of both: a symmetric matrix.
    pub stiffness: Vec<Vec<f64>>,
    /// Whether the sticking force of a node is shared among its contacts, so that many of them do not reverse its motion.
    pub shares_sticking: bool,
}

impl Contact {
    /// Check the coefficients for grains.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a coefficient outside its range, also of a material that the matrix does not have.
    pub fn validate(&self, grains: &Grains) -> Result<(), SetupError> {
        self.law.validate()?;
        for grain in &grains.rows {
            for other in &grains.rows {
                let row = self.stiffness.get(grain.material);
                let stiffness = row.and_then(|row| row.get(other.material));
                let stiffness = stiffness.copied().unwrap_or(f64::NAN);
                require("contact stiffness", stiffness, "positive", stiffness > 0.0)?;
            }
        }
        Ok(())
    }

    /// Refuse a contact radius through which the nodes of a grain let others pass.
    ///
    /// # Errors
    /// [`SetupError::ContactRadius`] if the radius is below [`SMALLEST_RADIUS_RATIO`] times the smallest distance of two
    /// nodes of any of the grains.
    pub fn check_radius(&self, grains: &Grains) -> Result<(), SetupError> {
        let distance = |row: &GrainRow| smallest_distance(&grains.position[row.nodes.clone()]);
        let smallest = grains.rows.iter().filter_map(distance);
        let smallest = smallest.fold(0.0, f64::max);
        let radius = self.law.radius;
        if radius < SMALLEST_RADIUS_RATIO * smallest {
            return Err(SetupError::ContactRadius { radius, smallest });
        }
        Ok(())
    }
}

/// Pairs of nodes that may touch before the list is built again: nodes of different grains, and nodes of one grain without
/// a bond.
#[derive(Clone, Debug)]
pub(crate) struct Candidates {
    neighbors: Neighbors<f64>,
    radii: Vec<f64>,
    positions: Vec<Vec2>,
    /// Sorted by second node, then by first.
    pub(crate) pairs: Vec<Pair>,
}

impl Candidates {
    pub(crate) fn new(grains: &Grains, radius: f64) -> Self {
        let radii = vec![0.5 * radius; grains.nodes()];
        let spheres = SearchSpheres {
            positions: &grains.position,
            radii: &radii,
        };
        Self {
            neighbors: Neighbors::new(spheres, &OPEN),
            radii,
            positions: Vec::new(),
            pairs: Vec::new(),
        }
    }

    /// Bring the list up to date for present positions, after `broken` bonds have left `bonds`.
    pub(crate) fn update(
        &mut self,
        grains: &Grains,
        bonds: &Bonds,
        positions: impl Iterator<Item = Vec2>,
        broken: &[Pair],
    ) {
        self.positions.clear();
        self.positions.extend(positions);
        if self.neighbors.is_stale(Open, &self.positions) {
            self.rebuild(grains, bonds);
        } else if !broken.is_empty() {
            let may_touch = |pair: &Pair| {
                let (i, j) = pair.indices();
                grains.of(i).touches_itself && self.is_near(i, j)
            };
            let near: Vec<_> = broken.iter().copied().filter(may_touch).collect();
            self.pairs.extend(near);
            self.pairs.sort_unstable();
        }
    }

    /// Whether two nodes may touch before the list is built again. Until then a node may move by the skin: from one side of
    /// the place where the list was built to the other.
    fn is_near(&self, i: usize, j: usize) -> bool {
        let distance = (self.positions[j] - self.positions[i]).norm();
        distance <= self.radii[i] + self.radii[j] + 2.0 * self.neighbors.skin()
    }

    fn rebuild(&mut self, grains: &Grains, bonds: &Bonds) {
        let spheres = SearchSpheres {
            positions: &self.positions,
            radii: &self.radii,
        };
        let may_touch = |i: usize, j: usize| {
            grains.grain_of[i] != grains.grain_of[j] || grains.of(i).touches_itself
        };
        self.neighbors
            .rebuild(Open, spheres, may_touch, &mut self.pairs);
        let is_free = |pair: &Pair| {
            let (i, j) = pair.indices();
            grains.grain_of[i] != grains.grain_of[j] || !bonds.are_bonded(*pair)
        };
        self.pairs.retain(is_free);
    }
}

/// Grains move in the open plane; walls are not the edge of a box.
const OPEN: Domain = Domain {
    width: None,
    height: None,
    periodic: false,
};
