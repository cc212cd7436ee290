//! What `gouge verify` leaves: one page for people, one file for programs.

use crate::checks::{Check, Measurement, Origin, Outcome};
use crate::error::Error;
use crate::run::write_whole;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use serde::Serialize;
use std::path::Path;

/// A check with what it found.
#[derive(Clone, Debug, Serialize)]
pub struct Record {
    /// Identifier.
    pub id: &'static str,
    /// The claim.
    pub claim: &'static str,
    /// Equations of the thesis.
    pub equations: &'static str,
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
    /// Correct digits.
    pub digits: f64,
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
            equations: check.equations,
            status: if found.passes() { "pass" } else { "fail" },
            expected: found.expected,
            measured: found.measured,
            error: found.error,
            tolerance: found.tolerance,
            tolerance_origin: check.origin,
            digits: found.digits(),
            seconds,
        }
    }

    /// One line for a terminal.
    pub fn line(&self) -> String {
        format!(
            "{:4}  {:28} error {:9.2e}  tolerance {:9.2e}  {:6.2} s  {}",
            self.status, self.id, self.error, self.tolerance, self.seconds, self.claim
        )
    }
}

#[derive(Serialize)]
struct Report<'a> {
    version: &'static str,
    machine: String,
    checks: &'a [Record],
}

/// The machine, in words.
fn machine() -> String {
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    format!(
        "{} {}, {threads} threads",
        std::env::consts::ARCH,
        std::env::consts::OS
    )
}

/// Write `report.json` and `report.html`.
///
/// # Errors
/// Failures of the file system.
pub fn write(folder: &Path, records: &[Record]) -> Result<(), Error> {
    let report = Report {
        version: env!("CARGO_PKG_VERSION"),
        machine: machine(),
        checks: records,
    };
    let path = folder.join("report.json");
    let text = serde_json::to_string_pretty(&report)
        .map_err(|error| Error::file("write", &path, std::io::Error::other(error)))?;
    write_whole(&path, (text + "\n").as_bytes())?;
    write_whole(
        &folder.join("report.html"),
        page(records).into_string().as_bytes(),
    )
}

const STYLE: &str = "body{font:16px/1.5 system-ui,sans-serif;margin:2rem auto;max-width:70rem;padding:0 1rem}\
    table{border-collapse:collapse;width:100%}th,td{text-align:left;padding:.4rem .6rem;\
    border-bottom:1px solid #ddd;vertical-align:top}td.n{font-variant-numeric:tabular-nums;white-space:nowrap}\
    .pass{color:#176b2c}.fail{color:#b00020;font-weight:bold}";

fn page(records: &[Record]) -> Markup {
    let failed = records
        .iter()
        .filter(|record| record.status == "fail")
        .count();
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width";
                title { "gouge: verification report" }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { "gouge: verification report" }
                p {
                    "Version " (env!("CARGO_PKG_VERSION")) ", " (machine()) ". "
                    (records.len() - failed) " of " (records.len()) " checks pass."
                }
                table {
                    tr {
                        @for name in ["check", "claim", "equations", "expected", "measured", "error", "tolerance", "origin", "digits"] {
                            th { (name) }
                        }
                    }
                    @for record in records { (row(record)) }
                }
            }
        }
    }
}

fn row(record: &Record) -> Markup {
    html! {
        tr {
            td class=(record.status) { (record.id) ": " (record.status) }
            td { (record.claim) }
            td { (record.equations) }
            td.n { (format!("{:.9e}", record.expected)) }
            td.n { (format!("{:.9e}", record.measured)) }
            td.n { (format!("{:.2e}", record.error)) }
            td.n { (format!("{:.2e}", record.tolerance)) }
            td { (format!("{:?}", record.tolerance_origin).to_lowercase()) }
            td.n { (format!("{:.1}", record.digits)) }
        }
    }
}
