//! Identities of geometry.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "identities",
        title: "Identities of geometry",
        about: "Overlap factor, focal point, frames, images and moments: what must hold for every pair, to rounding.",
        checks: Vec::new(),
    }
}
