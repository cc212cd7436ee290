//! Gaussian processes: regression with an error of its own, for values that scatter.

use super::climb::climb;
use super::sobol;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use std::f64::consts::PI;

/// Variance of the unknown mean of the process, in units of the variance of the values: as good as unknown.
const MEAN_VARIANCE: f64 = 100.0;
/// Ranges of the correlation lengths (the inputs fill the unit cube) and of the standard deviations of the process and
/// of the scatter (in units of that of the values).
const LENGTHS: [f64; 2] = [0.03, 10.0];
const AMPLITUDES: [f64; 2] = [1e-2, 1e2];
const SCATTERS: [f64; 2] = [1e-4, 10.0];
/// Number of settings that are tried, and from how many of the best ones the search climbs.
const TRIALS: u32 = 48;
const CLIMBS: usize = 4;

/// What was observed at a point: the mean of several values and the sum of their squared deviations from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Observed {
    /// The point in the unit cube.
    pub point: Vec<f64>,
    /// Mean of the values.
    pub mean: f64,
    /// Number of values.
    pub number: usize,
    /// Sum of the squared deviations from the mean.
    pub squares: f64,
}

impl Observed {
    /// The values at a point; none without a value.
    pub fn of(point: &[f64], values: &[f64]) -> Option<Self> {
        let number = values.len();
        let mean = values.iter().sum::<f64>() / number as f64;
        let squares = values.iter().map(|value| (value - mean).powi(2)).sum();
        (number > 0).then(|| Self {
            point: point.to_vec(),
            mean,
            number,
            squares,
        })
    }
}

/// A mean and a variance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normal {
    /// The mean.
    pub mean: f64,
    /// The variance.
    pub variance: f64,
}

/// A Gaussian process with unknown mean and the covariance of Matérn with smoothness 5/2,
///
/// s^2 (1 + q + q^2 / 3) exp(-q), q^2 = 5 sum_k (x_k - y_k)^2 / l_k^2,
///
/// of which values were observed with independent normal scatter of variance t^2. Lengths l_k, amplitude s and scatter
/// t maximise the likelihood of all values. Rasmussen and Williams, *Gaussian Processes for Machine Learning*, MIT Press
/// 2006, eqs. (2.23)-(2.30), (4.17) and (5.10)-(5.12).
#[derive(Clone, Debug)]
pub struct GaussianProcess {
    observed: Vec<Observed>,
    setting: Setting,
    /// Mean and standard deviation of the observed means, the units of all that follows.
    middle: f64,
    scale: f64,
    factor: Cholesky<f64, Dyn>,
    weights: DVector<f64>,
}

/// Lengths, amplitude and scatter.
#[derive(Clone, Debug)]
struct Setting {
    lengths: Vec<f64>,
    amplitude: f64,
    scatter: f64,
}

impl Setting {
    /// The setting at a place in the unit cube.
    fn at(place: &[f64]) -> Self {
        let within = |[low, high]: [f64; 2], part: f64| low * (high / low).powf(part);
        let dimensions = place.len() - 2;
        Self {
            lengths: place[..dimensions]
                .iter()
                .map(|&part| within(LENGTHS, part))
                .collect(),
            amplitude: within(AMPLITUDES, place[dimensions]),
            scatter: within(SCATTERS, place[dimensions + 1]),
        }
    }

    /// Covariance of the process at two points.
    fn covariance(&self, one: &[f64], other: &[f64]) -> f64 {
        let pairs = one.iter().zip(other).zip(&self.lengths);
        let squared: f64 = pairs.map(|((x, y), l)| ((x - y) / l).powi(2)).sum();
        let q = (5.0 * squared).sqrt();
        MEAN_VARIANCE + self.amplitude.powi(2) * (1.0 + q + q * q / 3.0) * (-q).exp()
    }

    /// Covariance of the observed means.
    fn matrix(&self, observed: &[Observed]) -> DMatrix<f64> {
        let number = observed.len();
        DMatrix::from_fn(number, number, |i, j| {
            let covariance = self.covariance(&observed[i].point, &observed[j].point);
            match i == j {
                true => covariance + self.scatter.powi(2) / observed[i].number as f64,
                false => covariance,
            }
        })
    }
}

impl GaussianProcess {
    /// The most likely process; none for fewer than two points.
    pub fn fit(observed: Vec<Observed>) -> Option<Self> {
        let number = observed.len() as f64;
        let dimensions = observed.first()?.point.len();
        let middle = observed.iter().map(|one| one.mean).sum::<f64>() / number;
        let squares = observed.iter().map(|one| (one.mean - middle).powi(2));
        let scale = (squares.sum::<f64>() / (number - 1.0)).sqrt();
        let scale = if scale > 0.0 {
            scale
        } else {
            f64::MIN_POSITIVE.sqrt()
        };
        let values = observed.iter().map(|one| (one.mean - middle) / scale);
        let values = DVector::from_iterator(observed.len(), values);
        let likelihood = |place: &[f64]| {
            let setting = Setting::at(place);
            log_likelihood(&setting, &observed, &values, scale).unwrap_or(f64::NEG_INFINITY)
        };
        let mut trials: Vec<(f64, Vec<f64>)> = sobol::points(TRIALS, dimensions + 2, 0)
            .map(|place| (likelihood(&place), place))
            .collect();
        trials.sort_by(|a, b| b.0.total_cmp(&a.0));
        let climbed = trials
            .into_iter()
            .take(CLIMBS)
            .map(|(_, place)| climb(place, &likelihood));
        let (_, best) = climbed.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let setting = Setting::at(&best);
        let factor = setting.matrix(&observed).cholesky()?;
        let weights = factor.solve(&values);
        (number > 1.0).then_some(Self {
            observed,
            setting,
            middle,
            scale,
            factor,
            weights,
        })
    }

    /// The process at a point, without the scatter of values.
    pub fn at(&self, point: &[f64]) -> Normal {
        let covariances = self
            .observed
            .iter()
            .map(|one| self.setting.covariance(point, &one.point));
        let mut covariances = DVector::from_iterator(self.observed.len(), covariances);
        let mean = self.middle + self.scale * covariances.dot(&self.weights);
        // In place, because the posterior asks at many points.
        let lower = self.factor.l_dirty();
        let is_solved = lower.solve_lower_triangular_mut(&mut covariances);
        let explained = if is_solved {
            covariances.norm_squared()
        } else {
            0.0
        };
        let variance = (self.setting.covariance(point, point) - explained).max(0.0);
        Normal {
            mean,
            variance: self.scale.powi(2) * variance,
        }
    }

    /// Standard deviation of a single value around the process.
    pub fn scatter(&self) -> f64 {
        self.scale * self.setting.scatter
    }

    /// Correlation lengths in the unit cube.
    pub fn lengths(&self) -> &[f64] {
        &self.setting.lengths
    }

    /// What was observed.
    pub fn observed(&self) -> &[Observed] {
        &self.observed
    }

    /// What the process, fitted without a point, expects as the mean of its values, for each point. The setting is that
    /// of all points.
    pub fn leave_one_out(&self) -> Vec<Normal> {
        let inverse = self.factor.inverse();
        let points = self.observed.iter().enumerate();
        let left_out = |(place, one): (usize, &Observed)| {
            let variance = 1.0 / inverse[(place, place)];
            Normal {
                mean: one.mean - self.scale * variance * self.weights[place],
                variance: self.scale.powi(2) * variance,
            }
        };
        points.map(left_out).collect()
    }
}

/// Logarithm of the likelihood of all values: that of the means, and that of the squares around them.
fn log_likelihood(
    setting: &Setting,
    observed: &[Observed],
    values: &DVector<f64>,
    scale: f64,
) -> Option<f64> {
    let factor = setting.matrix(observed).cholesky()?;
    let misfit = values.dot(&factor.solve(values));
    let diagonal = (0..values.len()).map(|i| factor.l_dirty()[(i, i)].ln());
    let of_means =
        -0.5 * misfit - diagonal.sum::<f64>() - 0.5 * values.len() as f64 * (2.0 * PI).ln();
    let freedom: usize = observed.iter().map(|one| one.number - 1).sum();
    let squares = observed.iter().map(|one| one.squares).sum::<f64>() / scale.powi(2);
    let variance = setting.scatter.powi(2);
    Some(of_means - 0.5 * (freedom as f64 * variance.ln() + squares / variance))
}
