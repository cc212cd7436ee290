//! Normal forces whose damping is scaled so that every pair rebounds with the same restitution.

use super::normal::{Bshp, KelvinVoigt, NormalLaw, reduced_radius};
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Truncated Kelvin-Voigt normal force with the same coefficient of restitution for every pair.
///
/// # Equation
/// As [`KelvinVoigt`], with the damping of the pair
///
/// $$ \gamma_{ij} = 2 \zeta \sqrt{k\, m_{ij}}, \qquad \frac{1}{m_{ij}} = \frac{1}{m_i} + \frac{1}{m_j} $$
///
/// # Symbols
/// $\zeta$ is the damping ratio, dimensionless, $k$ the stiffness in kg/s^2 and $m_{ij}$ the reduced mass in kg. The
/// damping ratio alone determines the restitution
/// ([`damping_ratio_for`](crate::calibration::damping_ratio_for)).
///
/// # Domain
/// A particle that forces cannot move counts as infinitely heavy. A pair of two such particles is not damped.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReboundingKelvinVoigt {
    /// The law of a pair with the reduced mass 1 kg.
    pub of_unit_mass: KelvinVoigt,
}

impl NormalLaw for ReboundingKelvinVoigt {
    const SCALES_DAMPING: bool = true;
    #[inline(always)]
    fn damping_factor<S: Real>(self, _: [S; 2], reduced_mass: S) -> S {
        reduced_mass.sqrt()
    }
    #[inline(always)]
    fn force<S: Real>(self, radii: [S; 2], xi: S, d_xi: S) -> S {
        self.of_unit_mass.force(radii, xi, d_xi)
    }
    #[inline(always)]
    fn elastic_force<S: Real>(self, radii: [S; 2], xi: S) -> S {
        self.of_unit_mass.elastic_force(radii, xi)
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, radii: [S; 2], xi: S) -> S {
        self.of_unit_mass.stored_energy(radii, xi)
    }
    fn linearised(self, radii: [f64; 2], reduced_mass: f64) -> [f64; 2] {
        let [stiffness, damping] = self.of_unit_mass.linearised(radii, reduced_mass);
        [
            stiffness,
            damping * self.damping_factor(radii, reduced_mass),
        ]
    }
}

/// Normal force of viscoelastic spheres with the same coefficient of restitution for every pair, at one relative speed.
///
/// # Equation
/// As [`Bshp`], with the dissipative constant of the pair
///
/// $$ \Lambda_{ij} = b \left( \frac{m_{ij}}{P_{ij}} \right)^{2/5} v^{-1/5} \propto \left( \frac{m_{ij}^2}{R_{ij}} \right)^{1/5} $$
///
/// # Symbols
/// $m_{ij}$ is the reduced mass in kg, $R_{ij} = r_i r_j / (r_i + r_j)$ the reduced radius in m, $P_{ij}$ the prefactor
/// of the force in N/m^(3/2) and $v$ the relative speed in m/s. In units of the length $(m v^2 / P)^{2/5}$ and of the
/// time in which $v$ covers it, only $b$ is left in the equation of motion, so that $b$ alone determines the restitution
/// ([`dissipation_for`](crate::calibration::dissipation_for)).
///
/// # Domain
/// A particle that forces cannot move counts as infinitely heavy. A pair of two such particles is not damped.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReboundingBshp {
    /// The law of a pair with the reduced mass 1 kg and the reduced radius 1 m.
    pub of_unit_pair: Bshp,
}

impl NormalLaw for ReboundingBshp {
    const SCALES_DAMPING: bool = true;
    #[inline(always)]
    fn damping_factor<S: Real>(self, radii: [S; 2], reduced_mass: S) -> S {
        (reduced_mass * reduced_mass / reduced_radius(radii)).powf(0.2)
    }
    #[inline(always)]
    fn force<S: Real>(self, radii: [S; 2], xi: S, d_xi: S) -> S {
        self.of_unit_pair.force(radii, xi, d_xi)
    }
    #[inline(always)]
    fn elastic_force<S: Real>(self, radii: [S; 2], xi: S) -> S {
        self.of_unit_pair.elastic_force(radii, xi)
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, radii: [S; 2], xi: S) -> S {
        self.of_unit_pair.stored_energy(radii, xi)
    }
    fn linearised(self, radii: [f64; 2], reduced_mass: f64) -> [f64; 2] {
        let [stiffness, damping] = self.of_unit_pair.linearised(radii, reduced_mass);
        [
            stiffness,
            damping * self.damping_factor(radii, reduced_mass),
        ]
    }
}
