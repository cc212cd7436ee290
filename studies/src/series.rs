//! Series of finished runs.

use std::path::Path;

/// The columns of `series.csv`.
#[derive(Clone, Debug)]
pub struct Series {
    columns: Vec<(String, Vec<f64>)>,
}

impl Series {
    /// The series of the run in a folder; none if there is no readable one.
    pub fn read(folder: &Path) -> Option<Self> {
        let mut reader = csv::Reader::from_path(folder.join("series.csv")).ok()?;
        let names = reader.headers().ok()?.clone();
        let mut columns: Vec<(String, Vec<f64>)> = names
            .iter()
            .map(|name| (name.to_owned(), Vec::new()))
            .collect();
        for row in reader.records() {
            let row = row.ok()?;
            for ((_, values), cell) in columns.iter_mut().zip(&row) {
                values.push(cell.parse().ok()?);
            }
        }
        let is_empty = columns.first().is_none_or(|(_, values)| values.is_empty());
        (!is_empty).then_some(Self { columns })
    }

    /// A column; none if the run does not have it.
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let found = self.columns.iter().find(|(column, _)| column == name);
        found.map(|(_, values)| values.as_slice())
    }

    /// A column from a time in s on; none if nothing is left of it.
    pub fn column_after(&self, name: &str, time: f64) -> Option<&[f64]> {
        let from = self.column("time")?.iter().position(|&one| one >= time)?;
        Some(&self.column(name)?[from..])
    }
}
