//! Modified Beeman method.

use super::{Motion, Previous};
use crate::scalar::Real;
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
pub(crate) fn beeman_predict<S: Real>(motion: Motion<S>, previous: &mut Previous<S>, step: f64) {
    for i in 0..motion.particles.len() {
        let (a, alpha) = motion.acceleration(i);
        if !previous.is_set {
            (previous.linear[i], previous.angular[i]) = (a, alpha);
        }
        let (a_, alpha_) = (previous.linear[i], previous.angular[i]);
        let sixth = S::from_f64(step / 6.0);
        let p = &mut *motion.particles;
        let linear = (a * S::from_f64(4.0) - a_) * sixth;
        p.position[i] += (p.velocity[i] + linear) * S::from_f64(step);
        p.angle[i] += (p.angular_velocity[i] + (alpha * 4.0 - alpha_) * sixth) * step;
        p.velocity[i] += (a * S::from_f64(3.0) - a_) * S::from_f64(0.5 * step);
        p.angular_velocity[i] += (alpha * 3.0 - alpha_) * (0.5 * step);
        (previous.older_linear[i], previous.older_angular[i]) = (a_, alpha_);
        (previous.linear[i], previous.angular[i]) = (a, alpha);
    }
    previous.is_set = true;
}

/// The correction, with the forces at the prediction.
pub(crate) fn beeman_correct<S: Real>(motion: Motion<S>, previous: &mut Previous<S>, step: f64) {
    let two = S::from_f64(2.0);
    for i in 0..motion.particles.len() {
        let (a, alpha) = motion.acceleration(i);
        let p = &mut *motion.particles;
        let bend = a - previous.linear[i] * two + previous.older_linear[i];
        let twist = alpha - previous.angular[i] * two + previous.older_angular[i];
        p.velocity[i] += bend * S::from_f64(step / 3.0);
        p.angular_velocity[i] += twist * (step / 3.0);
        p.position[i] += bend * S::from_f64(step * step / 6.0);
        p.angle[i] += twist * (step * step / 6.0);
    }
}
