//! The keys of a scene and their values as text, to tell how two scenes differ.

use super::table::{Source, number_of};
use super::text::hex;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Longest list or string that is stored as it is, in bytes; of longer ones, only a hash is stored.
const LONGEST: usize = 60;
/// Characters of a hash.
const HASH: usize = 12;

/// Dotted keys and their values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Keys(BTreeMap<String, String>);

impl Keys {
    /// The keys of a scene file with its overrides.
    pub(crate) fn of(source: &Source, table: &DeTable) -> Self {
        let mut keys = Self::default();
        keys.add_table(source, "", table);
        keys.0.remove("title");
        keys
    }

    fn add_table(&mut self, source: &Source, path: &str, table: &DeTable) {
        for (key, value) in table {
            let path = match path {
                "" => key.get_ref().to_string(),
                path => format!("{path}.{}", key.get_ref()),
            };
            match value.get_ref() {
                DeValue::Table(table) => self.add_table(source, &path, table),
                _ => self.set(&path, &plain(source, value)),
            }
        }
    }

    /// Set a key; long values are hashed.
    pub(crate) fn set(&mut self, key: &str, value: &str) {
        let value = match value.len() {
            0..=LONGEST => value.to_owned(),
            _ => format!("a long value with the hash {}", hash(value.as_bytes())),
        };
        self.0.insert(key.to_owned(), value);
    }

    /// Add the hash of the file that a key names.
    pub(crate) fn set_file(&mut self, key: &str, name: &str, content: &[u8]) {
        self.set(key, &format!("{name:?} with the hash {}", hash(content)));
    }

    /// The value of a key as text.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.0.get(key).map(String::as_str)
    }

    /// The value of a key as a number.
    pub fn number(&self, key: &str) -> Option<f64> {
        self.0.get(key)?.parse().ok()
    }

    /// How the values of other keys differ from these.
    pub fn differences(&self, other: &Self) -> Vec<String> {
        let all: BTreeSet<&String> = self.0.keys().chain(other.0.keys()).collect();
        let text = |keys: &Self, key: &str| {
            keys.0
                .get(key)
                .map_or_else(|| "absent".to_owned(), Clone::clone)
        };
        let differs = |key: &&&String| self.0.get(**key) != other.0.get(**key);
        let told = |key: &String| {
            format!(
                "{key} is {} there and {} here",
                text(self, key),
                text(other, key)
            )
        };
        all.iter().filter(differs).map(|key| told(key)).collect()
    }

    /// One line per key.
    pub fn to_text(&self) -> String {
        let line = |(key, value): (&String, &String)| format!("{key} = {value}\n");
        self.0.iter().map(line).collect()
    }

    /// The keys that [`Keys::to_text`] wrote.
    pub fn of_text(text: &str) -> Self {
        let pairs = text.lines().filter_map(|line| line.split_once(" = "));
        Self(
            pairs
                .map(|(key, value)| (key.to_owned(), value.to_owned()))
                .collect(),
        )
    }
}

fn hash(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes))[..HASH].to_owned()
}

/// A value as text; equal numbers give equal texts.
fn plain(source: &Source, value: &Spanned<DeValue>) -> String {
    match value.get_ref() {
        DeValue::String(text) => format!("{text:?}"),
        DeValue::Boolean(truth) => truth.to_string(),
        DeValue::Array(array) => {
            let items: Vec<String> = array.iter().map(|item| plain(source, item)).collect();
            format!("[{}]", items.join(", "))
        }
        DeValue::Table(table) => {
            let item = |(key, value): (&Spanned<_>, _)| {
                format!("{} = {}", key.get_ref(), plain(source, value))
            };
            let items: Vec<String> = table.iter().map(item).collect();
            format!("{{ {} }}", items.join(", "))
        }
        number => match number_of(number) {
            Some(number) => format!("{number:?}"),
            None => source.written(value.span()).to_owned(),
        },
    }
}
