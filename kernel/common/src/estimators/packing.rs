//! Packing fraction.

use core::f64::consts::PI;
use gouge_equations::rendered;

/// Packing fraction of discs in a box, dimensionless.
///
/// $$ q = \frac{\pi}{l^x l^y} \sum_i r_i^2 $$
///
/// Thesis eq. (68); radii in m, area in m^2. At most 0.9069 for equal discs that do not overlap. The bound
/// printed in the thesis is that of spheres in three dimensions (erratum E24 of the thesis).
#[rendered]
pub fn packing_fraction(radii: &[f64], area: f64) -> f64 {
    PI * radii.iter().map(|r| r * r).sum::<f64>() / area
}
