//! The runs of a study as one table.

use crate::csv_table::{CsvFile, csv_table};
use crate::sweep::{COST, RUN, STATE, Status, Sweep};
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use std::collections::{BTreeMap, BTreeSet};
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
        matches!(self.text(STATUS), "done" | "untrusted")
    }
    /// Whether the run counts: all finished ones of the arm that computes as the thesis did, but only trusted ones of
    /// the others.
    pub fn counts(&self) -> bool {
        self.text(STATUS) == "done" || (self.is_finished() && self.part.starts_with("thesis"))
    }
}

/// Column of the part of a study.
const PART: &str = "part";
/// Column of how a run ended.
const STATUS: &str = STATE[0];

/// What the columns of a table of runs must be.
#[derive(Clone, Debug, Default)]
pub struct Columns {
    /// Columns that must be there, besides those of all tables.
    needed: BTreeSet<String>,
    /// Columns that hold numbers, besides those of all tables.
    numbers: BTreeSet<String>,
}

impl Columns {
    /// Those of some sweeps: the axes that all have are needed, and observations are numbers.
    pub fn of<'a>(sweeps: impl Iterator<Item = &'a Sweep>) -> Self {
        let (mut needed, mut numbers) = (None, BTreeSet::new());
        for sweep in sweeps {
            let axes: BTreeSet<String> = sweep.all_axes().map(|axis| axis.name.clone()).collect();
            needed = Some(match needed {
                None => axes,
                Some(others) => &axes & &others,
            });
            let observed = sweep.observations.iter();
            numbers.extend(observed.map(|one| one.get_ref().name()));
        }
        let needed = needed.unwrap_or_default();
        Self { needed, numbers }
    }

    /// Whether a cell can be in a column; what is accepted otherwise. Numbers may be missing.
    fn check(&self, column: &str, cell: &str) -> Result<(), String> {
        let is_number = COST.contains(&column) || self.numbers.contains(column);
        let is_cell = match column {
            PART | RUN => !cell.is_empty(),
            STATUS => Status::named(cell).is_some(),
            _ => !is_number || cell.is_empty() || cell.parse::<f64>().is_ok(),
        };
        match (is_cell, column) {
            (true, _) => Ok(()),
            (false, PART | RUN) => Err("must not be empty".to_owned()),
            (false, STATUS) => {
                let names = Status::ALL.map(Status::name).join(", ");
                Err(format!("must be one of {names}"))
            }
            (false, _) => Err("must be a number or empty".to_owned()),
        }
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
    /// A table that cannot be read or is not one of runs: file, line, column and cell.
    pub fn add(&mut self, part: &str, path: &Path, columns: &Columns) -> Result<(), Error> {
        self.read(path, Some(part), columns)
    }

    /// Add the joint table of an earlier study.
    ///
    /// # Errors
    /// As for [`Results::add`].
    pub fn add_joint(&mut self, path: &Path, columns: &Columns) -> Result<(), Error> {
        self.read(path, None, columns)
    }

    /// Add the rows of a table. A run that is there already is replaced unless the new row knows less of it.
    fn read(&mut self, path: &Path, part: Option<&str>, columns: &Columns) -> Result<(), Error> {
        let table = CsvFile::read(path)?;
        let header = &table.header;
        let own = part.is_none().then_some(PART);
        let needed = columns.needed.iter().map(String::as_str);
        table.check_header([RUN].into_iter().chain(own).chain([STATUS]).chain(needed))?;
        for name in header
            .iter()
            .filter(|name| ![PART, RUN].contains(&name.as_str()))
        {
            if !self.columns.iter().any(|column| column == name) {
                self.columns.push(name.to_owned());
            }
        }
        for (line, row) in &table.rows {
            for (name, cell) in header.iter().zip(row) {
                let checked = columns.check(name, cell);
                checked.map_err(|accepted| table.error(*line, name, cell, &accepted))?;
            }
            let pairs = header.iter().zip(row);
            let cells: BTreeMap<String, String> = pairs
                .map(|(name, cell)| (name.to_owned(), cell.to_owned()))
                .collect();
            let cell = |name: &str| cells.get(name).cloned().unwrap_or_default();
            let run = Run {
                name: cell(RUN),
                part: part.map_or_else(|| cell(PART), str::to_owned),
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
        let header: Vec<&str> = [PART, RUN].into_iter().chain(names).collect();
        let rows = self.runs.iter().map(|run| {
            let cells = self.columns.iter().map(|name| run.text(name));
            let own = [run.part.as_str(), run.name.as_str()];
            own.into_iter().chain(cells).collect()
        });
        let bytes = csv_table(path, [header].into_iter().chain(rows))?;
        write_whole(path, &bytes)
    }
}
