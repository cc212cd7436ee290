//! The page for people.

use super::{Entry, Picture, Record, original, pictures, plot, speed};
use crate::checks::{Exhibit, Table, Topic};
use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("page.css");

/// The whole page.
pub fn page(topics: &[Topic], entries: &[Entry], drawn: &[Picture], machine: &str) -> Markup {
    let shown: Vec<(&Topic, Vec<&Entry>)> = topics
        .iter()
        .map(|topic| (topic, of_topic(topic, entries)))
        .filter(|(_, entries)| !entries.is_empty())
        .collect();
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width";
                title { "gouge: verification report" }
                style { (PreEscaped(STYLE)) }
            }
            body {
                (head(entries, machine))
                (summary(&shown))
                (how_to_read())
                @for (topic, entries) in &shown { (chapter(topic, entries)) }
                @if !drawn.is_empty() {
                    (original::chapter())
                    (speed::chapter())
                    (pictures::chapter(drawn))
                }
            }
        }
    }
}

fn of_topic<'a>(topic: &Topic, entries: &'a [Entry]) -> Vec<&'a Entry> {
    let belongs = |entry: &&Entry| topic.checks.iter().any(|check| check.id == entry.record.id);
    entries.iter().filter(belongs).collect()
}

fn passed(entries: &[&Entry]) -> usize {
    entries.iter().filter(|entry| entry.record.passed()).count()
}

fn head(entries: &[Entry], machine: &str) -> Markup {
    let all: Vec<&Entry> = entries.iter().collect();
    let failed: Vec<&Record> = all
        .iter()
        .map(|entry| &entry.record)
        .filter(|record| !record.passed())
        .collect();
    html! {
        header {
            h1 { "gouge: verification report" }
            p {
                "A discrete element model of shearing brittle surfaces, after S. Kiiskinen, "
                cite { "Modeling Friction between Shearing Brittle Surfaces with a Discrete Element Method" }
                " (Jyväskylä, 2018), and the evidence that the program computes it correctly."
            }
            p.verdict {
                b { (passed(&all)) " of " (all.len()) " checks pass." }
                " Version " (env!("CARGO_PKG_VERSION")) "; " (machine) "."
            }
            @if !failed.is_empty() {
                p.fail { "Failed: " @for record in &failed { a href=(format!("#{}", record.id)) { (record.id) } " " } }
            }
        }
    }
}

fn summary(shown: &[(&Topic, Vec<&Entry>)]) -> Markup {
    html! {
        nav {
            table.summary {
                tr { th { "chapter" } th.n { "checks" } th.n { "pass" } th.n { "fewest digits" } th.n { "median digits" } th.n { "time / s" } }
                @for (topic, entries) in shown {
                    tr {
                        td { a href=(format!("#{}", topic.id)) { (topic.title) } }
                        td.n { (entries.len()) }
                        td.n { (passed(entries)) }
                        td.n { (format!("{:.1}", digits(entries, 0.0))) }
                        td.n { (format!("{:.1}", digits(entries, 0.5))) }
                        td.n.time { (format!("{:.1}", entries.iter().map(|entry| entry.record.seconds).sum::<f64>())) }
                    }
                }
            }
        }
    }
}

/// A quantile of the correct digits.
fn digits(entries: &[&Entry], quantile: f64) -> f64 {
    let mut digits: Vec<f64> = entries.iter().map(|entry| entry.record.digits).collect();
    digits.sort_by(f64::total_cmp);
    let place = quantile * (digits.len().saturating_sub(1)) as f64;
    digits.get(place as usize).copied().unwrap_or(f64::NAN)
}

fn how_to_read() -> Markup {
    html! {
        section {
            h2 { "How to read this page" }
            p {
                "Each check states a claim, the scene that was run, and the oracle that the result was compared with. Oracles never call the kernel: "
                "each is a closed form, an independent high-order integration, data of another program, or an invariant. "
                "If a check compares many values, the page shows the one with the largest ratio of error to tolerance."
            }
            p {
                "The tolerance of a check has one of three origins. " b { "Exact" } ": rounding only, in units in the last place or with a stated bound for cancellation. "
                b { "Convergent" } ": the order of the method and a known or predicted constant. "
                b { "Statistical" } ": a margin, a significance level and a power fixed in advance. "
                "Digits are -log10 of the relative error, at most 16; where zero is expected, of the absolute error. "
                "In figures, lines are theory or data of others and marks are results of the kernel, unless the legend says otherwise. All quantities are in SI units. "
                "“thesis (42)” is equation (42) of the thesis, and “thesis E15” is section E15 of docs/thesis/errata.md; "
                "a number in parentheses without a source is an equation of the thesis."
            }
        }
    }
}

fn chapter(topic: &Topic, entries: &[&Entry]) -> Markup {
    html! {
        section id=(topic.id) {
            h2 { (topic.title) }
            p.about { (topic.about) }
            @for entry in entries { (article(entry)) }
        }
    }
}

fn article(entry: &Entry) -> Markup {
    let record = &entry.record;
    html! {
        article id=(record.id) {
            h3 { span class=(record.status) { (record.status) } " " (record.claim) }
            @if let Some(failure) = &record.failure { p.fail { "No measurement: " (failure) } }
            dl {
                dt { "check" } dd { code { (record.id) } ", covers " (record.equations) }
                dt { "scene" } dd { (record.scene) }
                dt { "compared with" } dd { (record.oracle) }
                dt { "error" } dd { (record.norm) }
                dt { "tolerance" } dd { b { (format!("{:?}", record.tolerance_origin).to_lowercase()) } ": " (record.tolerance_reason) }
            }
            (numbers(record))
            @for exhibit in &entry.exhibits { (show(exhibit)) }
        }
    }
}

fn numbers(record: &Record) -> Markup {
    html! {
        table.numbers {
            tr { th.n { "expected" } th.n { "measured" } th.n { "error" } th.n { "tolerance" } th.n { "digits" } th.n { "time / s" } }
            tr {
                td.n { (number(record.expected)) }
                td.n { (number(record.measured)) }
                td.n { (format!("{:.2e}", record.error)) }
                td.n { (format!("{:.2e}", record.tolerance)) }
                td.n { (format!("{:.1}", record.digits)) }
                td.n.time { (format!("{:.2}", record.seconds)) }
            }
        }
    }
}

/// A number with all significant digits; small whole numbers without an exponent.
fn number(value: f64) -> String {
    if value.fract() == 0.0 && value.abs() < 1e6 {
        format!("{value}")
    } else {
        format!("{value:.12e}")
    }
}

fn show(exhibit: &Exhibit) -> Markup {
    match exhibit {
        Exhibit::Plot(plot) => plot::figure(plot),
        Exhibit::Table(table) => data(table),
        Exhibit::Text(text) => html! { p { (text) } },
    }
}

fn data(table: &Table) -> Markup {
    html! {
        div.data {
            table {
                caption { (table.title) }
                tr { @for name in &table.columns { th { (name) } } }
                @for row in &table.rows {
                    tr { @for cell in row { td { (cell) } } }
                }
            }
        }
    }
}
