//! A table of a scene file that knows the position of its keys and rejects unknown ones.

use super::arrays::array_of;
use super::overrides::{Override, located};
use crate::error::SceneError;
use std::collections::BTreeMap;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

type Result<T> = std::result::Result<T, SceneError>;

/// The text of a file and its overrides, to convert byte positions to lines.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// Name of the file.
    pub file: &'a str,
    /// Text of the file.
    pub text: &'a str,
    /// Positions of all line breaks in the text.
    pub breaks: &'a [usize],
    /// The overrides. Their values have the byte positions after the text and one more byte.
    pub(super) overrides: &'a [Override],
}

impl<'a> Source<'a> {
    /// Positions of all line breaks in a text.
    pub fn breaks(text: &str) -> Vec<usize> {
        text.match_indices('\n').map(|(place, _)| place).collect()
    }

    /// The override to which a byte belongs, and the position of that byte in the value; none for a byte of the file.
    fn overriding(&self, byte: usize) -> Option<(&'a Override, usize)> {
        let behind = byte.checked_sub(self.text.len() + 1)?;
        located(self.overrides, behind)
    }

    /// The text of a span.
    pub fn written(&self, span: std::ops::Range<usize>) -> &'a str {
        let text = match self.overriding(span.start) {
            Some((one, start)) => one.written(start..start + span.len()),
            None => self.text.get(span),
        };
        text.unwrap_or_default()
    }

    /// Line of a byte, counted from one.
    pub fn line(&self, byte: usize) -> usize {
        1 + self.breaks.partition_point(|&place| place < byte)
    }

    /// An error at a byte of the file or of an override. An override already shows its key and value, so they are not
    /// repeated.
    pub fn error(&self, byte: usize, key: &str, value: &str, accepted: &str) -> SceneError {
        let (file, line, is_named) = match self.overriding(byte) {
            Some((one, _)) => (one.to_string(), 0, one.path() == key),
            None => (self.file.to_owned(), self.line(byte), false),
        };
        let (key, value) = if is_named { ("", "") } else { (key, value) };
        SceneError {
            file,
            line,
            key: key.to_owned(),
            value: value.to_owned(),
            accepted: accepted.to_owned(),
        }
    }
}

/// A table, its position and its keys.
pub struct Table<'a> {
    source: Source<'a>,
    path: String,
    at: usize,
    keys: BTreeMap<&'a str, (usize, &'a Spanned<DeValue<'a>>)>,
}

/// The interval in which a number must lie.
#[derive(Clone, Copy, Debug)]
pub enum Range {
    /// Any finite number.
    Finite,
    /// Greater than zero.
    Positive,
    /// Zero or greater.
    NonNegative,
    /// Greater than the first number and less than the second.
    Between(f64, f64),
}

impl Range {
    /// Whether the range contains a number.
    pub fn contains(self, number: f64) -> bool {
        number.is_finite()
            && match self {
                Self::Finite => true,
                Self::Positive => number > 0.0,
                Self::NonNegative => number >= 0.0,
                Self::Between(low, high) => number > low && number < high,
            }
    }
    /// The accepted numbers, in words.
    pub fn text(self) -> String {
        match self {
            Self::Finite => "must be a finite number".to_owned(),
            Self::Positive => "must be a finite number greater than zero".to_owned(),
            Self::NonNegative => "must be a finite number, zero or greater".to_owned(),
            Self::Between(low, high) => {
                format!("must be a number greater than {low} and less than {high}")
            }
        }
    }
}

/// A value as written in the file, shortened.
fn shown(source: &Source, value: &Spanned<DeValue>) -> String {
    match value.get_ref() {
        DeValue::Array(array) if array.len() <= 60 => {
            let elements: Vec<String> = array.iter().map(|v| shown_plain(source, v)).collect();
            shortened(&format!("[{}]", elements.join(", ")))
        }
        _ => shown_plain(source, value),
    }
}

/// Like [`shown`], but of arrays only the length is shown.
fn shown_plain(source: &Source, value: &Spanned<DeValue>) -> String {
    match value.get_ref() {
        DeValue::String(text) => format!("{:?}", shortened(text)),
        DeValue::Integer(_) | DeValue::Float(_) | DeValue::Datetime(_) => {
            shortened(source.written(value.span()))
        }
        DeValue::Boolean(truth) => truth.to_string(),
        DeValue::Array(array) => format!("[array of {}]", array.len()),
        DeValue::Table(_) => "{table}".to_owned(),
    }
}

/// The text, cut to at most sixty characters.
pub fn shortened(text: &str) -> String {
    match text.char_indices().nth(60) {
        None => text.to_owned(),
        Some(_) => text.chars().take(57).chain("...".chars()).collect(),
    }
}

/// The value as a number, if it is an integer or a float.
pub fn number_of(value: &DeValue) -> Option<f64> {
    match value {
        DeValue::Float(number) => number.as_str().replace('_', "").parse().ok(),
        DeValue::Integer(_) => integer_of(value).map(|n| n as f64),
        _ => None,
    }
}

/// What is accepted instead of an integer outside the range of TOML integers.
const TOO_LONG: &str = "must be an integer that fits into 64 bits; a larger number needs a decimal point or an exponent";

fn is_integer(value: &DeValue) -> bool {
    matches!(value, DeValue::Integer(_))
}

pub(super) fn integer_of(value: &DeValue) -> Option<i64> {
    match value {
        DeValue::Integer(number) => i64::from_str_radix(number.as_str(), number.radix()).ok(),
        _ => None,
    }
}

impl<'a> Table<'a> {
    /// The table of a whole file.
    pub fn root(source: Source<'a>, table: &'a DeTable<'a>) -> Self {
        Self::new(source, String::new(), 0, table)
    }

    fn new(source: Source<'a>, path: String, at: usize, table: &'a DeTable<'a>) -> Self {
        let keys = table
            .iter()
            .map(|(key, value)| (key.get_ref().as_ref(), (key.span().start, value)))
            .collect();
        Self {
            source,
            path,
            at,
            keys,
        }
    }

    /// Dotted path of a key of this table.
    pub fn key(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.path)
        }
    }

    /// Whether the key is present.
    pub fn has(&self, key: &str) -> bool {
        self.keys.contains_key(key)
    }

    /// The file.
    pub fn source(&self) -> Source<'a> {
        self.source
    }

    /// Check that all keys are among the known ones.
    pub fn allow(&self, known: &[&str]) -> Result<()> {
        for (key, (at, value)) in &self.keys {
            if !known.contains(key) {
                let accepted = format!("unknown key; accepted here: {}", known.join(", "));
                let path = self.key(&shortened(key));
                let value = shown(&self.source, value);
                return Err(self.source.error(*at, &path, &value, &accepted));
            }
        }
        Ok(())
    }

    /// An error about a key of this table, at the line of the key, or of the table if the key is missing.
    pub fn error(&self, key: &str, accepted: &str) -> SceneError {
        let (at, value) = match self.keys.get(key) {
            Some((at, value)) => (*at, shown(&self.source, value)),
            None => (self.at, String::new()),
        };
        self.source.error(at, &self.key(key), &value, accepted)
    }

    /// An error about this table as a whole.
    pub fn own_error(&self, accepted: &str) -> SceneError {
        self.source.error(self.at, &self.path, "", accepted)
    }

    fn is_overridden(&self, key: &str) -> bool {
        let at = self.keys.get(key).map(|(at, _)| *at);
        at.is_some_and(|at| self.source.overriding(at).is_some())
    }

    pub(super) fn missing(&self, key: &str, accepted: &str) -> SceneError {
        self.error(key, &format!("missing; {accepted}"))
    }

    pub(super) fn value(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.keys.get(key).map(|(_, value)| *value)
    }

    /// A number, if the key is present.
    pub fn optional_number(&self, key: &str, range: Range) -> Result<Option<f64>> {
        let Some(value) = self.value(key) else {
            return Ok(None);
        };
        match number_of(value.get_ref()) {
            Some(number) if range.contains(number) => Ok(Some(number)),
            None if is_integer(value.get_ref()) => Err(self.error(key, TOO_LONG)),
            _ => Err(self.error(key, &range.text())),
        }
    }

    /// A number.
    pub fn number(&self, key: &str, range: Range) -> Result<f64> {
        self.optional_number(key, range)?
            .ok_or_else(|| self.missing(key, &range.text()))
    }

    /// A duration and the time step, which must not be so small that the steps cannot be counted.
    pub fn duration_and_step(&self, duration: &str) -> Result<(f64, f64)> {
        let (key, duration) = (duration, self.number(duration, Range::NonNegative)?);
        let step = self.number("step", Range::Positive)?;
        if duration / step > 1e15 {
            // Blame what the user set for this command, if it is one of the two.
            return Err(
                match self.is_overridden(key) && !self.is_overridden("step") {
                    true => self.error(
                        key,
                        &format!("must be at most 1e15 times {}", self.key("step")),
                    ),
                    false => self.error(
                        "step",
                        &format!("must be at least 1e-15 times {}", self.key(key)),
                    ),
                },
            );
        }
        Ok((duration, step))
    }

    /// A non-negative integer, if the key is present.
    pub fn optional_whole(&self, key: &str) -> Result<Option<u64>> {
        let Some(value) = self.value(key) else {
            return Ok(None);
        };
        match integer_of(value.get_ref()).and_then(|n| u64::try_from(n).ok()) {
            Some(number) => Ok(Some(number)),
            None => Err(self.error(key, "must be an integer, zero or greater, less than 2^63")),
        }
    }

    /// An integer from `low` to `high`, if the key is present.
    pub fn optional_whole_within(&self, key: &str, low: u64, high: u64) -> Result<Option<u64>> {
        let Some(value) = self.value(key) else {
            return Ok(None);
        };
        let number = integer_of(value.get_ref()).and_then(|n| u64::try_from(n).ok());
        match number.filter(|number| (low..=high).contains(number)) {
            Some(number) => Ok(Some(number)),
            None => Err(self.error(key, &format!("must be an integer from {low} to {high}"))),
        }
    }

    /// A boolean, if the key is present.
    pub fn optional_truth(&self, key: &str) -> Result<Option<bool>> {
        match self.value(key).map(|value| value.get_ref()) {
            None => Ok(None),
            Some(DeValue::Boolean(truth)) => Ok(Some(*truth)),
            Some(_) => Err(self.error(key, "must be true or false")),
        }
    }

    /// A string, if the key is present.
    pub fn optional_text(&self, key: &str) -> Result<Option<&'a str>> {
        match self.value(key).map(|value| value.get_ref()) {
            None => Ok(None),
            Some(DeValue::String(text)) => Ok(Some(text.as_ref())),
            Some(_) => Err(self.error(key, "must be a string")),
        }
    }

    /// One of several names, if the key is present.
    pub fn optional_choice<T: Copy>(&self, key: &str, names: &[(&str, T)]) -> Result<Option<T>> {
        if !self.has(key) {
            return Ok(None);
        }
        let list: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
        let accepted = format!("must be one of: {}", list.join(", "));
        let found = match self.value(key).map(|value| value.get_ref()) {
            Some(DeValue::String(text)) => names.iter().find(|(name, _)| *name == text.as_ref()),
            _ => None,
        };
        found
            .map(|(_, choice)| Some(*choice))
            .ok_or_else(|| self.error(key, &accepted))
    }

    /// One of several names.
    pub fn choice<T: Copy>(&self, key: &str, names: &[(&str, T)]) -> Result<T> {
        let list: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
        self.optional_choice(key, names)?
            .ok_or_else(|| self.missing(key, &format!("must be one of: {}", list.join(", "))))
    }

    /// Whether the key is present and its value is a string.
    pub fn has_text(&self, key: &str) -> bool {
        matches!(
            self.value(key).map(|value| value.get_ref()),
            Some(DeValue::String(_))
        )
    }

    /// All keys of this table, in alphabetical order.
    pub fn names(&self) -> impl Iterator<Item = &'a str> + '_ {
        self.keys.keys().copied()
    }

    /// Whether the key is present and its value is a table.
    pub fn has_table(&self, key: &str) -> bool {
        matches!(
            self.value(key).map(|value| value.get_ref()),
            Some(DeValue::Table(_))
        )
    }

    /// A table below this one, if the key is present.
    pub fn optional_table(&self, key: &str) -> Result<Option<Table<'a>>> {
        let Some((at, value)) = self.keys.get(key) else {
            return Ok(None);
        };
        match value.get_ref() {
            DeValue::Table(table) => Ok(Some(Table::new(self.source, self.key(key), *at, table))),
            _ => Err(self.error(key, "must be a table")),
        }
    }

    /// The table of a law that a scene need not have, if the key is present. An empty table means no law, so that an
    /// override can remove one.
    pub fn optional_law(&self, key: &str) -> Result<Option<Table<'a>>> {
        let table = self.optional_table(key)?;
        Ok(table.filter(|table| !table.keys.is_empty()))
    }

    /// A table below this one.
    pub fn table(&self, key: &str) -> Result<Table<'a>> {
        self.optional_table(key)?
            .ok_or_else(|| self.missing(key, "must be a table"))
    }

    /// An array of tables; empty if the key is absent.
    pub fn tables(&self, key: &str) -> Result<Vec<Table<'a>>> {
        let Some(value) = self.value(key) else {
            return Ok(Vec::new());
        };
        let accepted = "must be an array of tables";
        let Some(array) = array_of(value) else {
            return Err(self.error(key, accepted));
        };
        let item = |(i, value): (usize, &'a Spanned<DeValue<'a>>)| match value.get_ref() {
            DeValue::Table(table) => {
                let path = format!("{}[{i}]", self.key(key));
                Ok(Table::new(self.source, path, value.span().start, table))
            }
            _ => Err(self.error(key, accepted)),
        };
        array.iter().enumerate().map(item).collect()
    }
}
