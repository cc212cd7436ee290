//! When a strong link breaks, thesis eqs. (46)-(50).

use core::f64::consts::PI;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// When a strong link breaks.
pub trait YieldLaw: Copy + Send + Sync {
    /// Whether a link with this [`weakest_section`] in m^2 breaks under these forces in N.
    fn is_exceeded<S: Real>(self, normal_force: S, tangential_force: S, section: S) -> bool;
}

/// Strong links that never break.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unbreakable;

impl YieldLaw for Unbreakable {
    #[inline(always)]
    fn is_exceeded<S: Real>(self, _: S, _: S, _: S) -> bool {
        false
    }
}

/// Area in m^2 that carries the forces of a link when it breaks.
///
/// $$ A = \pi (s\, r^{crit})^2, \qquad r^{crit} = \min\{r_i, r_j\} $$
///
/// Thesis eqs. (49)-(50), with the strength factor s and radii in m. Infinite for an infinite factor: such
/// a link never breaks.
#[rendered]
pub fn weakest_section<S: Real>(radii: [S; 2], strength_factor: S) -> S {
    let weakest = strength_factor * radii[0].min(radii[1]);
    weakest * weakest * PI
}

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
/// let law = gouge_dem::laws::ZhangEckert { normal_strength: 280e6, tangential_strength: 168e6 };
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
    pub fn breaks<S: Real>(
        self,
        normal_force: S,
        tangential_force: S,
        radii: [S; 2],
        strength_factor: S,
    ) -> bool {
        let section = weakest_section(radii, strength_factor);
        self.is_exceeded(normal_force, tangential_force, section)
    }
}

impl YieldLaw for ZhangEckert {
    #[inline(always)]
    fn is_exceeded<S: Real>(self, normal_force: S, tangential_force: S, section: S) -> bool {
        let normal = normal_force * (1.0 / self.normal_strength);
        let tangential = tangential_force * (1.0 / self.tangential_strength);
        normal * normal + tangential * tangential >= section * section
    }
}
