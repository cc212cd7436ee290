//! What a run reports while it goes on. The runner prints nothing; who watches decides what is shown.

use super::phases::Phase;
use std::fmt;
use std::path::Path;

/// Something that happened in a run.
///
/// A phase begins, goes on and writes checkpoints and, in the scene proper, samples; the next phase begins; at
/// last the run ends.
#[derive(Clone, Copy, Debug)]
pub enum Event<'a> {
    /// A phase begins, or a run is resumed in it.
    PhaseBegan {
        /// All phases of the run.
        phases: &'a [Phase],
        /// Position of this phase among them.
        index: usize,
    },
    /// Some steps were taken.
    Progress {
        /// Position of the phase.
        phase: usize,
        /// Steps of the phase so far.
        steps: u64,
    },
    /// Something that the user should know, although the run goes on.
    Warning(Warning<'a>),
    /// A sample was added to the series, and its frame to the trajectory.
    SampleWritten {
        /// Its number, from zero.
        sample: u64,
        /// Its time in s.
        time: f64,
    },
    /// A checkpoint replaced the one before.
    CheckpointWritten {
        /// Its file.
        path: &'a Path,
        /// Steps of the phase so far.
        steps: u64,
    },
    /// The last step was taken, or the run failed; what remains is to write the final state.
    Ended,
}

/// Something that the user should know, although the run goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Warning<'a> {
    /// The time step may be unstable.
    TimeStep {
        /// Name of the scene file.
        scene: &'a str,
        /// The time step in s.
        step: f64,
        /// Estimated stability bound in s.
        bound: f64,
    },
}

impl fmt::Display for Warning<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self::TimeStep { scene, step, bound } = self;
        write!(
            f,
            "{scene}: time.step = {step:?}: above the estimated stability bound, {bound:.3e} s \
             (run `gouge stability` for the bounds)"
        )
    }
}

/// Who watches a run.
pub trait Observer {
    /// Take note of an event.
    fn event(&mut self, event: Event<'_>);
}

impl<F: FnMut(Event<'_>)> Observer for F {
    fn event(&mut self, event: Event<'_>) {
        self(event);
    }
}
