//! The driving force, which shears and compresses, thesis eqs. (20)-(25).

use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// How the driving force is determined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Controller {
    /// In each step, each component of the total force changes by `force_rate` times the time step.
    ///
    /// The horizontal force increases while the mean velocity is below the target, and decreases otherwise. The
    /// vertical force increases while the reaction exceeds the target load, and decreases otherwise.
    RateLimited {
        /// Rate of change of the total force in N/s, the same along x and y.
        force_rate: f64,
    },
    /// The vertical force equals the target load. The horizontal force makes the mean acceleration of the driven
    /// particles zero, so that their mean velocity stays at the target. A deviation from the target velocity, initial
    /// or by rounding, is corrected within a few steps (E59 of `docs/thesis/errata.md`).
    Exact,
    /// The driven particles move with a constant velocity and do not rotate, whatever acts on them. The force is what
    /// that takes: minus the reaction.
    Steady {
        /// The velocity in m/s.
        velocity: Vec2,
    },
}

/// Target velocity and pressure of the driven particles.
///
/// # Equation
/// Thesis eqs. (20)-(22):
///
/// $$ \frac{1}{N} \sum_i v_i^x = v, \qquad \sum_i F_i^y = -p A $$
///
/// # Symbols
/// The sums run over the $N$ driven particles, which carry equal shares of the total driving force; $v$ is `speed` in
/// m/s, $p$ `pressure` in Pa and $A$ `area` in m^2.
///
/// # Sign
/// A positive pressure pushes down. The vertical forces are summed, not averaged (erratum E9 of the thesis).
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driving {
    /// How the force is determined.
    pub controller: Controller,
    /// Target mean horizontal velocity in m/s; not used if the velocity is prescribed.
    pub speed: f64,
    /// Target vertical pressure in Pa, positive downwards; not used if the velocity is prescribed.
    pub pressure: f64,
    /// Area of the driven surface in m^2, eq. (24).
    pub area: f64,
}

/// State of the driven particles, as the controller reads it.
#[derive(Clone, Copy, Debug)]
pub struct Driven<S> {
    /// Number of driven particles.
    pub number: S,
    /// Sum of the horizontal velocities in m/s.
    pub velocity_sum: S,
    /// Mean horizontal velocity in m/s at the beginning of the step.
    pub velocity_at_step_start: S,
    /// Fraction of the velocity error that the exact controller corrects per step.
    pub velocity_gain: f64,
    /// Reaction: sum of all other forces on the driven particles in N.
    pub reaction: Vec2<S>,
    /// Sum of the inverse masses in 1/kg.
    pub inverse_mass_sum: S,
    /// Sum of the horizontal accelerations due to all other forces, in m/s^2.
    pub acceleration_sum: S,
}

impl Driving {
    /// The velocity in m/s that the driven particles keep, if it is prescribed.
    pub fn prescribed_velocity(&self) -> Option<Vec2> {
        match self.controller {
            Controller::Steady { velocity } => Some(velocity),
            Controller::RateLimited { .. } | Controller::Exact => None,
        }
    }

    /// Whether the force follows from the present state alone.
    pub(crate) fn is_instantaneous(&self) -> bool {
        !matches!(self.controller, Controller::RateLimited { .. })
    }

    /// Total driving force in N for the next step; `force` is that of the present one, `step` the time step in s.
    #[inline]
    pub fn next_force<S: Real>(self, force: Vec2<S>, driven: &Driven<S>, step: f64) -> Vec2<S> {
        let load = S::from_f64(self.pressure * self.area);
        let velocity_error = S::from_f64(self.speed) - driven.velocity_sum / driven.number;
        match self.controller {
            Controller::RateLimited { force_rate } => {
                let change = force_rate * step;
                let excess = driven.reaction.y - load;
                Vec2::new(
                    force.x + velocity_error.signum_or_one() * change,
                    force.y + excess.signum_or_one() * change,
                )
            }
            Controller::Exact => {
                let velocity_error = S::from_f64(self.speed) - driven.velocity_at_step_start;
                let target_acceleration =
                    velocity_error * driven.number * (driven.velocity_gain / step);
                let share =
                    (target_acceleration - driven.acceleration_sum) / driven.inverse_mass_sum;
                Vec2::new(share * driven.number, -load)
            }
            Controller::Steady { .. } => -driven.reaction,
        }
    }
}

/// Thickness of the slice that the plane represents: twice the mean radius in m, thesis eq. (25).
pub fn characteristic_length(radii: &[f64]) -> f64 {
    2.0 * radii.iter().sum::<f64>() / radii.len() as f64
}
