//! The three-parameter Weibull distribution.

use super::Distribution;
use gouge_equations::rendered;

/// Three-parameter Weibull distribution.
///
/// $$ F(x) = 1 - \exp \left( - \left( \frac{x - x_0}{\lambda} \right)^k \right), \qquad x \ge x_0 $$
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weibull {
    /// Location $x_0$: the smallest value.
    pub location: f64,
    /// Scale $\lambda$.
    pub scale: f64,
    /// Shape $k$: the Weibull modulus.
    pub shape: f64,
}

#[rendered]
impl Weibull {
    fn moment(&self, order: f64) -> f64 {
        libm::tgamma(1.0 + order / self.shape)
    }
    /// Value below which the variable lies with a probability in [0, 1).
    ///
    /// $$ F^{-1}(p) = x_0 + \lambda \left( -\log (1 - p) \right)^{1/k} $$
    pub fn quantile(&self, probability: f64) -> f64 {
        let exponent = -libm::log1p(-probability);
        self.location + self.scale * libm::pow(exponent, 1.0 / self.shape)
    }
    /// Mean.
    pub fn mean(&self) -> f64 {
        self.location + self.scale * self.moment(1.0)
    }
    /// Variance.
    pub fn variance(&self) -> f64 {
        let first = self.moment(1.0);
        self.scale * self.scale * (self.moment(2.0) - first * first)
    }
}

impl Distribution for Weibull {
    fn density(&self, x: f64) -> f64 {
        let u = (x - self.location) / self.scale;
        if u <= 0.0 {
            return 0.0;
        }
        let power = libm::pow(u, self.shape);
        // The exponential is already zero when the power overflows.
        let falling = power.min(f64::MAX) * libm::exp(-power);
        self.shape / self.scale * falling / u
    }
    fn cumulative(&self, x: f64) -> f64 {
        let u = ((x - self.location) / self.scale).max(0.0);
        -libm::expm1(-libm::pow(u, self.shape))
    }
}
