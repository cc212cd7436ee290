//! The table of equations and the errata name only what exists, and all of it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Top of the source tree.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A file of the source tree.
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

fn document(name: &str) -> String {
    read(&root().join("docs/thesis").join(name))
}

/// What stands between backticks.
fn quoted(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

/// A row of the table.
struct Row {
    numbers: Vec<u32>,
    items: Vec<String>,
    item_cell: String,
    formula: String,
    test_cell: String,
    errata: Vec<String>,
}

fn rows() -> Vec<Row> {
    let text = document("equations.md");
    let lines = text.lines().filter(|line| {
        line.strip_prefix("| ")
            .is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
    });
    lines.map(row).collect()
}

fn row(line: &str) -> Row {
    let cells: Vec<&str> = line.split('|').map(str::trim).collect();
    let ["", numbers, formula, items, tests, errata, ""] = cells[..] else {
        panic!("five columns expected: {line}");
    };
    let (first, last) = numbers.split_once('-').unwrap_or((numbers, numbers));
    let number = |text: &str| text.parse::<u32>().expect("a number");
    let ids = errata.split(", ").filter(|&id| id != "-");
    Row {
        numbers: (number(first)..=number(last)).collect(),
        items: quoted(items).into_iter().map(str::to_owned).collect(),
        item_cell: items.to_owned(),
        formula: formula.to_owned(),
        test_cell: tests.to_owned(),
        errata: ids.map(str::to_owned).collect(),
    }
}

/// Names of all functions that are tests, in the gate and in the kernel, and ids of all checks of the register.
fn tests() -> BTreeSet<String> {
    let topics = gouge_validation::checks::register();
    let checks = topics.iter().flat_map(|topic| &topic.checks);
    let mut names: BTreeSet<String> = checks.map(|check| check.id.to_owned()).collect();
    let mut files = rust_files(&root().join("tests"));
    files.extend(kernel_files());
    for file in files {
        let text = read(&file);
        let mut is_test = false;
        for line in text.lines().map(str::trim) {
            if line.starts_with("#[test]") {
                is_test = true;
            } else if let (true, Some(rest)) = (is_test, line.strip_prefix("fn ")) {
                names.insert(leading_name(rest).to_owned());
                is_test = false;
            }
        }
    }
    names
}

fn leading_name(text: &str) -> &str {
    let end = text
        .find(|c: char| !c.is_alphanumeric() && c != '_')
        .unwrap_or(text.len());
    &text[..end]
}

/// Sources of the kernel's crates.
pub const KERNELS: [&str; 2] = ["kernel/dem/src", "kernel/common/src"];

/// All source files of the kernel's crates.
pub fn kernel_files() -> Vec<PathBuf> {
    let folders = KERNELS.iter().map(|folder| root().join(folder));
    folders.flat_map(|folder| rust_files(&folder)).collect()
}

/// Files of a crate in which a path may be declared, and what is left of the path.
fn places<'a>(source: &Path, path: &'a str) -> (Vec<PathBuf>, Vec<&'a str>) {
    let top = read(&source.join("lib.rs"));
    let mut rest: Vec<&str> = path.split("::").collect();
    let first = rest[0];
    if top.lines().any(|line| line == format!("pub mod {first};")) {
        rest.remove(0);
        return (module_files(source, first), rest);
    }
    // What the crate itself re-exports is declared in one of its private modules.
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
fn exists(path: &str) -> bool {
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

/// Whether the documentation of an item holds an example.
fn has_example(path: &str) -> bool {
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

fn headings() -> BTreeSet<String> {
    let text = document("errata.md");
    let ids = text.lines().filter_map(|line| line.strip_prefix("## E"));
    let ids: Vec<String> = ids.map(|rest| format!("E{}", leading_name(rest))).collect();
    let unique: BTreeSet<String> = ids.iter().cloned().collect();
    assert_eq!(ids.len(), unique.len(), "a section appears twice");
    unique
}

/// Erratum ids in a text: an E that follows no letter or digit, and digits.
fn cited(text: &str) -> BTreeSet<String> {
    let mut ids = BTreeSet::new();
    let mut before = ' ';
    for (at, c) in text.char_indices() {
        let digits: String = text[at + c.len_utf8()..]
            .chars()
            .take_while(char::is_ascii_digit)
            .collect();
        if c == 'E' && !before.is_alphanumeric() && !digits.is_empty() {
            ids.insert(format!("E{digits}"));
        }
        before = c;
    }
    ids
}

#[test]
fn every_numbered_equation_has_exactly_one_row() {
    let mut seen = BTreeMap::new();
    for number in rows().iter().flat_map(|row| row.numbers.clone()) {
        *seen.entry(number).or_insert(0) += 1;
    }
    for number in 1..=137 {
        assert_eq!(seen.remove(&number), Some(1), "rows for equation {number}");
    }
    assert!(
        seen.is_empty(),
        "rows for equations that there are not: {seen:?}"
    );
}

#[test]
fn the_items_and_tests_of_the_table_exist() {
    let tests = tests();
    for row in rows() {
        let numbers = &row.numbers;
        if row.items.is_empty() {
            assert_eq!(row.item_cell, "-", "{numbers:?}");
            assert!(
                row.formula.starts_with("not implemented: "),
                "{numbers:?}: why not?"
            );
            continue;
        }
        for item in &row.items {
            assert!(exists(item), "{numbers:?}: the kernel has no public {item}");
        }
        if row.test_cell == "doctest" {
            assert!(
                row.items.iter().any(|item| has_example(item)),
                "{numbers:?}: no example"
            );
            continue;
        }
        let named = quoted(&row.test_cell);
        assert!(!named.is_empty(), "{numbers:?}: no test");
        for name in named {
            let is_doctest = name == "doctest" && row.items.iter().any(|item| has_example(item));
            assert!(
                is_doctest || tests.contains(name),
                "{numbers:?}: there is no test {name}"
            );
        }
    }
}

#[test]
fn every_cited_erratum_has_its_section() {
    let headings = headings();
    for row in rows() {
        for id in &row.errata {
            assert!(headings.contains(id), "{:?} cites {id}", row.numbers);
        }
    }
    for file in kernel_files() {
        let text = read(&file);
        let comments = text
            .lines()
            .filter(|line| line.trim_start().starts_with("//"));
        for id in comments.flat_map(cited) {
            assert!(headings.contains(&id), "{} cites {id}", file.display());
        }
    }
    let documents = fs::read_dir(root().join("docs")).expect("readable");
    for file in documents.map(|entry| entry.expect("readable").path()) {
        if file.extension().is_some_and(|extension| extension == "md") {
            for id in cited(&read(&file)) {
                assert!(headings.contains(&id), "{} cites {id}", file.display());
            }
        }
    }
}

#[test]
fn every_erratum_names_its_item_and_its_test() {
    let (text, tests) = (document("errata.md"), tests());
    for section in text.split("\n## E").skip(1) {
        let id = leading_name(section);
        let line = |start: &str| {
            let mut lines = section.lines().filter_map(|line| line.strip_prefix(start));
            match (lines.next(), lines.next()) {
                (Some(line), None) => line,
                _ => panic!("E{id} needs exactly one line with {start}"),
            }
        };
        let items = line("Item: ");
        for item in quoted(items) {
            assert!(exists(item), "E{id}: the kernel has no public {item}");
        }
        assert!(items == "-" || !quoted(items).is_empty(), "E{id}");
        let test = line("Test: ");
        for name in quoted(test) {
            assert!(tests.contains(name), "E{id}: there is no test {name}");
        }
        let is_stated = test == "doctest"
            || test
                .strip_prefix("no test: ")
                .is_some_and(|reason| !reason.is_empty());
        assert!(
            is_stated || !quoted(test).is_empty(),
            "E{id}: no test and no reason"
        );
    }
}
