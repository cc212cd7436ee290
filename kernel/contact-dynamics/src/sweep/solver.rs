//! The sweeps.

use super::changes::Changes;
use super::momentum::Momentum;
use super::residual::natural_map;
use super::unit::{MovingUnit, gather, scatter};
use super::{ContactInput, Row, Rule, StopCriterion, SweepOrder, SweepSettings};
use crate::law::ContactLaw;
use crate::local::{Components, ExactRule, FrictionlessRule, LocalRule, PaperRule};
use crate::units::{InverseMass, Velocity};

/// The contact points of a step with their impulses. Its buffers are reused from step to step.
#[derive(Clone, Debug, Default)]
pub struct Solver {
    rows: Vec<Row>,
    units: Vec<MovingUnit>,
    momentum: Momentum,
    friction: f64,
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
        gather(&mut self.units, velocities, inverse_masses);
        match settings.rule {
            Rule::Exact if self.friction == 0.0 => {
                self.iterate(FrictionlessRule, settings, velocities)
            }
            Rule::Exact => self.iterate(ExactRule, settings, velocities),
            Rule::Paper => self.iterate(PaperRule, settings, velocities),
        }
    }

    fn iterate<R: LocalRule>(
        &mut self,
        rule: R,
        settings: &SweepSettings,
        velocities: &mut [Velocity],
    ) -> SweepReport {
        let mut report = SweepReport::default();
        let mut mean = self.mean_normal_impulse();
        if settings.momentum > 0.0 {
            self.momentum.begin(&self.rows, &self.units);
        }
        while report.sweeps < settings.max_sweeps && !report.has_converged {
            let is_odd = report.sweeps % 2 == 1;
            if settings.momentum > 0.0 && report.sweeps > 0 && !is_odd {
                let (rows, units) = (&mut self.rows, &mut self.units);
                self.momentum.extrapolate(settings.momentum, rows, units);
            }
            let is_backward = settings.order == SweepOrder::Alternating && is_odd;
            let changes = self.sweep(rule, settings, is_backward, mean);
            report.sweeps += 1;
            mean = changes.mean();
            report.has_converged = match settings.stop {
                StopCriterion::NaturalMap { velocity } => {
                    scatter(&self.units, velocities);
                    self.residual(velocities) <= velocity
                }
                stop => changes.are_small(stop) && self.is_near(settings, velocities),
            };
        }
        scatter(&self.units, velocities);
        let is_doubtful = |row: &&Row| !row.status.is_unique();
        report.not_unique = self.rows.iter().filter(is_doubtful).count();
        report
    }

    /// Whether the residual of the present state is small enough; it is evaluated only if that is asked for.
    fn is_near(&self, settings: &SweepSettings, velocities: &mut [Velocity]) -> bool {
        let Some(largest) = settings.largest_residual else {
            return true;
        };
        scatter(&self.units, velocities);
        self.residual(velocities) <= largest
    }

    /// Visit all points once. `mean` is the mean normal impulse.
    fn sweep<R: LocalRule>(
        &mut self,
        rule: R,
        settings: &SweepSettings,
        is_backward: bool,
        mean: f64,
    ) -> Changes {
        let mut visits = Visits {
            rule,
            friction: self.friction,
            floor: 0.0,
            units: &mut self.units,
        };
        let rows = self.rows.as_mut_slice();
        match settings.stop {
            StopCriterion::Relative { floor, .. } => {
                visits.floor = floor * mean;
                visits.run_all::<true>(rows, is_backward)
            }
            _ => visits.run_all::<false>(rows, is_backward),
        }
    }

    fn mean_normal_impulse(&self) -> f64 {
        let mut changes = Changes::default();
        for row in &self.rows {
            changes.add::<false>(Components::default(), row.impulse, 0.0);
        }
        changes.mean()
    }

    /// Largest residual of the laws over all points in m/s (natural map), zero exactly for a solution.
    pub fn residual(&self, velocities: &[Velocity]) -> f64 {
        let larger = |largest: f64, row| {
            let residual = natural_map(row, self.friction, velocities);
            if residual > largest || residual.is_nan() {
                residual
            } else {
                largest
            }
        };
        self.rows.iter().fold(0.0, larger)
    }
}

/// What all visits of a sweep share.
struct Visits<'a, R> {
    rule: R,
    friction: f64,
    /// Smallest denominator of relative changes.
    floor: f64,
    units: &'a mut [MovingUnit],
}

impl<R: LocalRule> Visits<'_, R> {
    fn run_all<const IS_RELATIVE: bool>(self, rows: &mut [Row], is_backward: bool) -> Changes {
        match is_backward {
            false => self.run::<IS_RELATIVE>(rows.iter_mut()),
            true => self.run::<IS_RELATIVE>(rows.iter_mut().rev()),
        }
    }

    #[inline(never)]
    fn run<'a, const IS_RELATIVE: bool>(self, rows: impl Iterator<Item = &'a mut Row>) -> Changes {
        let mut changes = Changes::default();
        let (friction, floor) = (self.friction, self.floor);
        for row in rows {
            let change = row.update(self.rule, friction, self.units);
            changes.add::<IS_RELATIVE>(change, row.impulse(), floor);
        }
        changes
    }
}
