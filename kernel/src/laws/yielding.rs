//! When a strong link breaks, thesis eqs. (46)-(50).

use crate::scalar::Real;
use core::f64::consts::PI;
use gouge_equations::rendered;

/// Zhang-Eckert criterion of brittle fracture.
///
/// $$ \left( \frac{F^n}{\sigma^n} \right)^2 + \left( \frac{F^t}{\sigma^t} \right)^2 \ge \left( \pi (s\, r^{crit})^2 \right)^2, \qquad r^{crit} = \min\{r_i, r_j\} $$
///
/// Thesis eqs. (48)-(50). The forces are the total ones, viscous parts included: (46) speaks of
/// stresses, and the stress of a Kelvin-Voigt solid (2) has both parts. Tension and compression count
/// alike.
///
/// # Example
/// A beam between 1 mm grains of granite carries 280 MPa over pi mm^2.
/// ```
/// let law = gouge_kernel::laws::ZhangEckert { normal_strength: 280e6, tangential_strength: 168e6 };
/// assert!(!law.breaks(879.0, 0.0, [1e-3, 1e-3], 1.0));
/// assert!(law.breaks(-880.0, 0.0, [1e-3, 1e-3], 1.0));
/// assert!(law.breaks(0.0, 528.0, [1e-3, 2e-3], 1.0));
/// ```
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZhangEckert {
    /// Ultimate normal strength in Pa.
    pub normal_strength: f64,
    /// Ultimate tangential strength in Pa.
    pub tangential_strength: f64,
}

impl ZhangEckert {
    /// Ratio of the semi-axes of the ellipse in stress space, thesis eq. (47).
    pub fn axial_ratio(self) -> f64 {
        self.tangential_strength / self.normal_strength
    }

    /// Whether a link with this strength factor breaks under these forces in N, for radii in m.
    #[inline(always)]
    pub fn breaks<S: Real>(
        self,
        normal_force: S,
        tangential_force: S,
        radii: [S; 2],
        strength_factor: S,
    ) -> bool {
        let weakest = strength_factor * radii[0].min(radii[1]);
        let area = weakest * weakest * PI;
        let normal = normal_force * (1.0 / self.normal_strength);
        let tangential = tangential_force * (1.0 / self.tangential_strength);
        normal * normal + tangential * tangential >= area * area
    }
}
