//! Effective strength of bonds, thesis section 3.5.2 and appendix E.

use super::{Distribution, Uniform};
use gouge_equations::rendered;

/// A positive random variable raised to a positive power.
///
/// $$ P_{X^n}(q) = \frac{q^{(1-n)/n}}{n} P_X \left( q^{1/n} \right) $$
///
/// Thesis eqs. (126)-(127), with the density of X where (126) prints that of A (E34 of `docs/thesis/errata.md`). The
/// strength of a bond is proportional to the square of strength factor times smaller radius.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power<D> {
    /// The random variable X.
    pub of: D,
    /// The power n.
    pub exponent: f64,
}

impl<D: Distribution> Distribution for Power<D> {
    fn density(&self, q: f64) -> f64 {
        if q <= 0.0 {
            return 0.0;
        }
        let x = libm::pow(q, 1.0 / self.exponent);
        x / (q * self.exponent) * self.of.density(x)
    }
    fn cumulative(&self, q: f64) -> f64 {
        if q <= 0.0 {
            0.0
        } else {
            self.of.cumulative(libm::pow(q, 1.0 / self.exponent))
        }
    }
}

/// Distribution of the strength factor times the smaller of two radii, all independent and uniform.
///
/// $$ f(x) = \frac{2}{(b-a)^2 (d-c)} \left( b \log \frac{y_1}{y_0} - (y_1 - y_0) \right), \qquad y_0 = \max\{a, x/d\}, \quad y_1 = \min\{b, x/c\} $$
///
/// Radii are in [a, b] and factors in [c, d]. The smaller radius y has the density 2 (b - y) / (b - a)^2, and f is
/// the density of its product with the factor. Figure 8 of the thesis is computed with a single uniform radius
/// instead, although (49) uses the smaller one (erratum E27 of the thesis).
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeakestProduct {
    /// Radii in m.
    pub radius: Uniform,
    /// Strength factors.
    pub factor: Uniform,
}

impl WeakestProduct {
    /// Range of smaller radii for which some factor gives the product x, and the normalisation.
    fn span(&self, x: f64) -> (f64, f64, f64) {
        let (a, b) = (self.radius.low, self.radius.high);
        let (c, d) = (self.factor.low, self.factor.high);
        (
            (x / d).clamp(a, b),
            (x / c).clamp(a, b),
            (b - a) * (b - a) * (d - c),
        )
    }
}

impl Distribution for WeakestProduct {
    fn density(&self, x: f64) -> f64 {
        let (low, high, norm) = self.span(x);
        if high <= low {
            return 0.0;
        }
        2.0 * (self.radius.high * libm::log(high / low) - (high - low)) / norm
    }
    fn cumulative(&self, x: f64) -> f64 {
        let (low, high, norm) = self.span(x);
        let (a, b, c) = (self.radius.low, self.radius.high, self.factor.low);
        // Smaller radii below `low` give products below x for every factor, those up to `high` for some factors.
        let surely = 1.0 - ((b - low) / (b - a)) * ((b - low) / (b - a));
        let partly = |y: f64| b * x * libm::log(y) - (b * c + x) * y + 0.5 * c * y * y;
        (surely + 2.0 * (partly(high) - partly(low)) / norm).clamp(0.0, 1.0)
    }
}
