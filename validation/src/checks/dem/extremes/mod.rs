//! Stiff systems and extreme values.

mod cases;
mod limits;
mod pairs;
mod random;
mod stiff;

use crate::checks::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "extremes",
        title: "Stiff systems and extreme values",
        about: "Extreme stiffnesses, sizes, overlaps, speeds, positions and magnitudes: the result is finite and correct, or a typed error.",
        checks: [stiff::checks(), limits::checks(), random::checks()]
            .into_iter()
            .flatten()
            .collect(),
    }
}
