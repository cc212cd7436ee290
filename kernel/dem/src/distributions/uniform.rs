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
    /// Standard deviation over mean.
    pub fn relative_deviation(&self) -> f64 {
        self.deviation() / self.mean()
    }
    fn length(&self) -> f64 {
        self.high - self.low
    }
}

/// Relative standard deviation of a positive interval whose upper end is so many times the lower one.
///
/// $$ \frac{\sigma}{\mu} = \frac{1}{\sqrt3} \frac{b/a - 1}{b/a + 1} $$
///
/// Thesis eq. (132), inverted. The root of two of the thesis gives the exact form of (131),
/// 0.0990576; the decimal printed there lacks a zero (erratum E35 of the thesis).
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

/// Whether sizes of this relative standard deviation order themselves, thesis eqs. (65) and (130).
///
/// The interval of thesis eq. (66) has 0.09906, which does (erratum E36 of the thesis).
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

/// A sum over the corners below x, each with its sign; `None` outside the support, where the terms
/// cancel only up to rounding.
fn over_corners(corners: [(f64, f64); 4], x: f64, term: impl Fn(f64) -> f64) -> Option<f64> {
    let inside = x > corners[0].1 && x < corners[3].1;
    let below = corners.iter().filter(|(_, corner)| x > *corner);
    inside.then(|| below.map(|&(sign, corner)| sign * term(corner)).sum())
}

/// Zero below a support, one above it.
fn outside(x: f64, upper_end: f64) -> f64 {
    if x < upper_end { 0.0 } else { 1.0 }
}

/// Sum of two independent uniform variables.
///
/// $$ P_{A+B}(x) = \frac{1}{(b-a)(d-c)} \left( [x-a-c]_+ - [x-b-c]_+ - [x-a-d]_+ + [x-b-d]_+ \right) $$
///
/// Thesis eqs. (121)-(123), both orders of the cases in one.
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

/// Product of two independent uniform variables over positive intervals.
///
/// $$ P_{AB}(x) = \frac{1}{(b-a)(d-c)} \left( \left[\log \tfrac{x}{ac}\right]_+ - \left[\log \tfrac{x}{bc}\right]_+ - \left[\log \tfrac{x}{ad}\right]_+ + \left[\log \tfrac{x}{bd}\right]_+ \right) $$
///
/// Thesis eqs. (121) and (124)-(125), both orders of the cases in one.
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
