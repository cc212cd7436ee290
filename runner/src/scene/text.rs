//! Converts the bytes of a file to TOML, or finds the position of the syntax error.

use super::table::{Source, shortened};
use crate::error::SceneError;

type Result<T> = std::result::Result<T, SceneError>;

pub(super) fn text_of<'a>(file: &str, bytes: &'a [u8]) -> Result<&'a str> {
    std::str::from_utf8(bytes).map_err(|error| {
        let valid = &bytes[..error.valid_up_to()];
        SceneError {
            file: file.to_owned(),
            line: 1 + valid.iter().filter(|&&b| b == b'\n').count(),
            key: String::new(),
            value: format!("byte 0x{:02x}", bytes[error.valid_up_to()]),
            accepted: "must be a TOML file in UTF-8".to_owned(),
        }
    })
}

/// The error for a file that is not TOML, with the key that the line appears to set.
pub(super) fn syntax_error(source: &Source, error: &toml::de::Error) -> SceneError {
    let at = error.span().map_or(0, |span| span.start);
    let before = source.line(at) - 1;
    let line = source.text.lines().nth(before).unwrap_or_default().trim();
    let table = enclosing_table(source.text, before);
    let (key, value) = match line.split_once('=') {
        _ if line.starts_with('[') => (String::new(), line),
        Some((key, value)) if table.is_empty() => (shortened(key.trim()), value.trim()),
        Some((key, value)) => (format!("{table}.{}", shortened(key.trim())), value.trim()),
        None => (table, line),
    };
    let accepted = format!("must be TOML: {}", error.message());
    source.error(at, &key, &shortened(value), &accepted)
}

/// Dotted path of the last table whose header is within the first `lines` lines of a text.
fn enclosing_table(text: &str, lines: usize) -> String {
    let headers = || text.lines().take(lines).filter_map(header);
    match headers().last() {
        None => String::new(),
        Some((name, false)) => name.to_owned(),
        Some(last) => format!(
            "{}[{}]",
            last.0,
            headers().filter(|&h| h == last).count() - 1
        ),
    }
}

/// Name in a line such as `[name]` or `[[name]]`, and whether the brackets are double.
fn header(line: &str) -> Option<(&str, bool)> {
    let (inner, _) = line.trim_start().strip_prefix('[')?.split_once(']')?;
    let name = inner.strip_prefix('[');
    let (name, is_list) = (name.unwrap_or(inner).trim(), name.is_some());
    let is_key = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.');
    let is_name = name.len() <= 60 && !name.is_empty() && name.chars().all(is_key);
    is_name.then_some((name, is_list))
}

/// Bytes in hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
