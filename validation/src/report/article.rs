//! A check on the page.

use super::fold::{decimal, ratio};
use super::judged::{digits, used};
use super::{Entry, Record, equations, sources};
use crate::checks::{Citation, Exhibit, Source};
use gouge_page::table;
use maud::{Markup, html};

/// A check with its result and its exhibits.
pub fn article(entry: &Entry) -> Markup {
    let record = &entry.record;
    html! {
        article id=(record.id) data-status=(record.status) data-equations=(numbers_of(record)) {
            h3 { span class=(record.status) { (record.status) } " " (record.claim) }
            @if let Some(failure) = &record.failure { p.fail { "No measurement: " (failure) } }
            dl {
                dt { "check" } dd { code { (record.id) } ", covers " (covers(record)) }
                dt { "scene" } dd { (record.scene) }
                dt { "compared with" } dd { (record.oracle) }
                dt { "error" } dd { (record.norm) }
                dt { "tolerance" } dd { b { (record.tolerance_origin.name()) } ": " (record.tolerance_reason) }
                (code_of(record))
            }
            (numbers(record))
            @for exhibit in &entry.exhibits { (show(exhibit)) }
        }
    }
}

/// Numbers of all equations that a check covers, for the filter of the page.
fn numbers_of(record: &Record) -> String {
    let citations = record.equations.citations().iter();
    // Those of other sources than the thesis carry the source, so that the filter does not mix them.
    let of = |citation: &Citation| {
        let prefix = match citation.source {
            Source::Thesis => String::new(),
            source => format!("{}:", source.name()),
        };
        let numbers = citation.equations().into_iter();
        numbers.map(move |number| format!("{prefix}{number}"))
    };
    let numbers: Vec<String> = citations.flat_map(of).collect();
    numbers.join(" ")
}

/// What a check covers, with links to the rows of the equations.
fn covers(record: &Record) -> Markup {
    let citations = record.equations.citations();
    html! {
        @if citations.is_empty() { "no equation" }
        @for (place, citation) in citations.iter().enumerate() {
            @if place > 0 { ", " }
            @match citation.equations().first() {
                Some(first) => {
                    a href=(format!("#{}", equations::anchor(citation.source, first))) { (citation) }
                }
                None => (citation),
            }
        }
    }
}

/// Where a check is defined.
fn code_of(record: &Record) -> Markup {
    html! {
        @if let Some(place) = sources::place(record.id) {
            dt { "code" }
            dd { a href=(format!("#{}", place.file)) { code { (place.file) } } ", line " (place.line) }
        }
    }
}

fn numbers(record: &Record) -> Markup {
    html! {
        table.numbers {
            tr { th.n { "expected" } th.n { "measured" } th.n { "error" } th.n { "tolerance" } th.n { "error / tolerance" } th.n { "digits" } th.n { "time / s" } }
            tr {
                td.n { (number(record.expected)) }
                td.n { (number(record.measured)) }
                td.n { (format!("{:.2e}", record.error)) }
                td.n { (format!("{:.2e}", record.tolerance)) }
                td.n { (ratio(used(record))) }
                td.n { (decimal(digits(record))) }
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
        Exhibit::Figure(figure) => figure.html(),
        Exhibit::Table(shown) => table(&shown.title, &shown.columns, &shown.rows),
        Exhibit::Text(text) => html! { p { (text) } },
    }
}
