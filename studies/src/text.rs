//! Text files of studies: errors that name file, line, key and value, and values on one line.

use gouge_runner::error::{Error, SceneError};
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::{Spanned, Value};

/// Most seeds of a list.
const MOST_SEEDS: u64 = 1_000_000;

/// A file and its text, to word errors.
pub(crate) struct Place<'a> {
    pub file: &'a str,
    pub text: &'a str,
}

impl Place<'_> {
    /// The keys of the file.
    pub fn keys<T: serde::de::DeserializeOwned>(&self) -> Result<T, SceneError> {
        toml::from_str(self.text).map_err(|error| {
            let span = error.span().unwrap_or(0..0);
            self.error(span, "", error.message())
        })
    }

    /// An error about a part of the file.
    pub fn error(&self, span: Range<usize>, key: &str, accepted: &str) -> SceneError {
        let before = self.text.get(..span.start).unwrap_or_default();
        let written = self.text.get(span).unwrap_or_default().lines().next();
        let value: String = written.unwrap_or_default().chars().take(60).collect();
        SceneError {
            file: self.file.to_owned(),
            line: 1 + before.matches('\n').count(),
            key: key.to_owned(),
            value,
            accepted: accepted.trim().replace('\n', "; "),
        }
    }

    /// Seeds as a range "0..8" or a list of integers, at least one.
    pub fn seeds(&self, key: &str, value: &Spanned<Value>) -> Result<Vec<u64>, SceneError> {
        let range = |text: &str| {
            let (from, to) = text.split_once("..")?;
            Some(from.trim().parse::<u64>().ok()?..to.trim().parse::<u64>().ok()?)
        };
        let seeds: Option<Vec<u64>> = match value.get_ref() {
            Value::String(text) => range(text)
                .filter(|range| range.end.saturating_sub(range.start) <= MOST_SEEDS)
                .map(Iterator::collect),
            Value::Array(list) => list
                .iter()
                .map(|seed| u64::try_from(seed.as_integer()?).ok())
                .collect(),
            _ => None,
        };
        seeds.filter(|seeds| !seeds.is_empty()).ok_or_else(|| {
            let accepted =
                "must be a range such as \"0..8\" or a list of integers, with at least one seed";
            self.error(value.span(), key, accepted)
        })
    }
}

/// The text of a file that an argument of the command names.
pub(crate) fn read_text(path: &Path) -> Result<String, Error> {
    let failed = |error| Error::Argument(format!("cannot read {}: {error}", path.display()));
    std::fs::read_to_string(path).map_err(failed)
}

/// The scene that a file names: a file beside it, or a built-in scene.
pub(crate) fn scene_beside(file: &Path, scene: &str) -> PathBuf {
    let beside = file.parent().unwrap_or(Path::new(".")).join(scene);
    match beside.is_file() {
        true => beside,
        false => PathBuf::from(scene),
    }
}

/// A number, if the value is one.
pub(crate) fn number(value: &Value) -> Option<f64> {
    let integer = || value.as_integer().map(|integer| integer as f64);
    value.as_float().or_else(integer)
}

/// A value on one line.
pub(crate) fn inline(value: &Value) -> String {
    match value {
        Value::Table(table) => {
            let entry = |(key, value): (&String, &Value)| format!("{key} = {}", inline(value));
            let entries: Vec<String> = table.iter().map(entry).collect();
            match entries.is_empty() {
                true => "{}".to_owned(),
                false => format!("{{ {} }}", entries.join(", ")),
            }
        }
        Value::Array(list) => {
            let items: Vec<String> = list.iter().map(inline).collect();
            format!("[{}]", items.join(", "))
        }
        Value::Float(number) => format!("{number:?}"),
        plain => plain.to_string(),
    }
}
