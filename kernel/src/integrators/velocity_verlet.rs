//! Velocity Verlet.

use super::{Motion, Previous};
use crate::scalar::Real;
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
pub(crate) fn verlet_predict<S: Real>(motion: Motion<S>, previous: &mut Previous<S>, step: f64) {
    for i in 0..motion.particles.len() {
        let (a, alpha) = motion.acceleration(i);
        let p = &mut *motion.particles;
        p.position[i] += (p.velocity[i] + a * S::from_f64(0.5 * step)) * S::from_f64(step);
        p.angle[i] += (p.angular_velocity[i] + alpha * (0.5 * step)) * step;
        p.velocity[i] += a * S::from_f64(step);
        p.angular_velocity[i] += alpha * step;
        (previous.linear[i], previous.angular[i]) = (a, alpha);
    }
}

/// The rest of the step, with the forces at the prediction: half the change of acceleration is added.
pub(crate) fn verlet_correct<S: Real>(motion: Motion<S>, previous: &mut Previous<S>, step: f64) {
    for i in 0..motion.particles.len() {
        let (a, alpha) = motion.acceleration(i);
        let p = &mut *motion.particles;
        p.velocity[i] += (a - previous.linear[i]) * S::from_f64(0.5 * step);
        p.angular_velocity[i] += (alpha - previous.angular[i]) * (0.5 * step);
    }
}

/// Velocity Verlet method with the velocities of half a step.
///
/// $$ \vec u = \vec v + \tfrac12 \vec a \Delta t, \qquad \vec x' = \vec x + \vec u \Delta t, \qquad \vec v' = \vec u + \tfrac12 \vec a' \Delta t $$
///
/// The forces a' are evaluated at u, which lags by half a step: with damping the method is of first order.
/// For comparison with LAMMPS, whose `fix nve` this is; [`verlet_predict`] is as cheap and better.
#[rendered]
pub(crate) fn half_kick_and_drift<S: Real>(mut motion: Motion<S>, step: f64) {
    motion.kick(0.5 * step);
    for i in 0..motion.particles.len() {
        let p = &mut *motion.particles;
        p.position[i] += p.velocity[i] * S::from_f64(step);
        p.angle[i] += p.angular_velocity[i] * step;
    }
}

/// The rest of the step, with the forces at its end.
pub(crate) fn half_kick<S: Real>(mut motion: Motion<S>, step: f64) {
    motion.kick(0.5 * step);
}

impl<S: Real> Motion<'_, S> {
    /// Change velocities by what the forces do in a time in s.
    fn kick(&mut self, time: f64) {
        for i in 0..self.particles.len() {
            let (a, alpha) = self.acceleration(i);
            self.particles.velocity[i] += a * S::from_f64(time);
            self.particles.angular_velocity[i] += alpha * time;
        }
    }
}
