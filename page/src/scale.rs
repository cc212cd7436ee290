//! A range with its ticks, as plotters draws it.

use crate::axis::Ticks;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use std::ops::Range;

/// The coordinate along an axis.
pub struct Scale {
    range: Range<f64>,
    ticks: Ticks,
}

impl Scale {
    /// A range with its ticks.
    pub fn new(range: Range<f64>, ticks: Ticks) -> Self {
        Self { range, ticks }
    }
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (first, last): (i32, i32)) -> i32 {
        let part = (value - self.range.start) / (self.range.end - self.range.start);
        (f64::from(first) + part * f64::from(last - first)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        match hint.weight().allow_light_points() {
            true => Vec::new(),
            false => self.ticks.positions.clone(),
        }
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Scale {
    fn format_ext(&self, value: &f64) -> String {
        let place = self.ticks.positions.iter().position(|at| at == value);
        place.map_or_else(String::new, |place| self.ticks.labels[place].clone())
    }
}
