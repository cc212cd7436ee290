//! Pay for use.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "economy",
        title: "Pay for use",
        about: "What a scene does not name costs nothing: absent and zero give the same bits.",
        checks: Vec::new(),
    }
}
