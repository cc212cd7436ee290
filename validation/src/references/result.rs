//! The result of an engine, as `references/regenerate` writes it.

use serde::Deserialize;
use std::collections::BTreeMap;

/// The result of a case, with its origin.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recorded {
    /// The program.
    pub engine: String,
    /// Its version.
    pub version: String,
    /// Packages from which the engine was installed.
    pub packages: Vec<String>,
    /// Architecture of the machine on which it ran.
    pub architecture: String,
    /// Units of all numbers.
    pub units: String,
    /// Date of the run.
    pub date: String,
    /// SHA-256 of all its inputs, by path.
    pub inputs: BTreeMap<String, String>,
    /// The runs, as `case.toml` lists them.
    pub runs: Vec<RecordedRun>,
}

impl Recorded {
    /// Inputs whose SHA-256 is not that with which the engine was given them.
    pub(super) fn changed_inputs(&self, hashes: &BTreeMap<String, String>) -> Vec<&str> {
        let is_other = |(path, hash): &(&String, &String)| hashes.get(*path) != Some(*hash);
        let others = self.inputs.iter().filter(is_other);
        others.map(|(path, _)| path.as_str()).collect()
    }
}

/// The result of one run.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RecordedRun {
    /// Name of the run.
    pub name: String,
    /// The command.
    pub command: String,
    /// Particles at some steps: one row per particle and step.
    pub motion: Option<Table>,
    /// Quantities of the whole system at some steps: one row per step.
    pub series: Option<Table>,
}

/// A step and its rows.
pub type Moment<'a> = (u64, &'a [Vec<f64>]);

/// A table of numbers.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Names of the columns.
    pub columns: Vec<String>,
    /// Rows, each with one number per column.
    pub rows: Vec<Vec<f64>>,
}

impl Table {
    /// Position of a column.
    ///
    /// # Errors
    /// The column is missing.
    pub fn column(&self, name: &str) -> Result<usize, String> {
        let found = self.columns.iter().position(|column| column == name);
        found.ok_or_else(|| format!("the result has no column {name}"))
    }

    /// Positions of several columns.
    ///
    /// # Errors
    /// One of the columns is missing.
    pub fn places<const N: usize>(&self, names: [&str; N]) -> Result<[usize; N], String> {
        let mut places = [0; N];
        for (place, name) in places.iter_mut().zip(names) {
            *place = self.column(name)?;
        }
        Ok(places)
    }

    /// The rows of each step, one step after the other.
    ///
    /// # Errors
    /// The column `step` is missing.
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
