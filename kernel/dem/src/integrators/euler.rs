//! Explicit and symplectic Euler methods.

use super::stage::{Coordinate, Motion, Stage};
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Explicit Euler method.
///
/// # Equation
/// Thesis eq. (55):
///
/// $$ \vec x' = \vec x + \vec v \Delta t, \qquad \vec v' = \vec v + \vec a \Delta t $$
///
/// # Order and cost
/// First order. One evaluation per step, no further arrays.
///
/// # Stability
/// Unstable for every time step on an undamped spring, where the amplitude grows by the factor
/// $\sqrt{1 + (\omega \Delta t)^2}$ per step (erratum E37 of the thesis). Stable up to $\omega \Delta t = 2 \zeta$
/// for damping ratios $\zeta \le 1$.
#[rendered]
pub(crate) struct Euler;

impl Stage for Euler {
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let step = S::from_f64(step);
        let forces = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        for ((x, v), (&force, &inverse)) in states.zip(forces) {
            *x += *v * step;
            *v += force * inverse * step;
        }
    }
}

/// Symplectic Euler method.
///
/// # Equation
/// Not in the thesis:
///
/// $$ \vec v' = \vec v + \vec a \Delta t, \qquad \vec x' = \vec x + \vec v' \Delta t $$
///
/// # Order and cost
/// First order, symplectic without damping. One evaluation per step, no further arrays.
///
/// # Stability
/// Stable up to $\omega \Delta t = 2 (\sqrt{1 + \zeta^2} - \zeta)$, which is 2 without damping.
#[rendered]
pub(crate) struct SymplecticEuler;

impl Stage for SymplecticEuler {
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let step = S::from_f64(step);
        let forces = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        for ((x, v), (&force, &inverse)) in states.zip(forces) {
            *v += force * inverse * step;
            *x += *v * step;
        }
    }
}
