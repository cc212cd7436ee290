//! How time advances, thesis eqs. (55)-(62).

mod beeman;
mod euler;
mod taylor;
mod time_step;
mod velocity_verlet;

pub use time_step::{
    Oscillator, characteristic_polynomial, crack_bound, critical_step, is_stable, wave_bound,
};

pub(crate) use beeman::{beeman_correct, beeman_predict};
pub(crate) use euler::{euler, symplectic_euler};
pub(crate) use taylor::taylor;
pub(crate) use velocity_verlet::{half_kick, half_kick_and_drift, verlet_correct, verlet_predict};

use crate::forces::Forces;
use crate::geometry::Vec2;
use crate::particles::Particles;
use crate::scalar::Real;

/// Integration method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Explicit Euler, thesis eq. (55).
    Euler,
    /// Symplectic (semi-implicit) Euler.
    SymplecticEuler,
    /// Taylor expansion to second order, thesis eq. (56).
    Taylor,
    /// Velocity Verlet with predicted velocities.
    VelocityVerlet,
    /// Velocity Verlet with the velocities of half a step, as LAMMPS has it; for comparisons only.
    VelocityVerletHalfStep,
    /// Modified Beeman predictor-corrector, thesis eqs. (57)-(58).
    Beeman,
}

impl Integrator {
    /// Every method that a scene may sensibly choose.
    pub const ALL: [Self; 5] = [
        Self::Euler,
        Self::SymplecticEuler,
        Self::Taylor,
        Self::VelocityVerlet,
        Self::Beeman,
    ];

    /// Whether a step evaluates forces before it moves, and not after.
    pub fn evaluates_first(self) -> bool {
        matches!(self, Self::Euler | Self::SymplecticEuler | Self::Taylor)
    }
    /// Fraction of a missing speed that a force may make up in a step.
    ///
    /// All of it where the step multiplies the present acceleration by its full length. The others
    /// spread an acceleration over two steps and more; a quarter keeps the response damped:
    /// the error falls by a factor of 0.70 a step.
    pub fn haste(self) -> f64 {
        if self.evaluates_first() { 1.0 } else { 0.25 }
    }
    /// Whether accelerations of the previous evaluation are kept.
    pub fn needs_previous(self) -> bool {
        matches!(self, Self::VelocityVerlet | Self::Beeman)
    }
}

/// Accelerations of the previous evaluation.
#[derive(Clone, Debug)]
pub struct Previous<S> {
    /// Accelerations in m/s^2.
    pub linear: Vec<Vec2<S>>,
    /// Angular accelerations in rad/s^2.
    pub angular: Vec<S>,
    /// Accelerations one evaluation earlier, for the Beeman method only.
    pub older_linear: Vec<Vec2<S>>,
    /// Angular accelerations one evaluation earlier, for the Beeman method only.
    pub older_angular: Vec<S>,
    /// Whether they have been set.
    pub is_set: bool,
}

impl<S: Real> Previous<S> {
    /// None yet, for so many particles.
    pub fn new(integrator: Integrator, number: usize) -> Self {
        let older = if integrator == Integrator::Beeman {
            number
        } else {
            0
        };
        Self {
            linear: vec![Vec2::zero(); number],
            angular: vec![S::zero(); number],
            older_linear: vec![Vec2::zero(); older],
            older_angular: vec![S::zero(); older],
            is_set: false,
        }
    }
}

/// What an integrator may touch: it moves particles under given forces.
pub(crate) struct Motion<'a, S> {
    /// The particles.
    pub particles: &'a mut Particles<S>,
    /// Forces and torques on them.
    pub forces: &'a Forces<S>,
    /// Inverse masses in 1/kg, zero for fixed particles.
    pub inverse_mass: &'a [S],
    /// Inverse moments of inertia in 1/(kg m^2), zero for fixed particles.
    pub inverse_inertia: &'a [S],
}

impl<S: Real> Motion<'_, S> {
    /// Acceleration of particle `i` in m/s^2 and its angular acceleration in rad/s^2, thesis eq. (51).
    #[inline(always)]
    fn acceleration(&self, i: usize) -> (Vec2<S>, S) {
        (
            self.forces.force[i] * self.inverse_mass[i],
            self.forces.torque[i] * self.inverse_inertia[i],
        )
    }
}
