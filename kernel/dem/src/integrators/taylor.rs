//! Second-order Taylor expansion.

use super::stage::{Coordinate, Motion, Stage};
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Second-order Taylor expansion of the positions.
///
/// # Equation
/// Thesis eq. (56):
///
/// $$ \vec x' = \vec x + \vec v \Delta t + \tfrac12 \vec a \Delta t^2, \qquad \vec v' = \vec v + \vec a \Delta t $$
///
/// # Order and cost
/// First order globally, because the velocities are. One evaluation per step, no further arrays.
///
/// # Stability
/// Unstable on an undamped spring. Stable up to $\omega \Delta t = \min\{4 \zeta, 1 / \zeta\}$.
#[rendered]
pub(crate) struct Taylor;

impl Stage for Taylor {
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
