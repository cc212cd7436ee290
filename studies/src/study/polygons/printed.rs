//! What the paper prints, with the tolerance at which a sample of 2 000 bodies is asked for.

use super::shapes::angularity;

/// A printed value.
pub struct Printed {
    /// The quantity in words.
    pub item: &'static str,
    /// The observation.
    pub column: &'static str,
    /// Numbers of sides of the shapes whose mean is compared.
    pub sides: &'static [u32],
    /// The value and how far from it the mean may be.
    pub value: [f64; 2],
}

/// Fit of the paper to the stress ratio, azema (6), which cannot be 0.47 for hexagons: azema E11.
pub fn fitted_stress_ratio(sides: u32) -> f64 {
    0.29 + 0.18 * (1.0 - (-angularity(sides) / 0.6).exp())
}

/// Shapes whose stress ratio is compared with the fit.
pub const FITTED: [u32; 13] = [60, 40, 30, 17, 11, 10, 9, 8, 7, 6, 5, 4, 3];
/// How far from the fit a stress ratio may be.
pub const FIT_TOLERANCE: f64 = 0.04;

const fn printed(
    item: &'static str,
    column: &'static str,
    sides: &'static [u32],
    value: [f64; 2],
) -> Printed {
    Printed {
        item,
        column,
        sides,
        value,
    }
}

/// All printed values besides the fit.
pub const ALL: [Printed; 33] = [
    printed("figure 5: q/p of discs", "stress_ratio", &[0], [0.29, 0.03]),
    printed(
        "figure 5: q/p, mean of 3, 4, 5 sides",
        "stress_ratio",
        &[3, 4, 5],
        [0.46, 0.03],
    ),
    printed(
        "figure 6: solid fraction of discs",
        "solid_fraction",
        &[0],
        [0.828, 0.015],
    ),
    printed(
        "figure 6: solid fraction",
        "solid_fraction",
        &[6],
        [0.798, 0.015],
    ),
    printed(
        "figure 6: solid fraction",
        "solid_fraction",
        &[5],
        [0.798, 0.015],
    ),
    printed(
        "figure 6: solid fraction",
        "solid_fraction",
        &[4],
        [0.798, 0.015],
    ),
    printed(
        "figure 6: solid fraction",
        "solid_fraction",
        &[3],
        [0.798, 0.02],
    ),
    printed(
        "figure 8: connected share of discs",
        "connected",
        &[0],
        [0.85, 0.05],
    ),
    printed(
        "figure 8: coordination of discs",
        "coordination",
        &[0],
        [3.25, 0.15],
    ),
    printed(
        "figure 8: coordination of triangles",
        "coordination",
        &[3],
        [3.6, 0.25],
    ),
    printed(
        "figure 13: share of side-side contacts of discs",
        "side_side",
        &[0],
        [0.0, 0.0],
    ),
    printed(
        "figure 13: share of side-side contacts",
        "side_side",
        &[5],
        [0.25, 0.08],
    ),
    printed(
        "figure 13: share of side-side contacts",
        "side_side",
        &[4],
        [0.25, 0.08],
    ),
    printed(
        "figure 13: share of side-side contacts",
        "side_side",
        &[3],
        [0.25, 0.08],
    ),
    printed(
        "figure 15: q of side-vertex contacts over p",
        "stress_ratio_sv",
        &[6],
        [0.22, 0.05],
    ),
    printed(
        "figure 15: q of side-vertex contacts over p",
        "stress_ratio_sv",
        &[5],
        [0.22, 0.05],
    ),
    printed(
        "figure 15: q of side-vertex contacts over p",
        "stress_ratio_sv",
        &[4],
        [0.22, 0.05],
    ),
    printed(
        "figure 15: q of side-vertex contacts over p",
        "stress_ratio_sv",
        &[3],
        [0.36, 0.06],
    ),
    printed(
        "figure 15: q of side-side contacts over p",
        "stress_ratio_ss",
        &[5],
        [0.265, 0.065],
    ),
    printed(
        "figure 15: q of side-side contacts over p",
        "stress_ratio_ss",
        &[4],
        [0.21, 0.06],
    ),
    printed(
        "figure 15: q of side-side contacts over p",
        "stress_ratio_ss",
        &[3],
        [0.11, 0.05],
    ),
    printed(
        "figure 16: a_c of side-vertex contacts",
        "a_c_sv",
        &[10],
        [0.2, 0.08],
    ),
    printed(
        "figure 16: a_c of side-vertex contacts",
        "a_c_sv",
        &[6],
        [0.2, 0.08],
    ),
    printed(
        "figure 16: a_c of side-vertex contacts",
        "a_c_sv",
        &[5],
        [0.2, 0.08],
    ),
    printed(
        "figure 16: a_c of side-vertex contacts",
        "a_c_sv",
        &[4],
        [0.2, 0.08],
    ),
    printed(
        "figure 17: a_fn of side-vertex contacts",
        "a_fn_sv",
        &[10],
        [0.2, 0.08],
    ),
    printed(
        "figure 17: a_fn of side-vertex contacts",
        "a_fn_sv",
        &[6],
        [0.2, 0.08],
    ),
    printed(
        "figure 17: a_fn of side-vertex contacts",
        "a_fn_sv",
        &[5],
        [0.2, 0.08],
    ),
    printed(
        "figure 17: a_fn of side-vertex contacts",
        "a_fn_sv",
        &[4],
        [0.2, 0.08],
    ),
    printed(
        "figure 17: a_ft of side-vertex contacts",
        "a_ft_sv",
        &[10],
        [0.05, 0.04],
    ),
    printed(
        "figure 17: a_ft of side-vertex contacts",
        "a_ft_sv",
        &[6],
        [0.05, 0.04],
    ),
    printed(
        "figure 17: a_ft of side-vertex contacts",
        "a_ft_sv",
        &[5],
        [0.05, 0.04],
    ),
    printed(
        "figure 17: a_ft of side-vertex contacts",
        "a_ft_sv",
        &[4],
        [0.05, 0.04],
    ),
];
