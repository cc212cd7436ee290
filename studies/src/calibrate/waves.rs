//! Waves of runs: each is made where the earlier ones leave the targets plausible.

use super::calibration::Calibration;
use super::emulator::{Emulator, Prediction};
use super::likelihood::{Measured, RULED_OUT, implausibility, log_likelihood};
use super::region::Region;
use super::results::{Results, Runner};
use super::sobol;
use crate::sweep::{Planned, estimate};
use gouge_runner::error::Error;

/// Candidates among which the points of a wave are chosen.
const CANDIDATES: u32 = 1 << 13;
/// Rounds of candidates, each in a smaller region, until enough of them are plausible.
const ROUNDS: usize = 4;

/// What a wave found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// Number of its points.
    pub points: usize,
    /// Share of the ranges that is not ruled out after it.
    pub share: f64,
    /// The smallest implausibility that any point has.
    pub smallest: f64,
}

/// The emulators of all targets.
#[derive(Clone, Debug)]
pub struct Emulators(pub Vec<Emulator>);

impl Emulators {
    /// Fit them to all results.
    ///
    /// # Errors
    /// Too few successful runs, or a closed form that does not fit.
    pub fn fit(calibration: &Calibration, results: &Results) -> Result<Self, Error> {
        let emulator = |target: &super::calibration::Target| {
            let test = &calibration.tests[target.test];
            let observed = &test.observed[target.quantity];
            let form = observed.closed_form;
            let expected = form.map(|form| calibration.expected(test, form));
            let expected = expected.transpose().map_err(Error::Argument)?;
            let samples = results.samples(target.test, target.quantity);
            Emulator::fit(&samples, observed.form, expected).map_err(|reason| {
                let cause = results.failed().find_map(|run| run.outcome.clone().err());
                let cause = cause.map_or(String::new(), |cause| format!("; a run said: {cause}"));
                let name = calibration.target_name(target);
                Error::Argument(format!("{}: {name}: {reason}{cause}", calibration.file))
            })
        };
        let all = calibration
            .targets
            .iter()
            .map(emulator)
            .collect::<Result<_, _>>()?;
        Ok(Self(all))
    }

    /// What is expected of all targets at a point.
    pub fn at(&self, point: &[f64]) -> Vec<Prediction> {
        self.0.iter().map(|one| one.at(point)).collect()
    }

    /// Log-likelihood of a point.
    pub fn log_likelihood(&self, measured: &[Measured], point: &[f64]) -> f64 {
        log_likelihood(measured, &self.at(point))
    }
}

/// Run all waves; the results, the emulators of all of them, and what each wave found.
///
/// # Errors
/// A run that cannot be executed, an interruption, a budget that does not suffice, too few successful runs.
pub fn run_waves(
    calibration: &Calibration,
    measured: &[Measured],
    runner: Runner,
) -> Result<(Results, Emulators, Vec<Wave>), Error> {
    let dimensions = calibration.parameters.len();
    let number = calibration.design.points;
    let mut points: Vec<Vec<f64>> = sobol::points(number, dimensions, 0).collect();
    within_budget(calibration, &points, runner)?;
    let (mut results, mut waves) = (Results::default(), Vec::new());
    loop {
        let purpose = format!("wave {}", waves.len() + 1);
        results.add(calibration, runner, &purpose, &points)?;
        let emulators = Emulators::fit(calibration, &results)?;
        let badness = |point: &[f64]| implausibility(measured, &emulators.at(point));
        let seed = waves.len() as u32 + 1;
        let (next, share, smallest) = choose(dimensions, number as usize, seed, &badness);
        waves.push(Wave {
            points: points.len(),
            share,
            smallest,
        });
        if waves.len() == calibration.design.waves {
            return Ok((results, emulators, waves));
        }
        points = next;
    }
}

/// Points of the next wave: plausible ones, evenly spread, or else the least implausible ones; the plausible share of
/// the cube, and the smallest implausibility.
fn choose(
    dimensions: usize,
    number: usize,
    seed: u32,
    badness: &dyn Fn(&[f64]) -> f64,
) -> (Vec<Vec<f64>>, f64, f64) {
    let mut region = Region::cube(dimensions);
    let mut smallest = f64::INFINITY;
    let mut share = None;
    for round in 1.. {
        let candidates = region.points(CANDIDATES, seed);
        let badnesses: Vec<f64> = candidates.iter().map(|point| badness(point)).collect();
        smallest = badnesses.iter().copied().fold(smallest, f64::min);
        let pairs = candidates.iter().zip(&badnesses);
        let plausible = pairs.clone().filter(|(_, badness)| **badness <= RULED_OUT);
        let plausible: Vec<Vec<f64>> = plausible.map(|(point, _)| point.clone()).collect();
        let share = *share.get_or_insert(plausible.len() as f64 / candidates.len() as f64);
        if plausible.len() >= number {
            // The first points of the sequence fill the region evenly, too.
            return (plausible[..number].to_vec(), share, smallest);
        }
        if round == ROUNDS {
            let mut order: Vec<(&Vec<f64>, &f64)> = pairs.collect();
            order.sort_by(|a, b| a.1.total_cmp(b.1));
            let best = order.into_iter().take(number);
            return (
                best.map(|(point, _)| point.clone()).collect(),
                share,
                smallest,
            );
        }
        let heights: Vec<f64> = badnesses
            .iter()
            .map(|badness| -0.5 * badness.powi(2))
            .collect();
        region = Region::around(&candidates, &heights, 0.5 * RULED_OUT.powi(2));
    }
    (Vec::new(), 0.0, smallest)
}

/// Refuse a calibration beyond its budget before anything is run.
fn within_budget(
    calibration: &Calibration,
    points: &[Vec<f64>],
    runner: Runner,
) -> Result<(), Error> {
    let per_point: usize = calibration
        .tests
        .iter()
        .map(|test| test.seeds_at(0).len())
        .sum();
    let number =
        per_point * (points.len() * calibration.design.waves + calibration.design.predictive);
    let file = &calibration.file;
    if let Some(most) = calibration.runs.filter(|&most| number > most) {
        let reason =
            format!("{file}: budget.runs = {most}: the calibration needs up to {number} runs");
        return Err(Error::Argument(reason));
    }
    let Some(most) = calibration.core_hours else {
        return Ok(());
    };
    let tests = |(place, point)| {
        calibration
            .tests
            .iter()
            .map(move |test| (place, point, test))
    };
    let runs: Vec<Planned> = points
        .iter()
        .enumerate()
        .flat_map(tests)
        .flat_map(|(place, point, test)| {
            let seeds = test.seeds_at(place).into_iter();
            seeds.map(move |seed| calibration.run(test, point, seed))
        })
        .filter(|run| !run.state(runner.out).status.is_final())
        .collect();
    let open: Vec<&Planned> = runs.iter().collect();
    let later = number as f64 / (per_point * points.len()) as f64;
    let hours = later * estimate(&open).core_hours;
    match hours > most {
        true => Err(Error::Argument(format!(
            "{file}: budget.core_hours = {most:?}: the runs would take about {hours:.3} core-hours"
        ))),
        false => Ok(()),
    }
}
