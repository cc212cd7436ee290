//! Two particles.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "pairs",
        title: "Two particles",
        about: "Collisions against closed forms and independent integration.",
        checks: Vec::new(),
    }
}
