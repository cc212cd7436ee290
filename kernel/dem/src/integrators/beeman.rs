//! Modified Beeman method.

use super::stage::{Coordinate, Motion, Stage};
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Prediction of the modified Beeman predictor-corrector method.
///
/// # Equation
/// Prediction, thesis eq. (57), with $\vec a^-$ the acceleration one step earlier:
///
/// $$ \vec v^* = \vec v + \tfrac12 (3 \vec a - \vec a^-) \Delta t, \qquad \vec x^* = \vec x + \vec v \Delta t + \tfrac16 (4 \vec a - \vec a^-) \Delta t^2 $$
///
/// Correction, thesis eq. (58), with $\vec a'$ the acceleration at the prediction, written as an increment:
///
/// $$ \vec v' = \vec v^* + \tfrac13 (\vec a' - 2 \vec a + \vec a^-) \Delta t, \qquad \vec x' = \vec x^* + \tfrac16 (\vec a' - 2 \vec a + \vec a^-) \Delta t^2 $$
///
/// # Order and cost
/// Second order: the error of the corrected velocity is $a'' \Delta t^3 / 12$ per step. One evaluation per step,
/// at the prediction; forces are not evaluated again after the correction. Stores two accelerations per particle.
/// In the first step the earlier acceleration equals the present one.
///
/// # Stability
/// Weakly unstable without damping: the amplitude grows by about $(\omega \Delta t)^4 / 12$ per step.
#[rendered]
pub(crate) struct BeemanPredict;

impl Stage for BeemanPredict {
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let sixth = S::from_f64(step / 6.0);
        let (half, step) = (S::from_f64(0.5 * step), S::from_f64(step));
        let (three, four) = (S::from_f64(3.0), S::from_f64(4.0));
        let forces = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        let accelerations = motion.previous.iter_mut().zip(motion.older);
        for (((x, v), (&force, &inverse)), (previous, older)) in
            states.zip(forces).zip(accelerations)
        {
            let a = force * inverse;
            *x += (*v + (a * four - *previous) * sixth) * step;
            *v += (a * three - *previous) * half;
            *older = *previous;
            *previous = a;
        }
    }
}

/// Start of the Beeman method: the earlier acceleration equals the present one.
pub(crate) struct BeemanBegin;

impl Stage for BeemanBegin {
    const MOVES: bool = false;
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, _: f64) {
        let forces = motion.force.iter().zip(motion.inverse_inertia);
        for (previous, (&force, &inverse)) in motion.previous.iter_mut().zip(forces) {
            *previous = force * inverse;
        }
    }
}

/// Correction of the Beeman method, with the forces at the prediction.
pub(crate) struct BeemanCorrect;

impl Stage for BeemanCorrect {
    #[inline(always)]
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64) {
        let (third, sixth) = (S::from_f64(step / 3.0), S::from_f64(step * step / 6.0));
        let two = S::from_f64(2.0);
        let forces = motion.force.iter().zip(motion.inverse_inertia);
        let states = motion.coordinate.iter_mut().zip(motion.velocity);
        let accelerations = motion.previous.iter().zip(motion.older);
        for (((x, v), (&force, &inverse)), (&previous, &mut older)) in
            states.zip(forces).zip(accelerations)
        {
            let second_difference = force * inverse - previous * two + older;
            *v += second_difference * third;
            *x += second_difference * sixth;
        }
    }
}
