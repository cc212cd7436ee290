//! How well points of the parameters agree with what was measured.

use super::emulator::Prediction;

/// Implausibility from which on a point is ruled out, in standard deviations.
pub const RULED_OUT: f64 = 3.0;

/// A measured quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The value.
    pub value: f64,
    /// Standard deviation of the measurement.
    pub deviation: f64,
    /// Number of specimens whose mean was measured: each is a packing of its own.
    pub specimens: f64,
}

impl Measured {
    /// Variance of the difference between the measurement and a prediction: the measurement, the scatter of packings
    /// over the number of specimens, and the error of the emulator.
    pub fn variance(&self, prediction: Prediction) -> f64 {
        self.deviation.powi(2) + prediction.scatter / self.specimens + prediction.variance
    }

    /// The difference in standard deviations.
    pub fn residual(&self, prediction: Prediction) -> f64 {
        (self.value - prediction.mean) / self.variance(prediction).sqrt()
    }
}

/// Logarithm of the likelihood of a point: the measurements are independent and normal.
pub fn log_likelihood(measured: &[Measured], predictions: &[Prediction]) -> f64 {
    let pairs = measured.iter().zip(predictions);
    let term = |(one, &prediction): (&Measured, &Prediction)| {
        -0.5 * (one.residual(prediction).powi(2) + one.variance(prediction).ln())
    };
    pairs.map(term).sum()
}

/// The largest difference from any measurement, in standard deviations.
pub fn implausibility(measured: &[Measured], predictions: &[Prediction]) -> f64 {
    let pairs = measured.iter().zip(predictions);
    let residuals = pairs.map(|(one, &prediction)| one.residual(prediction).abs());
    residuals.fold(0.0, f64::max)
}
