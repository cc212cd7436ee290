//! Number of particles in a box, thesis appendix B.

use core::f64::consts::{PI, SQRT_2};
use gouge_equations::rendered;

/// Packing fraction of the densest arrangement of equal discs, pi / (2 sqrt(3)), thesis eq. (103).
pub const DENSEST_DISCS: f64 = 0.906_899_682_117_108_9;
/// Packing fraction of the densest arrangement of equal spheres, pi / (3 sqrt(2)), thesis eq. (104).
pub const DENSEST_SPHERES: f64 = PI / (3.0 * SQRT_2);

/// Number of equal discs of radius R in a square of side L, in the densest arrangement.
///
/// $$ N_2 = q_2 \frac{L^2}{\pi R^2} = \frac{1}{2 \sqrt 3} \left( \frac LR \right)^2 $$
///
/// Thesis eqs. (102)-(103).
#[rendered]
pub fn discs_in_square(side: f64, radius: f64) -> f64 {
    DENSEST_DISCS * side * side / (PI * radius * radius)
}

/// Number of equal spheres of radius R in a cube of side L, in the densest arrangement.
///
/// $$ N_3 = q_3 \frac{3 L^3}{4 \pi R^3} = \frac{1}{4 \sqrt 2} \left( \frac LR \right)^3 $$
///
/// Thesis eqs. (102) and (104).
#[rendered]
pub fn spheres_in_cube(side: f64, radius: f64) -> f64 {
    DENSEST_SPHERES * side * side * side / (4.0 / 3.0 * PI * radius * radius * radius)
}

/// Ratio of the number of spheres in a cube to the number of discs in a square, both in the densest arrangement.
///
/// $$ \frac{N_3}{N_2} = \frac{\sqrt6}{4} \frac LR $$
///
/// Thesis eq. (105): [`spheres_in_cube`] divided by [`discs_in_square`].
#[rendered]
pub fn spheres_per_disc(side: f64, radius: f64) -> f64 {
    spheres_in_cube(side, radius) / discs_in_square(side, radius)
}
