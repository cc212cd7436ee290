//! The runs of a study as one table.

use crate::csv_table::csv_table;
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use std::collections::BTreeMap;
use std::path::Path;

/// A run and what was observed in it.
#[derive(Clone, Debug)]
pub struct Run {
    /// Name of the run.
    pub name: String,
    /// Part of the study.
    pub part: String,
    /// Cells by column.
    cells: BTreeMap<String, String>,
}

impl Run {
    /// A cell; empty if the run does not have it.
    pub fn text(&self, column: &str) -> &str {
        self.cells.get(column).map_or("", String::as_str)
    }
    /// A cell as a finite number.
    pub fn number(&self, column: &str) -> Option<f64> {
        let number = self.text(column).parse().ok();
        number.filter(|number: &f64| number.is_finite())
    }
    /// Law of friction.
    pub fn law(&self) -> &str {
        self.text("law")
    }
    /// Pressure in units of the normal strength.
    pub fn pressure(&self) -> f64 {
        self.number("pressure").unwrap_or(f64::NAN)
    }
    /// Seed of the packing.
    pub fn seed(&self) -> &str {
        self.text("setup.seed")
    }
    /// Whether the run finished, trusted or not.
    pub fn is_finished(&self) -> bool {
        matches!(self.text("status"), "done" | "untrusted")
    }
    /// Whether the run counts: all finished ones of the arm that computes as the thesis did, but only trusted ones of
    /// the others.
    pub fn counts(&self) -> bool {
        self.text("status") == "done" || (self.is_finished() && self.part.starts_with("thesis"))
    }
}

/// All runs of a study.
#[derive(Clone, Debug, Default)]
pub struct Results {
    columns: Vec<String>,
    runs: Vec<Run>,
}

impl Results {
    /// All runs.
    pub fn runs(&self) -> &[Run] {
        &self.runs
    }

    /// Runs of a part that count.
    pub fn of<'a>(&'a self, part: &'a str) -> impl Iterator<Item = &'a Run> + Clone {
        self.runs
            .iter()
            .filter(move |run| run.part == part && run.counts())
    }

    /// Add the table of a part.
    ///
    /// # Errors
    /// A table that cannot be read.
    pub fn add(&mut self, part: &str, path: &Path) -> Result<(), Error> {
        self.read(path, Some(part))
    }

    /// Add the joint table of an earlier study.
    ///
    /// # Errors
    /// A table that cannot be read.
    pub fn add_joint(&mut self, path: &Path) -> Result<(), Error> {
        self.read(path, None)
    }

    /// Add the rows of a table. A run that is there already is replaced unless the new row knows less of it.
    fn read(&mut self, path: &Path, part: Option<&str>) -> Result<(), Error> {
        let failed = |error: csv::Error| Error::file("read", path, std::io::Error::other(error));
        let mut reader = csv::Reader::from_path(path).map_err(failed)?;
        let header = reader.headers().map_err(failed)?.clone();
        for name in header.iter().filter(|name| !["part", "run"].contains(name)) {
            if !self.columns.iter().any(|column| column == name) {
                self.columns.push(name.to_owned());
            }
        }
        for row in reader.records() {
            let row = row.map_err(failed)?;
            let pairs = header.iter().zip(&row);
            let cells: BTreeMap<String, String> = pairs
                .map(|(name, cell)| (name.to_owned(), cell.to_owned()))
                .collect();
            let cell = |name: &str| cells.get(name).cloned().unwrap_or_default();
            let run = Run {
                name: cell("run"),
                part: part.map_or_else(|| cell("part"), str::to_owned),
                cells,
            };
            let known = self.runs.iter().position(|other| other.name == run.name);
            match known {
                None => self.runs.push(run),
                Some(place) if run.is_finished() => self.runs[place] = run,
                Some(_) => {}
            }
        }
        Ok(())
    }

    /// Write the joint table.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        let names = self.columns.iter().map(String::as_str);
        let header: Vec<&str> = ["part", "run"].into_iter().chain(names).collect();
        let rows = self.runs.iter().map(|run| {
            let cells = self.columns.iter().map(|name| run.text(name));
            let own = [run.part.as_str(), run.name.as_str()];
            own.into_iter().chain(cells).collect()
        });
        let bytes = csv_table(path, [header].into_iter().chain(rows))?;
        write_whole(path, &bytes)
    }
}
