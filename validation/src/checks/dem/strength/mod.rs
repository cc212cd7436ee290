//! The emergent distribution of strengths.

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
        title: "Strength of links",
        about: "The distribution of strengths that radii and factors give: exact, sampled from bonded grains, and against Weibull.",
        checks,
    }
}

/// Closed forms and fits.
fn exact() -> Vec<Check> {
    vec![
        Check {
            id: "strength.distributions",
            claim: "Densities, probabilities, moments and packing numbers are those of integration, of lattices and of another program library.",
            equations: thesis("(50), (65), (66), (102)-(105), (121)-(133)"),
            scene: "None: uniform variables, their sums, products and powers in both orders of the cases, the smaller of two, three Weibull laws",
            oracle: "Integration over one variable, parted where the other reaches an end; determinants of lattices; statrs",
            norm: "Largest relative error, or error of a density over the inverse width of its support",
            origin: Origin::Convergent,
            reason: "Double-exponential quadrature of analytic pieces has converged to a few units of 1e-14 of the total; 1e-11 leaves room for cancellation between corners of the closed forms, whose terms are up to a hundred times the result",
            effort: Effort::Quick,
            measure: distributions::distributions,
        },
        Check {
            id: "strength.variation",
            claim: "The modulus 5 of the thesis is that of the two-parameter Weibull law with the mean and variation of one radius, 5.007; the smaller of two radii has 5.494.",
            equations: thesis("(50), figure 8"),
            scene: "None: both exact laws",
            oracle: "Moments as products of integrals over radius and factor; root of the variation by Gamma functions",
            norm: "Largest relative error of mean, scale and modulus",
            origin: Origin::Convergent,
            reason: "Quadrature and Gamma functions to 1e-14; a variation of 0.2 magnifies the relative error of its square by 25, and the modulus follows it with a slope near one",
            effort: Effort::Quick,
            measure: fits::variation,
        },
        Check {
            id: "strength.weibull",
            claim: "No three-parameter Weibull law near the emergent strength has a modulus of 5: the nearest have about 2.1 for one radius and 1.8 to 1.9 for the smaller of two.",
            equations: thesis("(50), figure 8"),
            scene: "None: both exact laws, nearest in relative entropy and by Cramer and von Mises",
            oracle: "The same minimum with the integrated laws and the Weibull law of statrs",
            norm: "Largest difference of modulus, scale and location; moduli above 3 count as failures",
            origin: Origin::Convergent,
            reason: "A minimum is found to the root of the rounding of its value, 1e-8, over its smallest relative curvature, about 1e-3",
            effort: Effort::Thorough,
            measure: fits::weibull,
        },
    ]
}

/// Samples of bonds.
fn sampled() -> Vec<Check> {
    vec![
        Check {
            id: "strength.lattice",
            claim: "Bonds that the set-up makes and the criterion breaks have the strength of the smaller of two radii, and are as far from the law of the thesis as the laws are from each other, 0.2216.",
            equations: thesis("(46)-(50), (65), (66)"),
            scene: "6000 bonds without common grains on a hexagonal lattice of 12 000 grains with random radii and factors; their strength found by asking the criterion",
            oracle: "Exact distance of both laws, where their densities cross",
            norm: "Largest distance of the distribution of samples from either law",
            origin: Origin::Statistical,
            reason: "The bound of Dvoretzky, Kiefer, Wolfowitz and Massart at probability 1e-6 for each, 0.0348; a law 0.07 away would pass with a probability below 1e-6",
            effort: Effort::Quick,
            measure: sampled::lattice,
        },
        Check {
            id: "strength.power",
            claim: "A hundred independent bonds tell the law of the thesis from that of its criterion at level 1 % with a power above 0.98.",
            equations: thesis("(50)"),
            scene: "1000 samples of 20 to 200 strengths each",
            oracle: "Power of looking at the farthest point alone, exact by the binomial distribution: a lower bound",
            norm: "How far the simulated power falls below the bound",
            origin: Origin::Statistical,
            reason: "Five standard errors of the simulated power, and one sample for powers that round to one",
            effort: Effort::Quick,
            measure: sampled::power,
        },
        Check {
            id: "strength.block",
            claim: "Bonds of three settled packings are compatible with the smaller of two independent radii, and not with one radius.",
            equations: thesis("(49), (50), (65)-(67), (70)"),
            scene: "Three packings of about 670 grains, made as in the granite fault up to the bonds",
            oracle: "Redraws of all radii and factors on the bonds of the packings, because neighbouring bonds share grains",
            norm: "Largest distance of the distribution of strengths from the law; acceptance of one radius counts as a failure",
            origin: Origin::Statistical,
            reason: "The largest distance of 1000 redraws: a right law fails once in 1000 seeds. One radius is 0.22 away, four times that",
            effort: Effort::Thorough,
            measure: packing::small,
        },
        Check {
            id: "strength.packing",
            claim: "In settled packings large grains have more bonds: strengths follow the smaller of two radii if each counts as often as it has bonds, and are then on average 1.3 % above those of random pairs.",
            equations: thesis("(49), (50), (65)-(67), (70)"),
            scene: "32 packings of about 670 grains, some 57 000 bonds, other seeds than those after which the claim was worded",
            oracle: "Integrated law with a density of radii that grows with the measured preference; redraws of radii and factors on the same bonds for the effect of common grains",
            norm: "Largest distance of the distribution of strengths from that law; distance of the mean from that of pairs drawn by their numbers of bonds in standard errors; acceptance of the law without preference counts as a failure",
            origin: Origin::Statistical,
            reason: "The largest distance of 300 redraws, a level of 1/3 %, and four standard errors over the 32 packings",
            effort: Effort::Report,
            measure: packing::packings,
        },
    ]
}
