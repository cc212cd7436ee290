//! Stability limits of the time step.

mod amplification;
mod block;
mod bracket;
mod estimate;
mod growth;
mod map;
mod modes;
pub(super) mod network;
mod packing;
mod running;
mod waves;

use crate::checks::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "time-step",
        title: "Stability of the time step",
        about: "The stability limit of each integrator: from theory and from runs, for pairs and for whole packings.",
        checks: [
            amplification::checks(),
            bracket::checks(),
            packing::checks(),
            estimate::checks(),
            growth::checks(),
            map::checks(),
            waves::checks(),
        ]
        .into_iter()
        .flatten()
        .collect(),
    }
}
