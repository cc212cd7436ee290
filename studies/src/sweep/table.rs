//! The results of a sweep as a table in long form.

use super::file::{Axis, Sweep};
use super::finished::Finished;
use super::observe::Observation;
use super::page::{Outcome, page_of};
use super::plan::Planned;
use super::state::{State, Status};
use crate::csv_table::csv_table;
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use toml::Spanned;

/// Column of the name of a run.
pub const RUN: &str = "run";
/// Columns of how a run ended.
pub const STATE: [&str; 2] = ["status", "cause"];
/// Columns of what a run cost.
pub const COST: [&str; 5] = [
    "steps",
    "time",
    "particles",
    "balance_error",
    "wall_seconds",
];

/// Write `runs.csv` and `sweep.html`. The table has one row per run, with its axes, its status and cause, its observations and its cost. Failed runs are
/// rows, too; what a run does not have is empty.
///
/// # Errors
/// Failures of the file system.
pub fn collect(sweep: &Sweep, runs: &[Planned], out: &Path) -> Result<PathBuf, Error> {
    let path = out.join("runs.csv");
    let axes: Vec<&Axis> = sweep.all_axes().collect();
    let mut header = vec![RUN.to_owned()];
    header.extend(axes.iter().map(|axis| axis.name.clone()));
    header.extend(STATE.map(str::to_owned));
    header.extend(sweep.observations.iter().map(|one| one.get_ref().name()));
    header.extend(COST.map(str::to_owned));
    let first = 1 + axes.len();
    let all = runs.par_iter().map(|run| row(sweep, &axes, run, out));
    let rows: Vec<Vec<String>> = all.collect();
    let outcome = |row: &Vec<String>| {
        let observed = row[first + 2..].iter().take(sweep.observations.len());
        Outcome {
            status: row[first].clone(),
            observed: observed
                .map(|cell| cell.parse().unwrap_or(f64::NAN))
                .collect(),
        }
    };
    let outcomes: Vec<Outcome> = rows.iter().map(outcome).collect();
    let table = csv_table(&path, [header].into_iter().chain(rows))?;
    write_whole(&path, &table)?;
    let page = page_of(sweep, runs, &outcomes).into_string();
    write_whole(&out.join("sweep.html"), page.as_bytes())?;
    Ok(path)
}

fn row(sweep: &Sweep, axes: &[&Axis], run: &Planned, out: &Path) -> Vec<String> {
    let folder = run.folder(out);
    let state = State::of(&folder);
    let is_observed = match state.status {
        Status::Done => true,
        Status::Untrusted => sweep.observe_untrusted,
        _ => false,
    };
    let summary = state.summary.as_ref();
    let scene = || run.load().ok()?.into_dem();
    let summary_of_observed = summary.filter(|_| is_observed);
    let finished = summary_of_observed.map(|summary| Finished::new(&folder, summary, &scene));
    let observe = |one: &Observation| finished.as_ref().map(|run| one.value(run));
    let observations = sweep.observations.iter().map(Spanned::get_ref);
    let observed: Vec<_> = observations.map(observe).collect();
    let missing = observed
        .iter()
        .flatten()
        .filter_map(|one| one.as_ref().err());
    let causes = [&state.cause].into_iter().chain(missing);
    let causes: Vec<&str> = causes
        .map(String::as_str)
        .filter(|cause| !cause.is_empty())
        .collect();
    let mut row = vec![run.name.clone()];
    row.extend(
        axes.iter()
            .zip(&run.places)
            .map(|(axis, &place)| axis.labels[place].clone()),
    );
    row.extend([
        state.status.name().to_owned(),
        causes.join("; ").replace('\n', "; "),
    ]);
    let shown = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:?}"));
    row.extend(
        observed
            .iter()
            .map(|one| shown(one.as_ref().and_then(|one| one.as_ref().ok()).copied())),
    );
    let of_summary = |text: &dyn Fn(&gouge_runner::run::Summary) -> String| {
        summary.map_or_else(String::new, text)
    };
    row.extend([
        of_summary(&|one| one.steps.to_string()),
        of_summary(&|one| format!("{:?}", one.time)),
        of_summary(&|one| one.particles.to_string()),
        shown(summary.and_then(|one| one.balance_error)),
        of_summary(&|one| format!("{:.3}", one.wall_seconds)),
    ]);
    row
}
