//! Running a scene of contact dynamics.

mod begin;
mod checkpoint;
mod contacts;
mod directions;
mod files;
mod frame;
mod page;
mod picture;
mod shown;
mod samples;
mod scene_run;
mod since;
mod stability;
mod statistics;

pub(crate) use checkpoint::is_saved;
pub use contacts::contacts;
pub use samples::columns as series_columns;
pub use shown::shown;
pub use stability::stability;
pub use statistics::Statistics;

use super::Scene;
use crate::error::Error;
use crate::run::existing::{Beginning, prepared, with_interval_of_earlier_run};
use crate::run::{Observer, RunOptions, Summary};
use checkpoint::Checkpoint;
use scene_run::SceneRun;
use std::path::Path;

/// Run a scene, write its outputs into a folder, report what happens to an observer, and return the summary.
///
/// # Errors
/// A folder that cannot be written, that another run is using, or that holds results which the run would replace; a
/// damaged checkpoint; a state that becomes invalid; an interruption. What was written before the error is kept.
pub fn run(
    scene: &Scene,
    folder: &Path,
    options: RunOptions,
    observer: &mut dyn Observer,
) -> Result<Summary, Error> {
    let adapted = with_interval_of_earlier_run::<_, Checkpoint>(scene, folder, options);
    let scene = adapted.as_ref().unwrap_or(scene);
    let (lock, beginning) = prepared(scene, folder, options, observer)?;
    let place = (folder, &lock);
    let mut run = match beginning {
        Beginning::Complete(summary) => return Ok(*summary),
        Beginning::Checkpoint(saved) => SceneRun::resume(scene, place, options, observer, *saved)?,
        Beginning::Fresh => SceneRun::begin(scene, place, options, observer)?,
    };
    let ended = run.run_phases();
    run.complete(ended)
}
