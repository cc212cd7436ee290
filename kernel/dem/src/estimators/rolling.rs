//! Rolling and slip in the debris between two blocks.

use super::debris;
use crate::forces::{Interaction, InteractionKind};
use crate::geometry::{Arm, PairFrame, PairMotion, RadiusArm};
use crate::particles::Particles;
use crate::world::{NormalChoice, World};
use gouge_common::pair::map_ends;
use gouge_equations::rendered;

/// Speeds of rolling and of slip, summed over the contacts of the debris, in m/s.
///
/// $$ u = \frac{1}{2} \sum_{ij} |\partial_t \zeta_{ij} - \partial_t \zeta_{ji}| $$
///
/// $$ w = \sum_{ij} |\partial_t \zeta_{ij} + \partial_t \zeta_{ji}| $$
///
/// $\partial_t \zeta_{ij}$ is the speed in m/s at which the surface of i passes the contact point of i and j, seen from
/// their common normal: thesis eq. (34) with the radius as lever arm. Slip w is what friction resists: zero for two
/// wheels that roll on each other. Rolling u is the mean speed at which the contact point moves along both surfaces:
/// zero for two surfaces that pass at opposite speeds. Both are the same for every observer, also for a rotating one.
/// The sums are over contacts of pairs that are not bonded, of which at least one particle belongs to the
/// [`debris`]. The result is `[u, w]`; it is zero without debris.
#[rendered]
pub fn rolling_and_slip<N: NormalChoice<f64>>(world: &World<f64, N>) -> [f64; 2] {
    let is_debris = debris(world.state());
    if !is_debris.contains(&true) {
        return [0.0; 2];
    }
    let interactions = world.interactions();
    let counts = interactions.iter().filter(|one| {
        let (i, j) = one.pair.indices();
        one.kind == InteractionKind::Contact && (is_debris[i] || is_debris[j])
    });
    let speeds = counts.map(|one| surface_speeds(world.particles(), one));
    speeds.fold([0.0; 2], |[rolling, slip], [at_i, at_j]| {
        [
            rolling + (0.5 * (at_i - at_j)).abs(),
            slip + (at_i + at_j).abs(),
        ]
    })
}

/// Speeds in m/s at which the surfaces of both particles pass their contact point.
fn surface_speeds(particles: &Particles, one: &Interaction) -> [f64; 2] {
    let (i, j) = one.pair.indices();
    let of_both = |column: &[f64]| map_ends([i, j], |end| column[end]);
    let frame = PairFrame::new(one.normal * one.distance);
    let motion = PairMotion::new(&frame, particles.velocity[j] - particles.velocity[i]);
    let spins = of_both(&particles.angular_velocity);
    RadiusArm.velocities(of_both(&particles.radius), &frame, &motion, spins)
}
