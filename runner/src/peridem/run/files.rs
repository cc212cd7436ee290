//! The outputs that grow with every sample.

use super::super::Scene;
use super::samples::columns;
use crate::error::Error;
use crate::run::context::RunContext;
use crate::run::folder::BREAKS;
use crate::run::growing::{GrowingFiles, GrowthPlan};
use crate::run::trajectory::FramePlan;
use gouge_peridem::world::World;

/// Columns of the file of broken bonds: nodes are counted from the first of the grain.
const BREAK_COLUMNS: [&str; 5] = ["step", "time", "grain", "i", "j"];

/// Begin the outputs, or continue them after a number of bytes.
///
/// # Errors
/// Failures of the file system.
pub fn open(
    scene: &Scene,
    context: &RunContext,
    world: &World,
    bytes: Option<[u64; 2]>,
) -> Result<GrowingFiles, Error> {
    let plan = GrowthPlan {
        columns: &columns(scene),
        table: Some((BREAKS, &BREAK_COLUMNS)),
        frames: FramePlan {
            trajectory: scene.output.trajectory,
            has_links: false,
        },
        schedule: scene.schedule(),
        bodies: world.grains().nodes(),
    };
    GrowingFiles::open(context, &plan, bytes)
}
