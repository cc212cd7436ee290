//! What `gouge verify` leaves: one page for people, one file for programs.

mod machine;
mod original;
mod page;
mod pictures;
mod plot;
mod record;
mod speed;

pub use machine::words as machine_words;
pub use pictures::{Picture, pictures};
pub use record::Record;

use crate::checks::{Exhibit, Topic};
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use serde::Serialize;
use std::path::Path;

/// A check that was run: its record, and what it shows.
pub struct Entry {
    /// The record.
    pub record: Record,
    /// Figures and tables.
    pub exhibits: Vec<Exhibit>,
}

#[derive(Serialize)]
struct Report<'a> {
    version: &'static str,
    machine: String,
    checks: Vec<&'a Record>,
}

/// Write `report.json` and `report.html`.
///
/// # Errors
/// Failures of the file system.
pub fn write(
    folder: &Path,
    topics: &[Topic],
    entries: &[Entry],
    pictures: &[Picture],
) -> Result<(), Error> {
    let report = Report {
        version: env!("CARGO_PKG_VERSION"),
        machine: machine::words(),
        checks: entries.iter().map(|entry| &entry.record).collect(),
    };
    let path = folder.join("report.json");
    let text = serde_json::to_string_pretty(&report)
        .map_err(|error| Error::file("write", &path, std::io::Error::other(error)))?;
    write_whole(&path, (text + "\n").as_bytes())?;
    let page = page::page(topics, entries, pictures, &report.machine).into_string();
    write_whole(&folder.join("report.html"), page.as_bytes())
}
