//! Explicit and symplectic Euler methods.

use super::Motion;
use crate::scalar::Real;
use gouge_equations::rendered;

/// Explicit Euler method.
///
/// $$ \vec x' = \vec x + \vec v \Delta t, \qquad \vec v' = \vec v + \vec a \Delta t $$
///
/// Thesis eq. (55). First order, one evaluation a step. Unstable for every step on an undamped spring,
/// where the amplitude grows by the factor sqrt(1 + (w dt)^2) (E37 of `docs/errata.md`).
#[rendered]
pub(crate) fn euler<S: Real>(motion: Motion<S>, step: f64) {
    for i in 0..motion.particles.len() {
        let (a, alpha) = motion.acceleration(i);
        let p = &mut *motion.particles;
        p.position[i] += p.velocity[i] * S::from_f64(step);
        p.angle[i] += p.angular_velocity[i] * step;
        p.velocity[i] += a * S::from_f64(step);
        p.angular_velocity[i] += alpha * step;
    }
}

/// Symplectic Euler method.
///
/// $$ \vec v' = \vec v + \vec a \Delta t, \qquad \vec x' = \vec x + \vec v' \Delta t $$
///
/// First order, one evaluation a step; without damping symplectic and stable up to w dt = 2.
#[rendered]
pub(crate) fn symplectic_euler<S: Real>(motion: Motion<S>, step: f64) {
    for i in 0..motion.particles.len() {
        let (a, alpha) = motion.acceleration(i);
        let p = &mut *motion.particles;
        p.velocity[i] += a * S::from_f64(step);
        p.angular_velocity[i] += alpha * step;
        p.position[i] += p.velocity[i] * S::from_f64(step);
        p.angle[i] += p.angular_velocity[i] * step;
    }
}
