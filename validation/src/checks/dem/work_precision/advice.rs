//! What follows from the curves: who is fastest at an accuracy, and what other choices cost.

use super::case::Case;
use super::sweep::{Rung, Sweep};

/// Accuracies that the advice is given for.
pub const TARGETS: [f64; 4] = [1e-2, 1e-3, 1e-6, 1e-9];

/// A run with error and time.
fn points(sweep: &Sweep) -> impl Iterator<Item = [f64; 2]> + '_ {
    let point = |rung: &Rung| Some([rung.time?.median, rung.error]);
    sweep.rungs.iter().filter_map(point)
}

/// Between two points of a doubly logarithmic diagram, the second coordinate at a value of the first.
fn between(a: [f64; 2], b: [f64; 2], x: f64) -> f64 {
    let fraction = (x / a[0]).ln() / (b[0] / a[0]).ln();
    a[1] * (b[1] / a[1]).powf(fraction)
}

/// Wall time in s at which a sweep first comes within an error, if it does.
pub fn time_for(sweep: &Sweep, error: f64) -> Option<f64> {
    let points: Vec<[f64; 2]> = points(sweep).collect();
    let first = points.iter().position(|point| point[1] <= error)?;
    let [time, reached] = points[first];
    let Some(before) = first.checked_sub(1).map(|before| points[before]) else {
        return Some(time);
    };
    Some(between([before[1], before[0]], [reached, time], error))
}

/// Error that a sweep has after a wall time in s, if its runs go so far.
pub fn error_after(sweep: &Sweep, time: f64) -> Option<f64> {
    let points: Vec<[f64; 2]> = points(sweep).collect();
    let mut pairs = points.windows(2);
    let pair = pairs.find(|pair| pair[0][0] <= time && time <= pair[1][0])?;
    Some(between(pair[0], pair[1], time))
}

/// The fastest sweep at an error, and its wall time in s.
pub fn fastest(sweeps: &[Sweep], error: f64) -> Option<(&Sweep, f64)> {
    let timed = sweeps
        .iter()
        .filter_map(|sweep| Some((sweep, time_for(sweep, error)?)));
    timed.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// The runs that no other beats in both error and time, from the fastest to the most accurate.
pub fn front<'a>(sweeps: impl IntoIterator<Item = &'a Sweep>) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> = sweeps.into_iter().flat_map(points).collect();
    all.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut best = f64::INFINITY;
    all.retain(|point| {
        let is_better = point[1] < best;
        best = best.min(point[1]);
        is_better
    });
    all
}

/// The choice of the thesis: forward Euler with its step, and what else could be had.
pub struct Thesis {
    /// Error of the choice.
    pub error: f64,
    /// How many times longer it takes than the fastest for the same error; with that method's name.
    pub slower: Option<(f64, &'static str)>,
    /// The smallest error that can be had in the same time, as a fraction of its own.
    pub fraction: Option<(f64, &'static str)>,
}

/// What the choice of the thesis costs.
pub fn cost_of_thesis(case: &Case, sweeps: &[Sweep]) -> Option<Thesis> {
    let rung = sweeps.first()?.rungs.get(case.doublings as usize)?;
    let time = rung.time?.median;
    let slower = fastest(sweeps, rung.error);
    let others = sweeps
        .iter()
        .filter_map(|sweep| Some((error_after(sweep, time)? / rung.error, sweep.integrator)));
    Some(Thesis {
        error: rung.error,
        slower: slower.map(|(sweep, best)| (time / best, sweep.integrator)),
        fraction: others.min_by(|a, b| a.0.total_cmp(&b.0)),
    })
}

/// Times within this ratio count as equal: two that are taken on a busy machine differ by as much.
const ALIKE: f64 = 1.25;
/// An error that is smaller by this factor is clearly smaller.
const CLEARLY: f64 = 2.0;

/// Methods no run of which is worth its time: in as much, another method has clearly the smaller error.
pub fn useless(sweeps: &[Sweep]) -> Vec<&'static str> {
    let beaten = |sweep: &Sweep, [time, error]: [f64; 2]| {
        let others = sweeps
            .iter()
            .filter(|one| one.integrator != sweep.integrator);
        others
            .flat_map(points)
            .any(|other| other[0] <= ALIKE * time && CLEARLY * other[1] <= error)
    };
    sweeps
        .iter()
        .filter(|sweep| points(sweep).all(|point| beaten(sweep, point)))
        .map(|sweep| sweep.integrator)
        .collect()
}

fn factor(x: f64) -> String {
    if x < 10.0 {
        format!("{x:.1}")
    } else {
        format!("{x:.0}")
    }
}

/// The advice in words.
pub fn words(case: &Case, sweeps: &[Sweep]) -> String {
    let mut sentences = Vec::new();
    for error in TARGETS {
        let Some((best, time)) = fastest(sweeps, error) else {
            sentences.push(format!("No run comes within {error:e}."));
            continue;
        };
        let name = best.integrator;
        sentences.push(match time_for(&sweeps[0], error) {
            Some(euler) if euler <= ALIKE * time => format!("For {error:e} even euler will do."),
            Some(euler) => {
                let ratio = factor(euler / time);
                format!("For {error:e} take {name}; euler needs {ratio} times its time.")
            }
            None => format!("For {error:e} take {name}; no run of euler is so accurate."),
        });
    }
    sentences.push(match useless(sweeps).as_slice() {
        [] => "No method is useless.".to_owned(),
        names => format!(
            "Nobody should use {}: in at most {ALIKE} times the time of any of its runs, another method has \
             at most half the error.",
            names.join(" or ")
        ),
    });
    sentences.extend(cost_of_thesis(case, sweeps).map(|thesis| thesis_words(case, &thesis)));
    sentences.join(" ")
}

fn thesis_words(case: &Case, thesis: &Thesis) -> String {
    let step = case.thesis_step;
    if !thesis.error.is_finite() {
        return format!("Forward Euler with the step of the thesis, {step:e} s, is unstable here.");
    }
    let error = thesis.error;
    let mut text = format!(
        "Forward Euler with the step of the thesis, {step:e} s, has an error of {error:.1e}"
    );
    if let Some((ratio, name)) = thesis.slower {
        text += &format!("; {name} has it {} times faster", factor(ratio));
    }
    if let Some((fraction, name)) = thesis.fraction {
        text += &format!(
            "; in the same time {name} is {} times more accurate",
            factor(1.0 / fraction)
        );
    }
    text + "."
}

/// A ratio for a table.
pub fn ratio(x: Option<f64>) -> String {
    x.map_or_else(|| "-".to_owned(), factor)
}
