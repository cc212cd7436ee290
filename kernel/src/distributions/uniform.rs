//! Uniform variables, their sums and products.

use super::Distribution;
use gouge_equations::rendered;

/// Uniform over an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uniform {
    /// Lower end.
    pub low: f64,
    /// Upper end, above the lower one.
    pub high: f64,
}

#[rendered]
impl Uniform {
    /// The interval with a mean and a standard deviation.
    ///
    /// $$ a = \mu - \sigma \sqrt3, \qquad b = \mu + \sigma \sqrt3 $$
    ///
    /// Thesis eq. (129).
    pub fn with_moments(mean: f64, deviation: f64) -> Self {
        let half = deviation * 3.0_f64.sqrt();
        Self {
            low: mean - half,
            high: mean + half,
        }
    }
    /// Mean, thesis eq. (128).
    pub fn mean(&self) -> f64 {
        0.5 * (self.low + self.high)
    }
    /// Standard deviation: the length over twice the root of three, thesis eq. (128).
    pub fn deviation(&self) -> f64 {
        (self.high - self.low) / 12.0_f64.sqrt()
    }
    fn length(&self) -> f64 {
        self.high - self.low
    }
}

impl Distribution for Uniform {
    fn density(&self, x: f64) -> f64 {
        if x >= self.low && x <= self.high {
            1.0 / self.length()
        } else {
            0.0
        }
    }
    fn cumulative(&self, x: f64) -> f64 {
        ((x - self.low) / self.length()).clamp(0.0, 1.0)
    }
}

/// Whether sizes of this relative standard deviation order themselves, thesis eqs. (65) and (130).
///
/// The interval of thesis eq. (66) has 0.09906, which does (E36 of `docs/errata.md`).
pub fn crystallises(relative_deviation: f64) -> bool {
    relative_deviation < 0.1
}

/// Corners of the trapezoid of two intervals with the signs of its kinks, for any order of the ends.
fn corners(a: &Uniform, b: &Uniform, join: impl Fn(f64, f64) -> f64) -> [(f64, f64); 4] {
    [
        (1.0, join(a.low, b.low)),
        (-1.0, join(a.high, b.low)),
        (-1.0, join(a.low, b.high)),
        (1.0, join(a.high, b.high)),
    ]
}

/// Sum of two independent uniform variables.
///
/// $$ P_{A+B}(x) = \frac{1}{(b-a)(d-c)} \left( [x-a-c]_+ - [x-b-c]_+ - [x-a-d]_+ + [x-b-d]_+ \right) $$
///
/// Thesis eqs. (121)-(123), both orders of the cases in one.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UniformSum(pub Uniform, pub Uniform);

impl Distribution for UniformSum {
    fn density(&self, x: f64) -> f64 {
        let sum: f64 = corners(&self.0, &self.1, |a, b| a + b)
            .iter()
            .map(|(sign, corner)| sign * (x - corner).max(0.0))
            .sum();
        sum.max(0.0) / (self.0.length() * self.1.length())
    }
    fn cumulative(&self, x: f64) -> f64 {
        let sum: f64 = corners(&self.0, &self.1, |a, b| a + b)
            .iter()
            .map(|(sign, corner)| 0.5 * sign * (x - corner).max(0.0) * (x - corner).max(0.0))
            .sum();
        (sum / (self.0.length() * self.1.length())).clamp(0.0, 1.0)
    }
}

/// Product of two independent uniform variables over positive intervals.
///
/// $$ P_{AB}(x) = \frac{1}{(b-a)(d-c)} \left( \left[\log \tfrac{x}{ac}\right]_+ - \left[\log \tfrac{x}{bc}\right]_+ - \left[\log \tfrac{x}{ad}\right]_+ + \left[\log \tfrac{x}{bd}\right]_+ \right) $$
///
/// Thesis eqs. (121) and (124)-(125), both orders of the cases in one.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UniformProduct(pub Uniform, pub Uniform);

impl Distribution for UniformProduct {
    fn density(&self, x: f64) -> f64 {
        if x <= 0.0 {
            return 0.0;
        }
        let sum: f64 = corners(&self.0, &self.1, |a, b| a * b)
            .iter()
            .map(|(sign, corner)| sign * libm::log(x / corner).max(0.0))
            .sum();
        sum.max(0.0) / (self.0.length() * self.1.length())
    }
    fn cumulative(&self, x: f64) -> f64 {
        let area = |corner: f64| match x > corner {
            true => x * libm::log(x / corner) - x + corner,
            false => 0.0,
        };
        let sum: f64 = corners(&self.0, &self.1, |a, b| a * b)
            .iter()
            .map(|(sign, corner)| sign * area(*corner))
            .sum();
        (sum / (self.0.length() * self.1.length())).clamp(0.0, 1.0)
    }
}
