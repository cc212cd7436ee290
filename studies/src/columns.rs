//! Columns of the CSV files that runs leave.

use std::path::Path;

/// The columns of a CSV file that hold numbers.
#[derive(Clone, Debug)]
pub struct Columns {
    columns: Vec<(String, Vec<f64>)>,
}

impl Columns {
    /// The series of the run in a folder; none if there is no readable one.
    pub fn of_series(folder: &Path) -> Option<Self> {
        Self::read(&folder.join("series.csv"))
    }

    /// The columns of a file; none if it cannot be read or has no rows.
    pub fn read(path: &Path) -> Option<Self> {
        let mut reader = csv::Reader::from_path(path).ok()?;
        let names = reader.headers().ok()?.clone();
        let mut columns: Vec<(String, Option<Vec<f64>>)> = names
            .iter()
            .map(|name| (name.to_owned(), Some(Vec::new())))
            .collect();
        let mut rows = 0;
        for row in reader.records() {
            rows += 1;
            for ((_, values), cell) in columns.iter_mut().zip(&row.ok()?) {
                *values = values.take().and_then(|mut values| {
                    values.push(cell.parse().ok()?);
                    Some(values)
                });
            }
        }
        let numeric = columns
            .into_iter()
            .filter_map(|(name, values)| Some((name, values?)));
        (rows > 0).then(|| Self {
            columns: numeric.collect(),
        })
    }

    /// A column; none if the file does not have it, or not everything in it is a number.
    pub fn get(&self, name: &str) -> Option<&[f64]> {
        let found = self.columns.iter().find(|(column, _)| column == name);
        found.map(|(_, values)| values.as_slice())
    }

    /// A column from a time in s on; none if nothing is left of it.
    pub fn after(&self, name: &str, time: f64) -> Option<&[f64]> {
        let from = self.get("time")?.iter().position(|&one| one >= time)?;
        Some(&self.get(name)?[from..])
    }
}
