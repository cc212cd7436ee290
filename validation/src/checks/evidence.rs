//! The equations, errata, sections and figures that a check covers, each with its source.

use serde::{Serialize, Serializer};
use std::fmt;

/// A document whose equations are implemented. Its tables are in `docs/`, in the folder of its model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Source {
    /// S. Kiiskinen's thesis (Jyväskylä, 2018).
    Thesis,
    /// E. Azéma, N. Estrada and F. Radjai, Phys. Rev. E 86, 041301 (2012).
    Azema,
    /// D. Bhattacharya and R. P. Lipton, SIAM J. Sci. Comput. 45, B1 (2023).
    Peridem,
}

impl Source {
    /// All sources.
    pub const ALL: [Self; 3] = [Self::Thesis, Self::Azema, Self::Peridem];

    /// Its name in citations.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Thesis => "thesis",
            Self::Azema => "azema",
            Self::Peridem => "peridem",
        }
    }

    /// The name of its folder in `docs/`.
    pub const fn folder(self) -> &'static str {
        match self {
            Self::Thesis => "thesis",
            Self::Azema => "contact-dynamics",
            Self::Peridem => "peridem",
        }
    }
}

/// A place in a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Citation {
    /// The source.
    pub source: Source,
    /// An equation `(42)`, a range of them `(72)-(79)`, an erratum `E15`, a choice `C3`, `section 4.1` or `figure 8`.
    pub place: &'static str,
}

impl Citation {
    /// Parses what `Display` writes; none if the source is unknown or no place follows.
    pub fn parse(text: &'static str) -> Option<Self> {
        let (name, place) = text.split_once(' ')?;
        let source = Source::ALL.into_iter().find(|one| one.name() == name)?;
        Some(Self { source, place })
    }

    /// Numbers of the cited equations, with ranges written out; none if something else is cited.
    pub fn equations(&self) -> Vec<String> {
        numbers(self.place).unwrap_or_default()
    }
}

/// Numbers of an equation `(3.4)` or of a range of them `(A17)-(A19)`.
fn numbers(place: &str) -> Option<Vec<String>> {
    let number = |text: &'_ str| Some(text.strip_prefix('(')?.strip_suffix(')')?.to_owned());
    let Some((first, last)) = place.split_once('-') else {
        return Some(vec![number(place)?]);
    };
    let (first, last) = (number(first)?, number(last)?);
    let prefix = first.trim_end_matches(|c: char| c.is_ascii_digit());
    let counter = |text: &str| text.strip_prefix(prefix)?.parse::<u32>().ok();
    let range = counter(&first)?..=counter(&last)?;
    Some(range.map(|counter| format!("{prefix}{counter}")).collect())
}

impl fmt::Display for Citation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.source.name(), self.place)
    }
}

/// The citations that a check covers, printed as `thesis (42), thesis E15`, or as `-` if there are
/// none.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Evidence(Vec<Citation>);

impl Evidence {
    /// For a check of the program rather than of an equation.
    pub const NONE: Self = Self(Vec::new());

    /// Parses what `Display` writes; none if any citation cannot be parsed.
    pub fn parse(text: &'static str) -> Option<Self> {
        let citations: Option<Vec<Citation>> = text.split(", ").map(Citation::parse).collect();
        citations.map(Self)
    }

    /// These citations and those of another source.
    #[must_use]
    pub fn and(mut self, other: Self) -> Self {
        self.0.extend(other.0);
        self
    }

    /// The citations, in the order of their declaration.
    pub fn citations(&self) -> &[Citation] {
        &self.0
    }
}

/// Places in the thesis, separated by commas: `thesis("(42), (72)-(79), E15")`.
pub fn thesis(places: &'static str) -> Evidence {
    places_in(Source::Thesis, places)
}

/// Places in the source of contact dynamics, separated by commas: `azema("(A1)-(A3), E7")`.
pub fn azema(places: &'static str) -> Evidence {
    places_in(Source::Azema, places)
}

/// Places in the source of peridynamic grains, separated by commas: `peridem("(3.2), P4")`.
pub fn peridem(places: &'static str) -> Evidence {
    places_in(Source::Peridem, places)
}

fn places_in(source: Source, places: &'static str) -> Evidence {
    let citation = |place| Citation { source, place };
    Evidence(places.split(", ").map(citation).collect())
}

impl fmt::Display for Evidence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() {
            return f.write_str("-");
        }
        let words: Vec<String> = self.0.iter().map(ToString::to_string).collect();
        f.write_str(&words.join(", "))
    }
}

impl Serialize for Evidence {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(test)]
mod tests {
    use super::{Citation, Source};

    #[test]
    fn cited_equations_are_written_out() {
        let of = |place| {
            let source = Source::Thesis;
            Citation { source, place }.equations()
        };
        assert_eq!(of("(42)"), ["42"]);
        assert_eq!(of("(9)-(11)"), ["9", "10", "11"]);
        assert_eq!(of("(A9)-(A10)"), ["A9", "A10"]);
        assert_eq!(of("(3.4)-(3.5)"), ["3.4", "3.5"]);
        for other in ["E15", "section 4.1", "figure 8"] {
            assert!(of(other).is_empty(), "{other}");
        }
    }
}
