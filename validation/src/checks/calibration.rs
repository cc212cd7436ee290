//! The calibration chain.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "calibration",
        title: "The calibration chain",
        about: "Equations (87)-(97) recomputed with their uncertainties, and what the printed parameters really give.",
        checks: Vec::new(),
    }
}
