//! The text of a scene before it is known which model it is of.

use super::table::{Source, Table};
use super::text::{hex, syntax_error, text_of};
use super::{Overrides, builtin};
use crate::error::SceneError;
use std::borrow::Cow;
use std::path::{Path, PathBuf};
use toml::de::DeTable;

type Result<T> = std::result::Result<T, SceneError>;

/// A scene file: its name, its bytes, and the folder from which its CSV files are read.
pub struct SceneFile<'a> {
    name: String,
    bytes: Cow<'a, [u8]>,
    folder: PathBuf,
    path: Option<PathBuf>,
}

/// The models, by the values of the key `model`.
pub const MODELS: [(&str, &str); 3] = [
    ("dem", "dem"),
    ("contact-dynamics", "contact-dynamics"),
    ("peridem", "peridem"),
];

impl<'a> SceneFile<'a> {
    /// A scene in memory.
    pub fn new(name: &str, bytes: &'a [u8], folder: &Path) -> Self {
        Self {
            name: name.to_owned(),
            bytes: bytes.into(),
            folder: folder.to_owned(),
            path: None,
        }
    }

    /// A scene file, or a built-in scene by its name. If a file has the name of a built-in scene, it is read.
    ///
    /// # Errors
    /// An unreadable file.
    pub fn load(name: impl AsRef<Path>) -> Result<SceneFile<'static>> {
        let path = name.as_ref();
        if let Some((name, text)) = (!path.is_file()).then(|| builtin::of_path(path)).flatten() {
            return Ok(SceneFile {
                name: name.to_owned(),
                bytes: text.as_bytes().to_vec().into(),
                folder: PathBuf::from("."),
                path: None,
            });
        }
        let name = path.display().to_string();
        let bytes = std::fs::read(path).map_err(|error| SceneError {
            file: name.clone(),
            line: 0,
            key: String::new(),
            value: String::new(),
            accepted: format!(
                "must be a readable scene file or one of the built-in scenes {}: {error}",
                builtin::names().join(", ")
            ),
        })?;
        Ok(SceneFile {
            name,
            bytes: bytes.into(),
            folder: path.parent().unwrap_or(Path::new(".")).to_owned(),
            path: Some(path.to_owned()),
        })
    }

    /// The value of the key `model`.
    ///
    /// # Errors
    /// A file that is not TOML, or no model that exists.
    pub fn model(&self, overrides: &Overrides) -> Result<&'static str> {
        self.read(overrides, |root, _, _| {
            Ok(root.optional_choice("model", &MODELS)?.unwrap_or("dem"))
        })
    }

    /// Read the tables of the file with some keys overridden: `read` gets the root, its plain form and the folder.
    ///
    /// # Errors
    /// A file that is not TOML, or what `read` refuses.
    pub(crate) fn read<T>(
        &self,
        overrides: &Overrides,
        read: impl FnOnce(&Table, &DeTable, &Path) -> Result<T>,
    ) -> Result<T> {
        let text = text_of(&self.name, &self.bytes)?;
        let breaks = Source::breaks(text);
        let source = Source {
            file: &self.name,
            text,
            breaks: &breaks,
            overrides: overrides.list(),
        };
        let table = DeTable::parse(text).map_err(|error| syntax_error(&source, &error))?;
        let table = overrides.apply(table.into_inner(), text.len() + 1)?;
        read(&Table::root(source, &table), &table, &self.folder)
    }

    /// SHA-256 of the file and the overrides.
    pub(crate) fn sha256(&self, overrides: &Overrides) -> String {
        hex(&overrides.sha256(&self.bytes))
    }

    /// The path, if it was read from one.
    pub(crate) fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }
}
