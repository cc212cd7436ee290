//! Figures 8, 12, 13 and 14 of the thesis, from many seeds.

use super::printed::LAWS;
use crate::statistics::Mean;
use crate::study::curves::{Curves, Point};
use crate::study::friction_curves::PRESSURES;
use crate::study::results::{Results, Run};
use crate::study::sample::Sample;
use crate::study::strength::densities;
use gouge_page::{Axis, Curve, Figure};

/// Parts of the study that have figures, with words for their titles.
const ARMS: [(&str, &str); 4] = [
    ("corrected-full", "corrected, 100 mm"),
    ("corrected-small", "corrected, 25 mm"),
    ("thesis-full", "as in the thesis, 100 mm"),
    ("thesis-small", "as in the thesis, 25 mm"),
];
/// Pressures of thesis figure 14, in units of the normal strength.
const HEATED: [f64; 4] = [0.075, 0.15, 0.3, 0.6];

/// All figures for which there are runs.
pub fn all(results: &Results, curves: &Curves) -> Vec<Figure> {
    let mut figures = vec![densities::figure()];
    for (part, arm) in ARMS {
        let sample = Sample { results, part };
        if sample.runs().next().is_none() {
            continue;
        }
        figures.extend(over_pressure(sample, arm));
        for law in LAWS {
            figures.extend(over_time(sample, curves, law, arm));
        }
        for pressure in HEATED {
            figures.extend(heat(sample, curves, pressure, arm));
        }
    }
    figures
}

/// Thesis figure 13: friction over pressure, by two estimators.
fn over_pressure(sample: Sample, arm: &str) -> Vec<Figure> {
    let figure = |title: String, quantity: &str, column: &str| {
        let pressure = Axis::logarithmic("pressure over normal strength", "");
        let curves = LAWS.map(|law| sample.over_pressure(law, column, |run| run.law() == law));
        Figure::new(title, pressure, Axis::linear(quantity, ""), curves.into())
    };
    vec![
        figure(
            format!(
                "Friction over pressure, 95 % intervals over seeds ({arm}; thesis figure 13). Work of the drive over load times slip, second half of each run."
            ),
            "coefficient of friction",
            "friction",
        ),
        figure(
            format!(
                "The same by the estimator of the thesis: the limit D1 of the fit of (100) ({arm})."
            ),
            "D1",
            "decay-limit",
        ),
    ]
}

/// The curves of all runs with a law and a pressure.
fn of_runs<'a>(
    sample: Sample<'a>,
    curves: &'a Curves,
    law: &str,
    pressure: f64,
) -> Vec<&'a [Point]> {
    let is_meant = |run: &&Run| run.law() == law && run.pressure() == pressure;
    sample
        .runs()
        .filter(is_meant)
        .filter_map(|run| curves.of(run))
        .collect()
}

/// Mean and standard deviation over runs at each time.
fn averaged(curves: &[&[Point]], of: fn(&Point) -> f64) -> Vec<(f64, Mean)> {
    let length = curves.iter().map(|curve| curve.len()).min().unwrap_or(0);
    let at = |place: usize| {
        let values: Vec<f64> = curves.iter().map(|curve| of(&curve[place])).collect();
        Some((curves[0][place].time, Mean::of(&values)?))
    };
    (0..length).filter_map(at).collect()
}

fn band(means: &[(f64, Mean)]) -> impl Iterator<Item = [f64; 2]> {
    means.iter().map(|(_, mean)| {
        let deviation = if mean.number > 1 { mean.deviation } else { 0.0 };
        [mean.mean - deviation, mean.mean + deviation]
    })
}

/// Thesis figure 12: friction over time.
fn over_time(sample: Sample, curves: &Curves, law: &str, arm: &str) -> Option<Figure> {
    let of_pressure = |pressure: f64| {
        let means = averaged(&of_runs(sample, curves, law, pressure), |point| {
            point.numbers[0]
        });
        let points = means.iter().map(|(time, mean)| [*time, mean.mean]);
        let label = format!("p = {pressure} of the strength");
        let line = Curve::line(&label, points);
        (!means.is_empty()).then(|| line.with_intervals(band(&means)))
    };
    let lines: Vec<Curve> = PRESSURES.into_iter().filter_map(of_pressure).collect();
    (!lines.is_empty()).then(|| {
        Figure::new(
            format!("Friction over time, law {law}, mean and standard deviation over seeds ({arm}; thesis figure 12)."),
            Axis::linear("time", "s"),
            Axis::linear("coefficient of friction", ""),
            lines,
        )
    })
}

/// Thesis figure 14: heat over time.
fn heat(sample: Sample, curves: &Curves, pressure: f64, arm: &str) -> Option<Figure> {
    let of_law = |law: &str| {
        let means = averaged(&of_runs(sample, curves, law, pressure), |point| {
            point.numbers[1]
        });
        let points = means.iter().map(|(time, mean)| [*time, mean.mean]);
        (!means.is_empty()).then(|| Curve::line(law, points).with_intervals(band(&means)))
    };
    let lines: Vec<Curve> = LAWS.into_iter().filter_map(of_law).collect();
    (!lines.is_empty()).then(|| {
        Figure::new(
            format!("Heat over time at {pressure} of the strength, mean and standard deviation over seeds ({arm}; thesis figure 14)."),
            Axis::linear("time", "s"),
            Axis::linear("heat", "J"),
            lines,
        )
    })
}
