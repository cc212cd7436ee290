//! Laws and symmetries.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "laws",
        title: "Laws and symmetries",
        about: "Forces are minus the slopes of stored energies, dissipation is never negative, and nothing depends on the observer.",
        checks: Vec::new(),
    }
}
