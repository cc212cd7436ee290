//! The driving force that shears and presses, thesis eqs. (20)-(25).

use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// How the driving force is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Controller {
    /// The total force changes by the rate, in N/s, each step: along x by the sign of the missing
    /// speed, along y by the sign of the reaction above the target load.
    RateLimited {
        /// Rate of the total force in N/s, the same along x and y.
        force_rate: f64,
    },
    /// The constraints hold at once: the vertical force is the target load, and the horizontal one makes
    /// the mean acceleration of the driven particles zero, so that their mean velocity stays at the
    /// target; what it lacks, at first or by rounding, is made up within few steps (E59 of
    /// `docs/thesis/errata.md`).
    Exact,
}

/// Target speed and pressure of the driven particles.
///
/// $$ \frac{1}{N} \sum_i v_i^x = v, \qquad \sum_i F_i^y = -p A $$
///
/// Thesis eqs. (20)-(22). The second line is a sum, not a mean, and negative because compression of
/// the upper block points down (erratum E9 of the thesis). Each driven particle carries an equal share.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driving {
    /// How the force is found.
    pub controller: Controller,
    /// Target of the mean horizontal velocity in m/s.
    pub speed: f64,
    /// Target of the vertical pressure in Pa, downwards.
    pub pressure: f64,
    /// Area of the driven surface in m^2, eq. (24).
    pub area: f64,
}

/// What a controller sees of the driven particles.
#[derive(Clone, Copy, Debug)]
pub struct Driven<S> {
    /// Their number.
    pub number: S,
    /// Sum of their horizontal velocities in m/s.
    pub velocity: S,
    /// Mean of their horizontal velocities at the beginning of the step in m/s.
    pub known_velocity: S,
    /// Fraction of a missing speed that the exact controller makes up in a step.
    pub velocity_gain: f64,
    /// Sum of all other forces on them in N: the reaction.
    pub reaction: Vec2<S>,
    /// Sum of their inverse masses in 1/kg.
    pub inverse_mass: S,
    /// Sum of the horizontal accelerations that the other forces cause, in m/s^2.
    pub acceleration: S,
}

impl Driving {
    /// The next total driving force in N after `force`, for a step in s.
    #[inline]
    pub fn next_force<S: Real>(self, force: Vec2<S>, driven: &Driven<S>, step: f64) -> Vec2<S> {
        let load = S::from_f64(self.pressure * self.area);
        let missing_speed = S::from_f64(self.speed) - driven.velocity / driven.number;
        match self.controller {
            Controller::RateLimited { force_rate } => {
                let change = force_rate * step;
                let excess = driven.reaction.y - load;
                Vec2::new(
                    force.x + missing_speed.signum_or_one() * change,
                    force.y + excess.signum_or_one() * change,
                )
            }
            Controller::Exact => {
                let missing = S::from_f64(self.speed) - driven.known_velocity;
                let wanted = missing * driven.number * (driven.velocity_gain / step);
                let share = (wanted - driven.acceleration) / driven.inverse_mass;
                Vec2::new(share * driven.number, -load)
            }
        }
    }
}

/// Depth of the slice that the plane stands for: twice the mean radius in m, thesis eq. (25).
pub fn characteristic_length(radii: &[f64]) -> f64 {
    2.0 * radii.iter().sum::<f64>() / radii.len() as f64
}
