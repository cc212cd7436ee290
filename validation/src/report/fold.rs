//! Parts that the page shows in several places: chapters that can be folded, and links to checks.

use super::Record;
use maud::{Markup, html};

/// The heading of a chapter. A chapter is open, so that it can be read and printed without a script.
pub struct Fold<'a> {
    /// The anchor.
    pub id: &'a str,
    /// The title.
    pub title: &'a str,
    /// What is in it, in a few words.
    pub count: &'a str,
    /// The class: `checks`, `lookup` or `other`.
    pub class: &'a str,
}

impl Fold<'_> {
    /// The chapter with its content.
    pub fn around(&self, content: Markup) -> Markup {
        html! {
            section id=(self.id) class=(self.class) {
                details open {
                    summary { h2 { (self.title) } span.count { (self.count) } }
                    (content)
                }
            }
        }
    }
}

/// A link to a check; failed ones are marked.
pub fn link(record: &Record) -> Markup {
    html! {
        a href=(format!("#{}", record.id)) { code { (record.id) } }
        @if !record.passed() { " " span.fail { "fail" } }
    }
}

/// A number of things, in words: `1 check`, `2 checks`.
pub fn counted(number: usize, thing: &str) -> String {
    match number {
        1 => format!("1 {thing}"),
        _ => format!("{number} {thing}s"),
    }
}

/// A number with one decimal, or a dash.
pub fn decimal(number: Option<f64>) -> String {
    number.map_or("–".to_owned(), |number| format!("{number:.1}"))
}

/// The part of a tolerance that was used.
pub fn ratio(used: f64) -> String {
    match used {
        0.0 => "0".to_owned(),
        small if small < 1e-3 => format!("{small:.0e}"),
        used => format!("{used:.3}"),
    }
}
