//! The output of `gouge verify`: a page for people and a file for programs.

mod apart;
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

/// A check that was run: its record and its exhibits.
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

/// Where the figures of the page are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figures {
    /// In the page, which then needs no other file.
    Inside,
    /// Large ones in a folder `figures` next to the page.
    Apart,
}

/// Writes `report.json` and `report.html`.
///
/// # Errors
/// Failures of the file system.
pub fn write(
    folder: &Path,
    topics: &[Topic],
    entries: &[Entry],
    pictures: &[Picture],
    figures: Figures,
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
    match figures {
        Figures::Inside => write_whole(&folder.join("report.html"), page.as_bytes()),
        Figures::Apart => write_apart(folder, &page),
    }
}

fn write_apart(folder: &Path, page: &str) -> Result<(), Error> {
    let split = apart::split(page);
    let place = folder.join("figures");
    std::fs::create_dir_all(&place).map_err(|error| Error::file("create", &place, error))?;
    for (name, text) in &split.figures {
        write_whole(&place.join(name), text.as_bytes())?;
    }
    write_whole(&folder.join("report.html"), split.page.as_bytes())
}
