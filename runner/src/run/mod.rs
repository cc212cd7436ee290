//! Running a scene: phases, samples, checkpoints, outputs.

mod balance;
mod breaks;
pub(crate) mod bytes;
pub(crate) mod checkpoint;
pub(crate) mod clock;
pub(crate) mod columns;
pub(crate) mod context;
mod dem;
mod displacements;
mod doubts;
pub(crate) mod existing;
pub(crate) mod fingerprint;
pub(crate) mod folder;
mod friction;
pub(crate) mod growing;
pub(crate) mod legend;
mod links;
pub(crate) mod lock;
mod measures;
mod observer;
mod outcome;
pub(crate) mod page;
mod phases;
pub(crate) mod picture;
mod restart;
mod sampling;
mod scale_bar;
mod scene_run;
pub(crate) mod sealed;
pub(crate) mod series;
pub(crate) mod setup_states;
mod start;
mod stress_strain;
pub(crate) mod table;
pub(crate) mod trajectory;
mod transitions;
mod warning;

pub use bytes::words_of_bytes;
pub use checkpoint::{world_of_checkpoint, world_of_record};
pub use columns::Columns;
pub use dem::{frame as frame_of, series_columns};
pub use folder::write_whole;
pub use friction::{DriveSample, Friction};
pub use links::{links_of, table_of_links};
pub use observer::{Event, NamedPhase, Observer};
pub use outcome::{Summary, UNTRUSTED};
pub use phases::{Phase, PhaseKind, named, phases};
pub use picture::{Shown, draw_picture};
pub use sampling::sample_of;
pub use stress_strain::stress_strain;
pub use table::{Kinds, Table, Values};
pub use trajectory::{Frame, FramePlan, Frames};
pub use transitions::{advance, begin_phase, run_setup, run_setup_with};
pub use warning::Warning;

use crate::error::Error;
use crate::scene::Scene;
use existing::run_in_folder;
use scene_run::SceneRun;
use std::path::Path;

/// Options of a run that are not part of the scene.
#[derive(Clone, Copy, Debug)]
pub struct RunOptions {
    /// Whether to continue a run that was stopped, or to extend one whose scene ended earlier.
    pub resume: bool,
    /// Whether to replace the outputs of another run.
    pub overwrite: bool,
    /// Whether to write the data only: neither the page nor the scene that continues from the final state.
    pub data_only: bool,
    /// Wall time between checkpoints in s. A checkpoint is also written at the beginning of each phase.
    pub checkpoint_interval: f64,
}

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
    let phases = named(&phases(scene));
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
