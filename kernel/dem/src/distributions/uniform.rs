//! Uniform random variables, their sums and products.

use super::Distribution;
use gouge_equations::rendered;

/// A uniform random variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uniform {
    /// Lower bound.
    pub low: f64,
    /// Upper bound, greater than the lower one.
    pub high: f64,
}

#[rendered]
impl Uniform {
    /// The uniform variable with the given mean and standard deviation.
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
    /// Standard deviation: length of the interval divided by sqrt(12), thesis eq. (128).
    pub fn deviation(&self) -> f64 {
        (self.high - self.low) / 12.0_f64.sqrt()
    }
    /// Standard deviation divided by the mean.
    pub fn relative_deviation(&self) -> f64 {
        self.deviation() / self.mean()
    }
    fn length(&self) -> f64 {
        self.high - self.low
    }
}

/// Relative standard deviation of a positive uniform variable; `ratio` is its upper bound divided by its lower bound.
///
/// $$ \frac{\sigma}{\mu} = \frac{1}{\sqrt3} \frac{b/a - 1}{b/a + 1} $$
///
/// Inverse of thesis eq. (132). For the ratio sqrt(2) of the thesis the result is that of (131), 0.0990576. The
/// decimal printed there lacks a zero (erratum E35 of the thesis).
#[rendered]
pub fn relative_deviation_of_ratio(ratio: f64) -> f64 {
    (ratio - 1.0) / (3.0_f64.sqrt() * (ratio + 1.0))
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

/// Whether particles with this relative standard deviation of sizes crystallise, thesis eqs. (65) and (130).
///
/// They do for the range of thesis eq. (66), with 0.09906 (erratum E36 of the thesis).
pub fn crystallises(relative_deviation: f64) -> bool {
    relative_deviation < 0.1
}

/// Kinks of the trapezoidal density, each with its sign; `join` combines the bounds of both variables.
fn corners(a: &Uniform, b: &Uniform, join: impl Fn(f64, f64) -> f64) -> [(f64, f64); 4] {
    [
        (1.0, join(a.low, b.low)),
        (-1.0, join(a.high, b.low)),
        (-1.0, join(a.low, b.high)),
        (1.0, join(a.high, b.high)),
    ]
}

/// Sum of a term over all kinks below x, each with its sign. `None` outside the support, where the terms would cancel
/// only up to rounding.
fn over_corners(corners: [(f64, f64); 4], x: f64, term: impl Fn(f64) -> f64) -> Option<f64> {
    let inside = x > corners[0].1 && x < corners[3].1;
    let below = corners.iter().filter(|(_, corner)| x > *corner);
    inside.then(|| below.map(|&(sign, corner)| sign * term(corner)).sum())
}

/// Cumulative distribution outside the support: zero below it, one above it.
fn outside(x: f64, upper_end: f64) -> f64 {
    if x < upper_end { 0.0 } else { 1.0 }
}

/// Sum of two independent uniform random variables.
///
/// $$ P_{A+B}(x) = \frac{1}{(b-a)(d-c)} \left( [x-a-c]_+ - [x-b-c]_+ - [x-a-d]_+ + [x-b-d]_+ \right) $$
///
/// Thesis eqs. (121)-(123), for both orders of the inner kinks.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UniformSum(pub Uniform, pub Uniform);

impl UniformSum {
    fn corners(&self) -> [(f64, f64); 4] {
        corners(&self.0, &self.1, |a, b| a + b)
    }
    fn area(&self) -> f64 {
        self.0.length() * self.1.length()
    }
}

impl Distribution for UniformSum {
    fn density(&self, x: f64) -> f64 {
        let sum = over_corners(self.corners(), x, |corner| x - corner);
        sum.map_or(0.0, |sum| sum.max(0.0) / self.area())
    }
    fn cumulative(&self, x: f64) -> f64 {
        let corners = self.corners();
        let sum = over_corners(corners, x, |corner| 0.5 * (x - corner) * (x - corner));
        sum.map_or(outside(x, corners[3].1), |sum| {
            (sum / self.area()).clamp(0.0, 1.0)
        })
    }
}

/// Product of two independent uniform random variables with positive values.
///
/// $$ P_{AB}(x) = \frac{1}{(b-a)(d-c)} \left( \left[\log \tfrac{x}{ac}\right]_+ - \left[\log \tfrac{x}{bc}\right]_+ - \left[\log \tfrac{x}{ad}\right]_+ + \left[\log \tfrac{x}{bd}\right]_+ \right) $$
///
/// Thesis eqs. (121) and (124)-(125), for both orders of the inner kinks.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UniformProduct(pub Uniform, pub Uniform);

impl UniformProduct {
    fn corners(&self) -> [(f64, f64); 4] {
        corners(&self.0, &self.1, |a, b| a * b)
    }
    fn area(&self) -> f64 {
        self.0.length() * self.1.length()
    }
}

impl Distribution for UniformProduct {
    fn density(&self, x: f64) -> f64 {
        let sum = over_corners(self.corners(), x, |corner| libm::log(x / corner));
        sum.map_or(0.0, |sum| sum.max(0.0) / self.area())
    }
    fn cumulative(&self, x: f64) -> f64 {
        let corners = self.corners();
        let area = |corner: f64| x * libm::log(x / corner) - (x - corner);
        let sum = over_corners(corners, x, area);
        sum.map_or(outside(x, corners[3].1), |sum| {
            (sum / self.area()).clamp(0.0, 1.0)
        })
    }
}
