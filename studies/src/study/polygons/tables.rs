//! The tables of the study: printed against measured values, all shapes, and what moves the numbers.

use super::SHAPES;
use super::claims::{compared, mean};
use super::figures::was_run;
use super::shapes::{SIDES, TESTED, name};
use crate::statistics::Mean;
use crate::study::results::Results;
use crate::study::sample::Sample;
use gouge_page::table;
use maud::Markup;

/// Columns of the table of shapes: name and observation.
const COLUMNS: [(&str, &str); 12] = [
    ("q/p", "stress_ratio"),
    ("solid fraction", "solid_fraction"),
    ("connected", "connected"),
    ("coordination", "coordination"),
    ("side-side", "side_side"),
    ("sliding", "sliding"),
    ("a_c", "a_c"),
    ("a_fn", "a_fn"),
    ("a_ft", "a_ft"),
    ("sweeps per step", "sweeps_mean"),
    ("largest overlap", "largest_overlap_maximum"),
    ("residual of velocities", "velocity_residual_mean"),
];

/// Parts that change one thing, with the axis on which it stands.
const CHANGED: [(&str, &str); 5] = [
    ("tolerance", "tolerance"),
    ("bias", "bias"),
    ("step", "step"),
    ("number", "bodies"),
    ("inertia", "inertia"),
];

pub(super) fn tables(results: &Results) -> Vec<Markup> {
    let sample = Sample {
        results,
        part: SHAPES,
    };
    let printed = compared(&sample).map(|all| {
        let rows = all.iter().map(|one| {
            let ([value, tolerance], [mean, error]) = (one.printed, one.measured);
            vec![
                one.item.clone(),
                format!("{value:.3}"),
                format!("{tolerance:.3}"),
                format!("{mean:.3} ± {error:.3}"),
                if one.is_met() { "met" } else { "missed" }.to_owned(),
            ]
        });
        let columns = ["item", "printed", "tolerance", "measured", ""].map(str::to_owned);
        table(
            "Printed and measured values",
            &columns,
            &rows.collect::<Vec<_>>(),
        )
    });
    let shapes = SIDES.iter().filter(|&&sides| was_run(&sample, sides));
    let rows: Vec<Vec<String>> = shapes
        .map(|&sides| row(&sample, &name(sides), sides))
        .collect();
    let all = (!rows.is_empty()).then(|| table("All shapes", &header("shape"), &rows));
    let changed = CHANGED
        .iter()
        .filter_map(|(part, axis)| sensitivity(results, part, axis));
    printed.into_iter().chain(all).chain(changed).collect()
}

fn header(first: &str) -> Vec<String> {
    let names = COLUMNS.iter().map(|(name, _)| (*name).to_owned());
    [first.to_owned()].into_iter().chain(names).collect()
}

fn row(sample: &Sample, label: &str, sides: u32) -> Vec<String> {
    let cells = COLUMNS
        .iter()
        .map(|(_, column)| cell(mean(sample, sides, column)));
    [label.to_owned()].into_iter().chain(cells).collect()
}

fn cell(mean: Option<Mean>) -> String {
    match mean {
        None => String::new(),
        Some(mean) if mean.number == 1 => format!("{:.4}", mean.mean),
        Some(mean) => format!("{:.4} ± {:.4}", mean.mean, mean.error()),
    }
}

/// The means for every value of an axis and the shapes that are tested.
fn sensitivity(results: &Results, part: &str, axis: &str) -> Option<Markup> {
    let sample = Sample { results, part };
    let mut rows = Vec::new();
    for sides in TESTED {
        let name = name(sides);
        let mut seen = Vec::new();
        for run in sample.runs().filter(|run| run.text("shape") == name) {
            let value = run.text(axis);
            if !seen.contains(&value) {
                seen.push(value);
            }
        }
        for value in seen {
            let of = |column: &str| {
                let is_meant = |run: &&_| is_of(run, &name, axis, value);
                let runs = sample.runs().filter(is_meant);
                Mean::of(
                    &runs
                        .filter_map(|run| run.number(column))
                        .collect::<Vec<f64>>(),
                )
            };
            let cells = COLUMNS.iter().map(|(_, column)| cell(of(column)));
            rows.push(
                [format!("{name}, {axis} {value}")]
                    .into_iter()
                    .chain(cells)
                    .collect(),
            );
        }
    }
    (!rows.is_empty()).then(|| table(&format!("What changes with: {axis}"), &header("run"), &rows))
}

fn is_of(run: &crate::study::results::Run, shape: &str, axis: &str, value: &str) -> bool {
    run.text("shape") == shape && run.text(axis) == value
}
