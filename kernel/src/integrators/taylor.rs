//! Taylor expansion.

use super::Motion;
use crate::scalar::Real;
use gouge_equations::rendered;

/// Second-order expansion of the positions.
///
/// $$ \vec x' = \vec x + \vec v \Delta t + \tfrac12 \vec a \Delta t^2, \qquad \vec v' = \vec v + \vec a \Delta t $$
///
/// Thesis eq. (56). Globally first order, because the velocities are; one evaluation a step. Unstable
/// on an undamped spring.
#[rendered]
pub(crate) fn taylor<S: Real>(motion: Motion<S>, step: f64) {
    for i in 0..motion.particles.len() {
        let (a, alpha) = motion.acceleration(i);
        let p = &mut *motion.particles;
        p.position[i] += (p.velocity[i] + a * S::from_f64(0.5 * step)) * S::from_f64(step);
        p.angle[i] += (p.angular_velocity[i] + alpha * (0.5 * step)) * step;
        p.velocity[i] += a * S::from_f64(step);
        p.angular_velocity[i] += alpha * step;
    }
}
