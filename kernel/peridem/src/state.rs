//! What a step changes and a checkpoint saves.

use crate::bond_law::Elongation;
use crate::bonds::Bonds;
use crate::grain::Grains;
use gouge_common::geometry::Vec2;

/// Where a node is: in one cache line with what bonds need of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// Reference position in m.
    pub reference: Vec2,
    /// Displacement in m.
    pub displacement: Vec2,
}

impl Place {
    /// Present position in m.
    #[inline(always)]
    pub fn position(self) -> Vec2 {
        self.reference + self.displacement
    }

    /// Vector in m from one present position to another, from the differences of references and displacements, so that
    /// it has no larger rounding error than the displacements themselves.
    #[inline(always)]
    pub fn to(self, other: Self) -> Vec2 {
        (other.reference - self.reference) + (other.displacement - self.displacement)
    }

    /// Elongation of the bond to another node, of reference length in m.
    #[inline(always)]
    pub fn elongation_to(self, other: Self, length: f64) -> Elongation {
        let reference = other.reference - self.reference;
        Elongation::new(reference, other.displacement - self.displacement, length)
    }
}

/// Work and losses since the beginning, in J per metre of depth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// Work of walls on the grains: of their elastic forces, which is negative while walls are approached, and of damping and
    /// friction on the motion of the walls.
    pub walls: f64,
    /// Energy that damping has taken; positive.
    pub damping: f64,
    /// Energy that friction has taken; positive.
    pub friction: f64,
    /// Energy of bonds at the moment when they broke; positive.
    pub broken: f64,
}

/// Displacement in m of a node in a time step in s of velocity Verlet, from its velocity in m/s and its acceleration in
/// m/s^2 at the beginning.
#[inline(always)]
pub(crate) fn moved(velocity: Vec2, acceleration: Vec2, step: f64) -> Vec2 {
    velocity * step + acceleration * (0.5 * step * step)
}

/// Everything that changes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Where nodes are.
    pub places: Vec<Place>,
    /// Velocities in m/s.
    pub velocity: Vec<Vec2>,
    /// Accelerations in m/s^2.
    pub acceleration: Vec<Vec2>,
    /// Bonds that have not broken.
    pub bonds: Bonds,
    /// Positions in m of the left, right, top and bottom wall; infinite without walls.
    pub walls: [f64; 4],
    /// Number of steps.
    pub steps: u64,
    /// Work since the beginning.
    pub work: Work,
}

impl State {
    /// Grains at rest in their reference positions, without walls.
    pub fn at_rest(grains: &Grains, bonds: Bonds) -> Self {
        let place = |&reference: &Vec2| Place {
            reference,
            displacement: Vec2::zero(),
        };
        let nodes = grains.nodes();
        Self {
            places: grains.position.iter().map(place).collect(),
            velocity: vec![Vec2::zero(); nodes],
            acceleration: vec![Vec2::zero(); nodes],
            bonds,
            walls: [
                f64::NEG_INFINITY,
                f64::INFINITY,
                f64::INFINITY,
                f64::NEG_INFINITY,
            ],
            steps: 0,
            work: Work::default(),
        }
    }
}
