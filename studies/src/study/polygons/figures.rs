//! The figures of the paper that hold numbers, drawn from the runs.

use super::SHAPES;
use super::claims::{mean, values};
use super::printed::{FITTED, fitted_stress_ratio};
use super::shapes::{SIDES, angularity, name};
use super::sweeps::RATE;
use crate::columns::Columns;
use crate::statistics::Mean;
use crate::study::curves::{CurvePlan, Curves};
use crate::study::results::Results;
use crate::study::sample::Sample;
use gouge_page::{Axis, Curve, Figure};
use std::ops::Range;

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

/// Shapes whose stress and height over strain are kept.
const OVER_STRAIN: [u32; 4] = [0, 10, 5, 3];

/// Stress ratio at the roof, and height of the roof in mean diameters.
pub(super) const CURVES: CurvePlan = CurvePlan {
    names: ["wall_stress_ratio", "height"],
    is_shown: |run| {
        let is_of = |&sides: &u32| run.text("shape") == name(sides);
        run.part == SHAPES && run.seed() == "0" && OVER_STRAIN.iter().any(is_of)
    },
    numbers,
};

fn numbers(series: &Columns, rows: Range<usize>) -> Option<[f64; 2]> {
    // Before the first step there are no forces.
    let rows = rows.start.max(1)..rows.end;
    let mean = |column: &str| {
        let values = &series.get(column)?[rows.clone()];
        Some(values.iter().sum::<f64>() / values.len() as f64)
    };
    let ratio = mean("shear_stress")? / mean("normal_stress")?;
    Some([ratio, mean("height")?])
}

/// All figures of which something was run.
pub(super) fn figures(results: &Results, curves: &Curves) -> Vec<Figure> {
    let sample = Sample {
        results,
        part: SHAPES,
    };
    let stress = over_strain(&sample, curves, Shown::Stress);
    let volume = over_strain(&sample, curves, Shown::Volume);
    let over_angle = PLANS.iter().filter_map(|plan| figure(&sample, plan));
    stress.into_iter().chain(volume).chain(over_angle).collect()
}

/// What is shown over strain.
#[derive(Clone, Copy)]
enum Shown {
    /// The stress ratio at the roof.
    Stress,
    /// The volume.
    Volume,
}

fn over_strain(sample: &Sample, curves: &Curves, shown: Shown) -> Option<Figure> {
    let of_shape = |&sides: &u32| {
        let mut runs = sample.runs().filter(|run| (CURVES.is_shown)(run));
        let run = runs.find(|run| run.text("shape") == name(sides))?;
        let mean = run.number("height_mean")?;
        let number = |numbers: [f64; 2]| match shown {
            Shown::Stress => numbers[0],
            Shown::Volume => numbers[1] / mean,
        };
        let points = curves.of(run)?.iter();
        let points = points.map(|point| [RATE * point.time, number(point.numbers)]);
        Some(Curve::line(&name(sides), points))
    };
    let found: Vec<Curve> = OVER_STRAIN.iter().filter_map(of_shape).collect();
    let (title, quantity) = match shown {
        Shown::Stress => (
            "Figure 4a: shear over normal stress on the upper wall, first sample of each shape.",
            "shear over normal stress",
        ),
        Shown::Volume => (
            "Figure 4b: volume over its mean in the second half, first sample of each shape.",
            "volume over its mean",
        ),
    };
    let (x, y) = (Axis::linear("shear strain", ""), Axis::linear(quantity, ""));
    (!found.is_empty()).then(|| Figure::new(title, x, y, found))
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
