//! Sweep after sweep until the impulses have converged.

use super::changes::Changes;
use super::visit::Visit;
use super::{StopCriterion, SweepOrder, SweepSettings};

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

/// Points and units in some order.
pub(super) trait Sweeping {
    /// Begin with momentum, without a history.
    fn begin_momentum(&mut self);
    /// Extrapolate after a pair of sweeps.
    fn extrapolate(&mut self, largest: f64);
    /// Visit all points once.
    fn sweep(&mut self, visit: Visit) -> Changes;
    /// Largest residual of the laws in m/s.
    fn residual(&mut self, friction: f64) -> f64;
}

/// How the sweeps of a step go.
#[derive(Clone, Copy, Debug)]
pub(super) struct Iteration<'a> {
    pub settings: &'a SweepSettings,
    pub friction: f64,
    /// Mean positive normal impulse of the first guesses in kg m/s.
    pub mean: f64,
}

impl Iteration<'_> {
    /// Sweep until the stop criterion is met. Points without a unique solution are not counted.
    pub fn run(self, system: &mut impl Sweeping) -> SweepReport {
        let settings = self.settings;
        let mut report = SweepReport::default();
        let mut mean = self.mean;
        if settings.momentum > 0.0 {
            system.begin_momentum();
        }
        while report.sweeps < settings.max_sweeps && !report.has_converged {
            let is_odd = report.sweeps % 2 == 1;
            if settings.momentum > 0.0 && report.sweeps > 0 && !is_odd {
                system.extrapolate(settings.momentum);
            }
            let floor = match settings.stop {
                StopCriterion::Relative { floor, .. } => Some(floor * mean),
                _ => None,
            };
            let changes = system.sweep(Visit {
                rule: settings.rule,
                friction: self.friction,
                floor,
                is_backward: settings.order != SweepOrder::Forward && is_odd,
            });
            report.sweeps += 1;
            mean = changes.mean();
            report.has_converged = match settings.stop {
                StopCriterion::NaturalMap { velocity } => {
                    system.residual(self.friction) <= velocity
                }
                stop => changes.are_small(stop) && self.is_near(system),
            };
        }
        report
    }

    /// Whether the residual of the present state is small enough; it is evaluated only if that is asked for.
    fn is_near(self, system: &mut impl Sweeping) -> bool {
        let largest = self.settings.largest_residual;
        largest.is_none_or(|largest| system.residual(self.friction) <= largest)
    }
}
