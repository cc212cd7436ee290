//! Estimators.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "estimators",
        title: "Estimators",
        about: "What is read off a state, against states whose answer is known.",
        checks: Vec::new(),
    }
}
