//! Parameters and their ranges.

use std::collections::BTreeMap;

/// How a parameter fills its range before anything is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly in its logarithm.
    Log,
    /// Evenly.
    Linear,
}

/// A parameter that is sought.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// The keys that take its value.
    pub keys: Keys,
    /// The range in which it is sought.
    pub range: [f64; 2],
    /// How it fills the range.
    pub scale: Scale,
    /// Its unit on figures and in tables; empty if there is none.
    pub unit: String,
}

/// Which keys take the value of a parameter.
#[derive(Clone, Debug)]
pub enum Keys {
    /// The same keys in all tests.
    Same(Vec<String>),
    /// Keys of each test; a test that is not named does not depend on the parameter.
    Each(BTreeMap<String, Vec<String>>),
}

impl Parameter {
    /// Its name, with its unit if there is one.
    pub fn name_with_unit(&self) -> String {
        match self.unit.is_empty() {
            true => self.name.clone(),
            false => format!("{} in {}", self.name, self.unit),
        }
    }

    /// The value at a place of the range, from 0 to 1.
    pub fn value(&self, place: f64) -> f64 {
        let [low, high] = self.range;
        match self.scale {
            Scale::Log => low * (high / low).powf(place),
            Scale::Linear => low + (high - low) * place,
        }
    }

    /// The place of a value in the range.
    pub fn place(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        match self.scale {
            Scale::Log => (value / low).ln() / (high / low).ln(),
            Scale::Linear => (value - low) / (high - low),
        }
    }

    /// Length of the range: of the logarithm for a logarithmic scale.
    pub fn width(&self) -> f64 {
        let [low, high] = self.range;
        match self.scale {
            Scale::Log => (high / low).ln(),
            Scale::Linear => high - low,
        }
    }

    /// The value at a place as text with six digits, so that a file with it gives the same run.
    pub fn written(&self, place: f64) -> String {
        format!("{:.5e}", self.value(place))
    }

    /// The keys in a test.
    pub fn keys_in(&self, test: &str) -> &[String] {
        match &self.keys {
            Keys::Same(keys) => keys,
            Keys::Each(tests) => tests.get(test).map_or(&[], Vec::as_slice),
        }
    }
}
