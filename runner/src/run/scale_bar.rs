//! The scale bar of a picture.

/// A bar with a round length.
#[derive(Clone, Debug, PartialEq)]
pub struct ScaleBar {
    /// Length in m.
    pub length: f64,
    /// The length with its unit.
    pub label: String,
}

/// Units and their lengths in m, from long to short.
const UNITS: [(&str, f64); 5] = [
    ("km", 1e3),
    ("m", 1.0),
    ("mm", 1e-3),
    ("µm", 1e-6),
    ("nm", 1e-9),
];

impl ScaleBar {
    /// The longest bar whose length is 1, 2 or 5 times a power of ten and at most the given one in m; none if that is
    /// not a positive number.
    pub fn within(most: f64) -> Option<Self> {
        if !(most.is_finite() && most > f64::MIN_POSITIVE) {
            return None;
        }
        let decade = most.log10().floor() as i32;
        // One decade more, in case the logarithm was rounded down.
        let decades = [decade + 1, decade, decade - 1].into_iter();
        let mut rounds = decades.flat_map(|decade| [5, 2, 1].map(|digit| (digit, decade)));
        let (length, digit, decade) = rounds.find_map(|(digit, decade)| {
            let length: f64 = format!("{digit}e{decade}").parse().ok()?;
            (0.0 < length && length <= most).then_some((length, digit, decade))
        })?;
        Some(Self {
            length,
            label: label(length, digit, decade),
        })
    }
}

/// The length in the unit in which it is an integer below 1000; in m with an exponent if there is none.
fn label(length: f64, digit: u32, decade: i32) -> String {
    let in_unit = |&(name, size): &(&str, f64)| {
        let number = length / size;
        (0.999..999.0)
            .contains(&number)
            .then(|| format!("{number:.0} {name}"))
    };
    let unit = UNITS.iter().find_map(in_unit);
    unit.unwrap_or_else(|| format!("{digit}e{decade} m"))
}
