//! When a bond breaks, thesis eqs. (46)-(50).

use core::f64::consts::PI;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Yield criterion of a bond.
pub trait YieldLaw: Copy + Send + Sync {
    /// The normal and the tangential term that the criterion adds, in m^4, of forces in N.
    fn terms<S: Real>(self, normal_force: S, tangential_force: S) -> [S; 2];
    /// Whether a bond breaks under the given forces in N; `section` is its [`weakest_section`] in m^2.
    #[inline(always)]
    fn is_exceeded<S: Real>(self, normal_force: S, tangential_force: S, section: S) -> bool {
        let [normal, tangential] = self.terms(normal_force, tangential_force);
        normal + tangential >= section * section
    }
}

/// No yielding: the bond never breaks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unbreakable;

impl YieldLaw for Unbreakable {
    #[inline(always)]
    fn is_exceeded<S: Real>(self, _: S, _: S, _: S) -> bool {
        false
    }
    fn terms<S: Real>(self, _: S, _: S) -> [S; 2] {
        [S::zero(); 2]
    }
}

/// Area of the weakest section of a bond, in m^2.
///
/// $$ A = \pi (s\, r^{crit})^2, \qquad r^{crit} = \min\{r_i, r_j\} $$
///
/// Thesis eqs. (49)-(50), with radii in m and the strength factor s. An infinite strength factor gives an infinite
/// area: the bond never breaks.
#[rendered]
pub fn weakest_section<S: Real>(radii: [S; 2], strength_factor: S) -> S {
    let weakest = strength_factor * radii[0].min(radii[1]);
    weakest * weakest * PI
}

/// Strength factor of a bond that breaks when its normal force alone reaches `force` in N; `strength` in Pa.
///
/// $$ s = \frac{1}{\min\{r_i, r_j\}} \sqrt{\frac{Q}{\pi \sigma}} $$
///
/// The inverse of [`weakest_section`] times the strength: forces Q that are drawn from any distribution, independently
/// of the radii, are then exactly the strengths of the bonds.
#[rendered]
pub fn strength_factor_for(force: f64, strength: f64, radii: [f64; 2]) -> f64 {
    (force / (PI * strength)).sqrt() / radii[0].min(radii[1])
}

/// Zhang-Eckert yield criterion of brittle fracture.
///
/// # Equation
/// Thesis eqs. (48)-(50):
///
/// $$ \left( \frac{F^n}{\sigma^n} \right)^2 + \left( \frac{F^t}{\sigma^t} \right)^2 \ge \left( \pi (s\, r^{crit})^2 \right)^2, \qquad r^{crit} = \min\{r_i, r_j\} $$
///
/// # Symbols
/// $F^n$ and $F^t$ are the normal and tangential force in N, $\sigma^n$ `normal_strength` in Pa, $\sigma^t$
/// `tangential_strength` in Pa, $s$ the strength factor, and $r_i$, $r_j$ the radii in m.
///
/// # Domain
/// The forces include their viscous parts: (46) is written for stresses, and the stress of a Kelvin-Voigt solid
/// (2) has an elastic and a viscous part. Tension and compression are treated alike.
///
/// # Example
/// A bond between granite particles of 1 mm carries 280 MPa on pi mm^2.
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
    /// Ratio of the semi-axes of the yield ellipse in stress space, dimensionless, thesis eq. (47).
    pub fn axial_ratio(self) -> f64 {
        self.tangential_strength / self.normal_strength
    }

    /// Whether a bond breaks under the given forces in N, for radii in m.
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
    fn terms<S: Real>(self, normal_force: S, tangential_force: S) -> [S; 2] {
        let normal = normal_force * (1.0 / self.normal_strength);
        let tangential = tangential_force * (1.0 / self.tangential_strength);
        [normal * normal, tangential * tangential]
    }
}

/// Zhang-Eckert yield criterion with another strength in tension.
///
/// # Equation
/// As [`ZhangEckert`], with $\sigma^n$ replaced by `tensile_strength` while the bond pulls, that is, for a positive
/// normal force. The yield curve consists of two half ellipses, which meet at zero normal force.
///
/// # Example
/// ```
/// use gouge_dem::laws::{YieldLaw, ZhangEckert, ZhangEckertTensile};
/// let law = ZhangEckertTensile {
///     otherwise: ZhangEckert { normal_strength: 280e6, tangential_strength: 168e6 },
///     tensile_strength: 20e6,
/// };
/// assert!(law.is_exceeded(20.0, 0.0, 1e-6) && !law.is_exceeded(-279.0, 0.0, 1e-6));
/// ```
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZhangEckertTensile {
    /// The criterion in compression and shear.
    pub otherwise: ZhangEckert,
    /// Ultimate tensile strength in Pa.
    pub tensile_strength: f64,
}

impl YieldLaw for ZhangEckertTensile {
    #[inline(always)]
    fn terms<S: Real>(self, normal_force: S, tangential_force: S) -> [S; 2] {
        let ratio = self.otherwise.normal_strength / self.tensile_strength;
        // Selected, so that loops over bonds are vectorised.
        let pull = if normal_force > S::zero() { ratio } else { 1.0 };
        self.otherwise.terms(normal_force * pull, tangential_force)
    }
}
