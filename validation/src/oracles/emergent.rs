//! Distributions of sums, products and strengths of uniform variables, by integration over one
//! variable.

use super::quadrature::integral_over;

/// The smallest of several independent variables on an interval.
#[derive(Clone, Copy, Debug)]
pub struct Bounded {
    /// Interval.
    pub interval: [f64; 2],
    /// Number of variables.
    pub smallest_of: i32,
    /// Slope p of their density, which grows as 1 + p (x / m - 1), with m the middle of the interval; 0
    /// if uniform.
    pub preference: f64,
}

impl Bounded {
    /// The smallest of the given number of uniform variables.
    pub fn uniform(interval: [f64; 2], smallest_of: i32) -> Self {
        Self {
            interval,
            smallest_of,
            preference: 0.0,
        }
    }
    /// Probability that one variable exceeds x: the mean of its density at x and at the upper end.
    fn one_exceeds(&self, x: f64) -> f64 {
        let [a, b] = self.interval;
        let x = x.clamp(a, b);
        (b - x) * self.one_density(0.5 * (x + b))
    }
    /// Density of one variable inside the interval.
    fn one_density(&self, x: f64) -> f64 {
        let [a, b] = self.interval;
        (1.0 + self.preference * (2.0 * x / (a + b) - 1.0)) / (b - a)
    }
    /// Probability that the smallest value exceeds x: all values exceed it.
    fn exceeds(&self, x: f64) -> f64 {
        self.one_exceeds(x).powi(self.smallest_of)
    }
    /// Probability density.
    fn density(&self, x: f64) -> f64 {
        let [a, b] = self.interval;
        if x < a || x > b {
            return 0.0;
        }
        let n = self.smallest_of;
        f64::from(n) * self.one_density(x) * self.one_exceeds(x).powi(n - 1)
    }
    /// Expectation of a power.
    pub fn moment(&self, order: f64) -> f64 {
        integral_over(&self.interval, |x| x.powf(order) * self.density(x))
    }
}

/// The operation that joins two independent variables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Join {
    /// Their sum.
    Sum,
    /// Their product.
    Product,
}

/// The sum or product of a uniform factor and another variable, both positive.
#[derive(Clone, Copy, Debug)]
pub struct Joined {
    /// Interval of the uniform factor.
    pub factor: [f64; 2],
    /// The other variable.
    pub other: Bounded,
    /// The operation.
    pub join: Join,
}

impl Joined {
    /// The value of the other variable for which the factor gives x, and its derivative with respect to
    /// x.
    fn needed(&self, x: f64, factor: f64) -> [f64; 2] {
        match self.join {
            Join::Sum => [x - factor, 1.0],
            Join::Product => [x / factor, factor.recip()],
        }
    }
    /// Integral over the factor, split where the other variable reaches an end of its interval.
    fn mean(&self, x: f64, function: impl Fn(f64) -> f64) -> f64 {
        let [c, d] = self.factor;
        let mut points = vec![c, d];
        points.extend(self.other.interval.map(|end| match self.join {
            Join::Sum => (x - end).clamp(c, d),
            Join::Product => (x / end).clamp(c, d),
        }));
        points.sort_by(f64::total_cmp);
        integral_over(&points, function) / (d - c)
    }
    /// Probability density at x.
    pub fn density(&self, x: f64) -> f64 {
        self.mean(x, |factor| {
            let [other, slope] = self.needed(x, factor);
            self.other.density(other) * slope
        })
    }
    /// Probability of a value of at most x.
    pub fn cumulative(&self, x: f64) -> f64 {
        1.0 - self.mean(x, |factor| self.other.exceeds(self.needed(x, factor)[0]))
    }
}

/// Strength of bonds in units of that of mean grains: the square of factor times radius.
#[derive(Clone, Copy, Debug)]
pub struct Strength {
    /// Factor times radius.
    pub root: Joined,
}

impl Strength {
    /// Strength for a radius distribution and factors in an interval.
    pub fn new(radius: Bounded, factor: [f64; 2]) -> Self {
        Self {
            root: Joined {
                factor,
                other: radius,
                join: Join::Product,
            },
        }
    }
    /// Points between which the density is analytic.
    pub fn corners(&self) -> [f64; 4] {
        let ([a, b], [c, d]) = (self.root.other.interval, self.root.factor);
        let mut all = [a * c, a * d, b * c, b * d].map(|x| x * x);
        all.sort_by(f64::total_cmp);
        all
    }
    /// Probability density.
    pub fn density(&self, q: f64) -> f64 {
        let x = q.sqrt();
        self.root.density(x) / (2.0 * x)
    }
    /// Probability of a strength of at most q.
    pub fn cumulative(&self, q: f64) -> f64 {
        self.root.cumulative(q.sqrt())
    }
    /// Expectation of a power of the strength.
    pub fn moment(&self, order: f64) -> f64 {
        let factor = Bounded::uniform(self.root.factor, 1);
        factor.moment(2.0 * order) * self.root.other.moment(2.0 * order)
    }
    /// Standard deviation over mean.
    pub fn variation(&self) -> f64 {
        let mean = self.moment(1.0);
        (self.moment(2.0) - mean * mean).sqrt() / mean
    }
}
