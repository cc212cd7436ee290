//! The page of a sweep: how its runs ended, and each observation over each axis.

use super::file::{Axis, Sweep};
use super::observe::Observation;
use super::plan::Planned;
use crate::statistics::Mean;
use gouge_page::{Axis as Scale, Curve, Figure, page, table};
use maud::{Markup, html};
use std::collections::BTreeMap;

/// Most curves of a figure.
const MOST_CURVES: usize = 8;
/// Probability that an interval holds the true mean.
const LEVEL: f64 = 0.95;

/// What the page shows of a run.
pub struct Outcome {
    /// The name of its status.
    pub status: String,
    /// One number per observation; not a number if there is none.
    pub observed: Vec<f64>,
}

/// Values of an observation by the places of all axes but those of seeds.
type Groups = BTreeMap<Vec<usize>, Vec<f64>>;

/// The page of a sweep, from the outcomes of its runs.
pub fn page_of(sweep: &Sweep, runs: &[Planned], outcomes: &[Outcome]) -> Markup {
    let body = html! {
        h1 { (sweep.file) }
        p { "A sweep of " code { (sweep.scene.display()) } " with " (runs.len()) " runs; " a href="runs.csv" { "runs.csv" } " has a row per run." }
        (statuses(outcomes))
        @for (place, observation) in sweep.observations.iter().enumerate() {
            h2 { (observation.get_ref().name()) }
            (observed(sweep, observation.get_ref(), &groups(sweep, runs, outcomes, place)))
        }
    };
    page(&sweep.file, body)
}

/// Number of runs by status.
fn statuses(outcomes: &[Outcome]) -> Markup {
    let mut numbers: BTreeMap<&str, usize> = BTreeMap::new();
    for outcome in outcomes {
        *numbers.entry(&outcome.status).or_default() += 1;
    }
    let row = |(status, number): (&&str, &usize)| vec![(*status).to_owned(), number.to_string()];
    let rows: Vec<Vec<String>> = numbers.iter().map(row).collect();
    table(
        "How the runs ended",
        &["status".to_owned(), "runs".to_owned()],
        &rows,
    )
}

fn groups(sweep: &Sweep, runs: &[Planned], outcomes: &[Outcome], observation: usize) -> Groups {
    let mut groups = Groups::new();
    for (run, outcome) in runs.iter().zip(outcomes) {
        let value = outcome.observed[observation];
        if value.is_finite() {
            let places = run.places[..sweep.axes.len()].to_vec();
            groups.entry(places).or_default().push(value);
        }
    }
    groups
}

/// Figures over all axes of numbers, and a table over all others.
fn observed(sweep: &Sweep, observation: &Observation, groups: &Groups) -> Markup {
    let along = 0..sweep.axes.len();
    let figures = along.filter_map(|along| figure(sweep, observation, along, groups));
    let figures: Vec<Figure> = figures.collect();
    html! {
        @if groups.is_empty() { p { "No run has this observation yet." } }
        @for figure in &figures { (figure.html()) }
        @if figures.is_empty() && !groups.is_empty() { (means(sweep, observation, groups)) }
    }
}

/// The numbers that the labels of an axis are; none if some label is not a number, or if there is only one.
fn numbers(axis: &Axis) -> Option<Vec<f64>> {
    let numbers: Option<Vec<f64>> = axis.labels.iter().map(|label| label.parse().ok()).collect();
    numbers.filter(|numbers| numbers.len() > 1)
}

/// An observation over one axis, with a curve per combination of the others.
fn figure(
    sweep: &Sweep,
    observation: &Observation,
    along: usize,
    groups: &Groups,
) -> Option<Figure> {
    let name = observation.name();
    let (axis, numbers) = (&sweep.axes[along], numbers(&sweep.axes[along])?);
    let mut curves: BTreeMap<Vec<usize>, Vec<(f64, Mean)>> = BTreeMap::new();
    for (places, values) in groups {
        let mut others = places.clone();
        let place = others.remove(along);
        let mean = Mean::of(values)?;
        curves
            .entry(others)
            .or_default()
            .push((numbers[place], mean));
    }
    let left_out = curves.len().saturating_sub(MOST_CURVES);
    let shown = curves.into_iter().take(MOST_CURVES);
    let shown = shown.map(|(others, points)| curve(&label(sweep, along, &others), points));
    let mut title = format!("{name} over {}", axis.name);
    if !sweep.seeds.is_empty() {
        title += ": means with 95 % intervals of the mean over the seeds";
    }
    if left_out > 0 {
        title += &format!("; {left_out} more combinations are in runs.csv");
    }
    title.push('.');
    let x = Scale::linear(&axis.name, &axis.unit);
    let y = Scale::linear(&name, observation.unit());
    let figure = Figure::new(title, x, y, shown.collect());
    (!figure.curves.is_empty()).then_some(figure)
}

/// The values of all other axes.
fn label(sweep: &Sweep, along: usize, others: &[usize]) -> String {
    let axes = sweep
        .axes
        .iter()
        .enumerate()
        .filter(|(place, _)| *place != along);
    let values = axes
        .zip(others)
        .map(|((_, axis), &place)| format!("{} {}", axis.name, short(&axis.labels[place])));
    let values: Vec<String> = values.collect();
    match values.is_empty() {
        true => "all runs".to_owned(),
        false => values.join(", "),
    }
}

/// A label; one that is a number without zeros that say nothing.
fn short(label: &str) -> String {
    match label.parse::<f64>() {
        Ok(number) if number == 0.0 || (1e-3..1e5).contains(&number.abs()) => number.to_string(),
        Ok(number) => format!("{number:e}"),
        Err(_) => label.to_owned(),
    }
}

/// Means with their intervals; a single run has none.
fn curve(label: &str, mut points: Vec<(f64, Mean)>) -> Curve {
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let ends = |mean: &Mean| match mean.number {
        0 | 1 => [mean.mean; 2],
        _ => mean.interval(LEVEL),
    };
    let marks = points.iter().map(|(x, mean)| [*x, mean.mean]);
    Curve::marked_line(label, marks).with_intervals(points.iter().map(|(_, mean)| ends(mean)))
}

/// A row per combination.
fn means(sweep: &Sweep, observation: &Observation, groups: &Groups) -> Markup {
    let mut columns: Vec<String> = sweep.axes.iter().map(|axis| axis.name.clone()).collect();
    columns.extend(["runs", "mean", "95 % interval of the mean"].map(str::to_owned));
    let row = |(places, values): (&Vec<usize>, &Vec<f64>)| {
        let mean = Mean::of(values)?;
        let labels = sweep
            .axes
            .iter()
            .zip(places)
            .map(|(axis, &place)| short(&axis.labels[place]));
        let mut row: Vec<String> = labels.collect();
        let [low, high] = mean.interval(LEVEL);
        let interval = match mean.number {
            0 | 1 => String::new(),
            _ => format!("{low:.4e} to {high:.4e}"),
        };
        row.extend([
            mean.number.to_string(),
            format!("{:.4e}", mean.mean),
            interval,
        ]);
        Some(row)
    };
    let rows: Vec<Vec<String>> = groups.iter().take(1000).filter_map(row).collect();
    table(&titled(observation), &columns, &rows)
}

/// Name and unit.
fn titled(observation: &Observation) -> String {
    match observation.unit() {
        "" => observation.name(),
        unit => format!("{} in {unit}", observation.name()),
    }
}
