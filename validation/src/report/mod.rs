//! The output of `gouge verify`: a page for people and a file for programs.

mod apart;
mod article;
mod date;
mod equations;
#[cfg(test)]
mod examples;
mod first_page;
mod fold;
mod judged;
mod machine;
mod original;
mod outside;
mod page;
mod pictures;
mod record;
mod sources;
mod speed;

pub use machine::words as machine_words;
pub use pictures::{Picture, pictures};
pub use record::Record;

use crate::checks::{Exhibit, Topic};
use first_page::Facts;
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
    date: &'a str,
    commit: &'static str,
    machine: &'a str,
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

/// Largest size of a self-contained page in bytes.
const LARGEST_PAGE: usize = 5_000_000;

/// Writes `report.json` and `report.html`.
///
/// # Errors
/// Failures of the file system; a self-contained page that is larger than 5 MB, after it was written.
pub fn write(
    folder: &Path,
    topics: &[Topic],
    entries: &[Entry],
    pictures: &[Picture],
    figures: Figures,
) -> Result<(), Error> {
    let facts = Facts {
        date: date::today(),
        commit: gouge_runner::build::COMMIT,
        machine: machine::words(),
        instructions: gouge_runner::machine::chosen()?.instructions.name(),
        is_complete: entries.len() == topics.iter().map(|topic| topic.checks.len()).sum::<usize>(),
    };
    let report = Report {
        version: env!("CARGO_PKG_VERSION"),
        date: &facts.date,
        commit: facts.commit,
        machine: &facts.machine,
        checks: entries.iter().map(|entry| &entry.record).collect(),
    };
    let path = folder.join("report.json");
    let text = serde_json::to_string_pretty(&report)
        .map_err(|error| Error::file("write", &path, std::io::Error::other(error)))?;
    write_whole(&path, (text + "\n").as_bytes())?;
    let page = page::page(topics, entries, pictures, &facts).into_string();
    match figures {
        Figures::Inside => write_inside(folder, &page),
        Figures::Apart => write_apart(folder, &page),
    }
}

fn write_inside(folder: &Path, page: &str) -> Result<(), Error> {
    let path = folder.join("report.html");
    write_whole(&path, page.as_bytes())?;
    if page.len() > LARGEST_PAGE {
        let size = format!(
            "it has {} bytes; a page has at most {LARGEST_PAGE}",
            page.len()
        );
        return Err(Error::file("accept", &path, std::io::Error::other(size)));
    }
    Ok(())
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
