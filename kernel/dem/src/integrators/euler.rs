//! Explicit and symplectic Euler methods.

use super::stage::{Coordinate, Motion, Stage};
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Explicit Euler method.
///
/// $$ \vec x' = \vec x + \vec v \Delta t, \qquad \vec v' = \vec v + \vec a \Delta t $$
///
/// Thesis eq. (55). First order, one evaluation a step. Unstable for every step on an undamped spring,
/// where the amplitude grows by the factor sqrt(1 + (w dt)^2) (erratum E37 of the thesis).
#[rendered]
pub(crate) struct Euler;

impl Stage for Euler {
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let step = S::from_f64(step);
        let loads = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        for ((x, v), (&force, &inverse)) in states.zip(loads) {
            *x += *v * step;
            *v += force * inverse * step;
        }
    }
}

/// Symplectic Euler method.
///
/// $$ \vec v' = \vec v + \vec a \Delta t, \qquad \vec x' = \vec x + \vec v' \Delta t $$
///
/// First order, one evaluation a step; without damping symplectic and stable up to w dt = 2.
#[rendered]
pub(crate) struct SymplecticEuler;

impl Stage for SymplecticEuler {
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let step = S::from_f64(step);
        let loads = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        for ((x, v), (&force, &inverse)) in states.zip(loads) {
            *v += force * inverse * step;
            *x += *v * step;
        }
    }
}
