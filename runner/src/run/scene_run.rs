//! Runs a scene through its phases, with samples and checkpoints.

use super::balance::Balance;
use super::breaks;
use super::checkpoint::Checkpoint;
use super::clock::Clock;
use super::dem;
use super::displacements::Displacements;
use super::doubts;
use super::fingerprint::Fingerprint;
use super::folder::{BREAKS, CHECKPOINT, SERIES, SUMMARY, outputs, remove_outputs};
use super::friction::DriveSample;
use super::lock::Lock;
use super::outcome::Summary;
use super::page::Animation;
use super::phases::{Phase, named, phases};
use super::series::Series;
use super::trajectory::{FramePlan, Frames};
use super::transitions::begin_phase;
use super::warning::in_phase;
use super::{Event, Observer, RunOptions, Warning};
use crate::error::Error;
use crate::scene::{Measure, Scene};
use crate::stability::{Bound, exceeded, pair_bounds, smallest};
use gouge_dem::{State, StepError, World};
use std::path::{Path, PathBuf};

/// Number of steps between readings of the clock.
const CHUNK: u64 = 256;

/// A run in progress.
pub struct SceneRun<'a> {
    pub(super) scene: &'a Scene,
    pub(super) folder: PathBuf,
    /// Checked before anything is written.
    pub(super) lock: &'a Lock,
    pub(super) observer: &'a mut dyn Observer,
    pub(super) world: World,
    pub(super) bonds_initial: usize,
    pub(super) link_steps: f64,
    /// The latest valid state: the last one that was sampled, saved or began a phase. A run that fails writes it.
    pub(super) last_good: State,
    pub(super) phases: Vec<Phase>,
    /// Position of the current phase.
    pub(super) phase: usize,
    pub(super) series: Option<Series>,
    /// The bonds that broke, if any can.
    pub(super) breaks: Option<Series>,
    pub(super) frames: Option<Frames>,
    /// What the page shows of the trajectory.
    pub(super) animation: Option<Animation>,
    /// Number of samples written.
    pub(super) samples: u64,
    pub(super) options: RunOptions,
    fingerprint: Fingerprint,
    clock: Clock,
    pub(super) balance: Balance,
    /// What the samples so far say about the drive.
    pub(super) drive_samples: Vec<DriveSample>,
    /// Displacements since t = 0, if the scene measures strains.
    pub(super) displacements: Option<Displacements>,
    /// The warnings so far, one per line.
    pub(super) warnings: String,
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
    pub fn begin(
        scene: &'a Scene,
        folder: &Path,
        options: RunOptions,
        observer: &'a mut dyn Observer,
        lock: &'a Lock,
    ) -> Result<Self, Error> {
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
        let mut run = Self::new(scene, (folder, lock), options, observer, (phases, 0), world);
        run.report_phase();
        if let Some(doubt) = doubts::about_lattice(scene) {
            run.warn(doubt);
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
        folder: &Path,
        options: RunOptions,
        observer: &'a mut dyn Observer,
        saved: Checkpoint,
        lock: &'a Lock,
    ) -> Result<Self, Error> {
        let path = folder.join(CHECKPOINT);
        let phases = phases(scene);
        let phase = (saved.phase as usize).min(phases.len() - 1);
        let world = saved.world(&path, scene, phases[phase].kind)?;
        let displacements = saved.displacements(&path, &world.particles().position)?;
        let mut run = Self::new(
            scene,
            (folder, lock),
            options,
            observer,
            (phases, phase),
            world,
        );
        run.samples = saved.samples;
        run.bonds_initial = saved.bonds_initial as usize;
        run.link_steps = saved.link_steps;
        run.clock.earlier = saved.seconds;
        run.earlier_rebuilds = saved.rebuilds;
        run.balance = saved.balance;
        run.drive_samples = saved.drive_samples;
        run.displacements = displacements;
        run.is_step_doubted = saved.warnings.contains(&in_phase(&run.phases[phase].name));
        run.warnings = saved.warnings;
        if run.is_main() {
            let bytes = run.without_early_sample(saved.series_bytes)?;
            run.series = Some(run.open_series(Some(bytes))?);
            run.breaks = run.open_breaks(Some(saved.breaks_bytes))?;
            run.frames =
                Frames::open(&frames_of(scene), folder, &sample_times(scene, run.samples))?;
            run.animation = run.open_animation()?;
        }
        let _ = std::fs::remove_file(folder.join(SUMMARY));
        run.report_phase();
        Ok(run)
    }

    /// The last sample of a run that ends before a regular sample is due is early. A longer run does not take it, and a
    /// run that was stopped before its summary takes it again: forget it, and return the bytes of the series before it.
    fn without_early_sample(&mut self, series_bytes: u64) -> Result<u64, Error> {
        let is_early = self
            .samples
            .checked_sub(1)
            .is_some_and(|last| self.scene.regular_sample_step(last) > self.world.steps());
        if !is_early {
            return Ok(series_bytes);
        }
        self.samples -= 1;
        self.drive_samples.pop();
        Series::without_last_row(&self.folder.join(SERIES), series_bytes)
    }

    fn new(
        scene: &'a Scene,
        (folder, lock): (&Path, &'a Lock),
        options: RunOptions,
        observer: &'a mut dyn Observer,
        (phases, phase): (Vec<Phase>, usize),
        world: World,
    ) -> Self {
        Self {
            scene,
            options,
            observer,
            folder: folder.to_owned(),
            lock,
            fingerprint: Fingerprint::of(scene),
            phases,
            phase,
            last_good: world.state().clone(),
            world,
            series: None,
            breaks: None,
            frames: None,
            animation: None,
            samples: 0,
            bonds_initial: 0,
            link_steps: 0.0,
            clock: Clock::start(),
            balance: Balance::default(),
            drive_samples: Vec::new(),
            displacements: None,
            warnings: String::new(),
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

    /// Whether the current phase is the scene proper.
    pub(super) fn is_main(&self) -> bool {
        self.phase + 1 == self.phases.len()
    }

    /// Run all remaining phases, including the current one.
    pub(super) fn run_phases(&mut self) -> Result<(), Error> {
        while !self.is_main() {
            self.advance_to(self.phases[self.phase].steps)?;
            self.begin_next_phase()?;
        }
        self.clock.begin_main();
        let last = self.phases[self.phase].steps;
        loop {
            let due = self.scene.sample_step(self.samples);
            self.advance_to(due)?;
            // The last step is always sampled, but only once.
            let is_extra =
                due == last && self.samples > 0 && self.scene.sample_step(self.samples - 1) >= last;
            if !is_extra {
                self.sample()?;
            }
            if due == last {
                return Ok(());
            }
        }
    }

    fn begin_next_phase(&mut self) -> Result<(), Error> {
        self.last_good.clone_from(self.world.state());
        // The world is copied: if the next phase cannot begin, the run ends with the current one.
        let before = Some(self.world.clone());
        self.world = begin_phase(self.scene, &self.phases, self.phase + 1, before)?;
        self.phase += 1;
        self.last_good.clone_from(self.world.state());
        self.report_phase();
        self.save_beginning()
    }

    /// Write a checkpoint at the beginning of a phase, then open the other outputs if it is the scene proper. In this
    /// order, no output is ever without a checkpoint that tells what made it.
    fn save_beginning(&mut self) -> Result<(), Error> {
        (self.is_step_doubted, self.pair_bound) = (false, None);
        self.judge_step();
        if self.is_main() {
            self.bonds_initial = dem::number_of_bonds(&self.world);
            let is_measured = self.scene.output.measure.contains(&Measure::Strain);
            let position = &self.world.particles().position;
            self.displacements = is_measured.then(|| Displacements::new(position));
            self.balance = Balance::new(&self.world);
            for doubt in doubts::about_beginning(self.scene, &self.world) {
                self.warn(doubt);
            }
        }
        self.write_checkpoint()?;
        if self.is_main() {
            self.series = Some(self.open_series(None)?);
            self.breaks = self.open_breaks(None)?;
            self.frames = Frames::open(&frames_of(self.scene), &self.folder, &[])?;
            self.animation = self.open_animation()?;
        }
        Ok(())
    }

    fn open_series(&self, bytes: Option<u64>) -> Result<Series, Error> {
        let columns = dem::series_columns(self.scene);
        Series::open(self.folder.join(SERIES), &columns, bytes)
    }

    fn open_animation(&self) -> Result<Option<Animation>, Error> {
        match &self.frames {
            Some(_) if !self.options.data_only => {
                let particles = self.world.particles().len();
                Animation::open(&self.folder, self.samples, particles)
            }
            _ => Ok(None),
        }
    }

    fn open_breaks(&self, bytes: Option<u64>) -> Result<Option<Series>, Error> {
        let open = || Series::open(self.folder.join(BREAKS), &breaks::COLUMNS, bytes);
        self.can_break().then(open).transpose()
    }

    fn report_phase(&mut self) {
        let phases = named(&self.phases);
        self.observer.event(Event::PhaseBegan {
            phases: &phases,
            index: self.phase,
        });
    }

    /// Report a problem, and keep it for the summary.
    pub(super) fn warn(&mut self, warning: Warning) {
        self.warnings += &format!("{warning}\n");
        self.observer.event(Event::Warning(warning));
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
        let found = match self.is_main() {
            true => exceeded(&self.world, pairs),
            false => pairs.filter(|one| step > one.step),
        };
        // Without damping, explicit methods are unstable at any step, but grow slowly: the balance shows when it matters.
        let is_shown = |bound: &Bound| bound.step > 0.0 || !self.scene.output.energy;
        if let Some(bound) = found.filter(is_shown) {
            self.is_step_doubted = true;
            let scene = self.scene;
            let phase = self.phases[self.phase].name.clone();
            self.warn(Warning::TimeStep {
                scene: &scene.file,
                phase: &phase,
                step,
                bound: bound.step,
                meaning: bound.meaning,
            });
        }
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
            self.observer.event(Event::Progress {
                phase: self.phase,
                steps: self.world.steps(),
            });
            if self.observer.wants_stop() {
                return Err(Error::Interrupted(self.folder.clone()));
            }
            if self.clock.since_saved() > self.options.checkpoint_interval {
                self.world
                    .check()
                    .map_err(|source| self.step_error(source))?;
                self.last_good.clone_from(self.world.state());
                self.write_checkpoint()?;
            }
        }
        Ok(())
    }

    pub(super) fn step_error(&self, source: StepError) -> Error {
        Error::Step {
            phase: self.phases[self.phase].name.clone(),
            source,
        }
    }

    /// Wall time so far in s: of the whole run and of the scene proper.
    pub(super) fn seconds(&self) -> [f64; 2] {
        self.clock.seconds(self.is_main())
    }

    /// What the samples so far added up to.
    pub(super) fn progress(&self) -> Progress {
        Progress {
            balance: self.balance.clone(),
            warnings: self.warnings.clone(),
            link_steps: self.link_steps,
        }
    }

    /// Write the current state as a checkpoint.
    pub(super) fn write_checkpoint(&mut self) -> Result<(), Error> {
        self.lock.check()?;
        self.write_breaks()?;
        // Rows go to the disk first: a checkpoint must not count what a power failure may lose.
        for file in [&self.series, &self.breaks].into_iter().flatten() {
            file.sync()?;
        }
        if let Some(frames) = &mut self.frames {
            frames.sync()?;
        }
        if let Some(animation) = &self.animation {
            animation.sync()?;
        }
        let now = || self.progress();
        let progress = self.before_early_sample.clone().unwrap_or_else(now);
        let checkpoint = Checkpoint {
            phase: self.phase as u64,
            samples: self.samples,
            series_bytes: self.series.as_ref().map_or(0, Series::bytes),
            breaks_bytes: self.breaks.as_ref().map_or(0, Series::bytes),
            bonds_initial: self.bonds_initial as u64,
            seconds: self.seconds(),
            link_steps: progress.link_steps,
            rebuilds: self.rebuilds(),
            balance: progress.balance,
            drive_samples: self.drive_samples.clone(),
            displacements: self.displacements.clone(),
            warnings: progress.warnings,
            keys: self.scene.keys.clone(),
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

/// What frames a scene asks for.
fn frames_of(scene: &Scene) -> FramePlan {
    FramePlan {
        trajectory: scene.output.trajectory,
        has_links: scene.output.links,
    }
}

/// Times of the first samples in s.
fn sample_times(scene: &Scene, samples: u64) -> Vec<f64> {
    let time = |sample| scene.sample_step(sample) as f64 * scene.step;
    (0..samples).map(time).collect()
}
