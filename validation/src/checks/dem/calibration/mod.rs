//! The calibration chain.

use crate::checks::{Check, Effort, Origin, Topic, thesis};

mod chain;
mod pinned;
mod rebounds;

/// The topic.
pub fn topic() -> Topic {
    let mut checks = recomputed();
    checks.extend(propagated());
    checks.extend(collided());
    Topic {
        id: "calibration",
        title: "Calibration",
        about: "The calibration chain (87)-(97) of the thesis, recomputed with its uncertainties, and how grains with the printed parameters collide.",
        checks,
    }
}

/// Checks of formulas and constants.
fn recomputed() -> Vec<Check> {
    vec![
        Check {
            id: "calibration.functions",
            claim: "Every formula of the calibration chain agrees with an independent numerical solution.",
            equations: thesis("(87)-(97), (100)"),
            scene: "None: formulas, for granite and variations of it",
            oracle: "Hertz's pressure integrated over the contact, discs stacked to a sphere, force balances solved by bisection, collisions and the decay of friction integrated by extrapolated midpoint steps",
            norm: "Largest relative error",
            origin: Origin::Convergent,
            reason: "Quadrature and integration are converged to 1e-13; strong damping amplifies this by up to 4 zeta^2 = 400, and the inversion of a restitution near one by 1 / (1 - e) = 100",
            effort: Effort::Quick,
            measure: pinned::functions,
        },
        Check {
            id: "calibration.granite",
            claim: "The kernel's granite has the values and uncertainties given in the thesis.",
            equations: thesis("section 4.1, section 4.3"),
            scene: "None: constants",
            oracle: "The text of the thesis",
            norm: "Largest difference in units in the last place",
            origin: Origin::Exact,
            reason: "The kernel's literal and the printed decimal round to the same double",
            effort: Effort::Quick,
            measure: chain::granite,
        },
        Check {
            id: "calibration.first-order",
            claim: "The first coefficient of the restitution of viscoelastic spheres is 1.153448872..., both from the slope of integrated collisions and from the energy dissipated along Hertz's motion; the second coefficient is 3/5 of its square.",
            equations: thesis("(93)"),
            scene: "None: the kernel's coefficient and two oracles",
            oracle: "Collisions integrated in double-double with b = 1/4 ... 1/1024, extrapolated in powers 1, 3/2, 2, ...; (4/5) (5/4)^(3/5) B(3/5, 3/2)",
            norm: "Largest relative difference",
            origin: Origin::Convergent,
            reason: "Eight powers of b are removed. What is left is b^5 = 1e-3 of the coarsest run times its weight in the limit, 1 / (1 1.8 3 4.7 7 10.3 15 21.6): 1e-8 for the first coefficient at 1e-1 of its size, so 1e-9. The second coefficient is divided by the smallest b, so its tolerance is a thousand times larger",
            effort: Effort::Quick,
            measure: pinned::first_order,
        },
    ]
}

/// Checks of how the uncertainties of the inputs propagate.
fn propagated() -> Vec<Check> {
    vec![
        Check {
            id: "calibration.uncertainty",
            claim: "The standard uncertainties of the chain are those of products of powers: 2.2e6 kg/s^2 for the stiffness (the thesis prints 7e6), 0.63e-4 s for the dissipative constant, 0.49e3 kg/s for the bound of the damping.",
            equations: thesis("(87)-(97)"),
            scene: "Granite with the standard uncertainties of thesis sections 4.1 and 4.3",
            oracle: "Products of powers: the exponents of density, modulus, 1 - nu^2, strength and 1 - restitution in each quantity",
            norm: "Largest relative error of the value or of the first-order uncertainty",
            origin: Origin::Convergent,
            reason: "The kernel is differentiated by central differences with 1e-5 of the uncertainties: (1e-5)^2 by truncation and 1e-16 / 1e-5 by rounding",
            effort: Effort::Quick,
            measure: chain::uncertainty,
        },
        Check {
            id: "calibration.monte-carlo",
            claim: "Means over sampled inputs agree with the exact means. The distributions are skewed, so the medians in the table differ from the central values.",
            equations: thesis("(87)-(97)"),
            scene: "200 000 samples of normal inputs, truncated to positive moduli, Poisson's ratios in (-1, 1/2) and restitutions in (0, 1)",
            oracle: "Each quantity is a product of powers of independent inputs: its moments are products of one-dimensional integrals",
            norm: "Distance of the sample mean from the exact mean, in exact standard errors",
            origin: Origin::Statistical,
            reason: "Five standard errors: a correct mean fails for one seed in 2e6 per quantity. A wrong factor of 1.01 is detected in every quantity with a power above 0.9999",
            effort: Effort::Thorough,
            measure: chain::monte_carlo,
        },
    ]
}

/// Checks of collisions with calibrated parameters.
fn collided() -> Vec<Check> {
    vec![
        Check {
            id: "calibration.damping",
            claim: "Grains with the printed damping of 10 kg/s rebound with a restitution of 0.2228. The measured restitution of 0.83 needs 0.9267 kg/s for grains of 1 mm; with the damping computed for each size, the kernel's grains reach 0.83.",
            equations: thesis("(35), (36), section 4.3"),
            scene: "Collisions of the smallest, mean and largest grains, and of grains with the density of a block packed to 0.84",
            oracle: "Closed form of the restitution; its inverse by bisection",
            norm: "Largest relative error of restitution and damping",
            origin: Origin::Convergent,
            reason: "As for pairs.kelvin-voigt, extrapolated to zero time step: 1e-10 from the sixth power of the coarsest step and 3e-10 from rounding",
            effort: Effort::Quick,
            measure: rebounds::damping,
        },
        Check {
            id: "calibration.dissipative-constant",
            claim: "Spheres of 1 m diameter at 1 m/s rebound with 0.83 for a dissipative constant of 1.838e-4 s, with 0.8475 for the first-order 1.625e-4 s, and with 0.061 for the printed 6e-3. The constant fitted to these spheres stops grains of 1 mm.",
            equations: thesis("(37), (93)"),
            scene: "Collisions of granite spheres of 1 m diameter, and of 1 mm radius, at 1 m/s",
            oracle: "Bisection over integrated collisions",
            norm: "Largest relative error of the restitution",
            origin: Origin::Convergent,
            reason: "As for pairs.viscoelastic up to b = 0.17. The other runs have smaller time steps in proportion to b, up to 83; there, few steps resolve the onset, and dt^4 counts about ten times as much: 1e-8",
            effort: Effort::Quick,
            measure: rebounds::constant,
        },
    ]
}
