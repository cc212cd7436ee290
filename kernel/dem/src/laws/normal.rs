//! Normal forces of contacts and bonds, thesis eqs. (35)-(40) and (43).

use crate::material::Elastic;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Normal law of a contact.
pub trait NormalLaw: Copy + Send + Sync {
    /// Whether the damping of a pair depends on its reduced mass.
    const SCALES_DAMPING: bool = false;
    /// Factor of the damping of a pair beside that of the law, for the radii in m and the reduced mass in kg of the pair.
    ///
    /// The force depends on the rate only in its product with the damping, so a pair has the force of the law at the
    /// rate times this factor.
    #[inline(always)]
    fn damping_factor<S: Real>(self, _radii: [S; 2], _reduced_mass: S) -> S {
        S::from_f64(1.0)
    }
    /// Force in N along the normal, never positive: contacts only repel.
    ///
    /// `xi` is the normal displacement in m, `d_xi` its rate in m/s, and `radii` are the radii of the pair in m.
    fn force<S: Real>(self, radii: [S; 2], xi: S, d_xi: S) -> S;
    /// Elastic part of the force in N: the derivative of [`stored_energy`](Self::stored_energy), with a minus sign.
    fn elastic_force<S: Real>(self, radii: [S; 2], xi: S) -> S;
    /// Stored energy in J; zero without overlap.
    fn stored_energy<S: Real>(self, radii: [S; 2], xi: S) -> S;
    /// Stiffness in kg/s^2 and damping in kg/s of the linearised law, from which bounds of the time step follow, for a
    /// pair with radii in m and its reduced mass in kg. A nonlinear law is linearised at [`typical_overlap`].
    fn linearised(self, radii: [f64; 2], reduced_mass: f64) -> [f64; 2];
}

/// Overlap in m at which a nonlinear law is linearised: a tenth of the smaller radius.
pub fn typical_overlap(radii: [f64; 2]) -> f64 {
    0.1 * radii[0].min(radii[1])
}

/// Truncated Kelvin-Voigt normal force of a contact.
///
/// # Equation
/// Thesis eqs. (35)-(36):
///
/// $$ F^n = \min\{0, -(k \xi + \gamma\, \partial_t \xi)\}, \qquad \xi \ge 0 $$
///
/// # Symbols
/// $\xi$ is the normal displacement in m, $\partial_t \xi$ its rate in m/s, $k$ `stiffness` in kg/s^2 and $\gamma$
/// `damping` in kg/s.
///
/// # Sign
/// A negative force is repulsive; it is never positive.
///
/// # Domain
/// Zero for negative displacement: without this condition, approaching particles would repel each other before they
/// touch (erratum E14 of the thesis). At the kinks a dual number returns the derivative of the branch taken.
///
/// # Energy
/// Stored energy $\tfrac12 k \xi^2$, thesis eq. (75).
///
/// # Example
/// ```
/// use gouge_dem::laws::{KelvinVoigt, NormalLaw};
/// let law = KelvinVoigt { stiffness: 1000.0, damping: 2.0 };
/// assert_eq!(law.force([1.0, 1.0], 0.01, 3.0), -16.0);
/// assert_eq!(law.force([1.0, 1.0], 0.01, -6.0), 0.0);
/// ```
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KelvinVoigt {
    /// Stiffness k in kg/s^2.
    pub stiffness: f64,
    /// Damping coefficient in kg/s.
    pub damping: f64,
}

impl NormalLaw for KelvinVoigt {
    #[inline(always)]
    fn force<S: Real>(self, _: [S; 2], xi: S, d_xi: S) -> S {
        let force = S::zero().min(-(xi * self.stiffness + d_xi * self.damping));
        // Selected at the end, so that loops over contacts are vectorised.
        if xi < S::zero() { S::zero() } else { force }
    }
    #[inline(always)]
    fn elastic_force<S: Real>(self, _: [S; 2], xi: S) -> S {
        -(xi.max(S::zero()) * self.stiffness)
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, _: [S; 2], xi: S) -> S {
        let xi = xi.max(S::zero());
        xi * xi * (0.5 * self.stiffness)
    }
    fn linearised(self, _: [f64; 2], _: f64) -> [f64; 2] {
        [self.stiffness, self.damping]
    }
}

/// Brilliantov-Spahn-Hertzsch-Pöschel normal force of viscoelastic spheres in contact.
///
/// # Equation
/// Thesis eqs. (37) and (40), with the shear modulus $G = Y / (2 (1 + \nu))$ of (39):
///
/// $$ F^n = \min\{0, -P (\xi \sqrt{\xi} + \Lambda \sqrt{\xi}\, \partial_t \xi)\}, \qquad P = \frac{2 G \sqrt2}{3 (1 - \nu)} \sqrt{\frac{2}{1/r_i + 1/r_j}} $$
///
/// # Symbols
/// $\xi$ is the normal displacement in m, $\partial_t \xi$ its rate in m/s, $Y$ `youngs_modulus` in Pa, $\nu$
/// `poissons_ratio` and $\Lambda$ `dissipative_constant` in s; $r_i$ and $r_j$ are the radii in m.
///
/// # Sign
/// A negative force is repulsive; it is never positive.
///
/// # Domain
/// Zero for negative displacement.
///
/// # Energy
/// Stored energy $\tfrac25 P \xi^{5/2}$, thesis eq. (75).
///
/// # Errata
/// $\Lambda$ is the coefficient in (37). The constant $A$ of the original paper is two thirds of it, so (38) must be
/// multiplied by 3/2 (erratum E1 of the thesis).
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bshp {
    /// Young's modulus Y in Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio, dimensionless, in (-1, 1/2).
    pub poissons_ratio: f64,
    /// Dissipative constant Lambda in s.
    pub dissipative_constant: f64,
}

#[rendered]
impl Bshp {
    /// Prefactor P of the force, in N/m^(3/2).
    ///
    /// $$ P = \frac{2 Y}{3 (1 - \nu^2)} \sqrt{\frac{r_i r_j}{r_i + r_j}} $$
    ///
    /// # Example
    /// Two granite spheres of 1 mm, with a reduced radius of 0.5 mm.
    /// ```
    /// let granite = gouge_dem::laws::Bshp {
    ///     youngs_modulus: 50e9, poissons_ratio: 0.22, dissipative_constant: 0.0,
    /// };
    /// assert!((granite.prefactor([1e-3, 1e-3]) / 7.832660703e8 - 1.0_f64).abs() < 1e-9);
    /// ```
    #[inline(always)]
    pub fn prefactor<S: Real>(self, radii: [S; 2]) -> S {
        let reduced_radius = reduced_radius(radii);
        let modulus = self.youngs_modulus / (1.0 - self.poissons_ratio * self.poissons_ratio);
        reduced_radius.sqrt() * (2.0 / 3.0 * modulus)
    }
}

/// Reduced radius of a pair in m.
#[inline(always)]
pub(super) fn reduced_radius<S: Real>(radii: [S; 2]) -> S {
    radii[0] * radii[1] / (radii[0] + radii[1])
}

impl NormalLaw for Bshp {
    #[inline(always)]
    fn force<S: Real>(self, radii: [S; 2], xi: S, d_xi: S) -> S {
        let rate = xi + d_xi * self.dissipative_constant;
        let root = xi.max(S::zero()).sqrt();
        let force = S::zero().min(-(self.prefactor(radii) * root * rate));
        if xi < S::zero() { S::zero() } else { force }
    }
    #[inline(always)]
    fn elastic_force<S: Real>(self, radii: [S; 2], xi: S) -> S {
        let xi = xi.max(S::zero());
        -(self.prefactor(radii) * xi * xi.sqrt())
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, radii: [S; 2], xi: S) -> S {
        let xi = xi.max(S::zero());
        self.prefactor(radii) * xi * xi * xi.sqrt() * 0.4
    }
    fn linearised(self, radii: [f64; 2], _: f64) -> [f64; 2] {
        let slope = 1.5 * self.prefactor(radii) * typical_overlap(radii).sqrt();
        [slope, slope / 1.5 * self.dissipative_constant]
    }
}

/// Dissipative constant of viscoelastic spheres, from their viscosities, in s.
///
/// $$ A = \frac{1}{Y} \frac{1 + \nu}{1 - \nu} \left( \tfrac43 \eta_G (1 - \nu + \nu^2) + \eta_K (1 - 2 \nu)^2 \right), \qquad \Lambda = \tfrac32 A $$
///
/// Shear viscosity $\eta_G$ and bulk viscosity $\eta_K$ in Pa s. This replaces thesis eq. (38), whose constant
/// vanishes at $3 \eta_K = \eta_G$ and is wrong for viscosities proportional to the moduli; E2 of
/// `docs/thesis/errata.md` has the derivation. For the printed form see [`dissipative_constant_printed`].
#[rendered]
pub fn dissipative_constant(elastic: Elastic, shear_viscosity: f64, bulk_viscosity: f64) -> f64 {
    let nu = elastic.poissons_ratio;
    let viscosity = 4.0 / 3.0 * shear_viscosity * (1.0 - nu + nu * nu)
        + bulk_viscosity * (1.0 - 2.0 * nu) * (1.0 - 2.0 * nu);
    1.5 * (1.0 + nu) / (1.0 - nu) * viscosity / elastic.youngs_modulus
}

/// Dissipative constant as printed in thesis eq. (38), in s; use [`dissipative_constant`] instead.
///
/// $$ \Lambda = \frac{1}{3 M} \left( \frac{1 - \nu}{\nu} \right)^2 \frac{(3 \eta_K - \eta_G)^2}{3 \eta_K + 2 \eta_G} $$
#[rendered]
pub fn dissipative_constant_printed(
    elastic: Elastic,
    shear_viscosity: f64,
    bulk_viscosity: f64,
) -> f64 {
    let shape = (1.0 - elastic.poissons_ratio) / elastic.poissons_ratio;
    let difference = 3.0 * bulk_viscosity - shear_viscosity;
    let total = 3.0 * bulk_viscosity + 2.0 * shear_viscosity;
    shape * shape * difference * difference / (3.0 * elastic.p_wave_modulus() * total)
}

/// Kelvin-Voigt normal force of a bond, relative to its initial length.
///
/// # Equation
/// Thesis eqs. (33) and (43):
///
/// $$ F^n = -(\bar k\, \Xi + \bar\gamma\, \partial_t \Xi), \qquad \Xi = D(t^{init}) - D $$
///
/// # Symbols
/// $D$ is the distance of the centres in m, $\Xi$ the adjusted normal displacement in m, $\bar k$ `stiffness` in
/// kg/s^2 and $\bar\gamma$ `damping` in kg/s.
///
/// # Sign
/// $\Xi$ is positive in compression. A negative force is repulsive, a positive one attractive.
///
/// # Energy
/// Stored energy $\tfrac12 \bar k\, \Xi^2$, thesis eq. (77). Heat production $\bar\gamma\, (\partial_t \Xi)^2$.
///
/// # Errata
/// The displacement is relative to the initial distance, not to the sum of the contact distances as printed in (33).
/// Both are equal only for focal distances (erratum E12 of the thesis).
///
/// # Example
/// ```
/// let law = gouge_dem::laws::AdjustedKelvinVoigt { stiffness: 100.0, damping: 3.0 };
/// assert_eq!(law.force(0.5, -1.0), -47.0);
/// ```
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AdjustedKelvinVoigt {
    /// Stiffness in kg/s^2.
    pub stiffness: f64,
    /// Damping coefficient in kg/s.
    pub damping: f64,
}

impl AdjustedKelvinVoigt {
    /// Force in N along the normal; a positive force is attractive.
    #[inline(always)]
    pub fn force<S: Real>(self, xi_adjusted: S, d_xi: S) -> S {
        -(xi_adjusted * self.stiffness + d_xi * self.damping)
    }
    /// Stored energy in J.
    #[inline(always)]
    pub fn stored_energy<S: Real>(self, xi_adjusted: S) -> S {
        xi_adjusted * xi_adjusted * (0.5 * self.stiffness)
    }
    /// Heat production in W, never negative.
    #[inline(always)]
    pub fn heat_rate<S: Real>(self, d_xi: S) -> S {
        d_xi * d_xi * self.damping
    }
}
