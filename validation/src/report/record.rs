//! A check with what it found, as `report.json` holds it.

use crate::checks::{Check, Evidence, Measurement, Origin, Outcome};
use serde::Serialize;

/// A check with what it found.
#[derive(Clone, Debug, Serialize)]
pub struct Record {
    /// Identifier.
    pub id: &'static str,
    /// The claim.
    pub claim: &'static str,
    /// What the check stands for, each with its source.
    pub equations: Evidence,
    /// What was run.
    pub scene: &'static str,
    /// What it was compared with.
    pub oracle: &'static str,
    /// What is called the error.
    pub norm: &'static str,
    /// `pass` or `fail`.
    pub status: &'static str,
    /// What should come out.
    pub expected: f64,
    /// What came out.
    pub measured: f64,
    /// Their distance.
    pub error: f64,
    /// The largest distance that passes.
    pub tolerance: f64,
    /// Where the tolerance comes from.
    pub tolerance_origin: Origin,
    /// Why the tolerance is what it is.
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

    /// One line for a terminal.
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
