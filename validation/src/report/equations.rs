//! Every numbered equation with the checks that stand for it.

use super::fold::{Fold, counted, link};
use super::{Entry, Record};
use crate::checks::Source;
use maud::{Markup, html};

/// The table of equations of a source.
fn table(source: Source) -> &'static str {
    match source {
        Source::Thesis => include_str!("../../../docs/thesis/equations.md"),
        Source::Azema => include_str!("../../../docs/contact-dynamics/equations.md"),
        Source::Peridem => include_str!("../../../docs/peridem/equations.md"),
    }
}

/// The source in words.
pub fn title(source: Source) -> &'static str {
    match source {
        Source::Thesis => "the thesis",
        Source::Azema => "Azéma, Estrada and Radjai",
        Source::Peridem => "Bhattacharya and Lipton",
    }
}

/// Largest number of equations that a check stands for. One that covers more, such as a symmetry of the
/// whole model, says little about each.
const MOST: usize = 20;

/// A numbered equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equation {
    /// Its source.
    pub source: Source,
    /// Its number.
    pub number: String,
    /// The number of the equation above with the same entry in the table, if there is one.
    pub joins: Option<String>,
    /// The formula as implemented, or why it is not.
    pub formula: &'static str,
    /// Items of the kernel.
    pub items: Vec<&'static str>,
    /// Tests of `cargo test`.
    pub tests: Vec<&'static str>,
}

impl Equation {
    /// Whether the kernel implements it.
    pub fn is_implemented(&self) -> bool {
        !self.items.is_empty()
    }

    /// The anchor of its row.
    pub fn anchor(&self) -> String {
        anchor(self.source, &self.number)
    }

    /// The checks among the given ones that stand for it, those that cover the fewest equations first.
    fn checks<'a>(&self, entries: &'a [Entry]) -> Vec<&'a Record> {
        let records = entries.iter().map(|entry| &entry.record);
        let own = records.filter(|record| !is_broad(record) && self.is_covered(record));
        let mut own: Vec<&Record> = own.collect();
        own.sort_by_key(|record| covered(record));
        own
    }

    fn is_covered(&self, record: &Record) -> bool {
        let mut citations = record.equations.citations().iter();
        self.is_implemented()
            && citations.any(|citation| {
                citation.source == self.source && citation.equations().contains(&self.number)
            })
    }
}

/// Number of equations that a check covers.
fn covered(record: &Record) -> usize {
    let citations = record.equations.citations().iter();
    citations.map(|citation| citation.equations().len()).sum()
}

/// Whether a check covers too many equations to stand for each.
fn is_broad(record: &Record) -> bool {
    covered(record) > MOST
}

/// The anchor of the row of an equation.
pub fn anchor(source: Source, number: &str) -> String {
    format!("equation-{}-{number}", source.name())
}

/// All equations of a source.
pub fn equations(source: Source) -> Vec<Equation> {
    let lines = table(source).lines().filter(|line| line.starts_with("| "));
    let below = lines.skip_while(|line| !line.starts_with("| equation |"));
    below
        .skip(1)
        .flat_map(|line| of_line(source, line))
        .collect()
}

/// The equations of a line of the table: a single one or a range.
fn of_line(source: Source, line: &'static str) -> Vec<Equation> {
    let cells: Vec<&str> = line.split('|').map(str::trim).collect();
    let [_, citation, formula, items, tests, ..] = cells[..] else {
        return Vec::new();
    };
    let place = citation.split_once(' ').map_or("", |(_, place)| place);
    let numbers = crate::checks::Citation { source, place }.equations();
    let first = numbers.first().cloned();
    let equation = |number: String| Equation {
        source,
        joins: first.clone().filter(|first| *first != number),
        number,
        formula,
        items: quoted(items),
        tests: tests_of(tests),
    };
    numbers.into_iter().map(equation).collect()
}

/// The names of tests in a cell; an example in the documentation is named `doctest`.
fn tests_of(cell: &'static str) -> Vec<&'static str> {
    match quoted(cell) {
        none if none.is_empty() && cell == "doctest" => vec![cell],
        names => names,
    }
}

/// The texts between backticks.
fn quoted(text: &'static str) -> Vec<&'static str> {
    text.split('`').skip(1).step_by(2).collect()
}

/// Numbers of equations by what stands for them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coverage {
    /// All.
    pub all: usize,
    /// Those with at least one check.
    pub checked: usize,
    /// Those without a check that a test of `cargo test` covers.
    pub tested: usize,
    /// Those that are not implemented.
    pub missing: usize,
}

impl Coverage {
    /// That of all equations of a source by some checks.
    pub fn of(source: Source, entries: &[Entry]) -> Self {
        let mut coverage = Self::default();
        for equation in equations(source) {
            coverage.all += 1;
            match equation.checks(entries).is_empty() {
                false => coverage.checked += 1,
                true if equation.is_implemented() => coverage.tested += 1,
                true => coverage.missing += 1,
            }
        }
        coverage
    }
}

/// An equation and the checks that stand for it.
type Covered<'a> = (Equation, Vec<&'a Record>);

/// The chapter; without all checks it shows only the equations that the given ones cover.
pub fn chapter(entries: &[Entry], is_complete: bool) -> Markup {
    let rows = Source::ALL.map(|source| (source, rows(source, entries, is_complete)));
    let number = rows.iter().map(|(_, rows)| rows.len()).sum();
    Fold {
        id: "equations",
        title: "Equations",
        count: &counted(number, "numbered equation"),
        class: "lookup",
    }
    .around(html! {
        p.about {
            "Every numbered equation, the code that implements it, and the checks of this report that stand for it. "
            "If no check does, the row says why, or names the tests of " code { "cargo test" } " that do. "
            "Formulas are the implemented ones, from the files " code { "equations.md" } " in " code { "docs/" } ", which also list the errata."
        }
        (broad(entries))
        @for (source, rows) in &rows { @if !rows.is_empty() { (listed(*source, rows)) } }
    })
}

fn rows(source: Source, entries: &[Entry], is_complete: bool) -> Vec<Covered<'_>> {
    let covered = |equation: Equation| {
        let checks = equation.checks(entries);
        (equation, checks)
    };
    let all = equations(source).into_iter().map(covered);
    all.filter(|(_, checks)| is_complete || !checks.is_empty())
        .collect()
}

fn listed(source: Source, rows: &[Covered]) -> Markup {
    html! {
        h3 { "Equations of " (title(source)) }
        div.data {
            table.equations {
                thead { tr { th { "equation" } th { "formula as implemented" } th { "code" } th { "checks" } } }
                tbody { @for (equation, checks) in rows { (row(equation, checks)) } }
            }
        }
    }
}

/// The checks that stand for no single equation.
fn broad(entries: &[Entry]) -> Markup {
    let records = entries.iter().map(|entry| &entry.record);
    let broad: Vec<&Record> = records.filter(|record| is_broad(record)).collect();
    html! {
        @if !broad.is_empty() {
            p.about {
                "Checks that cover more than " (MOST) " equations, such as a symmetry of the whole model, are neither in the rows nor counted: "
                @for check in &broad { (link(check)) " " }
            }
        }
    }
}

fn row(equation: &Equation, checks: &[&Record]) -> Markup {
    html! {
        tr id=(equation.anchor()) {
            td { "(" (equation.number) ")" }
            td {
                @match &equation.joins {
                    Some(first) => { "see (" (first) ")" }
                    None => { (equation.formula) }
                }
            }
            td { @if equation.joins.is_none() { @for item in &equation.items { code { (item) } " " } } }
            td { (standing(equation, checks)) }
        }
    }
}

/// What stands for an equation: checks, or tests, or the reason why nothing does.
fn standing(equation: &Equation, checks: &[&Record]) -> Markup {
    html! {
        @for check in checks { (link(check)) " " }
        @if !equation.is_implemented() {
            "No check: " (equation.formula) "."
        } @else if checks.is_empty() {
            "No check of its own; " code { "cargo test" } ": "
            @for test in &equation.tests { code { (test) } " " }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::examples::{covering, entry};
    use super::{Coverage, chapter, equations};
    use crate::checks::Source;
    use std::collections::BTreeSet;

    #[test]
    fn every_equation_of_the_thesis_has_one_row() {
        let all = equations(Source::Thesis).into_iter();
        let numbers: Vec<String> = all.map(|one| one.number).collect();
        let distinct: BTreeSet<&String> = numbers.iter().collect();
        assert_eq!(distinct.len(), numbers.len());
        let expected: Vec<String> = (1..=137).map(|number| number.to_string()).collect();
        assert_eq!(numbers, expected);
        let page = chapter(&[], true).into_string();
        assert_eq!(page.matches("<tr id=\"equation-thesis-").count(), 137);
    }

    #[test]
    fn every_equation_of_contact_dynamics_has_one_row() {
        let all = equations(Source::Azema).into_iter();
        let numbers: Vec<String> = all.map(|one| one.number).collect();
        let plain = (1..=10).map(|number| number.to_string());
        let expected: Vec<String> = plain.chain((1..=32).map(|n| format!("A{n}"))).collect();
        assert_eq!(numbers, expected);
        let page = chapter(&[], true).into_string();
        assert_eq!(page.matches("<tr id=\"equation-azema-").count(), 42);
    }

    #[test]
    fn every_equation_of_peridynamic_grains_has_one_row() {
        let all = equations(Source::Peridem).into_iter();
        let numbers: Vec<String> = all.map(|one| one.number).collect();
        let contact = (1..=9).map(|number| format!("4.{number}"));
        let earlier = ["2.1", "3.1", "3.2"].map(str::to_owned).into_iter();
        assert_eq!(numbers, earlier.chain(contact).collect::<Vec<_>>());
    }

    #[test]
    fn a_row_links_to_its_checks_and_an_equation_without_one_says_so() {
        let entries = [
            entry(covering("laws.some", "(34)-(36), E15")),
            entry(covering("laws.other", "(36)")),
            entry(covering("laws.all", "(3)-(58)")),
        ];
        let page = chapter(&entries, true).into_string();
        let row = |number: u32| {
            let start = format!("<tr id=\"equation-thesis-{number}\">");
            let from = page.split_once(&start).map_or("", |(_, rest)| rest);
            from.split_once("</tr>")
                .map_or("", |(row, _)| row)
                .to_owned()
        };
        let linked = |number, id: &str| row(number).contains(&format!("href=\"#{id}\""));
        assert!(linked(35, "laws.some") && !linked(35, "laws.other"));
        assert!(linked(36, "laws.some") && linked(36, "laws.other"));
        assert!(!row(36).contains("No check"));
        assert!(page.contains("href=\"#laws.all\"") && !linked(33, "laws.all"));
        let place = |id: &str| row(36).find(id);
        assert!(place("laws.other") < place("laws.some"));
        assert!(
            row(33).contains("No check of its own; ")
                && row(33).contains("a_new_bond_is_unstrained")
        );
        assert!(row(23).contains("No check: not implemented: the area in three dimensions"));
        assert!(row(15).contains("see (14)"));
        let part = chapter(&entries, false).into_string();
        assert_eq!(part.matches("<tr id=").count(), 3);
    }

    #[test]
    fn coverage_counts_each_equation_once() {
        let entries = [
            entry(covering("laws.some", "(34)-(36)")),
            entry(covering("laws.other", "(36), E1")),
            entry(covering("laws.all", "(3)-(58)")),
        ];
        let found = Coverage::of(Source::Thesis, &entries);
        assert_eq!((found.all, found.checked, found.missing), (137, 3, 1));
        assert_eq!(found.checked + found.tested + found.missing, found.all);
    }
}
