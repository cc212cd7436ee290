//! The figures of the paper that hold numbers, drawn from the runs.

use super::SHAPES;
use super::claims::{mean, values};
use super::printed::{FITTED, fitted_stress_ratio};
use super::shapes::{SIDES, angularity};
use crate::statistics::Mean;
use crate::study::results::Results;
use crate::study::sample::Sample;
use gouge_page::{Axis, Curve, Figure};

/// A figure over angularity: title, quantity, and columns with their labels.
type Plan = (
    &'static str,
    &'static str,
    &'static [(&'static str, &'static str)],
);

const PLANS: [Plan; 10] = [
    (
        "Figure 5: stress ratio, direct and from the anisotropies (azema 8).",
        "q/p",
        &[
            ("direct", "stress_ratio"),
            ("half the sum of anisotropies", "half_sum"),
        ],
    ),
    (
        "Figure 6: solid fraction away from the walls and of the whole cell.",
        "solid fraction",
        &[
            ("away from the walls", "solid_fraction"),
            ("whole cell", "solid_fraction_cell"),
        ],
    ),
    (
        "Figure 8a: share of bodies with at least two contacts.",
        "share",
        &[("connected", "connected")],
    ),
    (
        "Figure 8b: coordination number of these bodies.",
        "contacts per body",
        &[("coordination", "coordination")],
    ),
    (
        "Figure 9: shares of bodies with 2 to 6 contacts.",
        "share",
        &[
            ("2", "share_with_2"),
            ("3", "share_with_3"),
            ("4", "share_with_4"),
            ("5", "share_with_5"),
            ("6", "share_with_6"),
        ],
    ),
    (
        "Figure 11: anisotropies.",
        "anisotropy",
        &[
            ("contacts", "a_c"),
            ("normal forces", "a_fn"),
            ("tangential forces", "a_ft"),
            ("normal branches", "a_ln"),
            ("tangential branches", "a_lt"),
        ],
    ),
    (
        "Figure 12a: mean forces in units of p d.",
        "force",
        &[
            ("normal", "normal_force"),
            ("tangential", "tangential_force"),
        ],
    ),
    (
        "Figures 12b and 13: shares of sliding, side-side and side-vertex contacts.",
        "share",
        &[
            ("sliding", "sliding"),
            ("side-side", "side_side"),
            ("side-vertex", "side_vertex"),
        ],
    ),
    (
        "Figure 15: stress ratio carried by side-vertex and side-side contacts, with eq. (8) of each.",
        "q/p",
        &[
            ("side-vertex", "stress_ratio_sv"),
            ("side-side", "stress_ratio_ss"),
            ("(8), side-vertex", "half_sum_sv"),
            ("(8), side-side", "half_sum_ss"),
        ],
    ),
    (
        "Figures 16 and 17: partial anisotropies.",
        "anisotropy",
        &[
            ("contacts, sv", "a_c_sv"),
            ("contacts, ss", "a_c_ss"),
            ("normal, sv", "a_fn_sv"),
            ("normal, ss", "a_fn_ss"),
            ("tangential, sv", "a_ft_sv"),
            ("tangential, ss", "a_ft_ss"),
        ],
    ),
];

/// All figures of which something was run.
pub(super) fn figures(results: &Results) -> Vec<Figure> {
    let sample = Sample {
        results,
        part: SHAPES,
    };
    PLANS
        .iter()
        .filter_map(|plan| figure(&sample, plan))
        .collect()
}

fn figure(sample: &Sample, (title, quantity, columns): &Plan) -> Option<Figure> {
    let mut curves: Vec<Curve> = columns
        .iter()
        .map(|(label, column)| curve(sample, label, column))
        .collect();
    if curves.iter().all(|curve| curve.points.is_empty()) {
        return None;
    }
    if title.starts_with("Figure 5:") {
        let fit = [0].iter().chain(FITTED.iter());
        let points = fit.map(|&sides| [angularity(sides), fitted_stress_ratio(sides)]);
        curves.push(Curve::dashed("printed fit (azema 6)", points));
    }
    let x = Axis::linear("angularity", "rad");
    Some(Figure::new(*title, x, Axis::linear(quantity, ""), curves))
}

/// Means with standard errors over samples.
fn curve(sample: &Sample, label: &str, column: &str) -> Curve {
    let of = |&sides: &u32| Some((angularity(sides), mean(sample, sides, column)?));
    let means: Vec<(f64, Mean)> = SIDES.iter().filter_map(of).collect();
    let intervals = means.iter().map(|(_, mean)| match mean.number {
        1 => [mean.mean; 2],
        _ => [mean.mean - mean.error(), mean.mean + mean.error()],
    });
    let points = means.iter().map(|(angle, mean)| [*angle, mean.mean]);
    Curve::marked_line(label, points).with_intervals(intervals)
}

/// Whether a shape was run.
pub(super) fn was_run(sample: &Sample, sides: u32) -> bool {
    !values(sample, sides, "stress_ratio").is_empty()
}
