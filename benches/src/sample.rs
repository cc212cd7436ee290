//! Repeated measurements.

use gouge_validation::measurements::quantile;
use serde::Serialize;

/// Repeated measurements of one quantity, in the order in which they were made.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Sample(pub Vec<f64>);

impl Sample {
    /// The quantile for a probability.
    fn quantile(&self, probability: f64) -> f64 {
        quantile(&self.0, probability)
    }
    /// The minimum.
    pub fn least(&self) -> f64 {
        self.quantile(0.0)
    }
    /// The median.
    pub fn median(&self) -> f64 {
        self.quantile(0.5)
    }
    /// Ratios to measurements made in the same rounds.
    pub fn over(&self, other: &Self) -> Self {
        Self(self.0.iter().zip(&other.0).map(|(a, b)| a / b).collect())
    }
    /// Median and quartiles in words.
    pub fn words(&self) -> String {
        format!(
            "{:.3} ({:.3} to {:.3})",
            self.median(),
            self.quantile(0.25),
            self.quantile(0.75)
        )
    }
}
