//! A whole calibration: waves of runs, the posterior, and what it determines.

use super::account::{exact, range};
use super::calibration::Calibration;
use super::identify::{Combination, Marginal, Model, combinations, marginals};
use super::likelihood::{Measured, RULED_OUT};
use super::posterior::Posterior;
use super::region::Region;
use super::results::{Results, Runner};
use super::waves::{Emulators, Wave, run_waves};
use gouge_runner::error::Error;

/// Points that look for the values that the model attains.
const SEARCHED: u32 = 1 << 13;
/// With a smaller effective number of points no interval is given.
const FEWEST: f64 = 100.0;

/// What a calibration found.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The measurements.
    pub measured: Vec<Measured>,
    /// What each wave found.
    pub waves: Vec<Wave>,
    /// All runs of the waves.
    pub results: Results,
    /// The emulators of the targets.
    pub emulators: Emulators,
    /// For each target, the smallest and the largest value that the model attains in the ranges.
    pub attained: Vec<[f64; 2]>,
    /// The posterior.
    pub posterior: Posterior,
    /// What is known of each parameter.
    pub marginals: Vec<Marginal>,
    /// The principal combinations of the parameters, the best determined first.
    pub combinations: Vec<Combination>,
    /// Runs at points of the posterior.
    pub predictive: Results,
    /// The answer.
    pub answer: Answer,
}

/// The answer of a calibration.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// All parameters are determined.
    Determined,
    /// Only combinations of the parameters are determined.
    Combinations,
    /// Nothing is determined.
    Undetermined,
    /// Too few points of the posterior count for any statement.
    Unresolved,
    /// The model cannot agree with the targets anywhere in the ranges: why.
    Refuted(Vec<String>),
}

impl Answer {
    /// The answer in a word.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Determined => "determined",
            Self::Combinations => "combinations",
            Self::Undetermined => "undetermined",
            Self::Unresolved => "unresolved",
            Self::Refuted(_) => "refuted",
        }
    }
}

/// Calibrate.
///
/// # Errors
/// A folder with the results of another calibration, a run that cannot be executed, an interruption, a budget that does
/// not suffice, too few successful runs, a target without a value.
pub fn calibrate(calibration: &Calibration, runner: Runner) -> Result<Outcome, Error> {
    let measured = calibration.measured()?;
    calibration.claim(runner.out)?;
    let (results, emulators, waves) = run_waves(calibration, &measured, runner)?;
    let log_likelihood = |point: &[f64]| emulators.log_likelihood(&measured, point);
    let posterior = Posterior::of(calibration.parameters.len(), &log_likelihood);
    let scaled = |point: &[f64]| {
        let pairs = measured.iter().zip(emulators.at(point));
        pairs
            .map(|(one, prediction)| prediction.mean / one.variance(prediction).sqrt())
            .collect()
    };
    let model = Model {
        log_likelihood: &log_likelihood,
        scaled: &scaled,
    };
    let marginals = marginals(&posterior, &model);
    let combinations = combinations(&posterior, &model);
    let attained = attained(calibration, &emulators);
    let smallest = waves.last().map_or(f64::INFINITY, |wave| wave.smallest);
    let reasons = refutation(calibration, &measured, &emulators, &attained, smallest);
    let answer = match reasons.is_empty() {
        false => Answer::Refuted(reasons),
        true if posterior.effective_number() < FEWEST => Answer::Unresolved,
        true => answer(&marginals, &combinations),
    };
    let mut predictive = Results {
        earlier: results.points.len(),
        ..Results::default()
    };
    let points = posterior.resampled(calibration.design.predictive);
    let points: Vec<Vec<f64>> = points.into_iter().map(<[f64]>::to_vec).collect();
    predictive.add(calibration, runner, "predictive check", &points)?;
    Ok(Outcome {
        measured,
        waves,
        results,
        emulators,
        attained,
        posterior,
        marginals,
        combinations,
        predictive,
        answer,
    })
}

impl Outcome {
    /// Part of the posterior that is closer to a point with a failed run than to any other: there the emulators know
    /// little.
    pub fn failed_share(&self) -> f64 {
        self.posterior.mean(&|point| self.near_failure(point))
    }

    /// The same part of the ranges.
    pub fn failed_range(&self) -> f64 {
        if self.results.failed().next().is_none() {
            return 0.0;
        }
        let points = Region::cube(self.marginals.len()).points(SEARCHED, 0);
        let near: f64 = points.iter().map(|point| self.near_failure(point)).sum();
        near / points.len() as f64
    }

    /// One if the nearest point has a failed run, otherwise zero.
    fn near_failure(&self, point: &[f64]) -> f64 {
        let points = &self.results.points;
        let distance = |place: &usize| -> f64 {
            let pairs = points[*place].iter().zip(point);
            pairs.map(|(x, y)| (x - y).powi(2)).sum()
        };
        let nearest = (0..points.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let has_failed = nearest.is_some_and(|nearest| self.results.has_failed_at(nearest));
        f64::from(u8::from(has_failed))
    }
}

fn answer(marginals: &[Marginal], combinations: &[Combination]) -> Answer {
    let is_bounded = marginals.iter().all(|one| one.is_bounded == [true; 2]);
    let determined = combinations.iter().filter(|one| one.is_determined());
    match determined.count() {
        0 => Answer::Undetermined,
        number if number == combinations.len() && is_bounded => Answer::Determined,
        _ => Answer::Combinations,
    }
}

/// The smallest and the largest mean of each target in the ranges.
fn attained(calibration: &Calibration, emulators: &Emulators) -> Vec<[f64; 2]> {
    let mut attained = vec![[f64::INFINITY, f64::NEG_INFINITY]; calibration.targets.len()];
    for point in Region::cube(calibration.parameters.len()).points(SEARCHED, 0) {
        for ([low, high], prediction) in attained.iter_mut().zip(emulators.at(&point)) {
            *low = low.min(prediction.mean);
            *high = high.max(prediction.mean);
        }
    }
    attained
}

/// Why the model cannot agree with the targets; empty if it can.
fn refutation(
    calibration: &Calibration,
    measured: &[Measured],
    emulators: &Emulators,
    attained: &[[f64; 2]],
    smallest: f64,
) -> Vec<String> {
    if smallest <= RULED_OUT {
        return Vec::new();
    }
    let mut least = vec![f64::INFINITY; measured.len()];
    for point in Region::cube(calibration.parameters.len()).points(SEARCHED, 0) {
        let pairs = measured.iter().zip(emulators.at(&point));
        for (least, (one, prediction)) in least.iter_mut().zip(pairs) {
            *least = least.min(one.residual(prediction).abs());
        }
    }
    let single = calibration
        .targets
        .iter()
        .zip(measured)
        .zip(attained.iter().zip(least));
    let mut reasons: Vec<String> = single
        .filter(|(_, (_, least))| *least > RULED_OUT)
        .map(|((target, one), ([low, high], least))| {
            format!(
                "{} = {}: the model attains {} in the ranges, {least:.1} standard deviations away",
                calibration.target_name(target),
                exact(one.value),
                range(*low, *high)
            )
        })
        .collect();
    if reasons.is_empty() {
        reasons.push(format!(
            "each target can be attained, but not all at once: at every point one of them is {smallest:.1} or more standard deviations away"
        ));
    }
    reasons
}
