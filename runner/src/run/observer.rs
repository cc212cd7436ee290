//! Events that a run reports. The runner prints nothing; the observer decides what is shown.

use super::warning::Warning;
use std::path::Path;

/// An event of a run.
///
/// In each phase, `PhaseBegan` is followed by progress, checkpoints and, in the scene proper, samples. The last event
/// is `Ended`. If the run was finished before, the only event is `AlreadyDone`.
#[derive(Clone, Copy, Debug)]
pub enum Event<'a> {
    /// A phase begins, or a run is resumed in it.
    PhaseBegan {
        /// All phases of the run, in order.
        phases: &'a [NamedPhase],
        /// Position of this phase among them.
        index: usize,
    },
    /// Some steps were completed.
    Progress {
        /// Position of the phase.
        phase: usize,
        /// Steps of the phase so far.
        steps: u64,
    },
    /// A problem that does not stop the run.
    Warning(Warning<'a>),
    /// A sample was written to the series, and its frame to the trajectory.
    SampleWritten {
        /// Number of the sample, counted from zero.
        sample: u64,
        /// Time of the sample in s.
        time: f64,
    },
    /// A checkpoint was written; it replaces the previous one.
    CheckpointWritten {
        /// File of the checkpoint.
        path: &'a Path,
        /// Steps of the phase so far.
        steps: u64,
    },
    /// The last step was completed, or the run failed. Only the final state remains to be written.
    Ended,
    /// There is nothing to resume, so the run begins.
    NothingToResume {
        /// The folder.
        folder: &'a Path,
    },
    /// The folder already holds the finished run of this scene, so nothing is done.
    AlreadyDone {
        /// The folder.
        folder: &'a Path,
    },
}

/// A phase of a run, of any model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedPhase {
    /// Name in progress and error messages.
    pub name: String,
    /// Number of steps, at most.
    pub steps: u64,
}

/// A receiver of the events of a run.
pub trait Observer {
    /// Receive an event.
    fn event(&mut self, event: Event<'_>);

    /// Whether the run should stop. It is asked every few hundred steps; a run that stops writes a checkpoint.
    fn wants_stop(&self) -> bool {
        false
    }
}

impl<F: FnMut(Event<'_>)> Observer for F {
    fn event(&mut self, event: Event<'_>) {
        self(event);
    }
}
