//! The result of a check and its tolerance.

use super::Exhibit;
use crate::scenes::Mistake;
use gouge_contact_dynamics::error as rigid;
use gouge_dem::{ModelError, StepError};
use gouge_peridem::error as deformable;
use gouge_runner::error::{Error, SceneError};
use serde::Serialize;
use thiserror::Error;

/// Where a tolerance comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Origin {
    /// Rounding only.
    Exact,
    /// The order of the method and a known constant.
    Convergent,
    /// A margin and a power fixed in advance.
    Statistical,
}

impl Origin {
    /// All origins.
    pub const ALL: [Self; 3] = [Self::Exact, Self::Convergent, Self::Statistical];

    /// Its name, as in `report.json`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Convergent => "convergent",
            Self::Statistical => "statistical",
        }
    }
}

/// The expected and the measured value, their error, and its tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// The expected value.
    pub expected: f64,
    /// The measured value.
    pub measured: f64,
    /// The error, in the norm of the check.
    pub error: f64,
    /// The largest error that passes.
    pub tolerance: f64,
}

impl Measurement {
    /// A comparison by relative error.
    pub fn relative(expected: f64, measured: f64, tolerance: f64) -> Self {
        Self {
            expected,
            measured,
            error: ((measured - expected) / expected).abs(),
            tolerance,
        }
    }
    /// A comparison by absolute error.
    pub fn absolute(expected: f64, measured: f64, tolerance: f64) -> Self {
        Self::scaled(expected, measured, 1.0, tolerance)
    }
    /// A comparison by the error in units of a scale.
    pub fn scaled(expected: f64, measured: f64, scale: f64, tolerance: f64) -> Self {
        Self {
            expected,
            measured,
            error: ((measured - expected) / scale).abs(),
            tolerance,
        }
    }
    /// A comparison in units in the last place of the expected value.
    pub fn ulp(expected: f64, measured: f64, tolerance: f64) -> Self {
        Self::scaled(expected, measured, unit_in_last_place(expected), tolerance)
    }
    /// A number of cases that must be zero.
    pub fn count(cases: usize) -> Self {
        Self::absolute(0.0, cases as f64, 0.0)
    }
    /// Whether the error is within the tolerance; an undefined error is not.
    pub fn passes(&self) -> bool {
        self.error <= self.tolerance
    }
    /// The measurement with the largest ratio of error to tolerance. An undefined error counts as
    /// infinite; without any measurement the result is undefined.
    pub fn worst(all: impl IntoIterator<Item = Self>) -> Self {
        let severity = |one: &Self| match one.error / one.tolerance {
            _ if one.error.is_nan() => f64::INFINITY,
            ratio if ratio.is_nan() => 0.0,
            ratio => ratio,
        };
        let worse = |a: &Self, b: &Self| severity(a).total_cmp(&severity(b));
        let nothing = Self::absolute(f64::NAN, f64::NAN, 0.0);
        all.into_iter().max_by(worse).unwrap_or(nothing)
    }
    /// Correct decimal digits of the measured value, at most those of a double.
    pub fn digits(&self) -> f64 {
        if self.measured == self.expected {
            return MOST_DIGITS;
        }
        let scale = if self.expected == 0.0 {
            1.0
        } else {
            self.expected.abs()
        };
        let relative = (self.measured - self.expected).abs() / scale;
        (-relative.log10()).clamp(0.0, MOST_DIGITS)
    }
}

/// Decimal digits of a double.
const MOST_DIGITS: f64 = 16.0;

/// Distance from a number to the next larger one in absolute value.
pub fn unit_in_last_place(number: f64) -> f64 {
    let size = number.abs();
    if size.is_finite() {
        size.next_up() - size
    } else {
        f64::NAN
    }
}

/// The largest of some sizes; undefined if one of them is, which `f64::max` would ignore.
pub fn largest(sizes: impl IntoIterator<Item = f64>) -> f64 {
    let keep = |a: f64, b: f64| if b > a || b.is_nan() { b } else { a };
    sizes.into_iter().fold(0.0, keep)
}

/// The result of a check: its measurement, and exhibits for the reader.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The measurement by which the check passes or fails.
    pub measurement: Measurement,
    /// Figures and tables for the report.
    pub exhibits: Vec<Exhibit>,
}

impl From<Measurement> for Finding {
    fn from(measurement: Measurement) -> Self {
        Self {
            measurement,
            exhibits: Vec::new(),
        }
    }
}

impl Measurement {
    /// The finding of this measurement, with exhibits.
    pub fn showing(self, exhibits: impl IntoIterator<Item = Exhibit>) -> Finding {
        Finding {
            measurement: self,
            exhibits: exhibits.into_iter().collect(),
        }
    }
}

/// Why a check has no measurement; it then fails.
#[derive(Debug, Error)]
pub enum Failure {
    /// The scene cannot be parsed.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// The draft of a scene is none.
    #[error("{0}")]
    Draft(#[from] Mistake),
    /// The kernel refused the scene.
    #[error("{0}")]
    Model(#[from] ModelError),
    /// A run stopped.
    #[error("{0}")]
    Step(#[from] StepError),
    /// The kernel of contact dynamics refused a system.
    #[error("{0}")]
    Setup(#[from] rigid::SetupError),
    /// A run of contact dynamics stopped.
    #[error("{0}")]
    RigidStep(#[from] rigid::StepError),
    /// The kernel of peridynamic grains refused a grain or a setting.
    #[error("{0}")]
    Grain(#[from] deformable::SetupError),
    /// A run of peridynamic grains stopped.
    #[error("{0}")]
    GrainStep(#[from] deformable::StepError),
    /// A command failed.
    #[error("{0}")]
    Command(#[from] Error),
    /// An oracle has no solution.
    #[error("{0}")]
    Oracle(String),
}

/// The result of a check.
pub type Outcome = Result<Finding, Failure>;

#[cfg(test)]
mod tests {
    use super::{Measurement, largest};
    use approx::assert_abs_diff_eq;

    #[test]
    fn an_undefined_error_is_the_worst() {
        let fine = Measurement::absolute(1.0, 1.0, 0.0);
        let poor = Measurement::absolute(1.0, 2.0, 0.1);
        let lost = Measurement::absolute(1.0, f64::NAN, 1.0);
        assert!(Measurement::worst([fine, poor]) == poor);
        assert!(Measurement::worst([lost, poor, fine]).error.is_nan());
        assert!(fine.passes() && !poor.passes() && !lost.passes());
        assert!(!Measurement::worst([]).passes());
    }

    #[test]
    fn the_largest_of_sizes_forgets_no_undefined_one() {
        assert_eq!(largest([1.0, 3.0, 2.0]), 3.0);
        assert!(largest([1.0, f64::NAN, 2.0]).is_nan() && largest([f64::NAN]).is_nan());
    }

    #[test]
    fn digits_are_those_of_the_relative_error() {
        assert_eq!(Measurement::relative(2.0, 2.0, 0.0).digits(), 16.0);
        assert_abs_diff_eq!(
            Measurement::relative(1.0, 1.001, 0.0).digits(),
            3.0,
            epsilon = 1e-9
        );
        assert_eq!(Measurement::relative(1.0, f64::INFINITY, 0.0).digits(), 0.0);
    }
}
