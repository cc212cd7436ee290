//! Tests and intervals for small samples.

use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

/// A mean with its confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// Number of values.
    pub number: usize,
    /// The mean.
    pub mean: f64,
    /// Standard deviation of a value; NaN for a single one.
    pub deviation: f64,
}

impl Mean {
    /// The mean of independent values; none without values.
    pub fn of(values: &[f64]) -> Option<Self> {
        let number = values.len();
        let mean = values.iter().sum::<f64>() / number as f64;
        let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
        let deviation = (squares / (number as f64 - 1.0)).sqrt();
        (number > 0).then_some(Self {
            number,
            mean,
            deviation,
        })
    }

    /// Standard error of the mean.
    pub fn error(&self) -> f64 {
        self.deviation / (self.number as f64).sqrt()
    }

    /// Student's distribution of the mean; none for a single value.
    fn student(&self) -> Option<StudentsT> {
        StudentsT::new(0.0, 1.0, self.number as f64 - 1.0).ok()
    }

    /// The interval that holds the true mean with a given probability, if values are normal; infinite for a single
    /// value.
    pub fn interval(&self, level: f64) -> [f64; 2] {
        let quantile = self.student().map(|one| one.inverse_cdf(0.5 + 0.5 * level));
        let margin = quantile.map_or(f64::INFINITY, |quantile| quantile * self.error());
        [self.mean - margin, self.mean + margin]
    }

    /// Probability of a mean at least this large if the true one is zero (one-sided test of Student); 1 for a single
    /// value.
    pub fn p_greater(&self) -> f64 {
        match self.student() {
            Some(student) if self.deviation > 0.0 => student.sf(self.mean / self.error()),
            Some(_) if self.mean > 0.0 => 0.0,
            _ => 1.0,
        }
    }
}

/// Probabilities of several tests, adjusted by Holm so that any error among them is as rare as stated.
pub fn holm(probabilities: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..probabilities.len()).collect();
    order.sort_by(|&a, &b| probabilities[a].total_cmp(&probabilities[b]));
    let mut adjusted = vec![0.0; probabilities.len()];
    let mut least: f64 = 0.0;
    for (rank, &test) in order.iter().enumerate() {
        let factor = (probabilities.len() - rank) as f64;
        least = least.max((factor * probabilities[test]).min(1.0));
        adjusted[test] = least;
    }
    adjusted
}

/// Jonckheere's test of a trend over ordered groups: the probability of a rise at least this strong without a trend,
/// in the normal approximation for values without ties.
pub fn rising(groups: &[Vec<f64>]) -> f64 {
    let pairs = |a: &[f64], b: &[f64]| -> f64 {
        let of = |x: &f64| b.iter().map(|y| score(*x, *y)).sum::<f64>();
        a.iter().map(of).sum()
    };
    let mut sum = 0.0;
    for (place, group) in groups.iter().enumerate() {
        sum += groups[place + 1..]
            .iter()
            .map(|later| pairs(group, later))
            .sum::<f64>();
    }
    let sizes = groups.iter().map(|group| group.len() as f64);
    let number: f64 = sizes.clone().sum();
    let cubic = |n: f64| n * n * (2.0 * n + 3.0);
    let mean = 0.25 * (number * number - sizes.clone().map(|n| n * n).sum::<f64>());
    let variance = (cubic(number) - sizes.map(cubic).sum::<f64>()) / 72.0;
    Normal::standard().sf((sum - mean) / variance.sqrt())
}

/// One if the second value is larger, a half for equal ones.
fn score(first: f64, second: f64) -> f64 {
    match second.total_cmp(&first) {
        std::cmp::Ordering::Greater => 1.0,
        std::cmp::Ordering::Equal => 0.5,
        std::cmp::Ordering::Less => 0.0,
    }
}

/// Slope of the straight line that fits points best.
pub fn slope(points: &[[f64; 2]]) -> f64 {
    let number = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|point| point[axis]).sum::<f64>() / number;
    let [x, y] = [mean(0), mean(1)];
    let product: f64 = points
        .iter()
        .map(|point| (point[0] - x) * (point[1] - y))
        .sum();
    let square: f64 = points.iter().map(|point| (point[0] - x).powi(2)).sum();
    product / square
}
