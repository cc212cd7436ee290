//! Results by file and case.

use crate::error::{CaseError, Fault};
use serde_json::{Map, Value};

/// What was found in a folder of cases.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// Results by name of the file without its ending, and by the identity of the case.
    pub results: Map<String, Value>,
    /// Cases without a result.
    pub failures: Vec<CaseError>,
    /// Number of all cases.
    pub cases: usize,
}

impl Outcome {
    /// The results as JSON.
    pub fn text(&self) -> String {
        format!("{}\n", Value::from(self.results.clone()))
    }

    /// Lines for people: how many cases of each file have a result.
    pub fn account(&self) -> String {
        let line = |(name, results): (&String, &Value)| {
            let solved = results.as_object().map_or(0, Map::len);
            format!("{name}.json: {solved} solved\n")
        };
        self.results.iter().map(line).collect()
    }
}

/// Refuse a result with a number that is not finite, which JSON cannot hold.
pub fn require_finite(result: Value) -> Result<Value, Fault> {
    match not_finite(&result) {
        Some(key) => Err(Fault::NotFinite(key)),
        None => Ok(result),
    }
}

fn not_finite(value: &Value) -> Option<String> {
    let inside = |key: String, value: &Value| {
        let found = not_finite(value)?;
        let separator = if found.is_empty() { "" } else { "." };
        Some(format!("{key}{separator}{found}"))
    };
    match value {
        Value::Null => Some(String::new()),
        Value::Object(items) => items.iter().find_map(|(key, v)| inside(key.clone(), v)),
        Value::Array(items) => {
            let mut items = items.iter().enumerate();
            items.find_map(|(k, v)| inside(format!("[{k}]"), v))
        }
        _ => None,
    }
}
