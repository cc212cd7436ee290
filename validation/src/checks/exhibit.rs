//! Figures and tables that a check shows in the report.

/// Something that the report shows.
#[derive(Clone, Debug)]
pub enum Exhibit {
    /// A figure.
    Plot(Plot),
    /// A table.
    Table(Table),
    /// A paragraph of plain text.
    Text(String),
}

/// A figure with two axes.
#[derive(Clone, Debug)]
pub struct Plot {
    /// The statement of the figure, a sentence.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// The curves; later ones are drawn over earlier ones.
    pub curves: Vec<Curve>,
}

/// An axis; its range is that of the data.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Quantity and unit.
    pub label: String,
    /// Whether the scale is logarithmic; points that are not positive are then left out.
    pub logarithmic: bool,
}

impl Axis {
    /// An axis with a linear scale.
    pub fn linear(label: &str) -> Self {
        Self {
            label: label.to_owned(),
            logarithmic: false,
        }
    }
    /// An axis with a logarithmic scale.
    pub fn logarithmic(label: &str) -> Self {
        Self {
            label: label.to_owned(),
            logarithmic: true,
        }
    }
}

/// Points that are drawn in the same way.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Name in the legend.
    pub label: String,
    /// How they are drawn.
    pub style: Style,
    /// The points.
    pub points: Vec<[f64; 2]>,
}

impl Curve {
    /// A line through points: theory, or data of others.
    pub fn line(label: &str, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(label, Style::Line, points)
    }
    /// Marks at points: results of the kernel.
    pub fn marks(label: &str, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(label, Style::Marks, points)
    }
    /// Marks joined by a line.
    pub fn marked_line(label: &str, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(label, Style::MarkedLine, points)
    }
    fn new(label: &str, style: Style, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self {
            label: label.to_owned(),
            style,
            points: points.into_iter().collect(),
        }
    }
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// A line without marks.
    Line,
    /// A dashed line without marks: a bound, a slope or a fit.
    Dashed,
    /// Marks without a line.
    Marks,
    /// Marks joined by a line.
    MarkedLine,
    /// Small squares side by side, for maps.
    Cells,
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
