//! Running a scene: phases, samples, checkpoints, outputs.

mod checkpoint;
mod dem;
mod folder;
mod observer;
mod outcome;
mod phases;
mod picture;
mod sampling;
mod scene_run;
mod series;
mod setup_states;
mod table;
mod trajectory;
mod transitions;

pub use checkpoint::{words_of_bytes, world_of_record};
pub use folder::write_whole;
pub use observer::{Event, Observer, Warning};
pub use phases::{Phase, PhaseKind, phases};
pub use picture::draw_picture;
pub use trajectory::write_frame;
pub use transitions::{advance, begin_phase, run_setup};

use crate::error::Error;
use crate::scene::Scene;
use folder::{CHECKPOINT, SUMMARY, refuse_replacing_inputs};
use scene_run::SceneRun;
use std::path::Path;

/// Options of a run that are not part of the scene.
#[derive(Clone, Copy, Debug)]
pub struct RunOptions {
    /// Whether to continue a run that was stopped.
    pub resume: bool,
    /// Wall time between checkpoints in s. A checkpoint is also written at the beginning of each phase.
    pub checkpoint_interval: f64,
}

/// Run a scene, write its outputs into a folder, and report what happens to an observer.
///
/// # Errors
/// A folder that cannot be written, a checkpoint of another scene, or a state that becomes invalid. What was written
/// before the error is kept.
pub fn run(
    scene: &Scene,
    folder: &Path,
    options: RunOptions,
    observer: &mut dyn Observer,
) -> Result<(), Error> {
    refuse_replacing_inputs(scene, folder)?;
    std::fs::create_dir_all(folder).map_err(|error| Error::file("create", folder, error))?;
    let path = folder.join(CHECKPOINT);
    let is_unfinished = path.exists() && !folder.join(SUMMARY).exists();
    if is_unfinished && !options.resume {
        return Err(Error::Argument(format!(
            "{} holds an unfinished run: continue it with --resume, or remove it first",
            folder.display()
        )));
    }
    let run = if options.resume && path.exists() {
        SceneRun::resume(scene, folder, options, observer)?
    } else {
        SceneRun::begin(scene, folder, options, observer)?
    };
    run.complete()
}
