//! Figures and tables that a check shows in the report.

use gouge_page::Figure;

/// Something that the report shows.
#[derive(Clone, Debug)]
pub enum Exhibit {
    /// A figure.
    Figure(Figure),
    /// A table.
    Table(Table),
    /// A paragraph of plain text.
    Text(String),
}

/// A table.
#[derive(Clone, Debug)]
pub struct Table {
    /// The statement of the table, a sentence.
    pub title: String,
    /// Names of the columns, with units.
    pub columns: Vec<String>,
    /// Rows, each with one cell per column.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    pub fn new(title: &str, columns: &[&str]) -> Self {
        Self {
            title: title.to_owned(),
            columns: columns.iter().map(|&name| name.to_owned()).collect(),
            rows: Vec::new(),
        }
    }
    /// Appends a row.
    pub fn push<S: Into<String>>(&mut self, cells: impl IntoIterator<Item = S>) {
        self.rows.push(cells.into_iter().map(Into::into).collect());
    }
}
