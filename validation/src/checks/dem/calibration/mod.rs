//! The chain of calibration.

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
        about: "The chain (87)-(97) of the thesis recomputed with its uncertainties, and what the printed parameters do to colliding grains.",
        checks,
    }
}

/// Checks of formulas and constants.
fn recomputed() -> Vec<Check> {
    vec![
        Check {
            id: "calibration.functions",
            claim: "Every function of the calibration chain gives what the fields in the spheres, root finding and integrated collisions give.",
            equations: thesis("(87)-(97), (100)"),
            scene: "None: granite and variations of it",
            oracle: "Hertz's pressure integrated over the contact, discs stacked to a sphere, bisection of forces, extrapolated midpoint integration of collisions",
            norm: "Largest relative error",
            origin: Origin::Convergent,
            reason: "Quadrature and integration are converged to 1e-13; strong damping magnifies that by up to 4 zeta^2, 400, and the inversion of a restitution near one by 1 / (1 - e), 100",
            effort: Effort::Quick,
            measure: pinned::functions,
        },
        Check {
            id: "calibration.granite",
            claim: "The granite of the kernel has the values and uncertainties that the thesis quotes.",
            equations: thesis("section 4.1, section 4.3"),
            scene: "None: constants",
            oracle: "The text of the thesis",
            norm: "Largest difference in units in the last place",
            origin: Origin::Exact,
            reason: "The nearest double to a printed decimal is that of the same decimal",
            effort: Effort::Quick,
            measure: chain::granite,
        },
        Check {
            id: "calibration.first-order",
            claim: "The first coefficient of the restitution of viscoelastic spheres is 1.153448872..., from the slope of integrated collisions and from the energy that Hertz's motion dissipates, and the second is 3/5 of its square.",
            equations: thesis("(93)"),
            scene: "None: the coefficient of the kernel and two oracles",
            oracle: "Collisions integrated in double-double with b = 1/4 ... 1/1024, extrapolated in powers 1, 3/2, 2, ...; (4/5) (5/4)^(3/5) B(3/5, 3/2)",
            norm: "Largest relative difference",
            origin: Origin::Convergent,
            reason: "Eight powers of b are removed, which leaves b^5 = 1e-3 of the coarsest times its weight in the limit, 1 / (1 1.8 3 4.7 7 10.3 15 21.6): 1e-8 for the first coefficient at 1e-1 of its size, so 1e-9, and a thousand times more for the second, which is divided by the smallest b",
            effort: Effort::Quick,
            measure: pinned::first_order,
        },
    ]
}

/// Checks of what the uncertainties of the inputs mean.
fn propagated() -> Vec<Check> {
    vec![
        Check {
            id: "calibration.uncertainty",
            claim: "The standard uncertainties of the chain are those of products of powers: 2.2e6 kg/s^2 for the stiffness where 7e6 is printed, 0.63e-4 s for the dissipative constant, 0.49e3 kg/s for the bound of the damping.",
            equations: thesis("(87)-(97)"),
            scene: "Granite with the standard uncertainties of thesis sections 4.1 and 4.3",
            oracle: "Exponents of density, modulus, 1 - nu^2, strength and loss in each quantity",
            norm: "Largest relative error of the value or of the first-order uncertainty",
            origin: Origin::Convergent,
            reason: "The derivatives of the kernel are central differences over 1e-5 of the uncertainties: (1e-5)^2 by truncation and 1e-16 / 1e-5 by rounding",
            effort: Effort::Quick,
            measure: chain::uncertainty,
        },
        Check {
            id: "calibration.monte-carlo",
            claim: "Drawn inputs give the means of the exact distribution; it is skewed, so that the central values lie away from the medians.",
            equations: thesis("(87)-(97)"),
            scene: "200 000 draws of normal inputs, cut to positive moduli, Poisson's ratios in (-1, 1/2) and restitutions in (0, 1)",
            oracle: "Each quantity is a product of powers of independent inputs: its moments are products of one-dimensional integrals",
            norm: "Distance of the mean from the exact one in exact standard errors",
            origin: Origin::Statistical,
            reason: "Five standard errors: a right mean fails for one seed in 2e6 a quantity; a factor of 1.01 is seen in every quantity with a power above 0.9999",
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
            claim: "Grains with the printed 10 kg/s rebound with 0.2228; the measured restitution of 0.83 needs 0.9267 kg/s at 1 mm, and the kernel's grains then have it at every size.",
            equations: thesis("(35), (36), section 4.3"),
            scene: "Collisions of the smallest, mean and largest grains, with each other, and with the density of a block packed to 0.84",
            oracle: "Closed form of the restitution; its inverse by bisection",
            norm: "Largest relative error of restitution and damping",
            origin: Origin::Convergent,
            reason: "As for pairs.kelvin-voigt: extrapolated to a step of no length, 1e-10 by the sixth power of the coarsest step and 3e-10 by rounding",
            effort: Effort::Quick,
            measure: rebounds::damping,
        },
        Check {
            id: "calibration.dissipative-constant",
            claim: "Spheres of 1 m at 1 m/s rebound with 0.83 if the dissipative constant is 1.838e-4 s, with 0.8475 for the first-order 1.625e-4 s, and with 0.061 for the printed 6e-3; the same constant stops grains of 1 mm.",
            equations: thesis("(37), (93)"),
            scene: "Collisions of granite spheres of 1 m diameter at 1 m/s",
            oracle: "Bisection of the integrated collision",
            norm: "Largest relative error of the restitution",
            origin: Origin::Convergent,
            reason: "As for pairs.viscoelastic up to b = 0.17; the other runs have finer steps in proportion to b, up to 83, where few steps resolve the onset: dt^4 counts some ten times as much, 1e-8",
            effort: Effort::Quick,
            measure: rebounds::constant,
        },
    ]
}
