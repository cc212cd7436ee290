//! What the measurements determine: single parameters, combinations of them, or nothing.

use super::climb::climb;
use super::parameter::{Parameter, Scale};
use super::posterior::Posterior;
use nalgebra::{DMatrix, SymmetricEigen};

/// A direction is determined if the measurements leave less than this part of the standard deviation of its range.
pub const DETERMINED: f64 = 0.5;
/// Drop of the profile of the log-likelihood at the ends of a 68 % and of a 95 % interval: half the quantile of the
/// chi-squared distribution with one degree of freedom.
pub const DROPS: [f64; 2] = [0.5, 1.92];
/// Probabilities of the quantiles that are reported: the median and the ends of the 68 % and 90 % intervals.
pub const PARTS: [f64; 5] = [0.5, 0.16, 0.84, 0.05, 0.95];
/// Components of a direction below this part of the largest one are not named: they carry 2 % of its variance.
const NEGLIGIBLE: f64 = 0.15;
/// Places of a profile inside the region that remains.
const PLACES: u32 = 40;
/// Points of the posterior over which the Fisher matrix is averaged.
const AVERAGED: usize = 200;
/// Step of differences in the unit cube.
const STEP: f64 = 1e-3;

/// What is known of one parameter, as places in its range.
#[derive(Clone, Debug, PartialEq)]
pub struct Marginal {
    /// The most likely value.
    pub best: f64,
    /// Quantiles of [`PARTS`].
    pub quantiles: [f64; 5],
    /// Standard deviation in units of that of the range.
    pub contraction: f64,
    /// The largest log-likelihood at each of some values, less that of the best.
    pub profile: Vec<[f64; 2]>,
    /// Whether the profile falls by 1.92 towards the lower and the upper end of the range.
    pub is_bounded: [bool; 2],
}

/// A combination of parameters: a direction in the unit cube.
#[derive(Clone, Debug, PartialEq)]
pub struct Combination {
    /// Coefficients of the places in the ranges.
    pub direction: Vec<f64>,
    /// Standard deviation in units of that of the ranges.
    pub contraction: f64,
}

/// The model as a likelihood, and the scaled predictions whose derivatives are the information.
pub struct Model<'a> {
    /// Log-likelihood of a point.
    pub log_likelihood: &'a dyn Fn(&[f64]) -> f64,
    /// Mean of each measured quantity in units of the standard deviation of its difference from the measurement.
    pub scaled: &'a dyn Fn(&[f64]) -> Vec<f64>,
}

/// What is known of each parameter.
pub fn marginals(posterior: &Posterior, model: &Model) -> Vec<Marginal> {
    let start = posterior.best().to_vec();
    let (top, best) = climb(start, model.log_likelihood);
    let marginal = |k: usize| {
        let place = |point: &[f64]| point[k];
        let profile = profile(posterior, model, k, top, &best);
        let end = |end: Option<&[f64; 2]>| end.is_some_and(|[_, drop]| *drop < -DROPS[1]);
        Marginal {
            best: best[k],
            quantiles: posterior.quantiles(&place, PARTS),
            contraction: posterior.deviation(&place) * 12.0_f64.sqrt(),
            is_bounded: [end(profile.first()), end(profile.last())],
            profile,
        }
    };
    (0..best.len()).map(marginal).collect()
}

/// The profile of a parameter over its whole range, finer where the likely points are.
fn profile(
    posterior: &Posterior,
    model: &Model,
    k: usize,
    top: f64,
    best: &[f64],
) -> Vec<[f64; 2]> {
    let [low, high] = posterior.quantiles(&|point| point[k], [1e-3, 1.0 - 1e-3]);
    let within = |place: u32| low + (high - low) * f64::from(place) / f64::from(PLACES);
    let coarse = (0..=PLACES).map(|place| f64::from(place) / f64::from(PLACES));
    let mut places: Vec<f64> = (0..=PLACES).map(within).chain(coarse).collect();
    places.push(best[k]);
    places.sort_by(f64::total_cmp);
    let height_at = |x: f64| {
        let others = |point: &[f64]| {
            let mut rest = point.to_vec();
            rest.remove(k);
            rest
        };
        let height = |rest: &[f64]| {
            let mut point = rest.to_vec();
            point.insert(k, x);
            (model.log_likelihood)(&point)
        };
        let near = posterior.points.iter().zip(&posterior.log_likelihood);
        let near = near.filter(|(point, _)| (point[k] - x).abs() < 1.0 / f64::from(PLACES));
        let likely = near.max_by(|a, b| a.1.total_cmp(b.1));
        let start = likely.map_or(best, |(point, _)| point.as_slice());
        climb(others(start), &height)
            .0
            .max(climb(others(best), &height).0)
    };
    places.iter().map(|&x| [x, height_at(x) - top]).collect()
}

/// Where a profile falls by an amount on both sides of its maximum; none where it does not.
pub fn profile_interval(profile: &[[f64; 2]], drop: f64) -> [Option<f64>; 2] {
    let crossing = |pair: &[[f64; 2]]| {
        let [[x, a], [y, b]] = [pair[0], pair[1]];
        let is_crossed = (a >= -drop) != (b >= -drop);
        // A profile is nearly a parabola: its root is nearly straight.
        let [a, b] = [a, b].map(|height| (-height).max(0.0).sqrt());
        is_crossed.then(|| x + (y - x) * (drop.sqrt() - a) / (b - a))
    };
    let crossings: Vec<f64> = profile.windows(2).filter_map(crossing).collect();
    let is_above = |end: Option<&[f64; 2]>| end.is_some_and(|[_, height]| *height >= -drop);
    [
        crossings
            .first()
            .copied()
            .filter(|_| !is_above(profile.first())),
        crossings
            .last()
            .copied()
            .filter(|_| !is_above(profile.last())),
    ]
}

/// The principal directions of the Fisher matrix, averaged over the posterior, the best determined first.
pub fn combinations(posterior: &Posterior, model: &Model) -> Vec<Combination> {
    let points = posterior.resampled(AVERAGED);
    let dimensions = posterior.best().len();
    let zero = DMatrix::zeros(dimensions, dimensions);
    let fisher = points.iter().fold(zero, |sum, point| {
        let slopes = slopes(model, point);
        sum + slopes.tr_mul(&slopes)
    });
    let eigen = SymmetricEigen::new(fisher);
    let mut order: Vec<usize> = (0..dimensions).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let combination = |k: usize| {
        let direction: Vec<f64> = eigen.eigenvectors.column(k).iter().copied().collect();
        let along = |point: &[f64]| point.iter().zip(&direction).map(|(x, v)| x * v).sum();
        // The direction has unit length, and each place has the variance 1/12 in its range.
        let contraction = posterior.deviation(&along) * 12.0_f64.sqrt();
        Combination {
            direction,
            contraction,
        }
    };
    order.into_iter().map(combination).collect()
}

/// Derivatives of the scaled predictions, one row each.
fn slopes(model: &Model, point: &[f64]) -> DMatrix<f64> {
    let shifted = |k: usize, by: f64| {
        let mut shifted = point.to_vec();
        shifted[k] = (shifted[k] + by).clamp(0.0, 1.0);
        let length = (shifted[k] - point[k]).abs();
        ((model.scaled)(&shifted), length)
    };
    let columns: Vec<Vec<f64>> = (0..point.len())
        .map(|k| {
            let ((above, right), (below, left)) = (shifted(k, STEP), shifted(k, -STEP));
            let pairs = above.iter().zip(&below);
            pairs.map(|(a, b)| (a - b) / (right + left)).collect()
        })
        .collect();
    DMatrix::from_fn(columns[0].len(), columns.len(), |i, k| columns[k][i])
}

impl Combination {
    /// Whether the measurements determine it.
    pub fn is_determined(&self) -> bool {
        self.contraction < DETERMINED
    }

    /// Exponents of the parameters (coefficients of those with a linear scale), the largest of which is 1 in size.
    pub fn exponents(&self, parameters: &[Parameter]) -> Vec<f64> {
        let pairs = self.direction.iter().zip(parameters);
        let raw: Vec<f64> = pairs.map(|(v, one)| v / one.width()).collect();
        let largest = raw
            .iter()
            .copied()
            .fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
        raw.iter().map(|exponent| exponent / largest).collect()
    }

    /// The combination as text, such as `damping stiffness^-0.50`; parameters that hardly enter are left out.
    pub fn text(&self, parameters: &[Parameter]) -> String {
        let largest = self.direction.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let enters = |k: &usize| self.direction[*k].abs() > NEGLIGIBLE * largest;
        let entering: Vec<usize> = (0..parameters.len()).filter(enters).collect();
        let exponents = self.exponents(parameters);
        let is_product = entering.iter().all(|&k| parameters[k].scale == Scale::Log);
        let term = |&k: &usize| {
            let Parameter { name, scale, .. } = &parameters[k];
            match (is_product, scale, format!("{:.2}", exponents[k])) {
                (true, _, one) if one == "1.00" => name.clone(),
                (true, _, exponent) => format!("{name}^{exponent}"),
                (false, Scale::Log, factor) => format!("{factor} ln({name})"),
                (false, Scale::Linear, factor) => format!("{factor} {name}"),
            }
        };
        let terms: Vec<String> = entering.iter().map(term).collect();
        terms.join(if is_product { " " } else { " + " })
    }
}
