//! Pressure in single particles.

use crate::forces::Interaction;
use crate::particles::Particles;
use core::f64::consts::PI;
use gouge_equations::rendered;

/// Mean pressure in each particle in Pa, positive in compression.
///
/// $$ p_i = -\frac{1}{2\, \pi r_i^2\, l} \sum_j F_{ij} \cdot (c_{ij} - x_i) $$
///
/// $F_{ij}$ is the force of j on i in N, $c_{ij}$ the focal point and $x_i$ the centre in m, and l `thickness` in m.
/// Half the trace of the mean stress in the disc, with the opposite sign; tangential forces do not contribute.
#[rendered]
pub fn particle_pressures(
    particles: &Particles,
    interactions: &[Interaction],
    thickness: f64,
) -> Vec<f64> {
    let mut virials = vec![0.0; particles.len()];
    for one in interactions {
        let (i, j) = one.pair.indices();
        let virial = one.normal_force * one.distance;
        virials[i] += virial * one.overlap_factor;
        virials[j] += virial * (1.0 - one.overlap_factor);
    }
    let of_disc = |(virial, r): (f64, &f64)| -virial / (2.0 * PI * r * r * thickness);
    virials
        .into_iter()
        .zip(&particles.radius)
        .map(of_disc)
        .collect()
}
