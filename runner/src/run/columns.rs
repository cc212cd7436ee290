//! The columns of a series, read back from its file.

use gouge_page::Curve;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Columns of a series by name.
#[derive(Default)]
pub struct Columns {
    names: Vec<String>,
    values: Vec<Vec<f64>>,
}

impl Columns {
    /// Read a series; one that is missing or damaged has no columns.
    pub fn read(path: &Path) -> Self {
        File::open(path).map_or_else(|_| Self::default(), Self::of)
    }

    /// The columns of a series until its first damaged row.
    pub fn of(series: impl Read) -> Self {
        let mut reader = csv::Reader::from_reader(series);
        let names: Vec<String> = match reader.headers() {
            Ok(header) => header.iter().map(str::to_owned).collect(),
            Err(_) => return Self::default(),
        };
        let mut values = vec![Vec::new(); names.len()];
        for row in reader.records().map_while(Result::ok) {
            for (column, cell) in values.iter_mut().zip(&row) {
                column.push(cell.parse().unwrap_or(f64::NAN));
            }
        }
        Self { names, values }
    }

    /// The values of a column.
    pub fn get(&self, name: &str) -> Option<&[f64]> {
        let place = self.names.iter().position(|own| own == name)?;
        Some(&self.values[place])
    }

    /// A column over another one.
    pub fn curve(&self, label: &str, [x, y]: [&str; 2]) -> Option<Curve> {
        let points = self.get(x)?.iter().zip(self.get(y)?);
        Some(Curve::line(label, points.map(|(&x, &y)| [x, y])))
    }
}
