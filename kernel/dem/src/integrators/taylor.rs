//! Taylor expansion.

use super::stage::{Coordinate, Motion, Stage};
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Second-order expansion of the positions.
///
/// $$ \vec x' = \vec x + \vec v \Delta t + \tfrac12 \vec a \Delta t^2, \qquad \vec v' = \vec v + \vec a \Delta t $$
///
/// Thesis eq. (56). Globally first order, because the velocities are; one evaluation a step. Unstable
/// on an undamped spring.
#[rendered]
pub(crate) struct Taylor;

impl Stage for Taylor {
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
