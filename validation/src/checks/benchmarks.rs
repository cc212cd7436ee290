//! Community benchmarks.

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "benchmarks",
        title: "Community benchmarks",
        about: "Chung and Ooi 1-8 and MFiX DEM01-06 in planar form, whole curves.",
        checks: Vec::new(),
    }
}
