//! What a figure shows.

/// Points that are drawn in the same way.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Name in the legend.
    pub label: String,
    /// How they are drawn.
    pub style: Style,
    /// The points.
    pub points: Vec<[f64; 2]>,
    /// Lower and upper end of an interval per point, e.g. of a confidence interval: bars at marks, a
    /// band along lines. Empty if there are none.
    pub intervals: Vec<[f64; 2]>,
}

impl Curve {
    /// Points in a style.
    pub fn new(label: &str, style: Style, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self {
            label: label.to_owned(),
            style,
            points: points.into_iter().collect(),
            intervals: Vec::new(),
        }
    }

    /// A line through points.
    pub fn line(label: &str, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(label, Style::Line, points)
    }

    /// A thin dashed line through points: a bound, a slope or a fit.
    pub fn dashed(label: &str, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(label, Style::Dashed, points)
    }

    /// Marks at points.
    pub fn marks(label: &str, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(label, Style::Marks, points)
    }

    /// Marks joined by a line.
    pub fn marked_line(label: &str, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new(label, Style::MarkedLine, points)
    }

    /// A histogram: `heights[k]` between `edges[k]` and `edges[k + 1]`.
    pub fn histogram(label: &str, edges: &[f64], heights: &[f64]) -> Self {
        let last = heights.last();
        let heights = heights.iter().chain(last);
        let points = edges.iter().zip(heights).map(|(&x, &y)| [x, y]);
        Self::new(label, Style::Steps, points)
    }

    /// With the ends of an interval per point.
    #[must_use]
    pub fn with_intervals(mut self, intervals: impl IntoIterator<Item = [f64; 2]>) -> Self {
        self.intervals = intervals.into_iter().collect();
        self
    }
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// A line without marks.
    Line,
    /// A thin dashed line without marks: a bound, a slope or a fit.
    Dashed,
    /// Marks without a line.
    Marks,
    /// Marks joined by a line.
    MarkedLine,
    /// Small squares side by side, for maps.
    Cells,
    /// Horizontal from each point to the next one, shaded down to zero: a histogram.
    Steps,
}

impl Style {
    /// Whether points are joined, so that their order matters.
    pub(crate) fn is_line(self) -> bool {
        matches!(self, Self::Line | Self::Dashed | Self::Steps)
    }
    /// Whether points have marks, and intervals are bars.
    pub(crate) fn has_marks(self) -> bool {
        matches!(self, Self::Marks | Self::MarkedLine)
    }
}
