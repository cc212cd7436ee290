//! Runs of all tests at some points, and what they gave.

use super::calibration::{Calibration, Test};
use super::emulator::Sample;
use crate::sweep::{Planned, State, Status};
use gouge_runner::error::Error;
use std::collections::HashSet;
use std::path::Path;

/// Executes runs; the text says what they are for.
pub type Execute<'a> = &'a dyn Fn(&str, &[Planned]) -> Result<(), Error>;

/// Where and how runs are executed.
#[derive(Clone, Copy)]
pub struct Runner<'a> {
    /// Folder of the calibration.
    pub out: &'a Path,
    /// Executes runs that are not done.
    pub execute: Execute<'a>,
}

/// A run and what it gave.
#[derive(Clone, Debug)]
pub struct Finished {
    /// The run.
    pub run: Planned,
    /// Place of its test.
    pub test: usize,
    /// Place of its point.
    pub point: usize,
    /// Its seed.
    pub seed: Option<u64>,
    /// The quantities of the test, or why there are none.
    pub outcome: Result<Vec<f64>, String>,
    /// Wall time in s.
    pub seconds: f64,
}

/// What the runs at some points gave.
#[derive(Clone, Debug, Default)]
pub struct Results {
    /// The points in the unit cube.
    pub points: Vec<Vec<f64>>,
    /// The runs at all points.
    pub runs: Vec<Finished>,
    /// Number of points elsewhere, whose seeds are not used again.
    pub earlier: usize,
}

impl Results {
    /// Run all tests at more points.
    ///
    /// # Errors
    /// A run that cannot be executed, or an interruption.
    pub fn add(
        &mut self,
        calibration: &Calibration,
        runner: Runner,
        purpose: &str,
        points: &[Vec<f64>],
    ) -> Result<(), Error> {
        let first = self.points.len();
        self.points
            .extend(points.iter().map(|point| calibration.rounded(point)));
        let mut planned = Vec::new();
        for (place, point) in self.points.iter().enumerate().skip(first) {
            for (number, test) in calibration.tests.iter().enumerate() {
                for seed in test.seeds_at(self.earlier + place) {
                    planned.push((calibration.run(test, point, seed), number, place, seed));
                }
            }
        }
        (runner.execute)(purpose, &distinct(planned.iter().map(|one| &one.0)))?;
        let finished = planned.into_iter().map(|(run, test, point, seed)| {
            let (outcome, seconds) = outcome(&run, &calibration.tests[test], runner.out);
            Finished {
                run,
                test,
                point,
                seed,
                outcome,
                seconds,
            }
        });
        self.runs.extend(finished);
        Ok(())
    }

    /// The values of a quantity at all points that have any.
    pub fn samples(&self, test: usize, quantity: usize) -> Vec<Sample> {
        let mut samples: Vec<Sample> = self
            .points
            .iter()
            .map(|point| Sample {
                point: point.clone(),
                values: Vec::new(),
            })
            .collect();
        for run in self.runs.iter().filter(|run| run.test == test) {
            if let Ok(values) = &run.outcome {
                samples[run.point].values.push(values[quantity]);
            }
        }
        samples.retain(|sample| !sample.values.is_empty());
        samples
    }

    /// The runs without an outcome.
    pub fn failed(&self) -> impl Iterator<Item = &Finished> {
        self.runs.iter().filter(|run| run.outcome.is_err())
    }

    /// Whether any run at a point failed.
    pub fn has_failed_at(&self, point: usize) -> bool {
        self.failed().any(|run| run.point == point)
    }

    /// Wall time of all runs in s.
    pub fn seconds(&self) -> f64 {
        self.runs.iter().map(|run| run.seconds).sum()
    }
}

/// Runs that are the same are executed once.
fn distinct<'a>(runs: impl Iterator<Item = &'a Planned>) -> Vec<Planned> {
    let mut seen = HashSet::new();
    runs.filter(|run| seen.insert(run.name.clone()))
        .cloned()
        .collect()
}

/// The quantities of a run, or why there are none, and its wall time in s.
fn outcome(run: &Planned, test: &Test, out: &Path) -> (Result<Vec<f64>, String>, f64) {
    let State {
        status,
        cause,
        summary,
    } = run.state(out);
    let seconds = summary.as_ref().map_or(0.0, |summary| summary.wall_seconds);
    let outcome = match (status, &summary) {
        (Status::Done, Some(summary)) => {
            let folder = run.folder(out);
            let read_scene = || run.load().ok()?.into_dem();
            let finished = crate::sweep::Finished::new(&folder, summary, &read_scene);
            let observed = test.observed.iter();
            observed
                .map(|one| one.observation.value(&finished))
                .collect()
        }
        (status, _) => Err(format!("{}: {cause}", status.name())),
    };
    (outcome, seconds)
}
