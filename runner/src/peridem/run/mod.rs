//! Running a scene of peridynamic grains.

mod balance;
mod begin;
mod checkpoint;
mod files;
mod frame;
mod links;
mod mesh;
mod outcome;
mod page;
mod picture;
mod samples;
mod scene_run;
mod shown;
mod stability;
mod tables;

pub use begin::world;
pub(crate) use checkpoint::is_saved;
pub use links::links;
pub use picture::damage_colours;
pub use samples::columns as series_columns;
pub use shown::shown;
pub use stability::stability;

use super::Scene;
use crate::error::Error;
use crate::run::existing::run_in_folder;
use crate::run::{Observer, RunOptions, Summary};
use scene_run::{SceneRun, phase};
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
    let phases = vec![phase(scene)];
    run_in_folder(
        scene,
        folder,
        options,
        observer,
        phases,
        |scene, context, saved| {
            let run = match saved {
                Some(saved) => SceneRun::resume(scene, context, saved),
                None => SceneRun::begin(scene, context),
            };
            run?.complete()
        },
    )
}
