//! Laws and symmetries.

mod cluster;
mod driving;
mod energy;
mod inertia;
mod rounding;
mod symmetry;
mod thresholds;

use crate::checks::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "laws",
        title: "Laws and symmetries",
        about: "Forces are minus the gradients of stored energies, dissipation is never negative, and nothing depends on the observer or on the units.",
        checks: [
            driving::checks(),
            energy::checks(),
            inertia::checks(),
            rounding::checks(),
            symmetry::checks(),
            thresholds::checks(),
        ]
        .into_iter()
        .flatten()
        .collect(),
    }
}
