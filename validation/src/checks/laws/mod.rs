//! Laws and symmetries.

mod cluster;
mod energy;
mod rounding;
mod symmetry;

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "laws",
        title: "Laws and symmetries",
        about: "Forces are minus the slopes of stored energies, dissipation is never negative, and nothing depends on the observer or on the units.",
        checks: [energy::checks(), rounding::checks(), symmetry::checks()]
            .into_iter()
            .flatten()
            .collect(),
    }
}
