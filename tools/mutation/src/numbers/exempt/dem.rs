//! Exemptions of the thesis's kernel, with what all kernels share.

use super::{Exemption, exempt};

const LIST: &str = "determines when the neighbour list is rebuilt and which pairs without overlap it contains; no result depends on it";
const BISECTION: &str = "where an interval is divided; the bisection continues until the interval cannot be divided further";
const SCAN: &str = "range and resolution of the search for the first unstable step";
const TINY: &str = "a term below 2e-9 wherever it is used; a millionth of it is less than rounding";
const BRACKET: &str = "brackets the root that the bisection then finds";
const NORMALISED: &str = "a common factor of all pairs; the distribution is normalised afterwards";
const BEYOND: &str = "which samples and pairs are visited; those beyond contribute nothing";
const ROUNDING: &str =
    "clamps a probability that exceeds one by rounding; exact probabilities never do";

const MADE_OF: &str =
    "what a grain of a check is made of, like its radius; the check holds for any value";

/// Exemptions of the thesis's kernel.
pub const EXEMPTIONS: &[Exemption] = &[
    exempt("kernel/common/src/neighbors/list.rs", "", "", LIST),
    exempt("kernel/common/src/neighbors/sizes.rs", "", "", LIST),
    exempt(
        "kernel/common/src/neighbors/cells.rs",
        "Cells::new",
        "",
        LIST,
    ),
    exempt(
        "kernel/dem/src/setup/bonding.rs",
        "r * «reach»",
        "reach",
        "a search for candidates, from which the exact distance then selects",
    ),
    exempt(
        "kernel/dem/src/geometry/pair_frame.rs",
        "PairFrame::new",
        "COINCIDENT",
        "distance below which centres count as coincident",
    ),
    exempt(
        "kernel/dem/src/geometry/angle.rs",
        "small_turn",
        "NEAR_COSINE",
        "where a series replaces an arctangent that agrees with it",
    ),
    exempt(
        "kernel/dem/src/geometry/contact.rs",
        "mean_distance",
        "1e-4",
        "where a series replaces a function that agrees with it",
    ),
    exempt(
        "kernel/dem/src/integrators/time_step.rs",
        "is_stable",
        "GROWTH",
        "growth by rounding that counts as no growth",
    ),
    exempt(
        "kernel/dem/src/geometry/contact.rs",
        "(«1.0» / 6.0)",
        "1.0",
        TINY,
    ),
    exempt(
        "kernel/dem/src/geometry/contact.rs",
        "(1.0 / «6.0»)",
        "6.0",
        TINY,
    ),
    exempt(
        "kernel/dem/src/integrators/time_step.rs",
        "let mut scale = ",
        "1.0",
        "a factor of all coefficients of a polynomial, which moves no root",
    ),
    exempt(
        "kernel/dem/src/integrators/time_step.rs",
        "let rate = ",
        "",
        SCAN,
    ),
    exempt(
        "kernel/dem/src/laws/tangential.rs",
        "CundallStrack::friction",
        "Self::SLIDING",
        "a marker that is only compared with zero",
    ),
    exempt(
        "kernel/dem/src/distributions/uniform.rs",
        "(sum / self.area()).clamp",
        "1.0",
        ROUNDING,
    ),
    exempt(
        "kernel/dem/src/integrators/time_step.rs",
        "critical_step",
        "4.0",
        SCAN,
    ),
    exempt(
        "kernel/dem/src/integrators/time_step.rs",
        "critical_step",
        "0.5",
        BISECTION,
    ),
    exempt(
        "kernel/dem/src/calibration/restitution.rs",
        "(mut low, mut high)",
        "1.0",
        BRACKET,
    ),
    exempt(
        "kernel/dem/src/calibration/restitution.rs",
        "while falling(high)",
        "value",
        BRACKET,
    ),
    exempt(
        "kernel/dem/src/calibration/restitution.rs",
        "(low, high) = (high",
        "1e3",
        BRACKET,
    ),
    exempt(
        "kernel/dem/src/calibration/restitution.rs",
        "let is_far = ",
        "2.0",
        "which of two means divides an interval; the bisection continues until the interval cannot be divided further",
    ),
    exempt(
        "kernel/dem/src/calibration/restitution.rs",
        "0.5» * (low + high)",
        "0.5",
        BISECTION,
    ),
    exempt(
        "kernel/common/src/estimators/radial.rs",
        "epanechnikov",
        "0.75",
        NORMALISED,
    ),
    exempt(
        "kernel/common/src/estimators/radial.rs",
        "let weight",
        "1.0",
        NORMALISED,
    ),
    exempt(
        "kernel/common/src/estimators/radial.rs",
        "separation > limit",
        "bandwidth",
        BEYOND,
    ),
    exempt(
        "kernel/common/src/estimators/radial.rs",
        "let first =",
        "bandwidth",
        BEYOND,
    ),
    exempt(
        "kernel/common/src/estimators/radial.rs",
        "let last =",
        "bandwidth",
        BEYOND,
    ),
    exempt(
        "kernel/dem/src/forces/driving.rs",
        "velocity_gain: ",
        "1.0",
        "a placeholder that the integrator sets before it is read",
    ),
    exempt(
        "kernel/dem/src/distributions/uniform.rs",
        "outside",
        "x",
        "only indicates on which side of the support a point lies",
    ),
    exempt(
        "kernel/dem/src/distributions/uniform.rs",
        "(«1.0», join(a.high, b.high))",
        "1.0",
        "the sign of a term that would begin where the support ends",
    ),
    exempt(
        "kernel/dem/src/distributions/uniform.rs",
        "let inside = «x» >",
        "x",
        "where the first term begins, which is zero there",
    ),
    exempt(
        "validation/src/checks/dem/strength/sampled.rs",
        "independent",
        "REACH",
        "which neighbours are bonded; only the nearest ones in a row are used",
    ),
    exempt(
        "kernel/dem/src/distributions/strength.rs",
        "WeakestProduct::cumulative",
        "1.0",
        ROUNDING,
    ),
    exempt(
        "validation/src/checks/dem/estimators/setup.rs",
        "grain",
        "SPHERE_INERTIA_FACTOR",
        MADE_OF,
    ),
    exempt(
        "validation/src/checks/dem/extremes/cases.rs",
        "Draw::particle",
        "SPHERE_INERTIA_FACTOR",
        MADE_OF,
    ),
    exempt(
        "validation/src/checks/dem/extremes/pairs.rs",
        "free",
        "SPHERE_INERTIA_FACTOR",
        MADE_OF,
    ),
    exempt(
        "validation/src/checks/dem/laws/cluster.rs",
        "grains",
        "SPHERE_INERTIA_FACTOR",
        MADE_OF,
    ),
    exempt(
        "validation/src/checks/dem/scenes.rs",
        "sphere",
        "SPHERE_INERTIA_FACTOR",
        MADE_OF,
    ),
    exempt(
        "validation/src/checks/dem/strength/sampled.rs",
        "independent",
        "SPHERE_INERTIA_FACTOR",
        MADE_OF,
    ),
];
