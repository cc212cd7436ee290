//! Running a scene of contact dynamics.

mod begin;
mod checkpoint;
mod contacts;
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

pub use contacts::contacts;
pub use samples::columns as series_columns;
pub use shown::{Shown, shown};
pub use stability::stability;
pub use statistics::Statistics;

use super::Scene;
use crate::error::Error;
use crate::run::existing::{Beginning, beginning};
use crate::run::folder::refuse_replacing_inputs;
use crate::run::lock::Lock;
use crate::run::{Event, Observer, RunOptions, Summary};
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
    std::fs::create_dir_all(folder).map_err(|error| Error::file("create", folder, error))?;
    let lock = Lock::take(folder)?;
    refuse_replacing_inputs(scene, folder)?;
    let mut run = match beginning(scene, folder, options)? {
        Beginning::Complete(summary) => {
            observer.event(Event::AlreadyDone { folder });
            return Ok(*summary);
        }
        Beginning::Checkpoint(saved) => {
            SceneRun::resume(scene, (folder, &lock), options, observer, *saved)?
        }
        Beginning::Fresh => {
            if options.resume {
                observer.event(Event::NothingToResume { folder });
            }
            SceneRun::begin(scene, (folder, &lock), options, observer)?
        }
    };
    let ended = run.run_phases();
    run.complete(ended)
}
