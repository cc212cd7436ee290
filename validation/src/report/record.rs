//! A check with its result, as stored in `report.json`.

use crate::checks::{Check, Evidence, Measurement, Origin, Outcome};
use serde::Serialize;

/// A check with its result.
#[derive(Clone, Debug, Serialize)]
pub struct Record {
    /// Identifier.
    pub id: &'static str,
    /// The claim.
    pub claim: &'static str,
    /// The citations that the check covers.
    pub equations: Evidence,
    /// The scene that was run.
    pub scene: &'static str,
    /// The oracle.
    pub oracle: &'static str,
    /// Definition of the error.
    pub norm: &'static str,
    /// `pass` or `fail`.
    pub status: &'static str,
    /// The expected value.
    pub expected: f64,
    /// The measured value.
    pub measured: f64,
    /// The error.
    pub error: f64,
    /// The largest error that passes.
    pub tolerance: f64,
    /// The origin of the tolerance.
    pub tolerance_origin: Origin,
    /// The reason for the tolerance.
    pub tolerance_reason: &'static str,
    /// Correct digits.
    pub digits: f64,
    /// Why there is no measurement.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
    /// Wall time in s.
    pub seconds: f64,
}

impl Record {
    /// The record of an outcome.
    pub fn new(check: &Check, outcome: &Outcome, seconds: f64) -> Self {
        let nothing = Measurement::absolute(f64::NAN, f64::NAN, 0.0);
        let found = outcome
            .as_ref()
            .map_or(nothing, |finding| finding.measurement);
        Self {
            id: check.id,
            claim: check.claim,
            equations: check.equations.clone(),
            scene: check.scene,
            oracle: check.oracle,
            norm: check.norm,
            status: if found.passes() { "pass" } else { "fail" },
            expected: found.expected,
            measured: found.measured,
            error: found.error,
            tolerance: found.tolerance,
            tolerance_origin: check.origin,
            tolerance_reason: check.reason,
            digits: found.digits(),
            failure: outcome.as_ref().err().map(ToString::to_string),
            seconds,
        }
    }

    /// Whether the check passed.
    pub fn passed(&self) -> bool {
        self.status == "pass"
    }

    /// One line for the terminal.
    pub fn line(&self) -> String {
        let reason = self
            .failure
            .as_deref()
            .map_or(String::new(), |why| format!(" ({why})"));
        format!(
            "{:4}  {:40} error {:9.2e}  tolerance {:9.2e}  {:6.2} s  {}{reason}",
            self.status, self.id, self.error, self.tolerance, self.seconds, self.claim
        )
    }
}
