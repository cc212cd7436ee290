//! Modified Beeman method.

use super::stage::{Coordinate, Motion, Stage};
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Modified Beeman predictor-corrector.
///
/// Prediction, thesis eq. (57), with a- the acceleration one step earlier:
///
/// $$ \vec v^* = \vec v + \tfrac12 (3 \vec a - \vec a^-) \Delta t, \qquad \vec x^* = \vec x + \vec v \Delta t + \tfrac16 (4 \vec a - \vec a^-) \Delta t^2 $$
///
/// Correction, thesis eq. (58), with a' the acceleration at the prediction, written as what it adds:
///
/// $$ \vec v' = \vec v^* + \tfrac13 (\vec a' - 2 \vec a + \vec a^-) \Delta t, \qquad \vec x' = \vec x^* + \tfrac16 (\vec a' - 2 \vec a + \vec a^-) \Delta t^2 $$
///
/// Second order: the corrected velocity misses a'' dt^3 / 12 a step. One evaluation a step, at the
/// prediction; the forces are not evaluated again after the correction. The first step takes the
/// earlier acceleration equal to the present one. Weakly unstable without damping: the amplitude grows
/// by about (w dt)^4 / 12 a step.
#[rendered]
pub(crate) struct BeemanPredict;

impl Stage for BeemanPredict {
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let sixth = S::from_f64(step / 6.0);
        let (half, step) = (S::from_f64(0.5 * step), S::from_f64(step));
        let (three, four) = (S::from_f64(3.0), S::from_f64(4.0));
        let loads = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        let kept = motion.previous.iter_mut().zip(motion.older);
        for (((x, v), (&force, &inverse)), (previous, older)) in states.zip(loads).zip(kept) {
            let a = force * inverse;
            *x += (*v + (a * four - *previous) * sixth) * step;
            *v += (a * three - *previous) * half;
            *older = *previous;
            *previous = a;
        }
    }
}

/// Before the first step: the earlier acceleration equals the present one.
pub(crate) struct BeemanBegin;

impl Stage for BeemanBegin {
    const MOVES: bool = false;
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, _: f64) {
        let loads = motion.force.iter().zip(motion.inverse_inertia);
        for (previous, (&force, &inverse)) in motion.previous.iter_mut().zip(loads) {
            *previous = force * inverse;
        }
    }
}

/// The correction, with the forces at the prediction.
pub(crate) struct BeemanCorrect;

impl Stage for BeemanCorrect {
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let (third, sixth) = (S::from_f64(step / 3.0), S::from_f64(step * step / 6.0));
        let two = S::from_f64(2.0);
        let loads = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        let kept = motion.previous.iter().zip(motion.older);
        for (((x, v), (&force, &inverse)), (&previous, &mut older)) in states.zip(loads).zip(kept) {
            let bend = force * inverse - previous * two + older;
            *v += bend * third;
            *x += bend * sixth;
        }
    }
}
