//! Normal variables truncated to their admissible range.

use super::quadrature::integral;

/// A normal variable, given that it lies in an interval.
#[derive(Clone, Copy, Debug)]
pub struct Truncated {
    /// Mean before truncation.
    pub mean: f64,
    /// Standard deviation before truncation.
    pub deviation: f64,
    /// Interval.
    pub interval: [f64; 2],
}

impl Truncated {
    /// Whether a value lies in the interval.
    pub fn keeps(&self, value: f64) -> bool {
        value > self.interval[0] && value < self.interval[1]
    }
    /// Expectation of a function.
    pub fn expectation(&self, function: impl Fn(f64) -> f64) -> f64 {
        // Beyond ten deviations the density is negligible in double precision.
        let end = |side: f64| self.mean + side * 10.0 * self.deviation;
        let low = self.interval[0].max(end(-1.0));
        let high = self.interval[1].min(end(1.0));
        let weight = |x: f64| (-0.5 * ((x - self.mean) / self.deviation).powi(2)).exp();
        integral(low, high, |x| weight(x) * function(x)) / integral(low, high, weight)
    }
}
