//! What the measurements leave of the ranges: the posterior, by importance sampling on fixed points.

use super::region::Region;

/// Points of a round, their seed, and the most rounds.
const POINTS: u32 = 1 << 14;
const SEED: u32 = 1;
const ROUNDS: usize = 6;
/// Effective number of points that is enough: means are then known to a thirtieth of a standard deviation.
pub const ENOUGH: f64 = 1000.0;
/// Points whose log-likelihood is further below the largest one do not shape the next round: five standard deviations.
const DEPTH: f64 = 12.5;

/// Points in the unit cube with their weights.
#[derive(Clone, Debug, PartialEq)]
pub struct Posterior {
    /// The points.
    pub points: Vec<Vec<f64>>,
    /// Log-likelihood at each.
    pub log_likelihood: Vec<f64>,
    /// Weights; their sum is 1.
    pub weights: Vec<f64>,
}

impl Posterior {
    /// The posterior of a likelihood, with a uniform prior in the unit cube. The points of the first round fill the
    /// cube. Those of each further round fill a box around what remained, along its principal axes, until enough of them
    /// count.
    pub fn of(dimensions: usize, log_likelihood: &dyn Fn(&[f64]) -> f64) -> Self {
        let mut region = Region::cube(dimensions);
        let mut best = Self::in_region(&region, log_likelihood);
        for _ in 1..ROUNDS {
            if best.effective_number() >= ENOUGH {
                break;
            }
            region = Region::around(&best.points, &best.log_likelihood, DEPTH);
            let next = Self::in_region(&region, log_likelihood);
            if next.effective_number() <= best.effective_number() {
                break;
            }
            best = next;
        }
        best
    }

    fn in_region(region: &Region, log_likelihood: &dyn Fn(&[f64]) -> f64) -> Self {
        let points = region.points(POINTS, SEED);
        let heights = points.iter().map(|point| log_likelihood(point)).collect();
        Self::weighted(points, heights)
    }

    /// Points that fill a region evenly, weighted by their likelihoods.
    fn weighted(points: Vec<Vec<f64>>, log_likelihood: Vec<f64>) -> Self {
        Self {
            points,
            weights: weights(&log_likelihood),
            log_likelihood,
        }
    }

    /// Number of independent points of equal weight that would tell as much (Kish).
    pub fn effective_number(&self) -> f64 {
        effective_number(&self.weights)
    }

    /// The most likely of the points.
    pub fn best(&self) -> &[f64] {
        let indices = 0..self.points.len();
        let best =
            indices.max_by(|&a, &b| self.log_likelihood[a].total_cmp(&self.log_likelihood[b]));
        best.map_or(&[], |best| &self.points[best])
    }

    /// Mean of a function.
    pub fn mean(&self, function: &dyn Fn(&[f64]) -> f64) -> f64 {
        let pairs = self.points.iter().zip(&self.weights);
        pairs.map(|(point, weight)| weight * function(point)).sum()
    }

    /// Standard deviation of a function.
    pub fn deviation(&self, function: &dyn Fn(&[f64]) -> f64) -> f64 {
        let mean = self.mean(function);
        self.mean(&|point| (function(point) - mean).powi(2)).sqrt()
    }

    /// Quantiles of a function.
    pub fn quantiles<const N: usize>(
        &self,
        function: &dyn Fn(&[f64]) -> f64,
        parts: [f64; N],
    ) -> [f64; N] {
        let mut pairs: Vec<(f64, f64)> = self
            .points
            .iter()
            .zip(&self.weights)
            .map(|(point, &weight)| (function(point), weight))
            .collect();
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        parts.map(|part| {
            let mut sum = 0.0;
            let reached = pairs.iter().find(|(_, weight)| {
                sum += weight;
                sum >= part
            });
            reached
                .or(pairs.last())
                .map_or(f64::NAN, |(value, _)| *value)
        })
    }

    /// Points with equal weights: each of them stands for the same part of the posterior.
    pub fn resampled(&self, number: usize) -> Vec<&[f64]> {
        let mut sum = 0.0;
        let mut chosen = Vec::with_capacity(number);
        for (point, weight) in self.points.iter().zip(&self.weights) {
            sum += weight;
            while (chosen.len() as f64 + 0.5) / (number as f64) < sum && chosen.len() < number {
                chosen.push(point.as_slice());
            }
        }
        chosen
    }
}

/// Likelihoods, scaled so that their sum is 1.
pub fn weights(log_likelihood: &[f64]) -> Vec<f64> {
    let top = log_likelihood
        .iter()
        .copied()
        .fold(f64::NEG_INFINITY, f64::max);
    let mut weights: Vec<f64> = log_likelihood.iter().map(|one| (one - top).exp()).collect();
    let sum: f64 = weights.iter().sum();
    weights.iter_mut().for_each(|weight| *weight /= sum);
    weights
}

/// Number of independent points of equal weight that would tell as much as these weights.
pub fn effective_number(weights: &[f64]) -> f64 {
    1.0 / weights.iter().map(|weight| weight * weight).sum::<f64>()
}
