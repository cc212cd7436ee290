//! How time advances, thesis eqs. (55)-(62).

mod beeman;
mod euler;
mod taylor;
mod time_step;
mod velocity_verlet;

pub use time_step::{
    Oscillator, characteristic_polynomial, crack_bound, critical_step, is_stable, wave_bound,
};

pub(crate) use beeman::{BeemanBegin, BeemanCorrect, BeemanPredict};
pub(crate) use euler::{Euler, SymplecticEuler};
pub(crate) use taylor::Taylor;
pub(crate) use velocity_verlet::{HalfKick, HalfKickAndDrift, VerletCorrect, VerletPredict};

use crate::geometry::Vec2;
use crate::scalar::Real;
use core::ops::{Add, AddAssign, Mul, Sub};

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
        let kept = if integrator.needs_previous() {
            number
        } else {
            0
        };
        let older = if integrator == Integrator::Beeman {
            number
        } else {
            0
        };
        Self {
            linear: vec![Vec2::zero(); kept],
            angular: vec![S::zero(); kept],
            older_linear: vec![Vec2::zero(); older],
            older_angular: vec![S::zero(); older],
            is_set: false,
        }
    }
}

/// What moves: a vector for translations, a number for rotations.
pub(crate) trait Coordinate<S>:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<S, Output = Self> + AddAssign
{
}
impl<S: Real> Coordinate<S> for Vec2<S> {}
impl<S: Real> Coordinate<S> for S {}

/// Translations or rotations of all particles, as columns of equal length.
pub(crate) struct Motion<'a, V, S> {
    /// Positions in m or angles in rad.
    pub coordinate: &'a mut [V],
    /// Velocities in m/s or rad/s.
    pub velocity: &'a mut [V],
    /// Forces in N or torques in N m.
    pub force: &'a [V],
    /// Inverse masses in 1/kg or moments of inertia in 1/(kg m^2), zero for fixed particles.
    pub inverse_inertia: &'a [S],
    /// Accelerations of the previous evaluation, for methods that keep them.
    pub previous: &'a mut [V],
    /// Accelerations one evaluation earlier, for methods that keep them.
    pub older: &'a mut [V],
}

/// A stage of a method: how coordinates and velocities change under given forces.
///
/// Accelerations are forces times inverse inertias, thesis eq. (51).
pub(crate) trait Stage {
    /// Whether coordinates change.
    const MOVES: bool = true;
    /// Advance by a time in s.
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64);
}

/// A stage on its columns, to be run with wide instructions.
pub(crate) struct Advance<'a, T, V, S> {
    pub stage: core::marker::PhantomData<T>,
    pub motion: Motion<'a, V, S>,
    pub step: f64,
}

impl<T: Stage, V: Coordinate<S>, S: Real> pulp::NullaryFnOnce for Advance<'_, T, V, S> {
    type Output = ();
    #[inline(always)]
    fn call(self) {
        T::advance(self.motion, self.step);
    }
}
