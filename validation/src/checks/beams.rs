//! Beams.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "beams",
        title: "Beams",
        about: "Modes, statics, waves and breaking of bonded particles.",
        checks: Vec::new(),
    }
}
