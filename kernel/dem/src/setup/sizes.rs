//! Particle sizes, thesis eqs. (65)-(66).

use core::f64::consts::SQRT_2;
use gouge_equations::rendered;

/// Range of uniformly distributed radii, in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeRange {
    /// Smallest radius.
    pub minimum: f64,
    /// Largest radius.
    pub maximum: f64,
}

#[rendered]
impl SizeRange {
    /// Range around a mean radius, chosen in the thesis to prevent crystallisation.
    ///
    /// $$ r^{min} = \frac{2}{1 + \sqrt 2} r^{avg}, \qquad r^{max} = \frac{4}{2 + \sqrt 2} r^{avg} $$
    ///
    /// Thesis eq. (66). The relative standard deviation is 0.09906, which lies just inside the range where particles
    /// crystallise according to (65), not outside (erratum E36 of the thesis).
    pub fn around(mean: f64) -> Self {
        Self {
            minimum: 2.0 / (1.0 + SQRT_2) * mean,
            maximum: 4.0 / (2.0 + SQRT_2) * mean,
        }
    }

    /// Radius at a fraction of the range, in m.
    pub fn at(self, fraction: f64) -> f64 {
        self.minimum + fraction * (self.maximum - self.minimum)
    }
}

/// Independent radii in m.
pub fn draw_radii(range: SizeRange, number: usize, mut uniform: impl FnMut() -> f64) -> Vec<f64> {
    (0..number).map(|_| range.at(uniform())).collect()
}
