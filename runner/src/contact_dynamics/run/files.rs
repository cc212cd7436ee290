//! The outputs that grow with every sample.

use super::super::Scene;
use super::samples::columns;
use super::statistics::Statistics;
use crate::error::Error;
use crate::run::context::RunContext;
use crate::run::folder::NETWORK;
use crate::run::growing::{GrowingFiles, GrowthPlan};
use crate::run::trajectory::FramePlan;

/// Begin the outputs, or continue them after a number of bytes.
///
/// # Errors
/// Failures of the file system.
pub fn open(
    scene: &Scene,
    context: &RunContext,
    bytes: Option<[u64; 2]>,
) -> Result<GrowingFiles, Error> {
    let names = Statistics::names();
    let names: Vec<&str> = ["time"]
        .into_iter()
        .chain(names.iter().map(String::as_str))
        .collect();
    let plan = GrowthPlan {
        columns: &columns(scene),
        table: scene.measures_network().then_some((NETWORK, &names)),
        frames: FramePlan {
            trajectory: scene.output.trajectory,
            has_links: false,
        },
        schedule: scene.schedule(),
        bodies: scene.number_of_bodies(),
    };
    GrowingFiles::open(context, &plan, bytes)
}
