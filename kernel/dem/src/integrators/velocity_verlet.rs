//! Velocity Verlet.

use super::stage::{Coordinate, Motion, Stage};
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Prediction of the velocity Verlet method with forces at the predicted velocity.
///
/// # Equation
/// Not in the thesis:
///
/// $$ \vec x' = \vec x + \vec v \Delta t + \tfrac12 \vec a \Delta t^2, \qquad \vec v' = \vec v + \tfrac12 (\vec a + \vec a') \Delta t $$
///
/// # Order and cost
/// Second order, also with damping: the forces $\vec a'$ are evaluated at the predicted velocity
/// $\vec v + \vec a \Delta t$, whose error is of second order. Methods that use the half-step velocity are of
/// first order with damping. One evaluation per step: the acceleration at the predicted velocity also begins the
/// next step. Symplectic without damping. Stores one more force per particle.
///
/// # Stability
/// Stable up to
///
/// $$ \omega \Delta t = \sqrt{16 \zeta^2 + 4} - 4 \zeta $$
#[rendered]
pub(crate) struct VerletPredict;

impl Stage for VerletPredict {
    const KEEPS_FORCES: bool = true;
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let (half, step) = (S::from_f64(0.5 * step), S::from_f64(step));
        let forces = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        for ((x, v), (&force, &inverse)) in states.zip(forces) {
            let a = force * inverse;
            *x += (*v + a * half) * step;
            *v += a * step;
        }
    }
}

/// Correction of the velocity Verlet method: adds half the change of acceleration, with the forces at the prediction.
pub(crate) struct VerletCorrect;

impl Stage for VerletCorrect {
    const MOVES: bool = false;
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let half = S::from_f64(0.5 * step);
        let forces = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.velocity.iter_mut().zip(motion.previous);
        for ((v, previous), (&force, &inverse)) in states.zip(forces) {
            *v += (force * inverse - *previous * inverse) * half;
            *previous = V::default();
        }
    }
}

/// First half of the velocity Verlet method with forces at the half-step velocity.
///
/// # Equation
/// $$ \vec u = \vec v + \tfrac12 \vec a \Delta t, \qquad \vec x' = \vec x + \vec u \Delta t, \qquad \vec v' = \vec u + \tfrac12 \vec a' \Delta t $$
///
/// # Order and cost
/// The forces $\vec a'$ are evaluated at $\vec u$, which lags behind by half a step: with damping the method is of
/// first order. It is `fix nve` of LAMMPS and serves comparisons; [`VerletPredict`] costs the same and is more
/// accurate.
#[rendered]
pub(crate) struct HalfKickAndDrift;

impl Stage for HalfKickAndDrift {
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let (half, step) = (S::from_f64(0.5 * step), S::from_f64(step));
        let forces = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        for ((x, v), (&force, &inverse)) in states.zip(forces) {
            *v += force * inverse * half;
            *x += *v * step;
        }
    }
}

/// Second half of the step, with the forces at its end.
pub(crate) struct HalfKick;

impl Stage for HalfKick {
    const MOVES: bool = false;
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let half = S::from_f64(0.5 * step);
        let forces = motion.force.iter().zip(motion.inverse_inertia);
        for (v, (&force, &inverse)) in motion.velocity.iter_mut().zip(forces) {
            *v += force * inverse * half;
        }
    }
}
