//! What an engine computed, as `references/regenerate` writes it.

use serde::Deserialize;
use std::collections::BTreeMap;

/// The result of a case, with where it comes from.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recorded {
    /// The program.
    pub engine: String,
    /// Its version.
    pub version: String,
    /// Packages that brought it.
    pub packages: Vec<String>,
    /// Architecture of the machine that it ran on.
    pub architecture: String,
    /// Units of all numbers.
    pub units: String,
    /// Day on which it ran.
    pub date: String,
    /// SHA-256 of everything that it was given, by path.
    pub inputs: BTreeMap<String, String>,
    /// The runs, as `case.toml` lists them.
    pub runs: Vec<RecordedRun>,
}

/// What one run gave.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RecordedRun {
    /// Name of the run.
    pub name: String,
    /// The command.
    pub command: String,
    /// Particles at some steps: a row a particle and step.
    pub motion: Option<Table>,
    /// Numbers of the whole at some steps: a row a step.
    pub series: Option<Table>,
}

/// A step and the rows that belong to it.
pub type Moment<'a> = (u64, &'a [Vec<f64>]);

/// A table of numbers.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Names of the columns.
    pub columns: Vec<String>,
    /// Rows of as many numbers.
    pub rows: Vec<Vec<f64>>,
}

impl Table {
    /// Position of a column.
    ///
    /// # Errors
    /// There is none.
    pub fn column(&self, name: &str) -> Result<usize, String> {
        let found = self.columns.iter().position(|column| column == name);
        found.ok_or_else(|| format!("the result has no column {name}"))
    }

    /// Positions of several columns.
    ///
    /// # Errors
    /// One of them is not there.
    pub fn places<const N: usize>(&self, names: [&str; N]) -> Result<[usize; N], String> {
        let mut places = [0; N];
        for (place, name) in places.iter_mut().zip(names) {
            *place = self.column(name)?;
        }
        Ok(places)
    }

    /// Rows that belong together, one step after the other.
    ///
    /// # Errors
    /// There is no column `step`.
    pub fn steps(&self) -> Result<Vec<Moment<'_>>, String> {
        let place = self.column("step")?;
        let same = |a: &Vec<f64>, b: &Vec<f64>| a.get(place) == b.get(place);
        let step = |rows: &[Vec<f64>]| rows[0].get(place).map_or(0, |&step| step as u64);
        Ok(self
            .rows
            .chunk_by(same)
            .map(|rows| (step(rows), rows))
            .collect())
    }
}
