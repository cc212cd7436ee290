//! Large figures, moved out of the page so that a stored copy of the page is small and can be compared.

use std::fmt::Write;

/// Size in bytes above which a figure is stored in a file of its own.
const BIG: usize = 6_000;

/// A page and the figures taken out of it.
pub struct Split {
    /// The page, which refers to each figure as `figures/NAME`.
    pub page: String,
    /// File name and text of each figure.
    pub figures: Vec<(String, String)>,
}

/// Replaces every large figure of a page by an image of the same size.
///
/// The name of a large figure is the `id` of the check or chapter that precedes it and its number there.
pub fn split(page: &str) -> Split {
    let mut split = Split {
        page: String::with_capacity(page.len()),
        figures: Vec::new(),
    };
    let (mut owner, mut place) = (String::new(), 0);
    let mut rest = page;
    while let Some((before, figure, after)) = next_figure(rest) {
        if let Some(id) = last_id(before) {
            // Checks of stored references have a slash in their names.
            (owner, place) = (id.replace('/', "."), 0);
        }
        split.page.push_str(before);
        if figure.len() > BIG {
            place += 1;
            let name = format!("{owner}-{place}.svg");
            let _ = write!(split.page, "<img src=\"figures/{name}\" alt=\"\">");
            split.figures.push((name, standalone(figure)));
        } else {
            split.page.push_str(figure);
        }
        rest = after;
    }
    split.page.push_str(rest);
    split
}

/// The text before the first figure, the figure, and the text after it.
fn next_figure(text: &str) -> Option<(&str, &str, &str)> {
    const CLOSING: &str = "</svg>";
    let begin = text.find("<svg")?;
    let end = begin + text[begin..].find(CLOSING)? + CLOSING.len();
    Some((&text[..begin], &text[begin..end], &text[end..]))
}

/// The last `id` of an element in a text.
fn last_id(text: &str) -> Option<&str> {
    let (_, rest) = text.rsplit_once(" id=\"")?;
    rest.split('"').next()
}

/// A figure as a file of its own, with the name space that figures in a page may omit.
fn standalone(figure: &str) -> String {
    const NAME_SPACE: &str = "xmlns=\"http://www.w3.org/2000/svg\"";
    if figure.contains(NAME_SPACE) {
        figure.to_owned()
    } else {
        figure.replacen("<svg", &format!("<svg {NAME_SPACE}"), 1)
    }
}
