//! The page for people.

use super::article::article;
use super::first_page::{Facts, first_page};
use super::fold::{Fold, counted, decimal, link, ratio};
use super::judged::{Digits, digits, fewest_digits_first, used, weakest_first};
use super::{Entry, Picture, Record, equations, original, pictures, sources, speed};
use crate::checks::Topic;
use gouge_page::styled_page;
use maud::{Markup, PreEscaped, html};
use std::collections::BTreeMap;

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// Length of the lists of weakest checks.
const WEAKEST: usize = 10;

/// A chapter with the checks that were run.
struct Shown<'a> {
    topic: &'a Topic,
    entries: Vec<&'a Entry>,
}

impl Shown<'_> {
    fn records(&self) -> impl Iterator<Item = &Record> {
        self.entries.iter().map(|entry| &entry.record)
    }
    fn passed(&self) -> usize {
        self.records().filter(|record| record.passed()).count()
    }
    fn largest(&self) -> f64 {
        self.records().map(used).fold(0.0, f64::max)
    }
    fn seconds(&self) -> f64 {
        self.records().map(|record| record.seconds).sum()
    }
}

/// The whole page.
pub fn page(topics: &[Topic], entries: &[Entry], drawn: &[Picture], facts: &Facts) -> Markup {
    let shown: Vec<Shown> = topics
        .iter()
        .map(|topic| of_topic(topic, entries))
        .filter(|chapter| !chapter.entries.is_empty())
        .collect();
    let body = html! {
        (first_page(entries, facts))
        (contents(&shown, !drawn.is_empty()))
        (weakest(entries))
        (how_to_read())
        (filters(&shown))
        @for shown in &shown { (chapter(shown)) }
        @if !drawn.is_empty() {
            (pictures::chapter(drawn))
            (original::chapter())
            (speed::chapter())
        }
        (equations::chapter(entries, facts.is_complete))
        (code(entries))
        script { (PreEscaped(SCRIPT)) }
    };
    styled_page("gouge: verification report", STYLE, body)
}

fn of_topic<'a>(topic: &'a Topic, entries: &'a [Entry]) -> Shown<'a> {
    let belongs = |entry: &&Entry| topic.checks.iter().any(|check| check.id == entry.record.id);
    let entries = entries.iter().filter(belongs).collect();
    Shown { topic, entries }
}

fn contents(shown: &[Shown], is_complete: bool) -> Markup {
    let others: &[(&str, &str)] = match is_complete {
        true => &[
            ("scenes", "Built-in scenes"),
            ("original", "The author's program"),
            ("speed", "Speed"),
        ],
        false => &[],
    };
    html! {
        nav {
            h2 { "Contents" }
            p {
                a href="#weakest" { "Weakest checks" } " · " a href="#how" { "How to read this page" } " · "
                a href="#equations" { "Equations with their checks" } " · " a href="#code" { "Code of the checks" }
                @for (id, title) in others { " · " a href=(format!("#{id}")) { (title) } }
            }
            table.summary {
                thead { tr {
                    th { "chapter" } th.n { "checks" } th.n { "pass" } th.n { "largest error / tolerance" }
                    th.n { "checks with digits" } th.n { "fewest digits" } th.n { "median digits" } th.n { "time / s" }
                } }
                tbody { @for shown in shown { (contents_row(shown)) } }
            }
        }
    }
}

fn contents_row(shown: &Shown) -> Markup {
    let digits = Digits::of(shown.records());
    html! {
        tr {
            td { a href=(format!("#{}", shown.topic.id)) { (shown.topic.title) } }
            td.n { (shown.entries.len()) }
            td.n { (shown.passed()) }
            td.n { (ratio(shown.largest())) }
            td.n { (digits.as_ref().map_or(0, |digits| digits.checks)) }
            td.n { (decimal(digits.as_ref().map(|digits| digits.fewest))) }
            td.n { (decimal(digits.as_ref().map(|digits| digits.median))) }
            td.n.time { (format!("{:.1}", shown.seconds())) }
        }
    }
}

/// The checks that failed or came closest to failing, and those with the fewest digits.
fn weakest(entries: &[Entry]) -> Markup {
    let by_tolerance = weakest_first(entries);
    let failed = by_tolerance
        .iter()
        .filter(|record| !record.passed())
        .count();
    let by_digits = fewest_digits_first(by_tolerance.iter().copied());
    html! {
        section id="weakest" {
            h2 { "Weakest checks" }
            p.about {
                "Failed checks first, then those that used most of their tolerance. "
                "A ratio near one is no weakness if the tolerance is a predicted error; the reason is given with each check."
            }
            (list(by_tolerance.iter().take(failed.max(WEAKEST)).copied()))
            @if !by_digits.is_empty() {
                p.about { "Fewest digits among the checks that demand three or more:" }
                (list(by_digits.iter().take(WEAKEST).map(|(_, record)| *record)))
            }
        }
    }
}

fn list<'a>(records: impl Iterator<Item = &'a Record>) -> Markup {
    html! {
        table.weakest {
            thead { tr { th { "check" } th.n { "error / tolerance" } th.n { "digits" } th { "origin of the tolerance" } th { "claim" } } }
            tbody {
                @for record in records {
                    tr {
                        td { (link(record)) }
                        td.n { (ratio(used(record))) }
                        td.n { (decimal(digits(record))) }
                        td { (record.tolerance_origin.name()) }
                        td { (record.claim) }
                    }
                }
            }
        }
    }
}

fn how_to_read() -> Markup {
    html! {
        section id="how" {
            h2 { "How to read this page" }
            p {
                "If a check compares many values, the page shows the one with the largest ratio of error to tolerance. "
                "The tolerance of a check has one of three origins. " b { "Exact" } ": rounding only, in units in the last place or with a stated bound for cancellation; a check that counts wrong cases tolerates none. "
                b { "Convergent" } ": the order of the method and a known or predicted constant. "
                b { "Statistical" } ": a margin, a significance level and a power fixed in advance."
            }
            p {
                "Digits are -log10 of the relative error, at most 16. If zero is expected, the error is relative to the size that the check states. "
                "Only checks whose tolerance demands at least three digits have digits; statistical checks, observed orders and counts have only the ratio of error to tolerance."
            }
            p {
                "In figures, lines are theory or data of others and marks are results of the kernel, unless the legend says otherwise. All quantities are in SI units. "
                "“thesis (42)” is equation (42) of the thesis, and “thesis E15” is section E15 of docs/thesis/errata.md; "
                "a number in parentheses without a source is an equation of the thesis. "
                "“azema (A18)” is equation (A18) of Azéma, Estrada and Radjai (2012), and “azema E2” is section E2 of docs/contact-dynamics/errata.md. "
                "“peridem (4.3)” is equation (4.3) of Bhattacharya and Lipton (2023), and “peridem P2” is section P2 of docs/peridem/errata.md."
            }
        }
    }
}

/// The form by which a script filters the checks; hidden without it.
fn filters(shown: &[Shown]) -> Markup {
    html! {
        form #filters hidden {
            label { "equation " input #filter-equation type="search" size="12" placeholder="42, azema:A18"; }
            label { "chapter "
                select #filter-chapter {
                    option value="" { "all" }
                    @for shown in shown { option value=(shown.topic.id) { (shown.topic.title) } }
                }
            }
            label { "status "
                select #filter-status { option value="" { "all" } option value="pass" { "pass" } option value="fail" { "fail" } }
            }
            button #open-all type="button" { "Open all" }
            button #close-all type="button" { "Close all" }
            output #filter-count {}
        }
    }
}

fn chapter(shown: &Shown) -> Markup {
    let (all, passed) = (shown.entries.len(), shown.passed());
    let count = match all - passed {
        0 => format!("{}, all pass", counted(all, "check")),
        failed => format!("{}, {failed} failed", counted(all, "check")),
    };
    Fold {
        id: shown.topic.id,
        title: shown.topic.title,
        count: &count,
        class: "checks",
    }
    .around(html! {
        p.about { (shown.topic.about) }
        @for entry in &shown.entries { (article(entry)) }
    })
}

/// The files in which the checks are defined.
fn code(entries: &[Entry]) -> Markup {
    let mut files: BTreeMap<String, Vec<(usize, &Record)>> = BTreeMap::new();
    for record in entries.iter().map(|entry| &entry.record) {
        if let Some(place) = sources::place(record.id) {
            files
                .entry(place.file)
                .or_default()
                .push((place.line, record));
        }
    }
    Fold {
        id: "code",
        title: "Code of the checks",
        count: &counted(files.len(), "file"),
        class: "lookup",
    }
    .around(html! {
        table.code {
            thead { tr { th { "file" } th { "checks, with their lines" } } }
            tbody {
                @for (file, records) in &files {
                    tr id=(file) {
                        td { code { (file) } }
                        td { @for (line, record) in records { (link(record)) " (" (line) ") " } }
                    }
                }
            }
        }
    })
}
