//! The distribution of bond strengths.

use crate::checks::{Check, Effort, Origin, Topic, thesis};

mod distributions;
mod fits;
mod packing;
mod sampled;

/// The topic.
pub fn topic() -> Topic {
    let mut checks = exact();
    checks.extend(sampled());
    Topic {
        id: "strength",
        title: "Strength of bonds",
        about: "The distribution of bond strengths that results from radii and factors: exact, sampled from bonded grains, and compared with Weibull distributions.",
        checks,
    }
}

/// Closed forms and fits.
fn exact() -> Vec<Check> {
    vec![
        Check {
            id: "strength.distributions",
            claim: "Densities, probabilities, moments and packing numbers agree with integration, lattice geometry and another library.",
            equations: thesis("(50), (65), (66), (102)-(105), (121)-(133)"),
            scene: "None: uniform variables, their sums, products and powers in both orders of the cases, the smaller of two, three Weibull distributions",
            oracle: "Integration over one variable, split where the other variable reaches an end; determinants of lattices; the library statrs",
            norm: "Largest relative error, or error of a density over the inverse width of its support",
            origin: Origin::Convergent,
            reason: "Double-exponential quadrature of analytic pieces converges to a few units of 1e-14 of the total; 1e-11 allows for cancellation between corners of the closed forms, whose terms are up to a hundred times the result",
            effort: Effort::Quick,
            measure: distributions::distributions,
        },
        Check {
            id: "strength.variation",
            claim: "The thesis's modulus of 5 is that of the two-parameter Weibull distribution with the mean and variation for one radius, 5.007; the smaller of two radii gives 5.494.",
            equations: thesis("(50), figure 8"),
            scene: "None: both exact distributions",
            oracle: "Moments as products of integrals over radius and factor; the shape from the variation by gamma functions",
            norm: "Largest relative error of mean, scale and modulus",
            origin: Origin::Convergent,
            reason: "Quadrature and gamma functions are accurate to 1e-14; for a variation of 0.2 the relative error of its square is amplified by 25, and the modulus follows it with a slope near one",
            effort: Effort::Quick,
            measure: fits::variation,
        },
        Check {
            id: "strength.weibull",
            claim: "No three-parameter Weibull distribution close to the actual bond strength has a modulus of 5: the closest ones have about 2.1 for one radius and 1.8 to 1.9 for the smaller of two.",
            equations: thesis("(50), figure 8"),
            scene: "None: both exact distributions; closest in relative entropy and in the Cramer-von Mises sense",
            oracle: "The same minimum with the integrated distributions and the Weibull distribution of statrs",
            norm: "Largest difference of modulus, scale and location; a modulus above 3 with a free location counts as a failure",
            origin: Origin::Convergent,
            reason: "A minimum is found to the square root of the rounding of its value, 1e-8, over its smallest relative curvature, about 1e-3",
            effort: Effort::Thorough,
            measure: fits::weibull,
        },
    ]
}

/// Sampled bonds.
fn sampled() -> Vec<Check> {
    vec![
        Check {
            id: "strength.lattice",
            claim: "Bonds made by the set-up and broken by the criterion have the strength of the smaller of two radii. Their distance from the thesis's distribution is the distance between the two distributions, 0.2216.",
            equations: thesis("(46)-(50), (65), (66)"),
            scene: "6000 bonds without common grains on a hexagonal lattice of 12 000 grains with random radii and factors; strengths found by bisection of the breaking criterion",
            oracle: "Exact distance between the two distributions, at the crossing of their densities",
            norm: "Largest distance of the sample distribution from the smaller-of-two law, and error of its distance from the single-radius law",
            origin: Origin::Statistical,
            reason: "The Dvoretzky-Kiefer-Wolfowitz-Massart bound at probability 1e-6 for each, 0.0348; a distribution 0.07 away would pass with a probability below 1e-6",
            effort: Effort::Quick,
            measure: sampled::lattice,
        },
        Check {
            id: "strength.power",
            claim: "A hundred independent bonds distinguish the thesis's distribution from that of its criterion at the 1 % level with a power above 0.98.",
            equations: thesis("(50)"),
            scene: "1000 samples of 20 to 200 strengths each",
            oracle: "Power of a test at the point of largest difference alone, exact by the binomial distribution: a lower bound",
            norm: "Amount by which the simulated power falls below the bound; a power below 0.98 for a hundred bonds counts as a failure",
            origin: Origin::Statistical,
            reason: "Five standard errors of the simulated power, and one sample for powers that round to one",
            effort: Effort::Quick,
            measure: sampled::power,
        },
        Check {
            id: "strength.block",
            claim: "Bonds of three settled packings are compatible with the smaller of two independent radii, and not with one radius.",
            equations: thesis("(49), (50), (65)-(67), (70)"),
            scene: "Three packings of about 670 grains, made like the granite fault up to bonding",
            oracle: "All radii and factors redrawn on the bonds of the packings, because neighbouring bonds share grains",
            norm: "Largest distance of the strengths' distribution from the smaller-of-two law; acceptance of the single-radius law counts as a failure",
            origin: Origin::Statistical,
            reason: "The largest distance of 1000 redraws: a correct law fails for one seed in 1000. The single-radius law is 0.22 away, four times that",
            effort: Effort::Thorough,
            measure: packing::small,
        },
        Check {
            id: "strength.packing",
            claim: "In settled packings large grains have more bonds. Strengths follow the smaller of two radii if each radius is weighted by its number of bonds; they are then on average 1.3 % above those of random pairs.",
            equations: thesis("(49), (50), (65)-(67), (70)"),
            scene: "32 packings of about 670 grains with about 57 000 bonds; their seeds were not used in formulating the claim",
            oracle: "Integrated distribution with a density of radii that grows with the measured preference for large grains; radii and factors redrawn on the same bonds for the effect of common grains",
            norm: "Largest distance of the strengths' distribution from that law; distance of the mean from that of pairs weighted by their numbers of bonds, in standard errors; acceptance of the law without preference counts as a failure",
            origin: Origin::Statistical,
            reason: "The largest distance of 300 redraws, a level of 1/3 %, and four standard errors over the 32 packings",
            effort: Effort::Report,
            measure: packing::packings,
        },
    ]
}
