//! The pass over particles for the external potential.

use super::sums::Forces;
use crate::laws::ExternalLaw;
use crate::particles::Particles;
use gouge_common::scalar::Real;

/// Add the external force on every particle.
#[inline(never)]
pub(crate) fn external<S: Real, L: ExternalLaw>(
    law: L,
    particles: &Particles<S>,
    forces: &mut Forces<S>,
) {
    for i in 0..particles.len() {
        forces.force[i] += law.force(particles.mass[i], particles.position[i]);
    }
}
