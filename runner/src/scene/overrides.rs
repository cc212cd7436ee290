//! Overrides: keys that a user sets on the command line, checked like those of the file.

use super::table::shortened;
use crate::error::SceneError;
use sha2::{Digest, Sha256};
use std::fmt;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

type Result<T> = std::result::Result<T, SceneError>;

/// Largest number of names in a dotted key; every key of a scene has far fewer.
const MOST_NAMES: usize = 16;

/// Keys of a scene with the values that replace those of the file.
///
/// If a key is overridden several times, only the last override is kept. The order of different keys does not matter.
/// So overrides with the same effect are equal and give the same hash.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Overrides(Vec<Override>);

/// A dotted key and a TOML value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Override {
    /// The names of the key. A name of digits is an index into an array.
    names: Vec<String>,
    /// The value as given by the user.
    value: String,
}

impl Overrides {
    /// Read overrides from texts of the form `KEY=VALUE`.
    ///
    /// # Errors
    /// A text without an equals sign, a key that is not a list of names joined by dots, or a value that is not TOML.
    pub fn parse<T: AsRef<str>>(texts: &[T]) -> Result<Self> {
        let mut list: Vec<Override> = Vec::new();
        for text in texts {
            let one = Override::parse(text.as_ref())?;
            list.retain(|earlier| !earlier.names.starts_with(&one.names));
            list.push(one);
        }
        // A table comes before its keys, which were set later.
        list.sort_by(|a, b| a.names.cmp(&b.names));
        Ok(Self(list))
    }

    /// The overrides, in the order in which they are applied.
    pub(super) fn list(&self) -> &[Override] {
        &self.0
    }

    /// SHA-256 of a scene file and its overrides; without overrides, the SHA-256 of the file.
    pub(super) fn sha256(&self, file: &[u8]) -> [u8; 32] {
        let mut hash = Sha256::new_with_prefix(file);
        for one in &self.0 {
            // No TOML file contains a zero byte, so no file with overrides has the hash of another file.
            hash.update(format!("\0{}={}", one.names.join("."), one.value));
        }
        hash.finalize().into()
    }

    /// Set the keys in the table of a file; `after` is the first byte after the text of the file.
    ///
    /// # Errors
    /// A key that leads through a value that is neither a table nor an array, or an index without an item.
    pub(super) fn apply<'a>(&'a self, table: DeTable<'a>, after: usize) -> Result<DeTable<'a>> {
        let mut root = DeValue::Table(table);
        for (start, one) in positions(&self.0) {
            let value = shifted(one.toml()?, after + start);
            one.set(&mut root, 0, after + start, value)?;
        }
        Ok(match root {
            DeValue::Table(table) => table,
            _ => DeTable::new(),
        })
    }
}

/// The overrides with the first byte of each value, as if the values were concatenated.
fn positions(list: &[Override]) -> impl Iterator<Item = (usize, &Override)> {
    list.iter().scan(0, |next, one| {
        let start = *next;
        *next += one.value.len() + 1;
        Some((start, one))
    })
}

/// The override to which a byte after the text of the file belongs, and the position of that byte in the value.
pub(super) fn located(list: &[Override], byte: usize) -> Option<(&Override, usize)> {
    let found = positions(list).find(|(start, one)| byte <= start + one.value.len());
    found.map(|(start, one)| (one, byte - start))
}

/// The value with its span, and all spans inside it, moved by a number of bytes.
fn shifted<'a>(value: Spanned<DeValue<'a>>, by: usize) -> Spanned<DeValue<'a>> {
    let moved = |span: std::ops::Range<usize>| span.start + by..span.end + by;
    let span = moved(value.span());
    let value = match value.into_inner() {
        DeValue::Array(array) => {
            DeValue::Array(array.into_iter().map(|item| shifted(item, by)).collect())
        }
        DeValue::Table(table) => {
            let item = |(key, value): (Spanned<_>, _)| {
                let span = moved(key.span());
                (Spanned::new(span, key.into_inner()), shifted(value, by))
            };
            DeValue::Table(table.into_iter().map(item).collect())
        }
        plain => plain,
    };
    Spanned::new(span, value)
}

/// The name as an index, if it is one.
fn index(name: &str) -> Option<usize> {
    let number: usize = name.parse().ok()?;
    (number.to_string() == name).then_some(number)
}

/// Names as error messages show them: `particles[0].radius`.
fn path_of(names: &[String]) -> String {
    let mut path = String::new();
    for name in names {
        match index(name) {
            Some(number) => path += &format!("[{number}]"),
            None if path.is_empty() => path.push_str(name),
            None => path += &format!(".{name}"),
        }
    }
    path
}

impl fmt::Display for Override {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let key = self.names.join(".");
        write!(f, "--set {}={}", shortened(&key), shortened(&self.value))
    }
}

impl Override {
    fn parse(text: &str) -> Result<Self> {
        let malformed = |accepted: &str| error(&format!("--set {}", shortened(text)), accepted);
        let Some((key, value)) = text.split_once('=') else {
            return Err(malformed("must be KEY=VALUE, such as time.step=1e-9"));
        };
        let names: Vec<String> = key.split('.').map(|name| name.trim().to_owned()).collect();
        let is_bare = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-');
        let is_name = |name: &String| !name.is_empty() && name.chars().all(is_bare);
        if names.len() > MOST_NAMES || !names.iter().all(is_name) {
            return Err(malformed(
                "must have a key of names joined by dots, such as contact.normal.stiffness or particles.0.radius",
            ));
        }
        let value = value.trim().to_owned();
        if value.is_empty() {
            return Err(malformed("must have a TOML value after the equals sign"));
        }
        let one = Self { names, value };
        one.toml()?;
        Ok(one)
    }

    /// The value as TOML.
    fn toml(&self) -> Result<Spanned<DeValue<'_>>> {
        DeValue::parse(&self.value).map_err(|problem| {
            let lower = self.value.to_lowercase();
            let accepted = if ["true", "false"].contains(&lower.as_str()) {
                format!("must be a TOML value; TOML writes {lower}")
            } else if is_word(&self.value) {
                let (key, value) = (self.names.join("."), shortened(&self.value));
                format!("a string needs quotes: --set '{key}=\"{value}\"'")
            } else {
                format!("must be a TOML value: {}", problem.message())
            };
            self.error(&accepted)
        })
    }

    /// The key as error messages show it.
    pub fn path(&self) -> String {
        path_of(&self.names)
    }

    /// Part of the value as given by the user.
    pub fn written(&self, span: std::ops::Range<usize>) -> Option<&str> {
        self.value.get(span)
    }

    fn error(&self, accepted: &str) -> SceneError {
        error(&self.to_string(), accepted)
    }

    /// Set the value below a node of the scene, following the names from `depth` on; new keys get the position `at`.
    fn set<'a>(
        &'a self,
        node: &mut DeValue<'a>,
        depth: usize,
        at: usize,
        value: Spanned<DeValue<'a>>,
    ) -> Result<()> {
        let (name, next) = (self.names[depth].as_str(), self.names.get(depth + 1));
        let key = || Spanned::new(at..at, name.into());
        let inner = match node {
            DeValue::Table(table) if next.is_none() => {
                // Inserting without removing would keep the position of the key in the file.
                table.remove(name);
                table.insert(key(), value);
                return Ok(());
            }
            DeValue::Table(table) => {
                if !table.contains_key(name) && next.is_some_and(|next| index(next).is_some()) {
                    let array = path_of(&self.names[..=depth]);
                    return Err(self.error(&format!(
                        "names an array that the scene does not have: {array}"
                    )));
                }
                if depth + 2 == self.names.len() && !matches!(value.get_ref(), DeValue::Table(_)) {
                    claim_array(table, name, key());
                }
                let new = DeValue::Table(DeTable::new());
                table.entry(key()).or_insert(Spanned::new(at..at, new))
            }
            DeValue::Array(array) => {
                let length = array.len();
                let Some(item) = index(name).and_then(|index| array.get_mut(index)) else {
                    let array = path_of(&self.names[..depth]);
                    let accepted = format!(
                        "{array} is an array of length {length}; must name an item by its index, counted from 0"
                    );
                    return Err(self.error(&accepted));
                };
                if next.is_none() {
                    *item = value;
                    return Ok(());
                }
                item
            }
            _ => {
                let path = path_of(&self.names[..depth]);
                return Err(self.error(&format!("{path} is neither a table nor an array")));
            }
        };
        self.set(inner.get_mut(), depth + 1, at, value)
    }
}

/// Move the key of an array, if there is one, to the position of the override of one of its items. Errors name this
/// key, because plain items have no key of their own.
fn claim_array<'a>(table: &mut DeTable<'a>, name: &str, key: Spanned<DeString<'a>>) {
    if matches!(
        table.get(name).map(Spanned::get_ref),
        Some(DeValue::Array(_))
    ) && let Some(array) = table.remove(name)
    {
        table.insert(key, array);
    }
}

/// Whether a value that is not TOML looks like a string without quotes.
fn is_word(value: &str) -> bool {
    let begins = |c: char| c.is_alphabetic() || matches!(c, '_' | '.' | '/');
    let is_part = |c: char| !c.is_control() && !"\"'\\[]{}=#".contains(c);
    value.starts_with(begins) && value.chars().all(is_part) && value.parse::<f64>().is_err()
}

fn error(place: &str, accepted: &str) -> SceneError {
    SceneError {
        file: place.to_owned(),
        line: 0,
        key: String::new(),
        value: String::new(),
        accepted: accepted.to_owned(),
    }
}
