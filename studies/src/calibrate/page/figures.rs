//! Figures of a calibration.

use crate::calibrate::account::NINETY;
use crate::calibrate::calibration::Calibration;
use crate::calibrate::identify::DROPS;
use crate::calibrate::outcome::Outcome;
use crate::calibrate::parameter::{Parameter, Scale};
use gouge_page::{Axis, Curve, Figure, Guide};

/// Points of the posterior in a figure of two parameters.
const DOTS: usize = 600;
/// Bars of a histogram.
const BARS: usize = 40;

/// The axis of a parameter.
fn axis(parameter: &Parameter) -> Axis {
    match parameter.scale {
        Scale::Log => Axis::logarithmic(&parameter.name, &parameter.unit),
        Scale::Linear => Axis::linear(&parameter.name, &parameter.unit),
    }
}

/// All figures with the names of their files.
pub fn figures(calibration: &Calibration, outcome: &Outcome) -> Vec<(String, Figure)> {
    let mut all = Vec::new();
    for (k, parameter) in calibration.parameters.iter().enumerate() {
        all.push((
            format!("marginal-{}", parameter.name),
            marginal(parameter, outcome, k),
        ));
        all.push((
            format!("profile-{}", parameter.name),
            profile(parameter, outcome, k),
        ));
    }
    for (k, x) in calibration.parameters.iter().enumerate() {
        for (l, y) in calibration.parameters.iter().enumerate().take(k) {
            let name = format!("pair-{}-{}", x.name, y.name);
            all.push((name, pair([x, y], outcome, [k, l])));
        }
    }
    all.push(("predictive".to_owned(), predictive(calibration, outcome)));
    for (place, target) in calibration.targets.iter().enumerate() {
        let name = calibration.target_name(target);
        let unit = calibration.target_unit(target);
        let figure = left_out(&name, unit, outcome, place);
        all.push((format!("left-out-{place}"), figure));
        for (k, parameter) in calibration.parameters.iter().enumerate() {
            let file = format!("residuals-{place}-{}", parameter.name);
            all.push((file, residuals(&name, parameter, outcome, [place, k])));
        }
    }
    all
}

/// Density of the posterior of a parameter in its range.
fn marginal(parameter: &Parameter, outcome: &Outcome, k: usize) -> Figure {
    let mut heights = [0.0; BARS];
    let posterior = &outcome.posterior;
    for (point, weight) in posterior.points.iter().zip(&posterior.weights) {
        heights[((point[k] * BARS as f64) as usize).min(BARS - 1)] += weight * BARS as f64;
    }
    let edge = |bar: usize| parameter.value(bar as f64 / BARS as f64);
    let edges: Vec<f64> = (0..=BARS).map(edge).collect();
    let flat = [[edges[0], 1.0], [edges[BARS], 1.0]];
    Figure::new(
        format!(
            "What is known of {}, in units of what was known before.",
            parameter.name
        ),
        axis(parameter),
        Axis::linear("density", ""),
        vec![
            Curve::histogram("posterior", &edges, &heights),
            Curve::dashed("before: even in the range", flat),
        ],
    )
}

/// Profile of the log-likelihood.
fn profile(parameter: &Parameter, outcome: &Outcome, k: usize) -> Figure {
    let profile = &outcome.marginals[k].profile;
    // What is far below is cut off: it is ruled out in any case.
    let shown = profile.iter().filter(|[_, drop]| *drop > -8.0);
    let points = shown.map(|&[place, drop]| [parameter.value(place), drop]);
    Figure::new(
        format!("The largest likelihood for each {}.", parameter.name),
        axis(parameter),
        Axis::linear("log-likelihood below its maximum", ""),
        vec![Curve::line("profile", points)],
    )
    .with_guide(Guide::horizontal("68 %", -DROPS[0]))
    .with_guide(Guide::horizontal("95 %", -DROPS[1]))
}

/// Points of the posterior of two parameters.
fn pair([x, y]: [&Parameter; 2], outcome: &Outcome, [k, l]: [usize; 2]) -> Figure {
    let points = outcome.posterior.resampled(DOTS);
    let points = points
        .iter()
        .map(|point| [x.value(point[k]), y.value(point[l])]);
    let failed = outcome
        .results
        .failed()
        .map(|run| &outcome.results.points[run.point]);
    let failed = failed.map(|point| [x.value(point[k]), y.value(point[l])]);
    let failed: Vec<[f64; 2]> = failed.collect();
    let mut curves = vec![Curve::marks("posterior", points)];
    if !failed.is_empty() {
        curves.push(Curve::marks("failed runs", failed));
    }
    Figure::new(
        format!("{} and {} that agree with the targets.", x.name, y.name),
        axis(x),
        axis(y),
        curves,
    )
}

/// What the posterior predicts of each target, and what runs gave.
fn predictive(calibration: &Calibration, outcome: &Outcome) -> Figure {
    let mut emulated = Vec::new();
    let mut intervals = Vec::new();
    let mut runs = Vec::new();
    for (place, (target, one)) in calibration
        .targets
        .iter()
        .zip(&outcome.measured)
        .enumerate()
    {
        let number = place as f64 + 1.0;
        let scaled = |value: f64| (value - one.value) / one.deviation;
        let emulator = &outcome.emulators.0[place];
        let mean = |point: &[f64]| scaled(emulator.at(point).mean);
        let [low, middle, high] = outcome.posterior.quantiles(&mean, [0.05, 0.5, 0.95]);
        emulated.push([number, middle]);
        intervals.push([low, high]);
        let samples = outcome.predictive.samples(target.test, target.quantity);
        let values = samples.iter().flat_map(|sample| &sample.values);
        runs.extend(values.map(|&value| [number + 0.15, scaled(value)]));
    }
    Figure::new(
        "Predictions of the targets, in standard deviations of their measurements.",
        Axis::counting("number of the target", calibration.targets.len()),
        Axis::linear("prediction less measurement, in sd", ""),
        vec![
            Curve::marks("emulator, median and 90 % of the posterior", emulated)
                .with_intervals(intervals),
            Curve::marks("runs at points of the posterior", runs),
        ],
    )
    .with_guide(Guide::horizontal("measured", 0.0))
}

/// What the emulator expected of each point without having seen it.
fn left_out(name: &str, unit: &str, outcome: &Outcome, place: usize) -> Figure {
    let left_out = outcome.emulators.0[place].leave_one_out();
    let points = left_out.iter().map(|one| [one.value, one.expected]);
    let intervals = left_out
        .iter()
        .map(|one| [-NINETY, NINETY].map(|width| one.expected + width * one.deviation));
    let values = || left_out.iter().map(|one| one.value);
    let ends = [
        values().fold(f64::INFINITY, f64::min),
        values().fold(f64::NEG_INFINITY, f64::max),
    ];
    Figure::new(
        format!("{name} of each point as the emulator expects it without having seen it."),
        Axis::linear("value of the runs", unit),
        Axis::linear("expected", unit),
        vec![
            Curve::marks("points, with 90 % intervals", points).with_intervals(intervals),
            Curve::dashed("equal", ends.map(|end| [end, end])),
        ],
    )
}

/// Residuals of the points that were left out along a parameter.
fn residuals(
    name: &str,
    parameter: &Parameter,
    outcome: &Outcome,
    [place, k]: [usize; 2],
) -> Figure {
    let emulator = &outcome.emulators.0[place];
    let left_out = emulator.leave_one_out();
    let pairs = emulator.points().zip(&left_out);
    let points = pairs.map(|(point, one)| [parameter.value(point[k]), one.standardised]);
    Figure::new(
        format!(
            "Residuals of {name} along {}: they should show no pattern.",
            parameter.name
        ),
        axis(parameter),
        Axis::linear("residual of a point left out, in sd", ""),
        vec![Curve::marks("points", points)],
    )
    .with_guide(Guide::horizontal("0", 0.0))
}
