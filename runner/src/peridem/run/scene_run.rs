//! Runs a scene, with samples and checkpoints.

use super::super::Scene;
use super::balance::Balance;
use super::begin::{Built, checked};
use super::checkpoint::Checkpoint;
use super::mesh::Cells;
use super::samples::{self, Pieces};
use super::tables::local;
use super::{files, frame};
use crate::error::Error;
use crate::run::checkpoint::{UNFIT, refusal};
use crate::run::context::{RunContext, Sampled};
use crate::run::folder::{CHECKPOINT, SERIES, SUMMARY, remove_outputs};
use crate::run::growing::GrowingFiles;
use crate::run::series::Series;
use crate::run::{NamedPhase, Warning};
use crate::scene::Schedule;
use gouge_peridem::limits::Limits;
use gouge_peridem::world::World;
use std::ops::Range;

/// Number of steps between reports of progress.
const CHUNK: u64 = 50;
/// Largest difference between two Poisson's ratios that count as the same, such as 1/3 and 0.33.
const SAME_RATIO: f64 = 5e-3;
/// Name of the only phase.
const PHASE: &str = "run";

/// A run in progress.
pub struct SceneRun<'a> {
    pub(super) scene: &'a Scene,
    pub(super) context: RunContext<'a>,
    pub(super) world: World,
    pub(super) cells: Vec<Cells>,
    pub(super) limits: Limits,
    pub(super) files: Option<GrowingFiles>,
    /// Number of bonds at t = 0.
    pub(super) intact: usize,
    /// Number of bonds now.
    bonds: usize,
    /// Number of bonds, summed over all steps.
    pub(super) bond_steps: f64,
    pub(super) balance: Balance,
    pub(super) pieces: Pieces,
}

impl<'a> SceneRun<'a> {
    /// Begin a run; outputs of an earlier run are removed.
    ///
    /// # Errors
    /// A state that the kernel rejects, or a failure of the file system.
    pub fn begin(scene: &'a Scene, context: RunContext<'a>) -> Result<Self, Error> {
        let built = checked(scene)?;
        remove_outputs(&context.folder)?;
        let mut run = Self::new(scene, context, built);
        run.context.report_phase();
        run.doubt_beginning();
        // In this order, no output is ever without a checkpoint that tells what made it.
        run.write_checkpoint()?;
        run.files = Some(files::open(scene, &run.context, &run.world, None)?);
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
        let path = context.folder.join(CHECKPOINT);
        let unfit = || refusal(&path, UNFIT);
        let mut run = Self::new(scene, context, checked(scene)?);
        run.world = run.world.restored(&saved.state).ok_or_else(unfit)?;
        run.bonds = run.world.bonds().count();
        run.context.samples = saved.samples;
        run.context.warnings = saved.warnings;
        run.context.clock.earlier = saved.seconds;
        run.bond_steps = saved.bond_steps;
        run.balance = saved.balance;
        let bytes = run.without_early_sample(saved.bytes)?;
        run.files = Some(files::open(scene, &run.context, &run.world, Some(bytes))?);
        let _ = std::fs::remove_file(run.context.folder.join(SUMMARY));
        run.context.report_phase();
        Ok(run)
    }

    fn new(scene: &'a Scene, context: RunContext<'a>, built: Built) -> Self {
        Self {
            scene,
            context,
            intact: built.world.bonds().count(),
            bonds: built.world.bonds().count(),
            balance: Balance::new(&built.world),
            world: built.world,
            cells: built.cells,
            limits: built.limits,
            files: None,
            bond_steps: 0.0,
            pieces: Pieces::default(),
        }
    }

    /// Bytes of the files before an early sample, which is forgotten, if there is one.
    fn without_early_sample(&mut self, [series, breaks]: [u64; 2]) -> Result<[u64; 2], Error> {
        let (schedule, steps) = (self.scene.schedule(), self.world.state().steps);
        if !self.context.forget_early_sample(schedule, steps) {
            return Ok([series, breaks]);
        }
        let path = self.context.folder.join(SERIES);
        Ok([Series::without_last_row(&path, series)?, breaks])
    }

    /// Warn of a step above a limit, of grains without bonds, of grains that touch from the beginning, and of materials whose
    /// Poisson's ratio bonds do not have.
    fn doubt_beginning(&mut self) {
        let (scene, (meaning, bound)) = (self.scene, self.limits.smallest());
        if scene.step > bound {
            self.context.warn(Warning::TimeStep {
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
            self.context.warn(Warning::WithoutBonds(grain));
        }
        let energy = self.world.energies().contacts;
        if energy > 0.0 {
            self.context.warn(Warning::Touching(energy));
        }
        let reactions = self.world.reactions().into_iter();
        let force = reactions.map(|force| force.norm()).fold(0.0, f64::max);
        if force > 0.0 {
            self.context.warn(Warning::InWalls(force));
        }
        let used = |index: usize| scene.grains.iter().any(|grain| grain.material == index);
        for (_, material) in scene.materials.iter().enumerate().filter(|(k, _)| used(*k)) {
            let of_bonds = material.plane.poisson_ratio_of_bonds();
            if (material.poisson_ratio - of_bonds).abs() > SAME_RATIO {
                let of_contact = material.contact(&scene.bonds);
                self.context.warn(Warning::PoissonRatio {
                    material: &material.name,
                    given: material.poisson_ratio,
                    of_bonds,
                    young_modulus: of_contact.material.young_modulus_of_bonds(),
                });
            }
        }
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
        let files = self.files.as_mut();
        match files.and_then(|files| files.table.as_mut()) {
            Some(table) => table.append_rows(&rows),
            None => Ok(()),
        }
    }

    /// Stop if the observer wants it, or write a checkpoint if it is time. Samples read the forces on walls of the latest
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
            samples: self.context.samples,
            bytes,
            seconds: self.context.seconds(),
            bond_steps: self.bond_steps,
            balance: self.balance.clone(),
            warnings: self.context.warnings.clone(),
            keys: self.scene.keys.clone(),
            state: self.world.record(),
        };
        let path = self.context.folder.join(CHECKPOINT);
        checkpoint.write(&path, &self.context.fingerprint)?;
        self.context
            .report_checkpoint(&path, self.world.state().steps);
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
        while self.world.state().steps < last {
            self.pause()?;
            let until = last.min(self.world.state().steps + CHUNK);
            while self.world.state().steps < until {
                self.step()?;
            }
            self.context.report_progress(until);
        }
        Ok(())
    }

    fn sample(&mut self) -> Result<(), Error> {
        let (scene, world) = (self.scene, &self.world);
        let terms = scene.output.energy.then(|| self.balance.terms(world));
        if let Some(terms) = &terms {
            self.balance.add(world, scene.mode.beginning(), terms);
        }
        let pieces = self.pieces.count(world).iter().sum();
        let sample = samples::sample(scene, world, terms.as_ref(), (self.intact, pieces));
        self.context.lock.check()?;
        if let Some(files) = &mut self.files {
            let frame = || (frame::frame(scene, world, &self.cells), None);
            let motion = || frame::nodes(world);
            files.write(self.context.samples, &sample, frame, motion)?;
        }
        self.context.count_sample(world.time());
        Ok(())
    }
}

/// The only phase of a run.
pub fn phase(scene: &Scene) -> NamedPhase {
    NamedPhase {
        name: PHASE.to_owned(),
        steps: scene.schedule().steps(),
    }
}

/// The error of a run that a step stopped.
pub fn stopped(source: gouge_peridem::error::StepError) -> Error {
    Error::PeridemStep {
        phase: PHASE.to_owned(),
        source,
    }
}
