//! Runs a scene through its phases, with samples and checkpoints.

use super::balance::Balance;
use super::breaks;
use super::checkpoint::Checkpoint;
use super::context::{RunContext, Sampled};
use super::dem;
use super::displacements::Displacements;
use super::doubts;
use super::folder::{BREAKS, CHECKPOINT, SERIES, SUMMARY, outputs, remove_outputs};
use super::friction::DriveSample;
use super::growing::{GrowingFiles, GrowthPlan};
use super::outcome::Summary;
use super::phases::{Phase, phases};
use super::series::Series;
use super::trajectory::FramePlan;
use super::transitions::begin_phase;
use super::warning::{Warning, in_phase};
use crate::error::Error;
use crate::scene::{Measure, Scene, Schedule};
use crate::stability::{Bound, exceeded, pair_bounds, smallest};
use gouge_dem::{State, StepError, World};

/// Number of steps between readings of the clock.
const CHUNK: u64 = 256;

/// A run in progress.
pub struct SceneRun<'a> {
    pub(super) scene: &'a Scene,
    pub(super) context: RunContext<'a>,
    pub(super) world: World,
    pub(super) bonds_initial: usize,
    pub(super) link_steps: f64,
    /// The latest valid state: the last one that was sampled, saved or began a phase. A run that fails writes it.
    pub(super) last_good: State,
    phases: Vec<Phase>,
    pub(super) files: Option<GrowingFiles>,
    pub(super) balance: Balance,
    /// What the samples so far say about the drive.
    pub(super) drive_samples: Vec<DriveSample>,
    /// Displacements since t = 0, if the scene measures strains.
    pub(super) displacements: Option<Displacements>,
    /// The smallest bound of single pairs in the current phase, once it was sought.
    pair_bound: Option<Option<Bound>>,
    /// Whether the step of the current phase was found to be above its bound.
    is_step_doubted: bool,
    /// Progress before the last sample, if it is early: a longer run does not take it.
    pub(super) before_early_sample: Option<Progress>,
    /// Number of times the neighbour list was built before the run was resumed.
    earlier_rebuilds: u64,
}

/// What samples add to.
#[derive(Clone)]
pub(super) struct Progress {
    balance: Balance,
    warnings: String,
    link_steps: f64,
}

impl<'a> SceneRun<'a> {
    /// Begin a run; outputs of an earlier run are removed.
    ///
    /// # Errors
    /// A state that the kernel rejects, or a failure of the file system.
    pub fn begin(scene: &'a Scene, context: RunContext<'a>) -> Result<Self, Error> {
        let folder = &context.folder;
        let phases = phases(scene);
        let world = match begin_phase(scene, &phases, 0, None) {
            Ok(world) => world,
            Err(error) => {
                let is_empty = || {
                    outputs(folder).is_ok_and(|all| all.iter().all(|path| path.ends_with(SUMMARY)))
                };
                if error.is_of_state() && is_empty() {
                    Summary::write_stillborn(scene, folder, &error)?;
                }
                return Err(error);
            }
        };
        remove_outputs(folder)?;
        let mut run = Self::new(scene, context, phases, world);
        run.context.report_phase();
        if let Some(doubt) = doubts::about_lattice(scene) {
            run.context.warn(doubt);
        }
        run.save_beginning()?;
        Ok(run)
    }

    /// Continue from the checkpoint in the folder.
    ///
    /// # Errors
    /// A state that does not fit the scene, a series shorter than the checkpoint requires, or a failure of the file
    /// system.
    pub fn resume(
        scene: &'a Scene,
        mut context: RunContext<'a>,
        saved: Checkpoint,
    ) -> Result<Self, Error> {
        let path = context.folder.join(CHECKPOINT);
        let phases = phases(scene);
        context.phase = (saved.phase as usize).min(phases.len() - 1);
        context.samples = saved.samples;
        context.clock.earlier = saved.seconds;
        let world = saved.world(&path, scene, phases[context.phase].kind)?;
        let displacements = saved.displacements(&path, &world.particles().position)?;
        let mut run = Self::new(scene, context, phases, world);
        run.bonds_initial = saved.bonds_initial as usize;
        run.link_steps = saved.link_steps;
        run.earlier_rebuilds = saved.rebuilds;
        run.balance = saved.balance;
        run.drive_samples = saved.drive_samples;
        run.displacements = displacements;
        let phase = in_phase(&run.context.present_phase().name);
        run.is_step_doubted = saved.warnings.contains(&phase);
        run.context.warnings = saved.warnings;
        if run.context.is_main() {
            let bytes = run.without_early_sample([saved.series_bytes, saved.breaks_bytes])?;
            run.files = Some(run.open_files(Some(bytes))?);
        }
        let _ = std::fs::remove_file(run.context.folder.join(SUMMARY));
        run.context.report_phase();
        Ok(run)
    }

    /// Bytes of the files before an early sample, which is forgotten, if there is one.
    fn without_early_sample(&mut self, [series, breaks]: [u64; 2]) -> Result<[u64; 2], Error> {
        let (schedule, steps) = (self.scene.schedule(), self.world.steps());
        if !self.context.forget_early_sample(schedule, steps) {
            return Ok([series, breaks]);
        }
        self.drive_samples.pop();
        let path = self.context.folder.join(SERIES);
        Ok([Series::without_last_row(&path, series)?, breaks])
    }

    fn new(scene: &'a Scene, context: RunContext<'a>, phases: Vec<Phase>, world: World) -> Self {
        Self {
            scene,
            context,
            phases,
            last_good: world.state().clone(),
            world,
            files: None,
            bonds_initial: 0,
            link_steps: 0.0,
            balance: Balance::default(),
            drive_samples: Vec::new(),
            displacements: None,
            pair_bound: None,
            is_step_doubted: false,
            before_early_sample: None,
            earlier_rebuilds: 0,
        }
    }

    /// Number of times the neighbour list was built since the run began.
    pub(super) fn rebuilds(&self) -> u64 {
        self.earlier_rebuilds + self.world.rebuilds()
    }

    /// Run all remaining phases, including the current one.
    pub(super) fn run_phases(&mut self) -> Result<(), Error> {
        while !self.context.is_main() {
            self.advance_to(self.context.present_phase().steps)?;
            self.begin_next_phase()?;
        }
        self.context.clock.begin_main();
        self.run_to_end()
    }

    fn begin_next_phase(&mut self) -> Result<(), Error> {
        self.last_good.clone_from(self.world.state());
        // The world is copied: if the next phase cannot begin, the run ends with the current one.
        let before = Some(self.world.clone());
        let next = self.context.phase + 1;
        self.world = begin_phase(self.scene, &self.phases, next, before)?;
        self.context.phase = next;
        self.last_good.clone_from(self.world.state());
        self.context.report_phase();
        self.save_beginning()
    }

    /// Write a checkpoint at the beginning of a phase, then open the other outputs if it is the scene proper. In this
    /// order, no output is ever without a checkpoint that tells what made it.
    fn save_beginning(&mut self) -> Result<(), Error> {
        (self.is_step_doubted, self.pair_bound) = (false, None);
        self.judge_step();
        if self.context.is_main() {
            self.bonds_initial = dem::number_of_bonds(&self.world);
            let is_measured = self.scene.output.measure.contains(&Measure::Strain);
            let position = &self.world.particles().position;
            self.displacements = is_measured.then(|| Displacements::new(position));
            self.balance = Balance::new(&self.world);
            for doubt in doubts::about_beginning(self.scene, &self.world) {
                self.context.warn(doubt);
            }
        }
        self.write_checkpoint()?;
        if self.context.is_main() {
            self.files = Some(self.open_files(None)?);
        }
        Ok(())
    }

    fn open_files(&self, bytes: Option<[u64; 2]>) -> Result<GrowingFiles, Error> {
        let scene = self.scene;
        let plan = GrowthPlan {
            columns: &dem::series_columns(scene),
            table: self.can_break().then_some((BREAKS, &breaks::COLUMNS)),
            frames: FramePlan {
                trajectory: scene.output.trajectory,
                has_links: scene.output.links,
            },
            schedule: scene.schedule(),
            bodies: self.world.particles().len(),
        };
        GrowingFiles::open(&self.context, &plan, bytes)
    }

    /// Warn, once in each phase, if the time step is above a bound of the present state.
    pub(super) fn judge_step(&mut self) {
        if self.is_step_doubted {
            return;
        }
        let step = self.world.model().time_step;
        let pairs = *self.pair_bound.get_or_insert_with(|| {
            smallest(&pair_bounds(&self.world, self.scene.material.density))
        });
        let found = match self.context.is_main() {
            true => exceeded(&self.world, pairs),
            false => pairs.filter(|one| step > one.step),
        };
        // Without damping, explicit methods are unstable at any step, but grow slowly: the balance shows when it matters.
        let is_shown = |bound: &Bound| bound.step > 0.0 || !self.scene.output.energy;
        if let Some(bound) = found.filter(is_shown) {
            self.is_step_doubted = true;
            let scene = self.scene;
            let phase = self.context.present_phase().name.clone();
            self.context.warn(Warning::TimeStep {
                scene: &scene.file,
                phase: &phase,
                step,
                bound: bound.step,
                meaning: bound.meaning,
            });
        }
    }

    pub(super) fn step_error(&self, source: StepError) -> Error {
        Error::Step {
            phase: self.context.present_phase().name.clone(),
            source,
        }
    }

    /// What the samples so far added up to.
    pub(super) fn progress(&self) -> Progress {
        Progress {
            balance: self.balance.clone(),
            warnings: self.context.warnings.clone(),
            link_steps: self.link_steps,
        }
    }

    /// Write the current state as a checkpoint.
    pub(super) fn write_checkpoint(&mut self) -> Result<(), Error> {
        self.context.lock.check()?;
        self.write_breaks()?;
        // Rows go to the disk first: a checkpoint must not count what a power failure may lose.
        let [series_bytes, breaks_bytes] = match &mut self.files {
            Some(files) => files.sync()?,
            None => [0; 2],
        };
        let now = || self.progress();
        let progress = self.before_early_sample.clone().unwrap_or_else(now);
        let checkpoint = Checkpoint {
            phase: self.context.phase as u64,
            samples: self.context.samples,
            series_bytes,
            breaks_bytes,
            bonds_initial: self.bonds_initial as u64,
            seconds: self.context.seconds(),
            link_steps: progress.link_steps,
            rebuilds: self.rebuilds(),
            balance: progress.balance,
            drive_samples: self.drive_samples.clone(),
            displacements: self.displacements.clone(),
            warnings: progress.warnings,
            keys: self.scene.keys.clone(),
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
            let until = last.min(self.world.steps() + CHUNK);
            while self.world.steps() < until {
                if let Err(source) = self.world.step() {
                    return Err(self.step_error(source));
                }
            }
            if let (Some(displacements), Some(period)) =
                (&mut self.displacements, self.scene.domain.period())
            {
                displacements.follow(&self.world.particles().position, period);
            }
            self.context.report_progress(self.world.steps());
            self.context.heed_stop()?;
            if self.context.is_checkpoint_due() {
                self.world
                    .check()
                    .map_err(|source| self.step_error(source))?;
                self.last_good.clone_from(self.world.state());
                self.write_checkpoint()?;
            }
        }
        Ok(())
    }

    fn sample(&mut self) -> Result<(), Error> {
        self.write_sample()
    }
}
