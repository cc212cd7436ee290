//! The pass over particles for the drag of the medium.

use super::bookings::Bookings;
use super::sums::Forces;
use crate::laws::AmbientLaw;
use crate::particles::Particles;
use gouge_common::scalar::Real;

/// Add the drag on every particle.
#[inline(never)]
pub(crate) fn ambient<S: Real, L: AmbientLaw, const LEDGER: bool>(
    law: L,
    particles: &Particles<S>,
    forces: &mut Forces<S>,
    bookings: &mut Bookings<S>,
) {
    for i in 0..particles.len() {
        let (v, omega) = (particles.velocity[i], particles.angular_velocity[i]);
        let drag = law.drag(particles.radius[i], v, omega);
        if LEDGER {
            bookings.ambient_rate -= drag.force.dot(v) + drag.torque * omega;
        }
        forces.force[i] += drag.force;
        forces.torque[i] += drag.torque;
    }
}
