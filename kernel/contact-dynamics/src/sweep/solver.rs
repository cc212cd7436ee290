//! The sweeps.

use super::residual::natural_map;
use super::{ContactInput, Row, Rule, StopCriterion, SweepOrder, SweepSettings};
use crate::law::ContactLaw;
use crate::local::{Components, ExactRule, LocalRule, PaperRule};
use crate::units::{InverseMass, Velocity};

/// The contact points of a step with their impulses. Its buffers are reused from step to step.
#[derive(Clone, Debug, Default)]
pub struct Solver {
    rows: Vec<Row>,
}

/// What the sweeps of a step did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SweepReport {
    /// Number of sweeps.
    pub sweeps: usize,
    /// Whether the stop criterion was met.
    pub has_converged: bool,
    /// Number of points whose local problem had no solution or several in the last sweep.
    pub not_unique: usize,
}

/// Changes during one sweep.
#[derive(Clone, Copy, Debug, Default)]
struct Changes {
    largest: f64,
    largest_relative: f64,
    sum: f64,
    positive: usize,
}

impl Solver {
    /// A solver without points.
    pub fn new() -> Self {
        Self::default()
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
        for row in &self.rows {
            row.kinematics
                .apply(row.impulse, inverse_masses, velocities);
        }
        match settings.rule {
            Rule::Exact => self.iterate(ExactRule, settings, inverse_masses, velocities),
            Rule::Paper => self.iterate(PaperRule, settings, inverse_masses, velocities),
        }
    }

    fn iterate<R: LocalRule>(
        &mut self,
        rule: R,
        settings: &SweepSettings,
        inverse_masses: &[InverseMass],
        velocities: &mut [Velocity],
    ) -> SweepReport {
        let mut report = SweepReport::default();
        let mut mean = self.mean_normal_impulse();
        while report.sweeps < settings.max_sweeps && !report.has_converged {
            let is_backward = settings.order == SweepOrder::Alternating && report.sweeps % 2 == 1;
            let floor = match settings.stop {
                StopCriterion::Relative { floor, .. } => floor * mean,
                _ => 0.0,
            };
            let mut changes = Changes::default();
            let mut visit = |row: &mut Row| {
                let change = row.update(rule, inverse_masses, velocities);
                changes.add(change, row.impulse, floor);
            };
            if is_backward {
                self.rows.iter_mut().rev().for_each(&mut visit);
            } else {
                self.rows.iter_mut().for_each(&mut visit);
            }
            report.sweeps += 1;
            mean = changes.mean();
            report.has_converged = self.has_converged(&changes, settings.stop, velocities);
        }
        let is_doubtful = |row: &&Row| !row.status.is_unique();
        report.not_unique = self.rows.iter().filter(is_doubtful).count();
        report
    }

    fn has_converged(
        &self,
        changes: &Changes,
        stop: StopCriterion,
        velocities: &[Velocity],
    ) -> bool {
        match stop {
            StopCriterion::Increment { tolerance, floor } => {
                changes.largest <= tolerance * changes.mean().max(floor)
            }
            StopCriterion::Relative { tolerance, .. } => changes.largest_relative <= tolerance,
            StopCriterion::NaturalMap { velocity } => self.residual(velocities) <= velocity,
        }
    }

    fn mean_normal_impulse(&self) -> f64 {
        let mut changes = Changes::default();
        for row in &self.rows {
            changes.add(Components::default(), row.impulse, 0.0);
        }
        changes.mean()
    }

    /// Largest residual of the laws over all points in m/s (natural map), zero exactly for a solution.
    pub fn residual(&self, velocities: &[Velocity]) -> f64 {
        let larger = |largest: f64, row| {
            let residual = natural_map(row, velocities);
            if residual > largest || residual.is_nan() {
                residual
            } else {
                largest
            }
        };
        self.rows.iter().fold(0.0, larger)
    }
}

impl Changes {
    #[inline]
    fn add(&mut self, change: Components, impulse: Components, floor: f64) {
        let size = change.n.abs().max(change.t.abs());
        self.largest = self.largest.max(size);
        if size > 0.0 {
            let reference = impulse.n.abs().max(impulse.t.abs()).max(floor);
            self.largest_relative = self.largest_relative.max(size / reference);
        }
        if impulse.n > 0.0 {
            self.sum += impulse.n;
            self.positive += 1;
        }
    }

    fn mean(&self) -> f64 {
        self.sum / self.positive.max(1) as f64
    }
}
