//! Text files of studies: errors that name file, line, key and value, and values on one line.

use gouge_runner::error::{Error, SceneError};
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::de::{DeTable, DeValue};
use toml::{Spanned, Value};

/// Most seeds of a list.
const MOST_SEEDS: u64 = 1_000_000;
/// Most characters of a value in an error.
pub(crate) const LONGEST: usize = 60;

/// A file and its text, to word errors.
#[derive(Clone, Copy)]
pub(crate) struct Place<'a> {
    pub file: &'a str,
    pub text: &'a str,
}

impl Place<'_> {
    /// The keys of the file.
    pub fn keys<T: serde::de::DeserializeOwned>(&self) -> Result<T, SceneError> {
        let table = DeTable::parse(self.text).map_err(|error| {
            let accepted = format!("must be TOML: {}", error.message());
            self.at(error.span().unwrap_or(0..0), "", &accepted)
        })?;
        toml::from_str(self.text).map_err(|error| self.refusal(table.get_ref(), &error))
    }

    /// An error of a key with a wrong value, of an unknown key or of a missing one.
    fn refusal(&self, table: &DeTable, error: &toml::de::Error) -> SceneError {
        let span = error.span().unwrap_or(0..0);
        let (key, value) = found(table, "", &span).unwrap_or((String::new(), 0..0));
        match quoted(error.message(), "missing field `") {
            Some(name) => self.at(span.start..span.start, &joined(&key, name), "missing"),
            None => self.at(value, &key, &accepted(error.message())),
        }
    }

    /// An error about a key of the table at a place of the file, or about the value there.
    pub fn error(&self, span: Range<usize>, key: &str, accepted: &str) -> SceneError {
        let name = key.rsplit('.').next().unwrap_or(key);
        let root = DeTable::parse(self.text);
        let table = root
            .as_ref()
            .ok()
            .and_then(|root| table_at(root.get_ref(), &span));
        let span = match table {
            None => span,
            Some(table) => match table.get(name) {
                Some(value) => value.span(),
                // The key is missing, so that no value is shown.
                None => span.start..span.start,
            },
        };
        self.at(span, key, accepted)
    }

    /// An error about a key with the value at a place of the file.
    fn at(&self, span: Range<usize>, key: &str, accepted: &str) -> SceneError {
        let before = self.text.get(..span.start).unwrap_or_default();
        let written = self.text.get(span).unwrap_or_default().lines().next();
        SceneError {
            file: self.file.to_owned(),
            line: 1 + before.matches('\n').count(),
            key: key.to_owned(),
            value: written.unwrap_or_default().chars().take(LONGEST).collect(),
            accepted: accepted.trim().replace('\n', "; "),
        }
    }

    /// Core-hours of a budget, if there is one.
    pub fn core_hours(&self, budget: Option<&Spanned<f64>>) -> Result<Option<f64>, SceneError> {
        let refused = budget.filter(|one| !(one.get_ref().is_finite() && *one.get_ref() >= 0.0));
        match refused {
            None => Ok(budget.map(|one| *one.get_ref())),
            Some(one) => {
                let accepted = "must be a finite number, zero or greater";
                Err(self.at(one.span(), "budget.core_hours", accepted))
            }
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

fn joined(path: &str, key: &str) -> String {
    match path.is_empty() {
        true => key.to_owned(),
        false => format!("{path}.{key}"),
    }
}

/// The tables in a value: itself, or items of an array.
fn tables<'a>(value: &'a Spanned<DeValue<'a>>) -> Vec<(Range<usize>, &'a DeTable<'a>)> {
    let table = |value: &'a Spanned<DeValue<'a>>| match value.get_ref() {
        DeValue::Table(table) => Some((value.span(), table)),
        _ => None,
    };
    match value.get_ref() {
        DeValue::Array(list) => list.iter().filter_map(table).collect(),
        _ => table(value).into_iter().collect(),
    }
}

/// The table at a place of the file.
fn table_at<'a>(root: &'a DeTable<'a>, span: &Range<usize>) -> Option<&'a DeTable<'a>> {
    let mut inner = root.iter().flat_map(|(_, value)| tables(value));
    inner.find_map(|(own, table)| match own == *span {
        true => Some(table),
        false => table_at(table, span),
    })
}

/// The key at a place of the file, or with a value or an item there, and the place of its value.
fn found(table: &DeTable, path: &str, span: &Range<usize>) -> Option<(String, Range<usize>)> {
    table.iter().find_map(|(key, value)| {
        let own = joined(path, key.get_ref());
        let is_item = match value.get_ref() {
            DeValue::Array(list) => list.iter().any(|item| item.span() == *span),
            _ => false,
        };
        if is_item || [key.span(), value.span()].contains(span) {
            let whole = value.span();
            return Some(match tables(value).is_empty() {
                true => (own, whole),
                false => (own, whole.start..whole.start),
            });
        }
        let mut inner = tables(value).into_iter();
        inner.find_map(|(_, table)| found(table, &own, span))
    })
}

/// What stands between a beginning and the next quotation mark of the parser.
fn quoted<'a>(message: &'a str, beginning: &str) -> Option<&'a str> {
    message.strip_prefix(beginning)?.split('`').next()
}

/// What is accepted, from a message of the parser.
fn accepted(message: &str) -> String {
    let (problem, expected) = message.split_once(", expected ").unwrap_or((message, ""));
    let list = expected.trim_start_matches("one of ").replace('`', "");
    let list = list.replace(" or ", ", ");
    if problem.starts_with("unknown field") {
        return format!("unknown key; accepted here: {list}");
    }
    if problem.starts_with("unknown variant") {
        return format!("must be one of {list}");
    }
    match expected {
        "" => message.to_owned(),
        "f64" => "must be a number".to_owned(),
        "u32" | "u64" | "usize" => "must be an integer, zero or greater".to_owned(),
        "a boolean" => "must be true or false".to_owned(),
        "a sequence" => "must be an array".to_owned(),
        _ if expected.starts_with("struct ") => "must be a table".to_owned(),
        _ => format!("must be {expected}"),
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
