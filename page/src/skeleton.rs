//! The frame of a page and tables.

use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("page.css");

/// A self-contained page for screens of any width and for print.
pub fn page(title: &str, body: Markup) -> Markup {
    styled_page(title, "", body)
}

/// A [`page`] with rules of its own, which come after those of all pages.
pub fn styled_page(title: &str, style: &str, body: Markup) -> Markup {
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) (PreEscaped(style)) }
            }
            body { (body) }
        }
    }
}

/// A table with a caption, which scrolls sideways where the screen is narrow.
pub fn table(caption: &str, columns: &[String], rows: &[Vec<String>]) -> Markup {
    html! {
        div.data {
            table {
                caption { span { (caption) } }
                thead { tr { @for name in columns { th { (name) } } } }
                tbody {
                    @for row in rows { tr { @for cell in row { td { (cell) } } } }
                }
            }
        }
    }
}
