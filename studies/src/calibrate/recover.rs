//! Recovery of known truths: whether intervals hold what they should, tested on measurements whose truth is known.

use super::emulator::Prediction;
use super::likelihood::{Measured, RULED_OUT, implausibility, log_likelihood};
use super::posterior::{Posterior, effective_number, weights};
use super::region::Region;
use statrs::distribution::Uniform;
use statrs::stats_tests::NaNPolicy;
use statrs::stats_tests::ks_test::{KSOneSampleAlternativeMethod, ks_onesample};

/// Points of the posterior of each repetition, and their seed.
const POINTS: u32 = 1 << 13;
const SEED: u32 = 3;
/// With fewer effective points, the posterior of a repetition is refined.
const FEWEST: f64 = 100.0;
/// Coverage of 90 % intervals that is accepted.
pub const ACCEPTED: [f64; 2] = [0.82, 0.97];
/// From so many repetitions on, ranks must be uniform, at this level.
const MANY: usize = 100;
const LEVEL: f64 = 0.01;

/// A measurement whose truth is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Repetition {
    /// The parameters, in the unit cube.
    pub truth: Vec<f64>,
    /// What was measured.
    pub measured: Vec<Measured>,
}

/// How a parameter was recovered.
#[derive(Clone, Debug, PartialEq)]
pub struct Recovered {
    /// Rank of each truth: the part of the posterior below it. Uniform in [0, 1] if the posterior is right (Cook,
    /// Gelman and Rubin, J. Comput. Graph. Stat. 15, 675, 2006).
    pub ranks: Vec<f64>,
    /// Mean standard deviation of the posterior in units of that of the range.
    pub contraction: f64,
}

/// How all parameters were recovered.
#[derive(Clone, Debug, PartialEq)]
pub struct Recovery {
    /// Each parameter.
    pub parameters: Vec<Recovered>,
    /// The smallest effective number of points of any posterior.
    pub effective_number: f64,
    /// Share of the repetitions that would be refuted although the truth is in the ranges.
    pub refuted: f64,
}

impl Recovered {
    /// Share of the central intervals of a probability that hold the truth.
    pub fn coverage(&self, probability: f64) -> f64 {
        let holds = |rank: &&f64| (*rank - 0.5).abs() <= 0.5 * probability;
        self.ranks.iter().filter(holds).count() as f64 / self.ranks.len() as f64
    }

    /// Probability of ranks at least as uneven as these if they are uniform (Kolmogorov and Smirnov).
    pub fn evenness(&self) -> f64 {
        let method = KSOneSampleAlternativeMethod::TwoSidedAsymptotic;
        let test = Uniform::new(0.0, 1.0).ok().and_then(|uniform| {
            ks_onesample(self.ranks.clone(), &uniform, method, NaNPolicy::Error).ok()
        });
        test.map_or(0.0, |(_, probability)| probability)
    }

    /// Whether the 90 % intervals cover what they should and, for many repetitions, the ranks are uniform.
    pub fn passes(&self) -> bool {
        let coverage = self.coverage(0.9);
        let is_even = self.ranks.len() < MANY || self.evenness() >= LEVEL;
        (ACCEPTED[0]..=ACCEPTED[1]).contains(&coverage) && is_even
    }
}

impl Recovery {
    /// Find the posterior of each repetition, with the same emulators for all.
    pub fn of(predict: &dyn Fn(&[f64]) -> Vec<Prediction>, repetitions: &[Repetition]) -> Self {
        let dimensions = repetitions.first().map_or(0, |one| one.truth.len());
        let points = Region::cube(dimensions).points(POINTS, SEED);
        let predictions: Vec<Vec<Prediction>> = points.iter().map(|point| predict(point)).collect();
        let none = Recovered {
            ranks: Vec::new(),
            contraction: 0.0,
        };
        let mut recovery = Self {
            parameters: vec![none; dimensions],
            effective_number: f64::INFINITY,
            refuted: 0.0,
        };
        let share = 1.0 / repetitions.len() as f64;
        for one in repetitions {
            let heights = predictions
                .iter()
                .map(|prediction| log_likelihood(&one.measured, prediction));
            let weights = weights(&heights.collect::<Vec<_>>());
            if effective_number(&weights) >= FEWEST {
                recovery.add(&one.truth, &points, &weights, share);
            } else {
                let height = |point: &[f64]| log_likelihood(&one.measured, &predict(point));
                let posterior = Posterior::of(dimensions, &height);
                recovery.add(&one.truth, &posterior.points, &posterior.weights, share);
            }
            let is_ruled_out = |prediction: &Vec<Prediction>| {
                implausibility(&one.measured, prediction) > RULED_OUT
            };
            if predictions.iter().all(is_ruled_out) {
                recovery.refuted += share;
            }
        }
        recovery
    }

    /// Count the posterior of a truth, a share of all.
    fn add(&mut self, truth: &[f64], points: &[Vec<f64>], weights: &[f64], share: f64) {
        for (k, parameter) in self.parameters.iter_mut().enumerate() {
            let (mut rank, mut mean, mut square) = (0.0, 0.0, 0.0);
            for (point, weight) in points.iter().zip(weights) {
                if point[k] < truth[k] {
                    rank += weight;
                }
                mean += weight * point[k];
                square += weight * point[k] * point[k];
            }
            parameter.ranks.push(rank);
            let variance = (square - mean * mean).max(0.0);
            parameter.contraction += share * (12.0 * variance).sqrt();
        }
        self.effective_number = self.effective_number.min(effective_number(weights));
    }

    /// Whether all parameters pass.
    pub fn passes(&self) -> bool {
        self.parameters.iter().all(Recovered::passes)
    }
}
