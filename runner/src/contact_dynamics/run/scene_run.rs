//! Runs a scene through its phases, with samples and checkpoints.

use super::super::Scene;
use super::begin::{after_compaction, first, phases};
use super::checkpoint::Checkpoint;
use super::files::Files;
use super::samples::{self, strain_of_step};
use super::since::{LARGE, Since};
use super::statistics::mean_diameter;
use crate::error::Error;
use crate::run::checkpoint::{UNFIT, refusal};
use crate::run::clock::Clock;
use crate::run::fingerprint::Fingerprint;
use crate::run::folder::{CHECKPOINT, NETWORK, SERIES, SUMMARY, remove_outputs};
use crate::run::lock::Lock;
use crate::run::series::Series;
use crate::run::{Event, NamedPhase, Observer, RunOptions, Warning};
use gouge_common::record::Record;
use gouge_contact_dynamics::error::StepError;
use gouge_contact_dynamics::world::World;
use std::path::{Path, PathBuf};

/// Number of steps between reports of progress.
const CHUNK: u64 = 50;

/// A run in progress.
pub struct SceneRun<'a> {
    pub(super) scene: &'a Scene,
    pub(super) options: RunOptions,
    pub(super) observer: &'a mut dyn Observer,
    pub(super) folder: PathBuf,
    pub(super) lock: &'a Lock,
    pub(super) world: World,
    pub(super) phases: Vec<NamedPhase>,
    pub(super) phase: usize,
    pub(super) files: Option<Files>,
    pub(super) samples: u64,
    pub(super) point_steps: f64,
    /// Kinetic energy in J at t = 0.
    pub(super) kinetic: f64,
    /// Shear strain since t = 0.
    pub(super) strain: f64,
    pub(super) since: Since,
    /// What the steps before the latest sample did.
    pub(super) sampled: Since,
    /// What the steps before the latest sample did since the one before, if the latest one is early: a longer run does not
    /// take it.
    before_early: Option<Since>,
    pub(super) warnings: String,
    /// Mean diameter of all bodies in m.
    diameter: f64,
    compacted: Option<Record>,
    fingerprint: Fingerprint,
    clock: Clock,
}

impl<'a> SceneRun<'a> {
    /// Begin a run; outputs of an earlier run are removed.
    ///
    /// # Errors
    /// A state that the kernel rejects, or a failure of the file system.
    pub fn begin(
        scene: &'a Scene,
        place: (&Path, &'a Lock),
        options: RunOptions,
        observer: &'a mut dyn Observer,
    ) -> Result<Self, Error> {
        let world = first(scene)?;
        remove_outputs(place.0)?;
        let mut run = Self::new(scene, place, options, observer, world);
        run.report_phase();
        if run.is_main() {
            run.begin_main()?;
        } else {
            run.write_checkpoint()?;
        }
        Ok(run)
    }

    /// Continue from the checkpoint in the folder.
    ///
    /// # Errors
    /// A state that does not fit the scene, a series shorter than the checkpoint requires, or a failure of the file
    /// system.
    pub fn resume(
        scene: &'a Scene,
        place: (&Path, &'a Lock),
        options: RunOptions,
        observer: &'a mut dyn Observer,
        saved: Checkpoint,
    ) -> Result<Self, Error> {
        let unfit = || refusal(&place.0.join(CHECKPOINT), UNFIT);
        let mut world = first(scene)?;
        if let (Some(compacted), Some(table)) = (&saved.compacted, &scene.packing) {
            let compacted = world.restored(compacted).ok_or_else(unfit)?;
            world = after_compaction(scene, table, compacted)?;
        }
        let world = world.restored(&saved.state).ok_or_else(unfit)?;
        let mut run = Self::new(scene, place, options, observer, world);
        run.phase = (saved.phase as usize).min(run.phases.len() - 1);
        run.samples = saved.samples;
        run.point_steps = saved.point_steps;
        [run.kinetic, run.strain] = saved.beginning;
        [run.since, run.sampled] = saved.since;
        run.warnings = saved.warnings;
        run.compacted = saved.compacted;
        run.clock.earlier = saved.seconds;
        if run.is_main() {
            let bytes = run.without_early_sample(saved.bytes)?;
            run.files = Some(Files::open(
                scene,
                place.0,
                options,
                run.samples,
                Some(bytes),
            )?);
        }
        let _ = std::fs::remove_file(place.0.join(SUMMARY));
        run.report_phase();
        Ok(run)
    }

    /// The last sample of a run that ends before a regular sample is due is early. A longer run does not take it: forget
    /// it, and return the bytes of the files before it.
    fn without_early_sample(&mut self, bytes: [u64; 2]) -> Result<[u64; 2], Error> {
        let last = self.samples.checked_sub(1);
        let is_early = |last| self.scene.schedule().regular_sample_step(last) > self.world.steps();
        if !last.is_some_and(is_early) {
            return Ok(bytes);
        }
        self.samples -= 1;
        let [series, network] = bytes;
        let before = |name, bytes| Series::without_last_row(&self.folder.join(name), bytes);
        Ok([
            before(SERIES, series)?,
            match self.scene.measures_network() {
                true => before(NETWORK, network)?,
                false => network,
            },
        ])
    }

    fn new(
        scene: &'a Scene,
        (folder, lock): (&Path, &'a Lock),
        options: RunOptions,
        observer: &'a mut dyn Observer,
        world: World,
    ) -> Self {
        Self {
            scene,
            options,
            observer,
            folder: folder.to_owned(),
            lock,
            diameter: mean_diameter(world.assembly()),
            world,
            phases: phases(scene),
            phase: 0,
            files: None,
            samples: 0,
            point_steps: 0.0,
            kinetic: 0.0,
            strain: 0.0,
            since: Since::default(),
            sampled: Since::default(),
            before_early: None,
            warnings: String::new(),
            compacted: None,
            fingerprint: Fingerprint::of(scene),
            clock: Clock::start(),
        }
    }

    /// Whether the current phase is the scene proper.
    pub(super) fn is_main(&self) -> bool {
        self.phase + 1 == self.phases.len()
    }

    fn report_phase(&mut self) {
        self.observer.event(Event::PhaseBegan {
            phases: &self.phases,
            index: self.phase,
        });
    }

    /// Run all remaining phases, including the current one.
    pub(super) fn run_phases(&mut self) -> Result<(), Error> {
        if !self.is_main() {
            self.compact()?;
        }
        self.clock.begin_main();
        let last = self.scene.steps();
        loop {
            let due = self.scene.schedule().sample_step(self.samples);
            self.advance_to(due)?;
            // The last step is always sampled, but only once.
            let is_extra = due == last
                && self.samples > 0
                && self.scene.schedule().sample_step(self.samples - 1) >= last;
            if !is_extra {
                self.sample()?;
            }
            if due == last {
                return Ok(());
            }
        }
    }

    fn compact(&mut self) -> Result<(), Error> {
        let most = self.phases[self.phase].steps;
        while !self.world.has_settled() {
            if self.world.steps() >= most {
                return Err(Error::Unsettled { steps: most });
            }
            let until = self.world.steps() + CHUNK;
            self.pause()?;
            while self.world.steps() < until && !self.world.has_settled() {
                self.step()?;
            }
            self.report_progress();
        }
        let Some(table) = &self.scene.packing else {
            return Ok(());
        };
        self.compacted = Some(self.world.record());
        self.world = after_compaction(self.scene, table, self.world.clone())?;
        self.phase += 1;
        self.report_phase();
        self.begin_main()
    }

    /// Write a checkpoint at t = 0, then open the outputs that grow. In this order, no output is ever without a
    /// checkpoint that tells what made it.
    fn begin_main(&mut self) -> Result<(), Error> {
        self.kinetic = self.world.kinetic_energy();
        self.since = Since::default();
        self.write_checkpoint()?;
        let files = Files::open(self.scene, &self.folder, self.options, 0, None)?;
        self.files = Some(files);
        Ok(())
    }

    fn advance_to(&mut self, last: u64) -> Result<(), Error> {
        while self.world.steps() < last {
            self.pause()?;
            let until = last.min(self.world.steps() + CHUNK);
            while self.world.steps() < until {
                self.step()?;
                self.strain += strain_of_step(&self.world);
                self.point_steps += self.world.workspace().points().len() as f64;
            }
            self.report_progress();
        }
        Ok(())
    }

    fn step(&mut self) -> Result<(), Error> {
        let report = self.world.step().map_err(|source| self.failure(source))?;
        if self.is_main() && self.world.steps() == 1 {
            self.doubt_beginning(report.largest_overlap);
        }
        self.since.add(&report, &self.world, self.diameter);
        Ok(())
    }

    /// All steps of the scene proper so far.
    pub(super) fn all_steps(&self) -> Since {
        let mut all = self.sampled;
        all.extend(&self.before_early.unwrap_or_default());
        all.extend(&self.since);
        all
    }

    /// Warn of bodies that overlap from the beginning.
    fn doubt_beginning(&mut self, overlap: f64) {
        if overlap > LARGE * self.diameter {
            self.warn(Warning::Overlapping(overlap));
        }
    }

    /// Report a problem, and keep it for the summary.
    pub(super) fn warn(&mut self, warning: Warning) {
        self.warnings += &format!("{warning}\n");
        self.observer.event(Event::Warning(warning));
    }

    fn failure(&self, source: StepError) -> Error {
        Error::ContactDynamicsStep {
            phase: self.phases[self.phase].name.clone(),
            source,
        }
    }

    fn report_progress(&mut self) {
        self.observer.event(Event::Progress {
            phase: self.phase,
            steps: self.world.steps(),
        });
    }

    /// Stop if the observer wants it, or write a checkpoint if it is time. Samples read the contact points of the latest
    /// step, which no checkpoint holds; so this is never done between a step and its sample.
    fn pause(&mut self) -> Result<(), Error> {
        if self.observer.wants_stop() {
            return Err(Error::Interrupted(self.folder.clone()));
        }
        if self.clock.since_saved() > self.options.checkpoint_interval {
            self.write_checkpoint()?;
        }
        Ok(())
    }

    /// Write a sample of the current state.
    fn sample(&mut self) -> Result<(), Error> {
        let (scene, world) = (self.scene, &self.world);
        let sample = samples::sample(scene, world, &self.since, self.kinetic, self.strain);
        self.lock.check()?;
        if let Some(files) = &mut self.files {
            files.write(scene, world, self.samples, &sample)?;
        }
        self.observer.event(Event::SampleWritten {
            sample: self.samples,
            time: self.world.time(),
        });
        let is_early = self.scene.schedule().regular_sample_step(self.samples) > self.world.steps();
        self.before_early = is_early.then_some(self.since);
        if !is_early {
            self.sampled.extend(&self.since);
        }
        self.samples += 1;
        self.since = Since::default();
        Ok(())
    }

    /// Wall time so far in s: of the whole run and of the scene proper.
    pub(super) fn seconds(&self) -> [f64; 2] {
        self.clock.seconds(self.is_main())
    }

    /// Write the current state as a checkpoint.
    pub(super) fn write_checkpoint(&mut self) -> Result<(), Error> {
        self.lock.check()?;
        let bytes = match &mut self.files {
            Some(files) => files.sync()?,
            None => [0; 2],
        };
        let checkpoint = Checkpoint {
            phase: self.phase as u64,
            samples: self.samples,
            bytes,
            seconds: self.seconds(),
            point_steps: self.point_steps,
            beginning: [self.kinetic, self.strain],
            since: [self.before_early.unwrap_or(self.since), self.sampled],
            warnings: self.warnings.clone(),
            keys: self.scene.keys.clone(),
            compacted: self.compacted.clone(),
            state: self.world.record(),
        };
        let path = self.folder.join(CHECKPOINT);
        checkpoint.write(&path, &self.fingerprint)?;
        self.clock.save();
        self.observer.event(Event::CheckpointWritten {
            path: &path,
            steps: self.world.steps(),
        });
        Ok(())
    }
}
