//! What runs of all models have in common: where and how they run, whom they report to, and how far they are.

use super::RunOptions;
use super::clock::Clock;
use super::fingerprint::Fingerprint;
use super::lock::Lock;
use super::observer::{Event, NamedPhase, Observer};
use super::warning::Warning;
use crate::error::Error;
use crate::scene::Schedule;
use std::path::{Path, PathBuf};

/// The surroundings and the progress of a run.
pub struct RunContext<'a> {
    /// The folder of its outputs.
    pub folder: PathBuf,
    /// Checked before anything is written.
    pub lock: &'a Lock,
    /// How it was asked for.
    pub options: RunOptions,
    /// All phases, the scene proper last.
    pub phases: Vec<NamedPhase>,
    /// Position of the current phase.
    pub phase: usize,
    /// Number of samples written.
    pub samples: u64,
    /// The warnings so far, one per line.
    pub warnings: String,
    /// Wall times.
    pub clock: Clock,
    /// Of the scene.
    pub fingerprint: Fingerprint,
    observer: &'a mut dyn Observer,
}

impl<'a> RunContext<'a> {
    /// A run that begins now.
    pub fn new(
        (folder, lock): (&Path, &'a Lock),
        options: RunOptions,
        observer: &'a mut dyn Observer,
        phases: Vec<NamedPhase>,
        fingerprint: Fingerprint,
    ) -> Self {
        Self {
            folder: folder.to_owned(),
            lock,
            options,
            phases,
            phase: 0,
            samples: 0,
            warnings: String::new(),
            clock: Clock::start(),
            fingerprint,
            observer,
        }
    }

    /// Whether the current phase is the scene proper.
    pub fn is_main(&self) -> bool {
        self.phase + 1 == self.phases.len()
    }

    /// The current phase.
    pub fn present_phase(&self) -> &NamedPhase {
        &self.phases[self.phase]
    }

    /// Wall time so far in s: of the whole run and of the scene proper.
    pub fn seconds(&self) -> [f64; 2] {
        self.clock.seconds(self.is_main())
    }

    /// Report that the current phase begins, or goes on.
    pub fn report_phase(&mut self) {
        self.observer.event(Event::PhaseBegan {
            phases: &self.phases,
            index: self.phase,
        });
    }

    /// Report the number of steps of the current phase so far.
    pub fn report_progress(&mut self, steps: u64) {
        self.observer.event(Event::Progress {
            phase: self.phase,
            steps,
        });
    }

    /// Report that a checkpoint was written.
    pub fn report_checkpoint(&mut self, path: &Path, steps: u64) {
        self.clock.save();
        self.observer
            .event(Event::CheckpointWritten { path, steps });
    }

    /// Count a sample that was written at a time in s, and report it.
    pub fn count_sample(&mut self, time: f64) {
        self.observer.event(Event::SampleWritten {
            sample: self.samples,
            time,
        });
        self.samples += 1;
    }

    /// Report that only the final state remains to be written.
    pub fn report_end(&mut self) {
        self.observer.event(Event::Ended);
    }

    /// Report a problem, and keep it for the summary.
    pub fn warn(&mut self, warning: Warning) {
        self.warnings += &format!("{warning}\n");
        self.observer.event(Event::Warning(warning));
    }

    /// Stop if the observer wants it.
    ///
    /// # Errors
    /// [`Error::Interrupted`].
    pub fn heed_stop(&self) -> Result<(), Error> {
        match self.observer.wants_stop() {
            true => Err(Error::Interrupted(self.folder.clone())),
            false => Ok(()),
        }
    }

    /// Whether it is time for a checkpoint.
    pub fn is_checkpoint_due(&self) -> bool {
        self.clock.since_saved() > self.options.checkpoint_interval
    }

    /// The last sample of a run that ends before a regular sample is due is early. A longer run does not take it, and a
    /// run that was stopped before its summary takes it again. Forget it, and return whether there was one.
    pub fn forget_early_sample(&mut self, schedule: Schedule, steps: u64) -> bool {
        let is_early = |last| schedule.regular_sample_step(last) > steps;
        let found = self.samples.checked_sub(1).is_some_and(is_early);
        self.samples -= u64::from(found);
        found
    }
}

/// A run whose scene proper is sampled.
pub trait Sampled {
    /// When samples are due.
    fn schedule(&self) -> Schedule;

    /// Number of samples written.
    fn samples(&self) -> u64;

    /// Advance to a step.
    ///
    /// # Errors
    /// A state that becomes invalid, an interruption, or a failure of the file system.
    fn advance_to(&mut self, last: u64) -> Result<(), Error>;

    /// Write a sample of the current state.
    ///
    /// # Errors
    /// A state that is invalid, or a failure of the file system.
    fn sample(&mut self) -> Result<(), Error>;

    /// Run all remaining steps of the scene proper.
    ///
    /// # Errors
    /// As those of the steps and samples.
    fn run_to_end(&mut self) -> Result<(), Error> {
        let schedule = self.schedule();
        let last = schedule.steps();
        loop {
            let due = schedule.sample_step(self.samples());
            self.advance_to(due)?;
            // The last step is always sampled, but only once.
            let before = self.samples().checked_sub(1);
            let is_taken = before.is_some_and(|before| schedule.sample_step(before) >= last);
            if !(due == last && is_taken) {
                self.sample()?;
            }
            if due == last {
                return Ok(());
            }
        }
    }
}
