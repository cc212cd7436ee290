//! The solver of a step.

use super::changes::Changes;
use super::iteration::{Iteration, SweepReport};
use super::momentum::{Momentum, Sequence};
use super::places::Places;
use super::plain::{Plain, largest_residual};
use super::strips::Strips;
use super::unit::{MovingUnit, gather, scatter};
use super::{ContactInput, Row, SweepOrder, SweepSettings};
use crate::law::ContactLaw;
use crate::local::Components;
use crate::units::{InverseMass, Velocity};

/// The contact points of a step with their impulses. Its buffers are reused from step to step.
#[derive(Clone, Debug, Default)]
pub struct Solver {
    rows: Vec<Row>,
    units: Vec<MovingUnit>,
    momentum: Momentum,
    friction: f64,
    places: Places,
    strips: Strips,
    threads: usize,
    is_by_strips: bool,
}

impl Solver {
    /// A solver without points.
    pub fn new() -> Self {
        Self::default()
    }

    /// Take the horizontal places of all units in m, and the period if x is periodic, for [`SweepOrder::Strips`].
    ///
    /// The place of a unit that is not in one place, such as a wall, is not a number. Places are kept until they are
    /// replaced; they change the order of the points, and nothing else.
    pub fn set_places(&mut self, x: impl Iterator<Item = f64>, period: Option<f64>) {
        self.places.x.clear();
        self.places.x.extend(x);
        self.places.period = period;
    }

    /// Divide sweeps by strips among the threads of the pool in use if `threads` is more than one. The bits of the
    /// results do not depend on it.
    pub fn set_threads(&mut self, threads: usize) {
        self.threads = threads;
    }

    /// Take the points of a step, with the velocities before the step.
    pub fn prepare(
        &mut self,
        points: &[ContactInput],
        law: &ContactLaw,
        time_step: f64,
        before: &[Velocity],
        inverse_masses: &[InverseMass],
    ) {
        self.rows.clear();
        self.friction = law.friction;
        let row = |point| Row::new(point, law, time_step, before, inverse_masses);
        self.rows.extend(points.iter().map(row));
    }

    /// The points with their impulses, in the order in which they were given.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Find the impulses.
    ///
    /// `velocities` come in with the external impulses but without those of contacts, and go out with both. The first
    /// guesses of the impulses are applied before the first sweep.
    pub fn solve(
        &mut self,
        settings: &SweepSettings,
        inverse_masses: &[InverseMass],
        velocities: &mut [Velocity],
    ) -> SweepReport {
        for row in &mut self.rows {
            if self.friction == 0.0 {
                row.impulse.t = 0.0;
            }
            row.kinematics
                .apply(row.impulse, inverse_masses, velocities);
        }
        let iteration = Iteration {
            settings,
            friction: self.friction,
            mean: self.mean_normal_impulse(),
        };
        self.is_by_strips = settings.order == SweepOrder::Strips
            && self
                .strips
                .gather(&self.rows, &self.places, velocities, inverse_masses);
        let mut report = match self.is_by_strips {
            true => {
                let report = self.strips.solve(iteration, self.threads);
                self.strips.scatter(&mut self.rows, velocities);
                report
            }
            false => self.sweep_plainly(iteration, inverse_masses, velocities),
        };
        let is_doubtful = |row: &&Row| !row.status.is_unique();
        report.not_unique = self.rows.iter().filter(is_doubtful).count();
        report
    }

    fn sweep_plainly(
        &mut self,
        iteration: Iteration<'_>,
        inverse_masses: &[InverseMass],
        velocities: &mut [Velocity],
    ) -> SweepReport {
        gather(&mut self.units, velocities, inverse_masses);
        let report = iteration.run(&mut Plain {
            rows: &mut self.rows,
            units: &mut self.units,
            momentum: &mut self.momentum,
            velocities,
            sequence: Sequence::default(),
        });
        scatter(&self.units, velocities);
        report
    }

    fn mean_normal_impulse(&self) -> f64 {
        let mut changes = Changes::default();
        for row in &self.rows {
            changes.add::<false>(Components::default(), row.impulse, 0.0);
        }
        changes.mean()
    }

    /// Number of strips in which the latest step was solved; zero if it was solved in another order.
    pub fn strips(&self) -> usize {
        match self.is_by_strips {
            true => self.strips.number(),
            false => 0,
        }
    }

    /// Largest residual of the laws over all points in m/s (natural map), zero exactly for a solution.
    pub fn residual(&self, velocities: &[Velocity]) -> f64 {
        largest_residual(&self.rows, self.friction, velocities)
    }
}
