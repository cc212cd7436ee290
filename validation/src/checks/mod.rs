//! The register of checks: a claim, how it is measured, and why the tolerance is what it is.
//!
//! The gate (`cargo test`) and the report (`gouge verify`) run the same register.

pub mod contact_dynamics;
pub mod dem;
mod evidence;
mod exhibit;
mod extrapolation;
mod measurement;
pub mod peridem;
mod random;

pub use evidence::{Citation, Evidence, Source, azema, peridem, thesis};
pub use exhibit::{Exhibit, Table};
pub use gouge_page::{Axis, Curve, Figure, Style};
pub use measurement::{
    Failure, Finding, Measurement, Origin, Outcome, largest, unit_in_last_place,
};

/// The run time of a check, which decides who runs it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effort {
    /// Less than about 0.2 s: run by the gate and in mutation tests.
    Quick,
    /// A few seconds: run by the gate.
    Thorough,
    /// Longer, or a measurement of time: run only for the report.
    Report,
}

/// A check.
pub struct Check {
    /// Identifier: topic and name, with dots in between.
    pub id: &'static str,
    /// The claim.
    pub claim: &'static str,
    /// The equations, errata, sections and figures that it covers.
    pub equations: Evidence,
    /// The scene that is run.
    pub scene: &'static str,
    /// The oracle that the result is compared with.
    pub oracle: &'static str,
    /// Definition of the error.
    pub norm: &'static str,
    /// The origin of the tolerance.
    pub origin: Origin,
    /// The reason for the tolerance.
    pub reason: &'static str,
    /// The run time.
    pub effort: Effort,
    /// The measurement.
    pub measure: fn() -> Outcome,
}

/// A chapter of the report: the checks of one subject.
pub struct Topic {
    /// Identifier; the identifiers of its checks begin with it.
    pub id: &'static str,
    /// Heading.
    pub title: &'static str,
    /// Its subject, in one or two sentences.
    pub about: &'static str,
    /// Its checks.
    pub checks: Vec<Check>,
}

/// All topics, in the order of the report.
pub fn register() -> Vec<Topic> {
    let mut topics = dem::topics();
    topics.push(contact_dynamics::topic());
    topics.push(peridem::topic());
    topics
}
