//! The pass over driven particles for the driving force.

use super::bookings::Bookings;
use super::sums::Forces;
use crate::laws::Driven;
use crate::particles::Particles;
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;

/// Measure the driven particles for the controller, before the driving force is added.
#[inline(never)]
pub(crate) fn measure_driven<S: Real>(
    particles: &Particles<S>,
    driven: &[u32],
    forces: &Forces<S>,
) -> Driven<S> {
    let mut sums = Driven {
        number: S::from_f64(driven.len() as f64),
        velocity_sum: S::zero(),
        velocity_at_step_start: S::zero(),
        velocity_gain: 1.0,
        reaction: Vec2::zero(),
        inverse_mass_sum: S::zero(),
        acceleration_sum: S::zero(),
    };
    for &i in driven {
        let i = i as usize;
        let inverse_mass = S::from_f64(1.0) / particles.mass[i];
        sums.velocity_sum += particles.velocity[i].x;
        sums.reaction += forces.force[i];
        sums.inverse_mass_sum += inverse_mass;
        sums.acceleration_sum += forces.force[i].x * inverse_mass;
    }
    sums
}

/// Add an equal share of the total driving force to every driven particle.
#[inline(never)]
pub(crate) fn driving<S: Real, const LEDGER: bool>(
    total: Vec2<S>,
    particles: &Particles<S>,
    driven: &[u32],
    forces: &mut Forces<S>,
    bookings: &mut Bookings<S>,
) {
    let number = S::from_f64(driven.len() as f64);
    let share = Vec2::new(total.x / number, total.y / number);
    for &i in driven {
        let i = i as usize;
        forces.force[i] += share;
        if LEDGER {
            let velocity = particles.velocity[i];
            bookings.driving_rate += share.dot(velocity);
            bookings.shearing_rate += share.x * velocity.x;
            bookings.sliding_rate -= share.y * velocity.x;
        }
    }
}
