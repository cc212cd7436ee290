//! Outcomes of tests for which theory has an expression.

use gouge_dem::calibration::truncated_restitution;
use gouge_runner::scene::Scene;
use serde::Deserialize;
use std::f64::consts::PI;

/// An expression for the outcome of a test. What a run deviates from it is emulated.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum ClosedForm {
    /// Restitution of two grains with truncated Kelvin-Voigt contacts that meet head on.
    KelvinVoigtRestitution,
    /// Young's modulus of a hexagonal lattice of equal grains and Euler-Bernoulli bonds, in Pa.
    ///
    /// E = 2 sqrt(3) k_n (1 + a) / ((3 + a) L), a = k_t / (2 k_n), with the thickness of the slice L = 2 r.
    HexagonalModulus,
    /// Poisson's ratio of the same lattice: (1 - a) / (3 + a).
    HexagonalPoissonsRatio,
}

const CONTACT: [&str; 2] = ["contact.normal.stiffness", "contact.normal.damping"];
const BOND: [&str; 2] = ["bond.normal.stiffness", "bond.tangential.stiffness"];

impl ClosedForm {
    /// The keys that enter. All others must have the same values in all runs.
    pub fn keys(self) -> [&'static str; 2] {
        match self {
            Self::KelvinVoigtRestitution => CONTACT,
            Self::HexagonalModulus | Self::HexagonalPoissonsRatio => BOND,
        }
    }

    /// The outcome for the values of its two keys in a scene; none for a scene that does not fit.
    pub fn value(self, scene: &Scene, [first, second]: [f64; 2]) -> Option<f64> {
        let stiffness_ratio = 0.5 * second / first;
        match self {
            Self::KelvinVoigtRestitution => {
                let [one, other] = scene.particles.as_slice() else {
                    return None;
                };
                let mass = |radius: f64, density: f64| 4.0 / 3.0 * PI * radius.powi(3) * density;
                let [one, other] = [one, other].map(|grain| mass(grain.radius, grain.density));
                let reduced = one * other / (one + other);
                let ratio = second / (2.0 * (first * reduced).sqrt());
                Some(truncated_restitution(ratio))
            }
            Self::HexagonalModulus => {
                let thickness = scene.keys.number("setup.sizes.minimum")? * 2.0;
                let factor = (1.0 + stiffness_ratio) / (3.0 + stiffness_ratio);
                Some(2.0 * 3.0_f64.sqrt() * first * factor / thickness)
            }
            Self::HexagonalPoissonsRatio => Some((1.0 - stiffness_ratio) / (3.0 + stiffness_ratio)),
        }
    }
}
