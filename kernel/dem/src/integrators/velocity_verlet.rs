//! Velocity Verlet.

use super::stage::{Coordinate, Motion, Stage};
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Velocity Verlet method with predicted velocities.
///
/// $$ \vec x' = \vec x + \vec v \Delta t + \tfrac12 \vec a \Delta t^2, \qquad \vec v' = \vec v + \tfrac12 (\vec a + \vec a') \Delta t $$
///
/// Not in the thesis. Second order also with damping, because the forces a' are evaluated at the
/// predicted velocity v + a dt, whose error is of second order; from the velocity at half step, as
/// some programs do, damping makes it first order. One evaluation a step: the acceleration at the
/// predicted velocity also begins the next step. Symplectic without damping; stable up to
///
/// $$ \omega \Delta t = \sqrt{16 \zeta^2 + 4} - 4 \zeta $$
#[rendered]
pub(crate) struct VerletPredict;

impl Stage for VerletPredict {
    const KEEPS_FORCES: bool = true;
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let (half, step) = (S::from_f64(0.5 * step), S::from_f64(step));
        let loads = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        for ((x, v), (&force, &inverse)) in states.zip(loads) {
            let a = force * inverse;
            *x += (*v + a * half) * step;
            *v += a * step;
        }
    }
}

/// The rest of the step, with the forces at the prediction: half the change of acceleration is added.
pub(crate) struct VerletCorrect;

impl Stage for VerletCorrect {
    const MOVES: bool = false;
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let half = S::from_f64(0.5 * step);
        let loads = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.velocity.iter_mut().zip(motion.previous);
        for ((v, previous), (&force, &inverse)) in states.zip(loads) {
            *v += (force * inverse - *previous * inverse) * half;
            *previous = V::default();
        }
    }
}

/// Velocity Verlet method with the velocities of half a step.
///
/// $$ \vec u = \vec v + \tfrac12 \vec a \Delta t, \qquad \vec x' = \vec x + \vec u \Delta t, \qquad \vec v' = \vec u + \tfrac12 \vec a' \Delta t $$
///
/// The forces a' are evaluated at u, which lags by half a step: with damping the method is of first order.
/// For comparison with LAMMPS, whose `fix nve` this is; [`VerletPredict`] is as cheap and better.
#[rendered]
pub(crate) struct HalfKickAndDrift;

impl Stage for HalfKickAndDrift {
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let (half, step) = (S::from_f64(0.5 * step), S::from_f64(step));
        let loads = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        for ((x, v), (&force, &inverse)) in states.zip(loads) {
            *v += force * inverse * half;
            *x += *v * step;
        }
    }
}

/// The rest of the step, with the forces at its end.
pub(crate) struct HalfKick;

impl Stage for HalfKick {
    const MOVES: bool = false;
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let half = S::from_f64(0.5 * step);
        let loads = motion.force.iter().zip(motion.inverse_inertia);
        for (v, (&force, &inverse)) in motion.velocity.iter_mut().zip(loads) {
            *v += force * inverse * half;
        }
    }
}
