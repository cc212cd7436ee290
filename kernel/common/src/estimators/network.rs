//! The network of contacts and bonds that a model passes to estimators.

use crate::geometry::Vec2;
use crate::pair::Pair;

/// A contact or bond of any model, as estimators read it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NetworkContact {
    /// The two particles i and j.
    pub pair: Pair,
    /// Branch vector from the centre of i to that of j, in m.
    pub branch: Vec2,
    /// Force of j on i, in N.
    pub force: Vec2,
}

/// All contacts and bonds of a state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactNetwork {
    /// Number of particles.
    pub particles: usize,
    /// Contacts and bonds, in a fixed order.
    pub contacts: Vec<NetworkContact>,
}

impl ContactNetwork {
    /// Mean number of contacts and bonds per particle; zero without particles.
    ///
    /// Each contact or bond counts once for each of its two particles.
    pub fn coordination_number(&self) -> f64 {
        2.0 * self.contacts.len() as f64 / self.particles.max(1) as f64
    }
}
