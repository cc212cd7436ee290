//! Stiff and extreme.

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
        title: "Stiff and extreme",
        about: "Stiffness, sizes, overlaps, speeds, places and magnitudes at the ends of their ranges: what comes out is \
                finite and right, or a typed error.",
        checks: [stiff::checks(), limits::checks(), random::checks()]
            .into_iter()
            .flatten()
            .collect(),
    }
}
