//! Named columns: the particle data that a model writes, as plain data.

use std::fmt::Write;

/// A table; all columns have the same number of rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The columns.
    pub columns: Vec<Column>,
}

/// A column: its name and its values.
pub type Column = (&'static str, Values);

/// The values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Numbers in SI units.
    Numbers(Vec<f64>),
    /// Counts and labels.
    Integers(Vec<usize>),
    /// Named categories, such as roles.
    Kinds(Kinds),
}

/// One category per row.
#[derive(Clone, Debug, PartialEq)]
pub struct Kinds {
    /// Names of all categories.
    pub names: Vec<&'static str>,
    /// For each row, the position of its category in `names`.
    pub codes: Vec<usize>,
}

impl Values {
    /// Number of rows.
    pub fn rows(&self) -> usize {
        match self {
            Self::Numbers(numbers) => numbers.len(),
            Self::Integers(integers) => integers.len(),
            Self::Kinds(kinds) => kinds.codes.len(),
        }
    }

    /// Append a value as text; reading it back gives the same bits.
    pub fn print(&self, row: usize, text: &mut String) {
        let _ = match self {
            Self::Numbers(numbers) => write!(text, "{:?}", numbers[row]),
            Self::Integers(integers) => write!(text, "{}", integers[row]),
            Self::Kinds(kinds) => write!(text, "{}", kinds.names[kinds.codes[row]]),
        };
    }
}

impl Table {
    /// The table as CSV, with a header.
    pub fn to_csv(&self) -> String {
        let names: Vec<&str> = self.columns.iter().map(|(name, _)| *name).collect();
        let mut text = names.join(",") + "\n";
        let rows = self.columns.first().map_or(0, |(_, values)| values.rows());
        for row in 0..rows {
            for (place, (_, values)) in self.columns.iter().enumerate() {
                if place > 0 {
                    text.push(',');
                }
                values.print(row, &mut text);
            }
            text.push('\n');
        }
        text
    }
}
