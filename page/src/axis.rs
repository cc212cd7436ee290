//! Axes: scales, ranges, ticks and their labels.

use std::ops::Range;

/// Approximate width of a digit in units of the figure.
const DIGIT: f64 = 25.0;
/// Least distance between neighbouring labels in units of the figure.
const GAP: f64 = 36.0;

/// An axis; its range is that of the data.
#[derive(Clone, Debug)]
pub struct Axis {
    /// The quantity.
    pub quantity: String,
    /// Its unit; empty for a number.
    pub unit: String,
    /// Its scale.
    pub(crate) scale: Scale,
}

/// How values are spread along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithms; points that are not positive are left out.
    Logarithmic,
    /// Evenly, with ticks only at whole numbers from 1 to this one.
    Counting(usize),
}

impl Axis {
    /// An axis with a linear scale; the unit of a number is empty.
    pub fn linear(quantity: &str, unit: &str) -> Self {
        Self {
            quantity: quantity.to_owned(),
            unit: unit.to_owned(),
            scale: Scale::Linear,
        }
    }

    /// An axis with a logarithmic scale; the unit of a number is empty.
    pub fn logarithmic(quantity: &str, unit: &str) -> Self {
        Self {
            scale: Scale::Logarithmic,
            ..Self::linear(quantity, unit)
        }
    }

    /// An axis of things that are numbered from 1 on.
    pub fn counting(quantity: &str, things: usize) -> Self {
        Self {
            scale: Scale::Counting(things),
            ..Self::linear(quantity, "")
        }
    }

    /// Whether the scale is logarithmic.
    pub(crate) fn is_logarithmic(&self) -> bool {
        self.scale == Scale::Logarithmic
    }

    /// A value in coordinates of the axis: its logarithm if the scale is logarithmic.
    pub(crate) fn along(&self, value: f64) -> f64 {
        if self.is_logarithmic() {
            value.log10()
        } else {
            value
        }
    }

    /// Range of the axis: all values, given in its coordinates, with a margin, or whole decades.
    pub(crate) fn range(&self, values: impl Iterator<Item = f64>) -> Range<f64> {
        if let Scale::Counting(things) = self.scale {
            return 0.5..things as f64 + 0.5;
        }
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        let finite = values.filter(|value| value.is_finite());
        finite.for_each(|value| (low, high) = (low.min(value), high.max(value)));
        if low > high {
            (low, high) = (0.0, 1.0);
        }
        if self.is_logarithmic() {
            let (low, high) = (low.floor(), high.ceil());
            return low..high.max(low + 1.0);
        }
        let least = (1e-12 * low.abs().max(high.abs())).max(1e-300);
        let margin = if high - low > least {
            0.04 * (high - low)
        } else {
            (0.1 * low.abs()).max(1e-300)
        };
        low - margin..high + margin
    }
}

/// The ticks of an axis.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ticks {
    /// Positions in coordinates of the axis.
    pub positions: Vec<f64>,
    /// A label per position.
    pub labels: Vec<String>,
    /// Quantity and unit, with the power of ten by which labels are to be multiplied.
    pub title: String,
}

impl Ticks {
    /// Ticks of a horizontal axis whose labels do not overlap within a width.
    pub fn beside_each_other(axis: &Axis, range: &Range<f64>, width: f64) -> Self {
        let fit = |ticks: &Self| {
            let each = DIGIT * ticks.longest() as f64 + GAP;
            each * ticks.labels.len() as f64 <= width + GAP
        };
        let mut ticks = Self::at_most(9, axis, range);
        for most in (2..9).rev() {
            if fit(&ticks) {
                break;
            }
            ticks = Self::at_most(most, axis, range);
        }
        ticks
    }

    /// At most a number of ticks.
    pub fn at_most(most: usize, axis: &Axis, range: &Range<f64>) -> Self {
        match axis.scale {
            Scale::Logarithmic => Self::decades(most, axis, range),
            Scale::Linear => Self::even(most, axis, range, 0.0),
            Scale::Counting(_) => Self::even(most, axis, range, 1.0),
        }
    }

    /// Width of the longest label.
    pub fn width(&self) -> f64 {
        DIGIT * self.longest() as f64
    }

    fn longest(&self) -> usize {
        let lengths = self.labels.iter().map(|label| label.chars().count());
        lengths.max().unwrap_or(0)
    }

    /// Powers of ten; with twice and five times them on a scale of one or two decades.
    fn decades(most: usize, axis: &Axis, range: &Range<f64>) -> Self {
        let (first, last) = (range.start.round() as i32, range.end.round() as i32);
        let step = (1..).find(|step| (last - first) / step < most as i32);
        let step = step.unwrap_or(1);
        let whole = (first..=last).filter(|decade| decade.rem_euclid(step) == 0);
        let digits: &[u8] = match last - first {
            ..=2 if 3 * (last - first) < most as i32 => &[1, 2, 5],
            _ => &[1],
        };
        let is_plain = first >= -3 && last <= 4;
        let each = whole.flat_map(|decade| digits.iter().map(move |&digit| (digit, decade)));
        let place = |&(digit, decade): &(u8, i32)| f64::from(decade) + f64::from(digit).log10();
        let (positions, labels) = each
            .filter(|tick| place(tick) <= range.end + 1e-9)
            .map(|tick| (place(&tick), power(tick, is_plain)))
            .unzip();
        Self {
            positions,
            labels,
            title: title(axis, 0),
        }
    }

    /// Multiples of 1, 2 or 5 times a power of ten, with at least a distance between them.
    fn even(most: usize, axis: &Axis, range: &Range<f64>, least: f64) -> Self {
        let least = ((range.end - range.start) / most as f64).max(least);
        let decade = least.log10().floor() as i32;
        let steps = [1, 2, 5, 10].map(|digit| f64::from(digit) * ten_to(decade));
        let step = steps.into_iter().find(|&step| step >= least);
        let step = step.unwrap_or(least);
        let (first, last) = ((range.start / step).ceil(), (range.end / step).floor());
        let number = (last - first).clamp(0.0, most as f64) as usize;
        let multiples = (0..=number).map(|k| first + k as f64);
        let exponent = exponent_of(range.start.abs().max(range.end.abs()));
        let unit = step / ten_to(exponent);
        let decimals = (-unit.log10().floor() + 1e-9).clamp(0.0, 15.0) as usize;
        Self {
            positions: multiples.clone().map(|k| k * step).collect(),
            labels: multiples
                .map(|k| format!("{:.decimals$}", k * unit + 0.0))
                .collect(),
            title: title(axis, exponent),
        }
    }
}

/// The power of ten that is taken out of labels: none for sizes from 0.01 to 10 000, otherwise a multiple
/// of three.
fn exponent_of(size: f64) -> i32 {
    match size {
        0.0 | 1e-2..1e4 => 0,
        _ => 3 * (size.log10() / 3.0).floor() as i32,
    }
}

fn ten_to(exponent: i32) -> f64 {
    10_f64.powi(exponent)
}

/// Quantity and unit with a power of ten: `time (10⁻⁶ s)`.
fn title(axis: &Axis, exponent: i32) -> String {
    let factor = match exponent {
        0 => String::new(),
        _ => format!("10{}", superscript(exponent)),
    };
    let unit = [factor, axis.unit.clone()].join(" ");
    match unit.trim() {
        "" => axis.quantity.clone(),
        unit => format!("{} ({unit})", axis.quantity),
    }
}

/// A digit times a power of ten, as a plain number or with the power, unless that is 1 or 10.
fn power((digit, decade): (u8, i32), is_plain: bool) -> String {
    match (digit, decade) {
        _ if is_plain || matches!(decade, 0 | 1) => {
            format!("{}", f64::from(digit) * ten_to(decade))
        }
        (1, _) => format!("10{}", superscript(decade)),
        _ => format!("{digit}·10{}", superscript(decade)),
    }
}

fn superscript(exponent: i32) -> String {
    let raised = |letter: char| match letter {
        '-' => '⁻',
        digit => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹']
            [digit.to_digit(10).unwrap_or(0) as usize],
    };
    exponent.to_string().chars().map(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::{Axis, DIGIT, Ticks};
    use std::ops::Range;

    fn ticks(range: Range<f64>) -> Ticks {
        Ticks::beside_each_other(&Axis::linear("time", "s"), &range, 1200.0)
    }

    #[test]
    fn labels_times_the_power_of_ten_are_the_positions() {
        let expected = [
            (0.0..10.5, "time (s)", 1.0),
            (-3.1e-6..2.9e-6, "time (10⁻⁶ s)", 1e-6),
            (0.0..2.5e-2, "time (s)", 1.0),
            (0.0..7e9, "time (10⁹ s)", 1e9),
            (0.0..1e-5, "time (10⁻⁶ s)", 1e-6),
        ];
        for (range, title, factor) in expected {
            let ticks = ticks(range);
            assert_eq!(ticks.title, title);
            assert!(ticks.positions.len() >= 4, "{ticks:?}");
            for (position, label) in ticks.positions.iter().zip(&ticks.labels) {
                let value = label.parse::<f64>().unwrap_or(f64::NAN) * factor;
                assert!((value - position).abs() <= 1e-12 * factor, "{ticks:?}");
            }
        }
    }

    #[test]
    fn labels_differ_and_do_not_overlap() {
        for range in [
            0.0..1.0,
            1.0..1.0 + 1e-9,
            -9.87e-301..1e-300,
            9999.0..10001.0,
        ] {
            let ticks = ticks(range.clone());
            assert!(ticks.labels.len() >= 2, "{range:?}: {ticks:?}");
            assert!(
                ticks.labels.windows(2).all(|two| two[0] != two[1]),
                "{ticks:?}"
            );
            let each = 1200.0 / (ticks.labels.len() - 1) as f64;
            assert!(ticks.longest() as f64 * DIGIT < each, "{ticks:?}");
        }
    }

    #[test]
    fn a_logarithmic_scale_has_labels_at_powers_of_ten() {
        let axis = Axis::logarithmic("error", "");
        let of = |range| Ticks::at_most(9, &axis, &range).labels;
        assert_eq!(of(-1.0..1.0), ["0.1", "0.2", "0.5", "1", "2", "5", "10"]);
        assert_eq!(of(-5.0..0.0), ["10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "1"]);
        let wide = [
            "10⁻¹⁶",
            "10⁻¹⁴",
            "10⁻¹²",
            "10⁻¹⁰",
            "10⁻⁸",
            "10⁻⁶",
            "10⁻⁴",
            "10⁻²",
            "1",
        ];
        assert_eq!(of(-16.0..0.0), wide);
    }

    #[test]
    fn things_are_counted_in_whole_numbers() {
        for (things, expected) in [(1, "1"), (3, "1 2 3"), (40, "5 10 15 20 25 30 35 40")] {
            let axis = Axis::counting("number of the target", things);
            let ticks = Ticks::at_most(9, &axis, &axis.range([1.3].into_iter()));
            assert_eq!(ticks.labels.join(" "), expected);
        }
    }

    #[test]
    fn values_without_a_spread_have_a_range() {
        let axis = Axis::linear("time", "s");
        for value in [0.0, 5.0, -1e-9, 1e300] {
            let range = axis.range([value, value].into_iter());
            assert!(range.start < value && value < range.end, "{range:?}");
        }
        let range = axis.range([f64::NAN].into_iter());
        assert!(range.start < range.end);
    }
}
