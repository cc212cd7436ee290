//! Emulators: what a run would give, without running it.

use super::gaussian_process::{GaussianProcess, Normal, Observed};
use serde::Deserialize;
use std::fmt;
use std::sync::Arc;

/// In which form a quantity is emulated.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Form {
    /// As it is.
    #[default]
    Linear,
    /// By its logarithm, for positive quantities that vary by factors.
    Log,
}

/// A function of the place in the unit cube of the parameters.
pub type Expected = Arc<dyn Fn(&[f64]) -> f64 + Send + Sync>;

/// What a quantity is at a point of the parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prediction {
    /// Mean over packings.
    pub mean: f64,
    /// Variance of this mean: the error of the emulator.
    pub variance: f64,
    /// Variance of a single packing around the mean.
    pub scatter: f64,
}

/// Values of a quantity at a point, one for each seed.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The point in the unit cube.
    pub point: Vec<f64>,
    /// The values.
    pub values: Vec<f64>,
}

/// An emulator of one quantity: an expression, if theory has one, and a Gaussian process for the rest.
#[derive(Clone)]
pub struct Emulator {
    form: Form,
    expected: Option<Expected>,
    process: GaussianProcess,
}

impl fmt::Debug for Emulator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Emulator")
            .field("form", &self.form)
            .field("process", &self.process)
            .finish_non_exhaustive()
    }
}

impl Emulator {
    /// The emulator of some samples.
    ///
    /// # Errors
    /// Fewer than two samples, or a value that is not positive where logarithms are emulated.
    pub fn fit(samples: &[Sample], form: Form, expected: Option<Expected>) -> Result<Self, String> {
        let rest = |sample: &Sample| {
            let base = expected.as_ref().map(|expected| expected(&sample.point));
            let rest: Vec<f64> = sample
                .values
                .iter()
                .map(|&value| match form {
                    Form::Linear => value - base.unwrap_or(0.0),
                    Form::Log => (value / base.unwrap_or(1.0)).ln(),
                })
                .collect();
            match rest.iter().all(|value| value.is_finite()) {
                true => Ok(Observed::of(&sample.point, &rest)),
                false => Err(format!("{:?} have no logarithm", sample.values)),
            }
        };
        let observed = samples.iter().map(rest).collect::<Result<Vec<_>, _>>()?;
        let process = GaussianProcess::fit(observed.into_iter().flatten().collect());
        Ok(Self {
            form,
            expected,
            process: process.ok_or("fewer than two points have a value")?,
        })
    }

    /// What is expected at a point.
    pub fn at(&self, point: &[f64]) -> Prediction {
        let scatter = self.process.scatter().powi(2);
        self.natural(point, self.process.at(point), scatter)
    }

    /// What the emulator, fitted without a point, expects as the mean of its values, for each point.
    pub fn leave_one_out(&self) -> Vec<Residual> {
        let observed = self.process.observed().iter();
        let pairs = observed.zip(self.process.leave_one_out());
        pairs
            .map(|(one, left_out)| {
                let natural = |rest| self.natural(&one.point, rest, 0.0);
                let exactly = Normal {
                    mean: one.mean,
                    variance: 0.0,
                };
                Residual {
                    value: natural(exactly).mean,
                    expected: natural(left_out).mean,
                    deviation: natural(left_out).variance.sqrt(),
                    standardised: (one.mean - left_out.mean) / left_out.variance.sqrt(),
                }
            })
            .collect()
    }

    /// The points that have values, in the order of [`Emulator::leave_one_out`].
    pub fn points(&self) -> impl Iterator<Item = &[f64]> {
        let observed = self.process.observed().iter();
        observed.map(|one| one.point.as_slice())
    }

    /// Correlation lengths in the unit cube.
    pub fn lengths(&self) -> &[f64] {
        self.process.lengths()
    }

    /// A prediction from that of the process, to first order in the logarithm.
    fn natural(&self, point: &[f64], rest: Normal, scatter: f64) -> Prediction {
        let base = self.expected.as_ref().map(|expected| expected(point));
        let (mean, slope) = match self.form {
            Form::Linear => (base.unwrap_or(0.0) + rest.mean, 1.0),
            Form::Log => {
                let mean = base.unwrap_or(1.0) * rest.mean.exp();
                (mean, mean)
            }
        };
        Prediction {
            mean,
            variance: slope * slope * rest.variance,
            scatter: slope * slope * scatter,
        }
    }
}

/// A point that was left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// The mean of its values.
    pub value: f64,
    /// What was expected.
    pub expected: f64,
    /// Standard deviation of the difference that was expected.
    pub deviation: f64,
    /// The difference in units of it, in the form in which the quantity is emulated.
    pub standardised: f64,
}
