//! Recovery of known truths by runs: truths from the ranges, and what would be measured there.

use super::calibration::{Calibration, Test};
use super::recover::{Recovery, Repetition};
use super::region::Region;
use super::results::{Results, Runner};
use super::waves::Emulators;
use gouge_runner::error::Error;
use rand::RngExt;
use rand_pcg::Pcg64;
use statrs::distribution::{ContinuousCDF, Normal};

/// Seed and stream of truths and errors of measurement.
const RANDOM: [u128; 2] = [20, 26];

/// A recovery and what it cost.
#[derive(Clone, Debug)]
pub struct Trial {
    /// How the parameters were recovered.
    pub recovery: Recovery,
    /// Number of repetitions whose run failed: they are left out.
    pub failed: usize,
    /// Number of runs.
    pub runs: usize,
    /// Wall time of all runs in s.
    pub seconds: f64,
}

/// Recover known truths: draw them from the ranges, run the scenes there with seeds of their own, add errors of
/// measurement, and find the posteriors with emulators that know nothing of these runs. One set of emulators, of as many
/// runs as all waves of a calibration, serves all repetitions.
///
/// # Errors
/// A run that cannot be executed, an interruption, too few successful runs.
pub fn recover(calibration: &Calibration, runner: Runner) -> Result<Trial, Error> {
    let calibration = &calibration.with_targets_only();
    let dimensions = calibration.parameters.len();
    let number = calibration.design.points * calibration.design.waves as u32;
    let mut design = Results::default();
    let points = Region::cube(dimensions).points(number, 0);
    design.add(calibration, runner, "emulators", &points)?;
    let emulators = Emulators::fit(calibration, &design)?;
    let [seed, stream] = RANDOM;
    let mut random = Pcg64::new(seed, stream);
    let mut truth = || (0..dimensions).map(|_| random.random::<f64>()).collect();
    let truths: Vec<Vec<f64>> = (0..calibration.design.repetitions)
        .map(|_| truth())
        .collect();
    let specimens = with_specimens(calibration, design.points.len());
    let mut runs = Results::default();
    runs.add(&specimens, runner, "truths", &truths)?;
    let failed = (0..truths.len()).filter(|&place| runs.has_failed_at(place));
    let failed = failed.count();
    let repetitions = repetitions(&specimens, &runs, &mut random);
    Ok(Trial {
        recovery: Recovery::of(&|point| emulators.at(point), &repetitions),
        failed,
        runs: design.runs.len() + runs.runs.len(),
        seconds: design.seconds() + runs.seconds(),
    })
}

/// The calibration with as many seeds as specimens are measured, other ones than those of a number of points.
fn with_specimens(calibration: &Calibration, points: usize) -> Calibration {
    let specimens = |place: usize| {
        let targets = calibration.targets.iter();
        let own = targets.filter(|target| target.test == place);
        own.map(|target| target.specimens as u64).max().unwrap_or(1)
    };
    let others = |(place, test): (usize, &Test)| {
        let first = test.seeds_at(points).into_iter().flatten().min();
        let seeds = first.map(|first| (first..first + specimens(place)).collect());
        Test {
            seeds: seeds.unwrap_or_default(),
            ..test.clone()
        }
    };
    Calibration {
        tests: calibration.tests.iter().enumerate().map(others).collect(),
        ..calibration.clone()
    }
}

/// What would be measured where all runs succeeded: the mean over the specimens, and an error.
fn repetitions(calibration: &Calibration, runs: &Results, random: &mut Pcg64) -> Vec<Repetition> {
    let normal = Normal::standard();
    let mut all = Vec::new();
    for (place, truth) in runs.points.iter().enumerate() {
        let errors: Vec<f64> = calibration
            .targets
            .iter()
            .map(|_| normal.inverse_cdf(random.random::<f64>()))
            .collect();
        if runs.has_failed_at(place) {
            continue;
        }
        let measured = calibration
            .targets
            .iter()
            .zip(errors)
            .map(|(target, error)| {
                let values: Vec<f64> = runs
                    .runs
                    .iter()
                    .filter(|run| run.point == place && run.test == target.test)
                    .filter_map(|run| run.outcome.as_ref().ok())
                    .map(|values| values[target.quantity])
                    .take(target.specimens as usize)
                    .collect();
                let mean = values.iter().sum::<f64>() / values.len() as f64;
                // A scene without random numbers gives the same for all specimens.
                target.measured(mean + target.deviation * error)
            });
        all.push(Repetition {
            truth: truth.clone(),
            measured: measured.collect(),
        });
    }
    all
}
