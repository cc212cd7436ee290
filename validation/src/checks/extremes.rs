//! Stiff and extreme.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "extremes",
        title: "Stiff and extreme",
        about: "Finite and right, or a typed error.",
        checks: Vec::new(),
    }
}
