//! A system with all that a step needs.

use crate::assembly::Assembly;
use crate::cell::{Cell, Drive, Settling, roof_height};
use crate::error::{SetupError, StepError};
use crate::step::{State, StepReport, StepSettings, Workspace, step};
use crate::work::Work;

/// A system that steps: bodies and walls, how a step goes, what drives it, and its state.
#[derive(Clone, Debug)]
pub struct World {
    pub(crate) assembly: Assembly,
    pub(crate) settings: StepSettings,
    pub(crate) drive: Option<Drive>,
    pub(crate) state: State,
    pub(crate) steps: u64,
    pub(crate) work: Option<Work>,
    pub(crate) settling: Settling,
    pub(crate) workspace: Workspace,
    pub(crate) threads: usize,
}

impl World {
    /// A system of bodies and walls that nothing drives.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a setting outside its range.
    pub fn new(
        assembly: Assembly,
        state: State,
        settings: StepSettings,
    ) -> Result<Self, SetupError> {
        settings.validate()?;
        let workspace = Workspace::new(&assembly, &state, &settings);
        Ok(Self {
            assembly,
            settings,
            drive: None,
            state,
            steps: 0,
            work: None,
            settling: Settling::default(),
            workspace,
            threads: 1,
        })
    }

    /// A cell between walls that are driven.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a setting outside its range.
    pub fn of_cell(cell: Cell, settings: StepSettings, drive: Drive) -> Result<Self, SetupError> {
        drive.validate()?;
        let settling = Settling::from_height(cell.height());
        let mut world = Self::new(cell.assembly, cell.state, settings)?;
        (world.drive, world.settling) = (Some(drive), settling);
        Ok(world)
    }

    /// Whether every step books its work.
    #[must_use]
    pub fn with_work(mut self, is_booked: bool) -> Self {
        self.work = is_booked.then(Work::default);
        self
    }

    /// The same world, whose sweeps by strips are divided among the threads of the pool in use if there is more than one
    /// ([`SweepOrder::Strips`](crate::sweep::SweepOrder)). The bits of the results do not depend on it.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.threads = threads;
        self.workspace.set_threads(threads);
        self
    }

    /// Advance by one step.
    ///
    /// # Errors
    /// [`StepError`] if the state is no longer finite, or a body moves too fast for the step.
    pub fn step(&mut self) -> Result<StepReport, StepError> {
        if let Some(drive) = &self.drive {
            drive.before_step(&mut self.assembly, &mut self.state);
        }
        let (assembly, settings) = (&self.assembly, &self.settings);
        let report = step(assembly, settings, &mut self.state, &mut self.workspace);
        if let Some(work) = &mut self.work {
            let done = Work::of_step(assembly, settings, &self.state, &self.workspace);
            *work = work.plus(&done);
        }
        self.steps += 1;
        self.check()?;
        if let Some(drive) = &self.drive {
            drive.after_step(&mut self.state);
            let height = roof_height(&self.state);
            self.settling.follow(drive, self.steps, height);
        }
        Ok(report)
    }

    fn check(&self) -> Result<(), StepError> {
        let configuration = &self.state.configuration;
        let (time, steps) = (self.time(), self.steps);
        for (unit, velocity) in configuration.velocity.iter().enumerate() {
            let sum = velocity.linear.x + velocity.linear.y + velocity.angular;
            if !sum.is_finite() {
                return Err(StepError::NotFinite { unit, time, steps });
            }
        }
        for (body, &unit) in self.assembly.unit.iter().enumerate() {
            let speed = configuration.velocity[unit as usize].linear.norm();
            let distance = speed * self.settings.time_step;
            let limit = self.diameter(body);
            if distance > limit && self.is_free(unit) {
                return Err(StepError::TooFast {
                    body,
                    distance,
                    limit,
                    time,
                });
            }
        }
        Ok(())
    }

    fn is_free(&self, unit: u32) -> bool {
        self.assembly.inverse_mass[unit as usize].rotation > 0.0
    }

    fn diameter(&self, body: usize) -> f64 {
        let shape = self.assembly.shapes.outline(self.assembly.shape[body]);
        2.0 * shape.measures.circumradius * self.assembly.scale[body]
    }

    /// Bodies and walls.
    pub fn assembly(&self) -> &Assembly {
        &self.assembly
    }

    /// How a step goes.
    pub fn settings(&self) -> &StepSettings {
        &self.settings
    }

    /// What drives the system, if anything does.
    pub fn drive(&self) -> Option<&Drive> {
        self.drive.as_ref()
    }

    /// The state.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Contact points of the latest step.
    pub fn workspace(&self) -> &Workspace {
        &self.workspace
    }

    /// Number of steps since the beginning.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Time in s: the number of steps times the time step.
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.settings.time_step
    }

    /// Work since the beginning, if it is booked.
    pub fn work(&self) -> Option<&Work> {
        self.work.as_ref()
    }

    /// Kinetic energy in J of all motion that is not imposed.
    pub fn kinetic_energy(&self) -> f64 {
        self.assembly.kinetic_energy(&self.state.configuration)
    }

    /// Whether a compaction has come to an end.
    pub fn has_settled(&self) -> bool {
        self.settling.is_settled
    }

    /// The cell in its present state, without what drives it.
    pub fn into_cell(self) -> Cell {
        Cell {
            assembly: self.assembly,
            state: self.state,
        }
    }
}
