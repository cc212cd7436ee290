//! Emergent strength.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "strength",
        title: "Emergent strength",
        about: "The distribution of link strengths, and the Weibull distribution that it is said to match.",
        checks: Vec::new(),
    }
}
