//! A copy of the workspace whose kernel holds switches for deliberate faults.

use crate::Outcome;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Folder of the lowest crate of the kernel, which contains the module of the switches.
pub const COMMON: &str = "kernel/common/src";

/// Names that are not copied.
const LEFT_BEHIND: [&str; 3] = ["target", ".git", "mutation"];

/// A source file.
pub struct Source {
    /// Path from the root of the workspace.
    pub path: PathBuf,
    /// Text of the file.
    pub text: String,
    /// The parsed text.
    pub file: syn::File,
}

impl Source {
    /// The path as a string.
    pub fn name(&self) -> String {
        self.path.to_string_lossy().into_owned()
    }
}

/// Read the sources below some folders, one folder after the other.
///
/// # Errors
/// A file that cannot be read or parsed.
pub fn parse_all(root: &Path, folders: &[&str]) -> Outcome<Vec<Source>> {
    let mut sources = Vec::new();
    for folder in folders {
        sources.extend(parse(root, folder)?);
    }
    Ok(sources)
}

/// Read the sources below a folder, in order of their paths.
///
/// # Errors
/// A file that cannot be read or parsed.
fn parse(root: &Path, folder: &str) -> Outcome<Vec<Source>> {
    let mut paths = Vec::new();
    list(&root.join(folder), &mut paths)?;
    paths.retain(|path| path.extension().is_some_and(|end| end == "rs"));
    paths.sort();
    let mut parsed = Vec::new();
    for path in paths {
        let text = fs::read_to_string(&path)?;
        let file = syn::parse_file(&text)?;
        let path = path.strip_prefix(root)?.to_owned();
        parsed.push(Source { path, text, file });
    }
    Ok(parsed)
}

/// The crate that a file of the kernel calls for its switches.
pub fn library(path: &Path) -> &'static str {
    if path.starts_with(COMMON) {
        "crate"
    } else {
        "gouge_common"
    }
}

/// Copy the workspace with changed texts of some files and with the given number of switches. Files that do not change
/// are not touched, so that nothing is compiled twice.
///
/// # Errors
/// A file that cannot be read or written.
pub fn plant(
    root: &Path,
    copy: &Path,
    texts: &HashMap<PathBuf, String>,
    switches: usize,
) -> Outcome<()> {
    let mut paths = Vec::new();
    list(root, &mut paths)?;
    let module_path = copy.join(COMMON).join("perturbation.rs");
    remove_others(root, copy, &module_path)?;
    for path in paths {
        let inside = path.strip_prefix(root)?;
        let mut bytes = match texts.get(inside) {
            Some(text) => text.clone().into_bytes(),
            None => fs::read(&path)?,
        };
        if inside == Path::new("Cargo.toml") {
            let text = String::from_utf8(bytes)?;
            bytes = text.replace("    \"tools/mutation\",\n", "").into_bytes();
        } else if inside == Path::new(COMMON).join("lib.rs") {
            bytes.extend(b"\n#[allow(missing_docs)]\npub mod perturbation;\n");
        }
        write(&copy.join(inside), &bytes)?;
    }
    let module =
        include_str!("perturbation.rs.txt").replace("NUMBER_OF_FAULTS", &switches.to_string());
    write(&module_path, module.as_bytes())
}

/// Remove files of the copy that no longer exist in the workspace.
fn remove_others(root: &Path, copy: &Path, kept: &Path) -> Outcome<()> {
    let mut paths = Vec::new();
    if copy.exists() {
        list(copy, &mut paths)?;
    }
    for path in paths {
        if path != kept && !root.join(path.strip_prefix(copy)?).exists() {
            fs::remove_file(path)?;
        }
    }
    Ok(())
}

fn write(path: &Path, bytes: &[u8]) -> Outcome<()> {
    if fs::read(path).is_ok_and(|old| old == bytes) {
        return Ok(());
    }
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    Ok(fs::write(path, bytes)?)
}

/// All files below a folder.
fn list(folder: &Path, found: &mut Vec<PathBuf>) -> Outcome<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let is_left = LEFT_BEHIND.iter().any(|name| entry.file_name() == *name);
        if entry.file_type()?.is_dir() {
            if !is_left {
                list(&entry.path(), found)?;
            }
        } else if !is_left {
            found.push(entry.path());
        }
    }
    Ok(())
}
