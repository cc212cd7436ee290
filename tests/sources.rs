//! Files of the source tree, and the items that they declare.

use std::fs;
use std::path::{Path, PathBuf};

/// Root of the source tree.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Text of a file of the source tree.
pub fn read(path: &Path) -> String {
    match fs::read_to_string(path) {
        Ok(text) => text,
        Err(error) => panic!("{}: {error}", path.display()),
    }
}

/// All Rust files under a folder, in order.
pub fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let entries = fs::read_dir(folder).expect("the folder is readable");
    for entry in entries.map(|entry| entry.expect("readable").path()) {
        if entry.is_dir() {
            files.extend(rust_files(&entry));
        } else if entry.extension().is_some_and(|extension| extension == "rs") {
            files.push(entry);
        }
    }
    files.sort();
    files
}

/// The texts between backticks.
pub fn quoted(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

/// Sources of the kernel's crates.
pub const KERNELS: [&str; 4] = [
    "kernel/dem/src",
    "kernel/contact-dynamics/src",
    "kernel/peridem/src",
    "kernel/common/src",
];

/// All source files of the kernel's crates.
pub fn kernel_files() -> Vec<PathBuf> {
    let folders = KERNELS.iter().map(|folder| root().join(folder));
    folders.flat_map(|folder| rust_files(&folder)).collect()
}

/// The name at the beginning of a text.
pub fn leading_name(text: &str) -> &str {
    let end = text
        .find(|c: char| !c.is_alphanumeric() && c != '_')
        .unwrap_or(text.len());
    &text[..end]
}

/// Files of a crate in which a path may be declared, and the rest of the path.
fn places<'a>(source: &Path, path: &'a str) -> (Vec<PathBuf>, Vec<&'a str>) {
    let top = read(&source.join("lib.rs"));
    let mut rest: Vec<&str> = path.split("::").collect();
    let first = rest[0];
    if top.lines().any(|line| line == format!("pub mod {first};")) {
        rest.remove(0);
        return (module_files(source, first), rest);
    }
    // Items re-exported by the crate root are declared in one of its private modules.
    let private = top
        .lines()
        .filter_map(|line| line.strip_prefix("mod ")?.strip_suffix(';'));
    let files = private
        .flat_map(|module| module_files(source, module))
        .collect();
    (files, rest)
}

fn module_files(source: &Path, module: &str) -> Vec<PathBuf> {
    let file = source.join(module).with_extension("rs");
    if file.is_file() {
        vec![file]
    } else {
        rust_files(&source.join(module))
    }
}

/// Whether a line declares a public item.
fn declares(line: &str, name: &str) -> bool {
    let line = line.trim_start();
    let Some(rest) = line.strip_prefix("pub ") else {
        return false;
    };
    let rest = rest.strip_prefix("const fn ").map_or(rest, |_| &rest[6..]);
    ["fn ", "struct ", "enum ", "trait ", "const ", "mod "]
        .iter()
        .any(|kind| {
            rest.strip_prefix(kind)
                .is_some_and(|r| leading_name(r) == name)
        })
}

/// Whether a line declares a public field, a method, or a variant of an enumeration.
fn declares_member(line: &str, name: &str) -> bool {
    let line = line.trim_start();
    let field = line
        .strip_prefix("pub ")
        .is_some_and(|rest| leading_name(rest) == name && rest[name.len()..].starts_with(':'));
    let method = line
        .strip_prefix("fn ")
        .is_some_and(|rest| leading_name(rest) == name);
    let variant = leading_name(line) == name
        && name.starts_with(|c: char| c.is_uppercase())
        && [",", " {", "("]
            .iter()
            .any(|end| line[name.len()..].starts_with(end));
    field || method || variant || declares(line, name)
}

/// Whether a path leads to a public item of a kernel crate, or a public member of one.
pub fn exists(path: &str) -> bool {
    let mut sources = KERNELS.iter().map(|source| root().join(source));
    sources.any(|source| exists_in(&source, path))
}

fn exists_in(source: &Path, path: &str) -> bool {
    let (files, rest) = places(source, path);
    let texts: Vec<String> = files.iter().map(|file| read(file)).collect();
    let mut lines = texts.iter().flat_map(|text| text.lines());
    match rest[..] {
        [item] => lines.any(|line| declares(line, item)),
        [item, member] => {
            lines.any(|line| declares(line, item))
                && texts
                    .iter()
                    .flat_map(|text| text.lines())
                    .any(|line| declares_member(line, member))
        }
        _ => false,
    }
}

/// Whether the documentation of an item contains an example.
pub fn has_example(path: &str) -> bool {
    let mut sources = KERNELS.iter().map(|source| root().join(source));
    sources.any(|source| has_example_in(&source, path))
}

fn has_example_in(source: &Path, path: &str) -> bool {
    let (files, rest) = places(source, path);
    let Some(item) = rest.last() else {
        return false;
    };
    files.iter().any(|file| {
        let text = read(file);
        let lines: Vec<&str> = text.lines().map(str::trim).collect();
        let at = lines.iter().position(|line| declares(line, item));
        at.is_some_and(|at| {
            let above = lines[..at].iter().rev();
            above
                .take_while(|line| line.starts_with("///") || line.starts_with("#["))
                .any(|line| line.starts_with("/// ```"))
        })
    })
}
