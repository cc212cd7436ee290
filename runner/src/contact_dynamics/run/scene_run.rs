//! Runs a scene through its phases, with samples and checkpoints.

use super::super::Scene;
use super::begin::{after_compaction, first};
use super::checkpoint::Checkpoint;
use super::samples::{self, strain_of_step};
use super::since::{LARGE, Since};
use super::statistics::{Statistics, mean_diameter};
use super::{files, frame};
use crate::error::Error;
use crate::run::Warning;
use crate::run::checkpoint::{UNFIT, refusal};
use crate::run::context::{RunContext, Sampled};
use crate::run::folder::{CHECKPOINT, NETWORK, SERIES, SUMMARY, remove_outputs};
use crate::run::growing::GrowingFiles;
use crate::run::series::Series;
use crate::scene::Schedule;
use gouge_common::record::Record;
use gouge_contact_dynamics::error::StepError;
use gouge_contact_dynamics::observables::Network;
use gouge_contact_dynamics::world::World;

/// Number of steps between reports of progress.
const CHUNK: u64 = 50;

/// A run in progress.
pub struct SceneRun<'a> {
    pub(super) scene: &'a Scene,
    pub(super) context: RunContext<'a>,
    pub(super) world: World,
    pub(super) files: Option<GrowingFiles>,
    /// A buffer.
    network: Network,
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
    /// Mean diameter of all bodies in m.
    diameter: f64,
    compacted: Option<Record>,
}

impl<'a> SceneRun<'a> {
    /// Begin a run; outputs of an earlier run are removed.
    ///
    /// # Errors
    /// A state that the kernel rejects, or a failure of the file system.
    pub fn begin(scene: &'a Scene, context: RunContext<'a>) -> Result<Self, Error> {
        let world = first(scene)?;
        remove_outputs(&context.folder)?;
        let mut run = Self::new(scene, context, world);
        run.context.report_phase();
        if run.context.is_main() {
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
        context: RunContext<'a>,
        saved: Checkpoint,
    ) -> Result<Self, Error> {
        let unfit = || refusal(&context.folder.join(CHECKPOINT), UNFIT);
        let mut world = first(scene)?;
        if let (Some(compacted), Some(table)) = (&saved.compacted, &scene.packing) {
            let compacted = world.restored(compacted).ok_or_else(unfit)?;
            world = after_compaction(scene, table, compacted)?;
        }
        let world = world.restored(&saved.state).ok_or_else(unfit)?;
        let mut run = Self::new(scene, context, world);
        run.context.phase = (saved.phase as usize).min(run.context.phases.len() - 1);
        run.context.samples = saved.samples;
        run.context.warnings = saved.warnings;
        run.context.clock.earlier = saved.seconds;
        run.point_steps = saved.point_steps;
        [run.kinetic, run.strain] = saved.beginning;
        [run.since, run.sampled] = saved.since;
        run.compacted = saved.compacted;
        if run.context.is_main() {
            let bytes = run.without_early_sample(saved.bytes)?;
            run.files = Some(files::open(scene, &run.context, Some(bytes))?);
        }
        let _ = std::fs::remove_file(run.context.folder.join(SUMMARY));
        run.context.report_phase();
        Ok(run)
    }

    /// Bytes of the files before an early sample, which is forgotten, if there is one.
    fn without_early_sample(&mut self, bytes: [u64; 2]) -> Result<[u64; 2], Error> {
        let (schedule, steps) = (self.scene.schedule(), self.world.steps());
        if !self.context.forget_early_sample(schedule, steps) {
            return Ok(bytes);
        }
        let [series, network] = bytes;
        let folder = &self.context.folder;
        let before = |name, bytes| Series::without_last_row(&folder.join(name), bytes);
        Ok([
            before(SERIES, series)?,
            match self.scene.measures_network() {
                true => before(NETWORK, network)?,
                false => network,
            },
        ])
    }

    fn new(scene: &'a Scene, context: RunContext<'a>, world: World) -> Self {
        Self {
            scene,
            context,
            diameter: mean_diameter(world.assembly()),
            world,
            files: None,
            network: Network::new(),
            point_steps: 0.0,
            kinetic: 0.0,
            strain: 0.0,
            since: Since::default(),
            sampled: Since::default(),
            before_early: None,
            compacted: None,
        }
    }

    /// Run all remaining phases, including the current one.
    pub(super) fn run_phases(&mut self) -> Result<(), Error> {
        if !self.context.is_main() {
            self.compact()?;
        }
        self.context.clock.begin_main();
        self.run_to_end()
    }

    fn compact(&mut self) -> Result<(), Error> {
        let most = self.context.present_phase().steps;
        while !self.world.has_settled() {
            if self.world.steps() >= most {
                return Err(Error::Unsettled { steps: most });
            }
            let until = self.world.steps() + CHUNK;
            self.pause()?;
            while self.world.steps() < until && !self.world.has_settled() {
                self.step()?;
            }
            self.context.report_progress(self.world.steps());
        }
        let Some(table) = &self.scene.packing else {
            return Ok(());
        };
        self.compacted = Some(self.world.record());
        self.world = after_compaction(self.scene, table, self.world.clone())?;
        self.context.phase += 1;
        self.context.report_phase();
        self.begin_main()
    }

    /// Write a checkpoint at t = 0, then open the outputs that grow. In this order, no output is ever without a
    /// checkpoint that tells what made it.
    fn begin_main(&mut self) -> Result<(), Error> {
        self.kinetic = self.world.kinetic_energy();
        self.since = Since::default();
        self.write_checkpoint()?;
        let files = files::open(self.scene, &self.context, None)?;
        self.files = Some(files);
        Ok(())
    }

    fn step(&mut self) -> Result<(), Error> {
        let report = self.world.step().map_err(|source| self.failure(source))?;
        if self.context.is_main() && self.world.steps() == 1 {
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
            self.context.warn(Warning::Overlapping(overlap));
        }
    }

    fn failure(&self, source: StepError) -> Error {
        Error::ContactDynamicsStep {
            phase: self.context.present_phase().name.clone(),
            source,
        }
    }

    /// Stop if the observer wants it, or write a checkpoint if it is time. Samples read the contact points of the latest
    /// step, which no checkpoint holds; so this is never done between a step and its sample.
    fn pause(&mut self) -> Result<(), Error> {
        self.context.heed_stop()?;
        if self.context.is_checkpoint_due() {
            self.write_checkpoint()?;
        }
        Ok(())
    }

    /// Write the current state as a checkpoint.
    pub(super) fn write_checkpoint(&mut self) -> Result<(), Error> {
        self.context.lock.check()?;
        let bytes = match &mut self.files {
            Some(files) => files.sync()?,
            None => [0; 2],
        };
        let checkpoint = Checkpoint {
            phase: self.context.phase as u64,
            samples: self.context.samples,
            bytes,
            seconds: self.context.seconds(),
            point_steps: self.point_steps,
            beginning: [self.kinetic, self.strain],
            since: [self.before_early.unwrap_or(self.since), self.sampled],
            warnings: self.context.warnings.clone(),
            keys: self.scene.keys.clone(),
            compacted: self.compacted.clone(),
            state: self.world.record(),
        };
        let path = self.context.folder.join(CHECKPOINT);
        checkpoint.write(&path, &self.context.fingerprint)?;
        self.context.report_checkpoint(&path, self.world.steps());
        Ok(())
    }
}

impl Sampled for SceneRun<'_> {
    fn schedule(&self) -> Schedule {
        self.scene.schedule()
    }

    fn samples(&self) -> u64 {
        self.context.samples
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
            self.context.report_progress(until);
        }
        Ok(())
    }

    fn sample(&mut self) -> Result<(), Error> {
        let (scene, world) = (self.scene, &self.world);
        let sample = samples::sample(scene, world, &self.since, self.kinetic, self.strain);
        self.context.lock.check()?;
        if let Some(files) = &mut self.files {
            let frame = || (frame::frame(scene, world), None);
            let motion = || frame::grains(scene, world);
            files.write(self.context.samples, &sample, frame, motion)?;
            // Before the first step there is no network.
            if let Some(table) = files.table.as_mut().filter(|_| world.steps() > 0) {
                let statistics = Statistics::of(scene, world, &mut self.network);
                let numbers = [world.time()].into_iter().chain(statistics.values());
                let cells: Vec<String> = numbers.map(|number| format!("{number:?}")).collect();
                table.append_row(&cells)?;
            }
        }
        let regular = scene.schedule().regular_sample_step(self.context.samples);
        let is_early = regular > self.world.steps();
        self.before_early = is_early.then_some(self.since);
        if !is_early {
            self.sampled.extend(&self.since);
        }
        self.since = Since::default();
        self.context.count_sample(self.world.time());
        Ok(())
    }
}
