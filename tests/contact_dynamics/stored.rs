//! Files of `references/`.

use serde_json::Value;
use std::path::Path;

/// A JSON file in a folder of `references/`.
pub fn read(path: &str) -> Value {
    serde_json::from_str(&text(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The text of a file in a folder of `references/`.
pub fn text(path: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../references");
    std::fs::read_to_string(folder.join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// A number of an object.
pub fn number(object: &Value, key: &str) -> f64 {
    let number = object[key].as_f64();
    number.unwrap_or_else(|| panic!("{key} is not a number"))
}

/// A table with named columns.
pub struct Table<'a> {
    columns: Vec<&'a str>,
    rows: &'a [Value],
}

impl<'a> Table<'a> {
    /// A table of a JSON file.
    pub fn new(value: &'a Value) -> Self {
        let columns = value["columns"].as_array().unwrap();
        Self {
            columns: columns.iter().map(|name| name.as_str().unwrap()).collect(),
            rows: value["rows"].as_array().unwrap(),
        }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// A text of the table.
    pub fn text(&self, row: usize, column: &str) -> &'a str {
        self.value(row, column).as_str().unwrap()
    }

    /// A number of the table.
    pub fn cell(&self, row: usize, column: &str) -> f64 {
        self.value(row, column).as_f64().unwrap()
    }

    fn value(&self, row: usize, column: &str) -> &'a Value {
        let place = self.columns.iter().position(|name| *name == column);
        &self.rows[row][place.unwrap_or_else(|| panic!("there is no column {column}"))]
    }
}
