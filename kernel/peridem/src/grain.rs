//! Grains: what a run does not change.

use crate::bond_law::BreakingRule;
use crate::error::{SetupError, require};
use crate::material::BondConstants;
use core::ops::Range;
use gouge_common::geometry::Vec2;

/// A grain: a cloud of nodes of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Grain {
    /// Reference positions of its nodes in m.
    pub position: Vec<Vec2>,
    /// Areas of its nodes in m^2.
    pub area: Vec<f64>,
    /// Density in kg/m^3.
    pub density: f64,
    /// Stiffness and critical stretch of its bonds.
    pub constants: BondConstants,
    /// Which of its bonds break; none if the grain stays whole.
    pub breaking: Option<BreakingRule>,
    /// Whether nodes without a bond repel each other, section 4.4 of peridem.
    pub touches_itself: bool,
    /// Stiffness c in N/m^6 of self contact: that of bonds of the constant weight, whatever the weight of the bonds.
    pub contact_stiffness: f64,
    /// Number of its material, which selects the stiffness of contacts.
    pub material: usize,
    /// Nodes that never move, counted from the first of the grain.
    pub clamped: Vec<usize>,
    /// Force density in N/m^3 on each node besides gravity; empty if there is none.
    pub load: Vec<Vec2>,
}

/// What all nodes of a grain share.
#[derive(Clone, Debug, PartialEq)]
pub struct GrainRow {
    /// Its nodes.
    pub nodes: Range<usize>,
    /// Density in kg/m^3.
    pub density: f64,
    /// Stiffness and critical stretch of its bonds.
    pub constants: BondConstants,
    /// Which of its bonds break; none if the grain stays whole.
    pub breaking: Option<BreakingRule>,
    /// Whether nodes without a bond repel each other, section 4.4 of peridem.
    pub touches_itself: bool,
    /// Stiffness c in N/m^6 of self contact: that of bonds of the constant weight, whatever the weight of the bonds.
    pub contact_stiffness: f64,
    /// Number of its material.
    pub material: usize,
}

/// All grains, and the columns of their nodes, one grain after the other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Grains {
    /// The grains.
    pub rows: Vec<GrainRow>,
    /// Grain of each node.
    pub grain_of: Vec<u32>,
    /// Reference positions in m.
    pub position: Vec<Vec2>,
    /// Areas in m^2.
    pub area: Vec<f64>,
    /// Nodes that never move, in ascending order.
    pub clamped: Vec<u32>,
    /// Force density in N/m^3 on each node besides gravity; empty if no grain has one.
    pub load: Vec<Vec2>,
}

impl Grains {
    /// Put grains together.
    ///
    /// # Errors
    /// [`SetupError`] for a grain without nodes, columns of different lengths, areas that are not positive, positions
    /// that are not finite, nodes that do not exist, and more nodes than indices.
    pub fn new(grains: &[Grain]) -> Result<Self, SetupError> {
        let nodes = grains.iter().map(|grain| grain.position.len()).sum();
        if u32::try_from(nodes).is_err() {
            return Err(SetupError::TooManyNodes { nodes });
        }
        let mut all = Self::default();
        let is_loaded = grains.iter().any(|grain| !grain.load.is_empty());
        for (index, grain) in grains.iter().enumerate() {
            grain.validate(index)?;
            let first = all.position.len();
            all.rows.push(GrainRow {
                nodes: first..first + grain.position.len(),
                density: grain.density,
                constants: grain.constants,
                breaking: grain.breaking,
                touches_itself: grain.touches_itself,
                contact_stiffness: grain.contact_stiffness,
                material: grain.material,
            });
            all.position.extend(&grain.position);
            all.area.extend(&grain.area);
            all.grain_of.resize(all.position.len(), index as u32);
            all.clamped
                .extend(grain.clamped.iter().map(|node| (first + node) as u32));
            all.clamped.sort_unstable();
            all.clamped.dedup();
            all.load.extend(&grain.load);
            if is_loaded {
                all.load.resize(all.position.len(), Vec2::zero());
            }
        }
        Ok(all)
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.position.len()
    }

    /// What the grain of a node shares.
    pub fn of(&self, node: usize) -> &GrainRow {
        &self.rows[self.grain_of[node] as usize]
    }

    /// Mass of a node in kg per metre of depth: density times area.
    pub fn mass(&self, node: usize) -> f64 {
        self.of(node).density * self.area[node]
    }
}

impl Grain {
    fn validate(&self, grain: usize) -> Result<(), SetupError> {
        let nodes = self.position.len();
        if nodes == 0 {
            return Err(SetupError::NoNodes { grain });
        }
        let lengths = [
            ("area", self.area.len()),
            (
                "load",
                if self.load.is_empty() {
                    nodes
                } else {
                    self.load.len()
                },
            ),
        ];
        for (column, length) in lengths {
            if length != nodes {
                return Err(SetupError::Length {
                    grain,
                    column,
                    length,
                    nodes,
                });
            }
        }
        if let Some(&node) = self.clamped.iter().find(|&&node| node >= nodes) {
            return Err(SetupError::MissingNode { grain, node, nodes });
        }
        require("density", self.density, "positive", self.density > 0.0)?;
        for (&area, position) in self.area.iter().zip(&self.position) {
            require("area", area, "positive", area > 0.0)?;
            require("x", position.x, "finite", true)?;
            require("y", position.y, "finite", true)?;
        }
        Ok(())
    }
}
