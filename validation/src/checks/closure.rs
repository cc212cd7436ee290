//! Closure.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "closure",
        title: "Closure",
        about: "The energy balance (72), momentum and angular momentum.",
        checks: Vec::new(),
    }
}
