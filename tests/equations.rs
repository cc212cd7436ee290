//! Citations are valid: the table of equations and the errata of each source name existing items and tests, and all
//! equations; checks, comments and documents cite only existing equations and errata.

use crate::sources::{
    exists, has_example, kernel_files, leading_name, quoted, read, root, rust_files,
};
use gouge_validation::checks::{Citation, Evidence, Source, register};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

/// The documents of a source in its folder of `docs/`.
struct Document {
    source: String,
    /// The table of equations.
    equations: String,
    /// The errata, if there are any.
    errata: String,
}

/// All sources.
fn documents() -> Vec<Document> {
    let of = |source: Source| {
        let folder = root().join("docs").join(source.folder());
        Document {
            source: source.name().to_owned(),
            equations: read(&folder.join("equations.md")),
            errata: fs::read_to_string(folder.join("errata.md")).unwrap_or_default(),
        }
    };
    Source::ALL.map(of).into()
}

/// A row of a table of equations.
struct Row {
    numbers: Vec<String>,
    items: Vec<String>,
    item_cell: String,
    formula: String,
    test_cell: String,
    errata: Vec<String>,
}

impl Document {
    /// Rows of the table of numbered equations.
    fn rows(&self) -> Vec<Row> {
        let below = self.lines_from("| equation |");
        below.map(|line| self.row(line, numbers)).collect()
    }

    /// Rows of the table above it of sections and tables without a number, if there is one.
    fn unnumbered_rows(&self) -> Vec<Row> {
        let lines = self.lines_from("| place |");
        let own = lines.take_while(|line| !line.starts_with("| equation |"));
        let place = |place: &str| vec![place.to_owned()];
        own.map(|line| self.row(line, place)).collect()
    }

    fn all_rows(&self) -> Vec<Row> {
        let mut rows = self.unnumbered_rows();
        rows.extend(self.rows());
        rows
    }

    /// Rows of tables below the one that starts like this.
    fn lines_from(&self, head: &'static str) -> impl Iterator<Item = &str> {
        let lines = self.equations.lines().filter(|line| line.starts_with("| "));
        lines
            .skip_while(move |line| !line.starts_with(head))
            .skip(1)
    }

    fn row(&self, line: &str, numbers: impl Fn(&str) -> Vec<String>) -> Row {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let ["", equations, formula, items, tests, errata, ""] = cells[..] else {
            panic!("five columns expected: {line}");
        };
        let ids = errata.split(", ").filter(|&id| id != "-");
        Row {
            numbers: numbers(self.place(equations)),
            items: quoted(items).into_iter().map(str::to_owned).collect(),
            item_cell: items.to_owned(),
            formula: formula.to_owned(),
            test_cell: tests.to_owned(),
            errata: ids.map(|id| self.place(id).to_owned()).collect(),
        }
    }

    /// The place that a citation of this source cites.
    fn place<'a>(&self, citation: &'a str) -> &'a str {
        match citation.split_once(' ') {
            Some((source, place)) if source == self.source => place,
            _ => panic!("{citation} does not cite {}", self.source),
        }
    }

    /// Numbers of all equations of the source, as listed in the head of its table.
    fn numbered(&self) -> BTreeSet<String> {
        let mut lines = self.equations.lines();
        let line = lines.find_map(|line| line.strip_prefix("Numbered equations: "));
        let ranges = line.expect("numbered equations").trim_end_matches('.');
        ranges.split(", ").flat_map(numbers).collect()
    }

    /// Sections of the errata, by their ids.
    fn sections(&self) -> BTreeMap<String, &str> {
        let mut sections = BTreeMap::new();
        for section in self.errata.split("\n## ").skip(1) {
            let Some(rest) = section.strip_prefix(&format!("{} ", self.source)) else {
                assert!(
                    cited(section).next().is_none_or(|(_, at)| at > 0),
                    "{section}"
                );
                continue;
            };
            let twice = sections.insert(leading_name(rest).to_owned(), section);
            assert!(twice.is_none(), "the section {rest} exists twice");
        }
        sections
    }
}

/// Numbers of an equation or of a range of them: `(3.4)`, `(A17)-(A19)`.
fn numbers(place: &str) -> Vec<String> {
    let number = |text: &str| {
        let inside = text
            .strip_prefix('(')
            .and_then(|rest| rest.strip_suffix(')'));
        inside
            .unwrap_or_else(|| panic!("{text} is not the number of an equation"))
            .to_owned()
    };
    let Some((first, last)) = place.split_once('-') else {
        return vec![number(place)];
    };
    let (first, last) = (number(first), number(last));
    let counter = |text: &str| {
        let prefix = text.trim_end_matches(|c: char| c.is_ascii_digit()).len();
        let counted: u32 = text[prefix..].parse().expect("a number");
        (text[..prefix].to_owned(), counted)
    };
    let ((prefix, from), (other, to)) = (counter(&first), counter(&last));
    assert!(prefix == other && from < to, "{place} is not a range");
    (from..=to)
        .map(|number| format!("{prefix}{number}"))
        .collect()
}

/// Erratum ids of a text and their positions. An id is an E that does not follow a letter or digit, and digits.
fn cited(text: &str) -> impl Iterator<Item = (&str, usize)> {
    text.match_indices('E').filter_map(|(at, _)| {
        let digits = text[at + 1..].find(|c: char| !c.is_ascii_digit());
        let end = digits.map_or(text.len(), |digits| at + 1 + digits);
        let follows = text[..at].ends_with(char::is_alphanumeric);
        (end > at + 1 && !follows).then(|| (&text[at..end], at))
    })
}

/// The source of an erratum: the source named last before its position in the text.
fn source_before<'a>(text: &str, at: usize, sources: &[&'a str]) -> Option<&'a str> {
    let before = text[..at].to_lowercase();
    let place = |source: &&'a str| Some((before.rfind(source)?, *source));
    sources
        .iter()
        .filter_map(place)
        .max()
        .map(|(_, source)| source)
}

/// Names of all test functions of the gate and of the kernel, and ids of all checks of the register.
fn tests() -> BTreeSet<String> {
    let topics = register();
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

/// Texts that may cite errata, with their files: comments of the code and the pages of `docs/`.
fn prose() -> Vec<(PathBuf, String)> {
    let mut files = kernel_files();
    files.extend(rust_files(&root().join("validation/src")));
    let comments = files.into_iter().map(|file| {
        let text = read(&file);
        let lines = text.lines().map(str::trim_start);
        let lines: Vec<&str> = lines.filter(|line| line.starts_with("//")).collect();
        (file, lines.join(" "))
    });
    let entries = fs::read_dir(root().join("docs")).expect("readable");
    let pages = entries.map(|entry| entry.expect("readable").path());
    let pages = pages.filter(|file| file.extension().is_some_and(|extension| extension == "md"));
    comments
        .chain(pages.map(|file| (file.clone(), read(&file))))
        .collect()
}

#[test]
fn ranges_of_equations_are_written_out() {
    assert_eq!(numbers("(42)"), ["42"]);
    assert_eq!(numbers("(9)-(11)"), ["9", "10", "11"]);
    assert_eq!(numbers("(A9)-(A10)"), ["A9", "A10"]);
    assert_eq!(numbers("(3.4)-(3.5)"), ["3.4", "3.5"]);
}

#[test]
fn the_source_of_an_erratum_is_the_one_named_last_before_it() {
    let text = "As the thesis prints it (E1), not Azema E2; 1E3 and E are none.";
    let sources = ["azema", "thesis"];
    let found: Vec<_> = cited(text)
        .map(|(id, at)| (id, source_before(text, at, &sources)))
        .collect();
    assert_eq!(found, [("E1", Some("thesis")), ("E2", Some("azema"))]);
    assert_eq!(source_before("E1 of the thesis", 0, &sources), None);
}

#[test]
fn every_folder_with_a_table_of_equations_belongs_to_a_source() {
    let folders = fs::read_dir(root().join("docs")).expect("readable");
    let paths = folders.map(|entry| entry.expect("readable").path());
    let found: BTreeSet<String> = paths
        .filter(|folder| folder.join("equations.md").is_file())
        .map(|folder| {
            folder
                .file_name()
                .expect("a name")
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    let expected = Source::ALL.map(|source| source.folder().to_owned());
    assert_eq!(found, BTreeSet::from(expected));
}

#[test]
fn every_numbered_equation_has_exactly_one_row() {
    for document in documents() {
        let mut seen = BTreeSet::new();
        for number in document.rows().into_iter().flat_map(|row| row.numbers) {
            assert!(seen.insert(number.clone()), "two rows for ({number})");
        }
        assert_eq!(seen, document.numbered(), "{}", document.source);
    }
}

#[test]
fn items_and_tests_named_by_the_table_exist() {
    let tests = tests();
    let documents = documents();
    for row in documents.iter().flat_map(Document::all_rows) {
        let numbers = &row.numbers;
        if row.items.is_empty() {
            assert_eq!(row.item_cell, "-", "{numbers:?}");
            let is_explained = row.formula.starts_with("not implemented: ");
            assert!(
                is_explained,
                "{numbers:?}: the reason for 'not implemented' is missing"
            );
            continue;
        }
        for item in &row.items {
            assert!(exists(item), "{numbers:?}: the kernel has no public {item}");
        }
        let has_doctest = || row.items.iter().any(|item| has_example(item));
        if row.test_cell == "doctest" {
            assert!(
                has_doctest(),
                "{numbers:?}: the item has no documentation example"
            );
            continue;
        }
        let named = quoted(&row.test_cell);
        assert!(!named.is_empty(), "{numbers:?}: no test is named");
        for name in named {
            let is_test = tests.contains(name) || name == "doctest" && has_doctest();
            assert!(is_test, "{numbers:?}: there is no test {name}");
        }
    }
}

#[test]
fn every_cited_erratum_has_its_section() {
    let documents = documents();
    let mut errata = BTreeSet::new();
    for document in &documents {
        let (sections, source) = (document.sections(), document.source.as_str());
        for row in document.all_rows() {
            for id in &row.errata {
                assert!(sections.contains_key(id), "{:?} cites {id}", row.numbers);
            }
        }
        errata.extend(sections.into_keys().map(|id| (source, id)));
    }
    let sources: Vec<&str> = documents.iter().map(|one| one.source.as_str()).collect();
    for (file, text) in prose() {
        for (id, at) in cited(&text) {
            let source = source_before(&text, at, &sources);
            let source = source
                .unwrap_or_else(|| panic!("{}: no source is named before {id}", file.display()));
            let is_there = errata.contains(&(source, id.to_owned()));
            assert!(is_there, "{} cites {source} {id}", file.display());
        }
    }
}

#[test]
fn every_erratum_cited_with_its_source_has_its_section() {
    let documents = documents();
    let texts = prose();
    let pairs = documents
        .iter()
        .flat_map(|one| texts.iter().map(move |text| (one, text)));
    for (document, (file, text)) in pairs {
        let (sections, name) = (document.sections(), format!("{} ", document.source));
        for (at, _) in text.match_indices(&name) {
            let id = leading_name(&text[at + name.len()..]);
            let is_id = id.starts_with(['C', 'E', 'P', 'Q'])
                && id.len() > 1
                && id[1..].chars().all(|c| c.is_ascii_digit());
            assert!(
                !is_id || sections.contains_key(id),
                "{} cites {name}{id}",
                file.display()
            );
        }
    }
}

#[test]
fn every_erratum_names_its_item_and_its_test() {
    let tests = tests();
    for (id, section) in documents().iter().flat_map(Document::sections) {
        let line = |start: &str| {
            let mut lines = section.lines().filter_map(|line| line.strip_prefix(start));
            match (lines.next(), lines.next()) {
                (Some(line), None) => line,
                _ => panic!("{id} needs exactly one line with {start}"),
            }
        };
        let items = line("Item: ");
        for item in quoted(items) {
            assert!(exists(item), "{id}: the kernel has no public {item}");
        }
        assert!(items == "-" || !quoted(items).is_empty(), "{id}");
        let test = line("Test: ");
        for name in quoted(test) {
            assert!(tests.contains(name), "{id}: there is no test {name}");
        }
        let reason = test.strip_prefix("no test: ");
        let is_stated = test == "doctest" || reason.is_some_and(|reason| !reason.is_empty());
        let is_covered = is_stated || !quoted(test).is_empty();
        assert!(is_covered, "{id}: neither a test nor a reason for none");
    }
}

#[test]
fn checks_cite_only_existing_equations() {
    let documents = documents();
    let is_known = |citation: &Citation| {
        let of = |document: &&Document| document.source == citation.source.name();
        let document = documents.iter().find(of).expect("a document");
        let (place, numbered) = (citation.place, document.numbered());
        match place.split_once(' ') {
            Some(("section" | "figure", number)) => {
                number.starts_with(|c: char| c.is_ascii_digit())
            }
            Some(_) => false,
            None if place.starts_with(['E', 'C', 'P', 'Q']) => {
                document.sections().contains_key(place)
            }
            None => numbers(place)
                .iter()
                .all(|number| numbered.contains(number)),
        }
    };
    let topics = register();
    for check in topics.iter().flat_map(|topic| &topic.checks) {
        for citation in check.equations.citations() {
            assert!(is_known(citation), "{} cites {citation}", check.id);
        }
    }
}

#[test]
fn stored_cases_cite_in_the_form_of_checks() {
    for path in gouge_runner::references::paths() {
        let case = gouge_validation::references::case(&path).expect("a case");
        let read = Evidence::parse(&case.equations).map(|evidence| evidence.to_string());
        assert_eq!(read.as_deref(), Some(case.equations.as_str()), "{path}");
    }
}
