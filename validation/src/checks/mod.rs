//! The register of checks: a claim, how it is measured, and why the tolerance is what it is.
//!
//! The gate (`cargo test`) and the report (`gouge verify`) run the same register.

pub mod dem;
mod evidence;
mod exhibit;
mod extrapolation;
mod measurement;
mod random;

pub use evidence::{Citation, Evidence, Source, thesis};
pub use exhibit::{Axis, Curve, Exhibit, Plot, Style, Table};
pub use measurement::{
    Failure, Finding, Measurement, Origin, Outcome, largest, unit_in_last_place,
};

/// How long a check takes, and so who runs it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effort {
    /// Below about 0.2 s: run by the gate and against deliberate faults.
    Quick,
    /// A few seconds: run by the gate.
    Thorough,
    /// Longer, or a measurement of time: run for the report only.
    Report,
}

/// A check, before it is run.
pub struct Check {
    /// Identifier: topic, point, name.
    pub id: &'static str,
    /// The claim, one sentence.
    pub claim: &'static str,
    /// Equations, errata, sections and figures that it stands for.
    pub equations: Evidence,
    /// What is run.
    pub scene: &'static str,
    /// What it is compared with.
    pub oracle: &'static str,
    /// What is called the error.
    pub norm: &'static str,
    /// Where the tolerance comes from.
    pub origin: Origin,
    /// Why the tolerance is what it is.
    pub reason: &'static str,
    /// How long it takes.
    pub effort: Effort,
    /// The measurement.
    pub measure: fn() -> Outcome,
}

/// A chapter of the report: checks of one subject.
pub struct Topic {
    /// Identifier, with which the identifiers of its checks begin.
    pub id: &'static str,
    /// Heading.
    pub title: &'static str,
    /// What the chapter is about, in one or two sentences.
    pub about: &'static str,
    /// Its checks.
    pub checks: Vec<Check>,
}

/// All topics, in the order of the report.
pub fn register() -> Vec<Topic> {
    dem::topics()
}
