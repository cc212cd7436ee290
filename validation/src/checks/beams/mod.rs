//! Beams.

mod breaking;
mod cantilever;
mod chain;
mod modes;

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "beams",
        title: "Beams",
        about: "Modes, statics, waves and breaking of bonded particles.",
        checks: [
            modes::checks(),
            cantilever::checks(),
            chain::checks(),
            breaking::checks(),
        ]
        .into_iter()
        .flatten()
        .collect(),
    }
}

/// Laws of the thesis's beams without damping: 1e7 kg/s^2 along and across.
const BEAM: &str = "[bond.normal]\nstiffness = 1e7\ndamping = 0.0\n\
    [bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = 1e7\ndamping = 0.0\n";
const STIFFNESS: f64 = 1e7;
