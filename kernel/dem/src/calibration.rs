//! How the thesis fixes its calibration parameters, section 4.3, eqs. (87)-(97), and (100).

use crate::laws::Bshp;
use crate::material::Elastic;
use crate::particles::sphere_mass;
use core::f64::consts::PI;
use gouge_equations::rendered;

/// Normal displacement in m at which a bond of equal particles breaks under pure compression, if the
/// contact is Kelvin-Voigt.
///
/// $$ \xi = \frac{\pi (s r)^2 \sigma}{k} $$
///
/// Thesis eqs. (87)-(89): stiffness in kg/s^2, radius in m, strength in Pa.
#[rendered]
pub fn breaking_overlap_linear(
    stiffness: f64,
    radius: f64,
    strength: f64,
    strength_factor: f64,
) -> f64 {
    breaking_force(radius, strength, strength_factor) / stiffness
}

/// The same for BSHP.
///
/// $$ \xi = \left( \frac{\pi (s r)^2 \sigma}{P} \right)^{2/3} $$
///
/// Thesis eqs. (90)-(91).
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

/// Stiffness in kg/s^2 with which both overlaps at break agree.
///
/// $$ k^n = \left( P^2\, \pi (s r)^2 \sigma \right)^{1/3} $$
///
/// Thesis eq. (92). For granite 8.14e6 kg/s^2; the thesis takes 1e7.
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

/// Upper bound of the damping in kg/s: the dissipative constant times [`matching_stiffness`].
///
/// $$ \gamma^n < \Lambda k^n $$
///
/// Thesis eqs. (94)-(97). With the constant that the thesis prints the bound is 5.1e4 kg/s, with the
/// right one 1.3e3 kg/s (erratum E5 of the thesis).
#[rendered]
pub fn damping_bound(dissipative_constant: f64, matching_stiffness: f64) -> f64 {
    dissipative_constant * matching_stiffness
}

/// Dissipative constant in s of spheres that rebound with a measured restitution, to first order.
///
/// $$ \Lambda = \frac{1 - \Upsilon}{C_1 \kappa^{2/5} v^{1/5}}, \qquad \kappa = \frac{P}{m^*}, \qquad C_1 = \frac{\sqrt\pi\, \Gamma(3/5)}{2^{1/5} 5^{2/5}\, \Gamma(21/10)} = 1.15345 $$
///
/// Thesis eq. (93) with the ratio of stiffness to reduced mass that its source calls rho, where the
/// thesis put the mass density (erratum E4 of the thesis): speed in m/s, radius in m of both spheres,
/// density in kg/m^3.
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

/// Thesis eq. (93) as printed, with the mass density in kg/m^3; neither in s nor in 1/s.
pub fn dissipative_constant_printed_from_restitution(
    restitution: f64,
    density: f64,
    speed: f64,
) -> f64 {
    (1.0 - restitution) / (1.15 * libm::pow(density * density * speed, 0.2))
}

/// Coefficient of the first term of one minus the restitution of viscoelastic spheres.
pub fn first_order_coefficient() -> f64 {
    PI.sqrt() * libm::tgamma(0.6) / (libm::pow(2.0, 0.2) * libm::pow(5.0, 0.4) * libm::tgamma(2.1))
}

/// Duration, in units of the inverse natural frequency, of a truncated Kelvin-Voigt collision.
///
/// $$ t = \frac{2 \arccos \zeta}{\sqrt{1 - \zeta^2}}, \quad \zeta < 1, \qquad t = \frac{2\, \mathrm{arcosh}\, \zeta}{\sqrt{\zeta^2 - 1}}, \quad \zeta > 1 $$
///
/// The collision ends when the force first vanishes, before the overlap does; 2 at critical damping.
/// The damping ratio is that of the pair with its reduced mass.
#[rendered]
pub fn truncated_duration(damping_ratio: f64) -> f64 {
    let squared = (1.0 - damping_ratio) * (1.0 + damping_ratio);
    let w = squared.abs().sqrt();
    if squared > 0.0 {
        2.0 * libm::atan2(w, damping_ratio) / w
    } else if w > 0.0 {
        2.0 * libm::asinh(w) / w
    } else {
        2.0
    }
}

/// Restitution of a truncated Kelvin-Voigt collision.
///
/// $$ \Upsilon = e^{-\zeta t} $$
///
/// Tends to 1 / (4 zeta^2) for strong damping.
#[rendered]
pub fn truncated_restitution(damping_ratio: f64) -> f64 {
    libm::exp(-damping_ratio * truncated_duration(damping_ratio))
}

/// Damping ratio with which a truncated Kelvin-Voigt collision has a restitution in (0, 1].
///
/// By bisection; the restitution falls monotonically with the damping ratio.
pub fn damping_ratio_for(restitution: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    while truncated_restitution(high) > restitution && high < 1e150 {
        (low, high) = (high, 2.0 * high);
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if truncated_restitution(middle) > restitution {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Model of the decay of friction after its peak.
///
/// $$ \mu(t) = \begin{cases} \mu^{crit} t / t^{crit}, & t \le t^{crit} \\ D_1 + (\mu^{crit} - D_1) e^{-D_2 (t - t^{crit})}, & t \ge t^{crit} \end{cases} $$
///
/// Thesis eq. (100); it tends to D1 at late times (101) if D2 is positive.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionDecay {
    /// Time of the peak in s.
    pub peak_time: f64,
    /// Coefficient of friction at the peak.
    pub peak: f64,
    /// Coefficient of friction at late times, D1.
    pub residual: f64,
    /// Decay constant D2 in 1/s.
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

/// Force in N that breaks a bond of equal particles in compression, thesis eq. (87).
fn breaking_force(radius: f64, strength: f64, strength_factor: f64) -> f64 {
    let weakest = strength_factor * radius;
    PI * weakest * weakest * strength
}

/// Prefactor of BSHP for equal radii in N/m^(3/2).
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
