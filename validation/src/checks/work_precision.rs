//! Error against run time.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "work-precision",
        title: "Error against run time",
        about: "What accuracy costs, for each integrator and number type.",
        checks: Vec::new(),
    }
}
