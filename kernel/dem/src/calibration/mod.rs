//! Calibration of the model parameters, thesis section 4.3, eqs. (87)-(97), and the friction decay (100).

mod restitution;

pub use restitution::{
    damping_ratio_for, dissipation_for, rebounding_bshp, rebounding_kelvin_voigt,
    truncated_duration, truncated_restitution, viscoelastic_restitution,
};

use crate::laws::Bshp;
use crate::material::Elastic;
use crate::particles::sphere_mass;
use core::f64::consts::PI;
use gouge_equations::rendered;

/// Normal displacement in m at which a bond between equal particles breaks in pure compression, with Kelvin-Voigt
/// contacts.
///
/// $$ \xi = \frac{\pi (s r)^2 \sigma}{k} $$
///
/// Thesis eqs. (87)-(89): stiffness $k$ in kg/s^2, radius $r$ in m, strength $\sigma$ in Pa, strength factor $s$.
#[rendered]
pub fn breaking_overlap_linear(
    stiffness: f64,
    radius: f64,
    strength: f64,
    strength_factor: f64,
) -> f64 {
    breaking_force(radius, strength, strength_factor) / stiffness
}

/// Normal displacement in m at which a bond between equal particles breaks in pure compression, with BSHP contacts.
///
/// $$ \xi = \left( \frac{\pi (s r)^2 \sigma}{P} \right)^{2/3} $$
///
/// Thesis eqs. (90)-(91): radius $r$ in m, strength $\sigma$ in Pa, strength factor $s$; $P$ is the
/// [`Bshp::prefactor`].
#[rendered]
pub fn breaking_overlap_hertzian(
    elastic: Elastic,
    radius: f64,
    strength: f64,
    strength_factor: f64,
) -> f64 {
    let force = breaking_force(radius, strength, strength_factor);
    libm::pow(force / prefactor(elastic, radius), 2.0 / 3.0)
}

/// Stiffness in kg/s^2 for which [`breaking_overlap_linear`] and [`breaking_overlap_hertzian`] agree.
///
/// $$ k^n = \left( P^2\, \pi (s r)^2 \sigma \right)^{1/3} $$
///
/// Thesis eq. (92). 8.14e6 kg/s^2 for granite; the thesis uses 1e7.
#[rendered]
pub fn matching_stiffness(
    elastic: Elastic,
    radius: f64,
    strength: f64,
    strength_factor: f64,
) -> f64 {
    let p = prefactor(elastic, radius);
    libm::cbrt(p * p * breaking_force(radius, strength, strength_factor))
}

/// Upper bound of the normal damping in kg/s: dissipative constant times [`matching_stiffness`].
///
/// $$ \gamma^n < \Lambda k^n $$
///
/// Thesis eqs. (94)-(97). For granite 5.1e4 kg/s with the dissipative constant printed in the thesis, and 1.3e3
/// kg/s with the correct one (erratum E5 of the thesis).
#[rendered]
pub fn damping_bound(dissipative_constant: f64, matching_stiffness: f64) -> f64 {
    dissipative_constant * matching_stiffness
}

/// Dissipative constant in s of spheres with a measured coefficient of restitution, to first order.
///
/// $$ \Lambda = \frac{1 - \Upsilon}{C_1 \kappa^{2/5} v^{1/5}}, \qquad \kappa = \frac{P}{m^*}, \qquad C_1 = \frac{\sqrt\pi\, \Gamma(3/5)}{2^{1/5} 5^{2/5}\, \Gamma(21/10)} = 1.15345 $$
///
/// Thesis eq. (93), for two equal spheres with radius in m, density in kg/m^3 and relative speed in m/s. $\kappa$
/// is the ratio of stiffness to reduced mass. The source calls it rho, which the thesis mistook for the mass
/// density (erratum E4 of the thesis).
#[rendered]
pub fn dissipative_constant_from_restitution(
    restitution: f64,
    elastic: Elastic,
    density: f64,
    radius: f64,
    speed: f64,
) -> f64 {
    let kappa = prefactor(elastic, radius) / (0.5 * sphere_mass(density, radius));
    let scale = first_order_coefficient() * libm::pow(kappa, 0.4) * libm::pow(speed, 0.2);
    (1.0 - restitution) / scale
}

/// Thesis eq. (93) as printed, with the mass density in kg/m^3. The result has no unit of time.
pub fn dissipative_constant_printed_from_restitution(
    restitution: f64,
    density: f64,
    speed: f64,
) -> f64 {
    (1.0 - restitution) / (1.15 * libm::pow(density * density * speed, 0.2))
}

/// First coefficient in the expansion of the restitution of viscoelastic spheres, dimensionless.
pub fn first_order_coefficient() -> f64 {
    PI.sqrt() * libm::tgamma(0.6) / (libm::pow(2.0, 0.2) * libm::pow(5.0, 0.4) * libm::tgamma(2.1))
}

/// Model of the decay of friction after the peak.
///
/// $$ \mu(t) = \begin{cases} \mu^{crit} t / t^{crit}, & t \le t^{crit} \\ D_1 + (\mu^{crit} - D_1) e^{-D_2 (t - t^{crit})}, & t \ge t^{crit} \end{cases} $$
///
/// Thesis eq. (100). If $D_2$ is positive, it tends to $D_1$ at late times, thesis eq. (101).
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionDecay {
    /// Time of the peak in s.
    pub peak_time: f64,
    /// Coefficient of friction at the peak, dimensionless.
    pub peak: f64,
    /// Residual coefficient of friction $D_1$ at late times, dimensionless.
    pub residual: f64,
    /// Decay rate $D_2$ in 1/s.
    pub rate: f64,
}

impl FrictionDecay {
    /// Coefficient of friction at a time in s.
    pub fn at(&self, time: f64) -> f64 {
        if time <= self.peak_time {
            self.peak * time / self.peak_time
        } else {
            let decay = libm::exp(-self.rate * (time - self.peak_time));
            self.residual + (self.peak - self.residual) * decay
        }
    }
}

/// Force in N that breaks a bond between equal particles in compression, thesis eq. (87).
fn breaking_force(radius: f64, strength: f64, strength_factor: f64) -> f64 {
    let weakest = strength_factor * radius;
    PI * weakest * weakest * strength
}

/// BSHP prefactor for equal radii, in N/m^(3/2).
fn prefactor(elastic: Elastic, radius: f64) -> f64 {
    let Elastic {
        youngs_modulus,
        poissons_ratio,
    } = elastic;
    Bshp {
        youngs_modulus,
        poissons_ratio,
        dissipative_constant: 0.0,
    }
    .prefactor([radius; 2])
}
