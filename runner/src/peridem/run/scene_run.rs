//! Runs a scene, with samples and checkpoints.

use super::super::Scene;
use super::begin::{Built, checked};
use super::checkpoint::Checkpoint;
use super::files::Files;
use super::mesh::Cells;
use super::samples::{self, Balance, Pieces};
use super::tables::local;
use crate::error::Error;
use crate::run::checkpoint::{UNFIT, refusal};
use crate::run::clock::Clock;
use crate::run::fingerprint::Fingerprint;
use crate::run::folder::{CHECKPOINT, SERIES, SUMMARY, remove_outputs};
use crate::run::lock::Lock;
use crate::run::series::Series;
use crate::run::{Event, NamedPhase, Observer, RunOptions, Warning};
use gouge_peridem::limits::Limits;
use gouge_peridem::world::World;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Number of steps between reports of progress.
const CHUNK: u64 = 50;
/// Largest difference between two Poisson's ratios that count as the same, such as 1/3 and 0.33.
const SAME_RATIO: f64 = 5e-3;
/// The only phase.
pub const PHASE: &str = "run";

/// A run in progress.
pub struct SceneRun<'a> {
    pub(super) scene: &'a Scene,
    pub(super) options: RunOptions,
    pub(super) observer: &'a mut dyn Observer,
    pub(super) folder: PathBuf,
    pub(super) lock: &'a Lock,
    pub(super) world: World,
    pub(super) cells: Vec<Cells>,
    pub(super) limits: Limits,
    pub(super) files: Option<Files>,
    pub(super) samples: u64,
    /// Number of bonds at t = 0.
    pub(super) intact: usize,
    /// Number of bonds now.
    bonds: usize,
    /// Number of bonds, summed over all steps.
    pub(super) bond_steps: f64,
    pub(super) balance: Balance,
    pub(super) pieces: Pieces,
    pub(super) warnings: String,
    phases: [NamedPhase; 1],
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
        let built = checked(scene)?;
        remove_outputs(place.0)?;
        let mut run = Self::new(scene, place, options, observer, built);
        run.report_phase();
        run.doubt_beginning();
        // In this order, no output is ever without a checkpoint that tells what made it.
        run.write_checkpoint()?;
        run.files = Some(Files::open(scene, place.0, options, &run.world, (0, None))?);
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
        let mut run = Self::new(scene, place, options, observer, checked(scene)?);
        run.world = run.world.restored(&saved.state).ok_or_else(unfit)?;
        run.bonds = run.world.bonds().count();
        run.samples = saved.samples;
        run.bond_steps = saved.bond_steps;
        run.balance = saved.balance;
        run.warnings = saved.warnings;
        run.clock.earlier = saved.seconds;
        let bytes = run.without_early_sample(saved.bytes)?;
        let written = (run.samples, Some(bytes));
        run.files = Some(Files::open(scene, place.0, options, &run.world, written)?);
        let _ = std::fs::remove_file(place.0.join(SUMMARY));
        run.report_phase();
        Ok(run)
    }

    fn new(
        scene: &'a Scene,
        (folder, lock): (&Path, &'a Lock),
        options: RunOptions,
        observer: &'a mut dyn Observer,
        built: Built,
    ) -> Self {
        Self {
            scene,
            options,
            observer,
            folder: folder.to_owned(),
            lock,
            intact: built.world.bonds().count(),
            bonds: built.world.bonds().count(),
            balance: Balance::new(&built.world),
            world: built.world,
            cells: built.cells,
            limits: built.limits,
            files: None,
            samples: 0,
            bond_steps: 0.0,
            pieces: Pieces::default(),
            warnings: String::new(),
            phases: [NamedPhase {
                name: PHASE.to_owned(),
                steps: scene.schedule().steps(),
            }],
            fingerprint: Fingerprint::of(scene),
            clock: Clock::start(),
        }
    }

    /// The last sample of a run that ends before a regular sample is due is early. A longer run does not take it: forget
    /// it, and return the bytes of the files before it.
    fn without_early_sample(&mut self, [series, breaks]: [u64; 2]) -> Result<[u64; 2], Error> {
        let schedule = self.scene.schedule();
        let is_early = |last| schedule.regular_sample_step(last) > self.world.state().steps;
        if !self.samples.checked_sub(1).is_some_and(is_early) {
            return Ok([series, breaks]);
        }
        self.samples -= 1;
        let before = Series::without_last_row(&self.folder.join(SERIES), series)?;
        Ok([before, breaks])
    }

    fn report_phase(&mut self) {
        self.observer.event(Event::PhaseBegan {
            phases: &self.phases,
            index: 0,
        });
    }

    /// Warn of a step above a limit, of grains without bonds, of grains that touch from the beginning, and of materials whose
    /// Poisson's ratio bonds do not have.
    fn doubt_beginning(&mut self) {
        let (scene, (meaning, bound)) = (self.scene, self.limits.smallest());
        if scene.step > bound {
            self.warn(Warning::TimeStep {
                scene: &scene.file,
                phase: PHASE,
                step: scene.step,
                bound,
                meaning,
            });
        }
        let rows = self.world.grains().rows.iter();
        let has_none = |nodes: Range<usize>| self.world.bonds().count_of(nodes) == 0;
        if let Some(grain) = rows.clone().position(|row| has_none(row.nodes.clone())) {
            self.warn(Warning::WithoutBonds(grain));
        }
        let energy = self.world.energies().contacts;
        if energy > 0.0 {
            self.warn(Warning::Touching(energy));
        }
        let used = |index: usize| scene.grains.iter().any(|grain| grain.material == index);
        for (_, material) in scene.materials.iter().enumerate().filter(|(k, _)| used(*k)) {
            let of_bonds = material.plane.poisson_ratio_of_bonds();
            if (material.poisson_ratio - of_bonds).abs() > SAME_RATIO {
                let of_contact = material.contact(&scene.bonds);
                self.warn(Warning::PoissonRatio {
                    material: &material.name,
                    given: material.poisson_ratio,
                    of_bonds,
                    young_modulus: of_contact.material.young_modulus_of_bonds(),
                });
            }
        }
    }

    /// Run all remaining steps.
    pub(super) fn run_to_end(&mut self) -> Result<(), Error> {
        self.clock.begin_main();
        let schedule = self.scene.schedule();
        let last = schedule.steps();
        loop {
            let due = schedule.sample_step(self.samples);
            self.advance_to(due)?;
            // The last step is always sampled, but only once.
            let is_extra =
                due == last && self.samples > 0 && schedule.sample_step(self.samples - 1) >= last;
            if !is_extra {
                self.sample()?;
            }
            if due == last {
                return Ok(());
            }
        }
    }

    fn advance_to(&mut self, last: u64) -> Result<(), Error> {
        while self.world.state().steps < last {
            self.pause()?;
            let until = last.min(self.world.state().steps + CHUNK);
            while self.world.state().steps < until {
                self.step()?;
            }
            self.observer.event(Event::Progress {
                phase: 0,
                steps: until,
            });
        }
        Ok(())
    }

    fn step(&mut self) -> Result<(), Error> {
        self.world.step().map_err(stopped)?;
        self.bonds -= self.world.broken().len();
        self.bond_steps += self.bonds as f64;
        if self.world.broken().is_empty() {
            return Ok(());
        }
        let (steps, time) = (self.world.state().steps, self.world.time());
        let row = |pair: &gouge_common::pair::Pair| {
            let (i, j) = pair.indices();
            let grain = self.world.grains().grain_of[j];
            let [i, j] = [i, j].map(|node| local(&self.world, node));
            vec![
                steps.to_string(),
                format!("{time:?}"),
                grain.to_string(),
                i.to_string(),
                j.to_string(),
            ]
        };
        let rows: Vec<Vec<String>> = self.world.broken().iter().map(row).collect();
        match &mut self.files {
            Some(files) => files.write_breaks(&rows),
            None => Ok(()),
        }
    }

    /// Report a problem, and keep it for the summary.
    pub(super) fn warn(&mut self, warning: Warning) {
        self.warnings += &format!("{warning}\n");
        self.observer.event(Event::Warning(warning));
    }

    /// Stop if the observer wants it, or write a checkpoint if it is time. Samples read the forces on walls of the latest
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
        let terms = scene.output.energy.then(|| self.balance.terms(world));
        if let Some(terms) = &terms {
            self.balance.add(terms);
        }
        let pieces = self.pieces.count(world).iter().sum();
        let sample = samples::sample(scene, world, terms.as_ref(), (self.intact, pieces));
        self.lock.check()?;
        if let Some(files) = &mut self.files {
            files.write(scene, (world, &self.cells), self.samples, &sample)?;
        }
        self.observer.event(Event::SampleWritten {
            sample: self.samples,
            time: world.time(),
        });
        self.samples += 1;
        Ok(())
    }

    /// Wall time so far in s: of the whole run and of its steps.
    pub(super) fn seconds(&self) -> [f64; 2] {
        self.clock.seconds(true)
    }

    /// Write the current state as a checkpoint.
    pub(super) fn write_checkpoint(&mut self) -> Result<(), Error> {
        self.lock.check()?;
        let bytes = match &mut self.files {
            Some(files) => files.sync()?,
            None => [0; 2],
        };
        let checkpoint = Checkpoint {
            samples: self.samples,
            bytes,
            seconds: self.seconds(),
            bond_steps: self.bond_steps,
            balance: self.balance,
            warnings: self.warnings.clone(),
            keys: self.scene.keys.clone(),
            state: self.world.record(),
        };
        let path = self.folder.join(CHECKPOINT);
        checkpoint.write(&path, &self.fingerprint)?;
        self.clock.save();
        self.observer.event(Event::CheckpointWritten {
            path: &path,
            steps: self.world.state().steps,
        });
        Ok(())
    }
}

/// The error of a run that a step stopped.
pub fn stopped(source: gouge_peridem::error::StepError) -> Error {
    Error::PeridemStep {
        phase: PHASE.to_owned(),
        source,
    }
}
