//! Conclusions from the curves: the fastest integrator for an accuracy, and the cost of other choices.

use super::case::Case;
use super::sweep::{Rung, Sweep};

/// Accuracies for which advice is given.
pub const TARGETS: [f64; 4] = [1e-2, 1e-3, 1e-6, 1e-9];

/// Wall time and error of each timed run.
fn points(sweep: &Sweep) -> impl Iterator<Item = [f64; 2]> + '_ {
    let point = |rung: &Rung| Some([rung.time?.median, rung.error]);
    sweep.rungs.iter().filter_map(point)
}

/// Linear interpolation in a doubly logarithmic diagram: the second coordinate at a value of the first.
fn between(a: [f64; 2], b: [f64; 2], x: f64) -> f64 {
    let fraction = (x / a[0]).ln() / (b[0] / a[0]).ln();
    a[1] * (b[1] / a[1]).powf(fraction)
}

/// Wall time in s at which a sweep first reaches an error, if it does.
pub fn time_for(sweep: &Sweep, error: f64) -> Option<f64> {
    let points: Vec<[f64; 2]> = points(sweep).collect();
    let first = points.iter().position(|point| point[1] <= error)?;
    let [time, reached] = points[first];
    let Some(before) = first.checked_sub(1).map(|before| points[before]) else {
        return Some(time);
    };
    Some(between([before[1], before[0]], [reached, time], error))
}

/// Error of a sweep for a wall time in s, if its runs cover that time.
pub fn error_after(sweep: &Sweep, time: f64) -> Option<f64> {
    let points: Vec<[f64; 2]> = points(sweep).collect();
    let mut pairs = points.windows(2);
    let pair = pairs.find(|pair| pair[0][0] <= time && time <= pair[1][0])?;
    Some(between(pair[0], pair[1], time))
}

/// The fastest sweep for an error, and its wall time in s.
pub fn fastest(sweeps: &[Sweep], error: f64) -> Option<(&Sweep, f64)> {
    let timed = sweeps
        .iter()
        .filter_map(|sweep| Some((sweep, time_for(sweep, error)?)));
    timed.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// The runs that no other run beats in both error and time, from the fastest to the most accurate.
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

/// The thesis's choice, forward Euler with its time step, compared with the alternatives.
pub struct Thesis {
    /// Error of the choice.
    pub error: f64,
    /// Ratio of its time to that of the fastest method for the same error, with the name of that
    /// method.
    pub slower: Option<(f64, &'static str)>,
    /// The smallest error available in the same time, as a fraction of its own error.
    pub fraction: Option<(f64, &'static str)>,
}

/// The cost of the thesis's choice.
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

/// Times within this ratio count as equal, because timings on a busy machine scatter by as much.
const ALIKE: f64 = 1.25;
/// An error smaller by this factor counts as clearly smaller.
const CLEARLY: f64 = 2.0;

/// Methods that are dominated: for each of their runs, another method has a clearly smaller error in
/// about the same time.
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
            sentences.push(format!("No run reaches an error of {error:e}."));
            continue;
        };
        let name = best.integrator;
        sentences.push(match time_for(&sweeps[0], error) {
            Some(euler) if euler <= ALIKE * time => {
                format!("For an error of {error:e}, euler is sufficient.")
            }
            Some(euler) => {
                let ratio = factor(euler / time);
                format!("For an error of {error:e}, use {name}; euler takes {ratio} times as long.")
            }
            None => format!("For an error of {error:e}, use {name}; no run of euler reaches it."),
        });
    }
    sentences.push(match useless(sweeps).as_slice() {
        [] => "No method is dominated by the others.".to_owned(),
        names => format!(
            "Do not use {}: within {ALIKE} times the time of any of its runs, another method has at most half the error.",
            names.join(" or ")
        ),
    });
    sentences.extend(cost_of_thesis(case, sweeps).map(|thesis| thesis_words(case, &thesis)));
    sentences.join(" ")
}

fn thesis_words(case: &Case, thesis: &Thesis) -> String {
    let step = case.thesis_step;
    if !thesis.error.is_finite() {
        return format!("Forward Euler with the thesis's time step, {step:e} s, is unstable here.");
    }
    let error = thesis.error;
    let mut text = format!(
        "Forward Euler with the thesis's time step, {step:e} s, has an error of {error:.1e}"
    );
    if let Some((ratio, name)) = thesis.slower {
        text += &format!("; {name} reaches it {} times faster", factor(ratio));
    }
    if let Some((fraction, name)) = thesis.fraction {
        text += &format!(
            "; in the same time {name} is {} times more accurate",
            factor(1.0 / fraction)
        );
    }
    text + "."
}

/// A ratio as text for a table.
pub fn ratio(x: Option<f64>) -> String {
    x.map_or_else(|| "-".to_owned(), factor)
}
