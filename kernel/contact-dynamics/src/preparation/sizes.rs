//! Diameters of circumscribed circles.

use crate::error::{SetupError, require};
use gouge_equations::rendered;

/// Range of diameters whose distribution is uniform by volume.
///
/// Equal intervals of the diameter d hold equal areas, so that the number density is
///
/// $$ p(d) = \frac{d^{-2}}{1/d_0 - 1/d_1}, \qquad d_0 \le d \le d_1 $$
///
/// with the mean $\langle d \rangle = \ln(d_1/d_0) / (1/d_0 - 1/d_1)$.
///
/// # Errata and departures
/// What the source calls the mean is not the mean of its range: azema E10.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiameterRange {
    /// Smallest diameter $d_0$ in m.
    pub minimum: f64,
    /// Largest diameter $d_1$ in m.
    pub maximum: f64,
}

impl DiameterRange {
    /// The range with a mean diameter in m and a ratio of the largest to the smallest.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] unless the mean is positive and the ratio is at least 1.
    pub fn with_mean(mean: f64, ratio: f64) -> Result<Self, SetupError> {
        require("mean diameter", mean, "positive", mean > 0.0)?;
        require("size ratio", ratio, "at least 1", ratio >= 1.0)?;
        let of_smallest = match ratio > 1.0 {
            true => (ratio - 1.0) / (ratio * libm::log(ratio)),
            false => 1.0,
        };
        let minimum = mean * of_smallest;
        Ok(Self {
            minimum,
            maximum: ratio * minimum,
        })
    }

    /// The range printed in the source, 0.6 to 2.4 of a length that it takes for the mean.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] unless the length is positive.
    pub fn printed(length: f64) -> Result<Self, SetupError> {
        require("mean diameter", length, "positive", length > 0.0)?;
        Ok(Self {
            minimum: 0.6 * length,
            maximum: 2.4 * length,
        })
    }

    /// Mean diameter in m.
    pub fn mean(self) -> f64 {
        let width = 1.0 / self.minimum - 1.0 / self.maximum;
        match width > 0.0 {
            true => libm::log(self.maximum / self.minimum) / width,
            false => self.minimum,
        }
    }

    /// Diameter in m below which a share of all bodies, in [0, 1], lies.
    pub fn quantile(self, share: f64) -> f64 {
        let (low, high) = (1.0 / self.minimum, 1.0 / self.maximum);
        1.0 / (low - share * (low - high))
    }
}

/// Independent diameters in m.
pub fn draw_diameters(
    range: DiameterRange,
    number: usize,
    mut uniform: impl FnMut() -> f64,
) -> Vec<f64> {
    (0..number).map(|_| range.quantile(uniform())).collect()
}
