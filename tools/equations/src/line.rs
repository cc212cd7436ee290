//! One line of Markdown prose with formulas in it.

use crate::mathml;
use math_core::MathDisplay;

/// Returns the line with MathML for its formulas, or the reason why one of them has none.
pub fn render(line: &str) -> Result<String, String> {
    let mut output = String::with_capacity(line.len());
    let mut rest = line;
    while !rest.is_empty() {
        rest = if rest.starts_with('$') {
            formula(rest, &mut output)?
        } else {
            let (verbatim, rest) = rest.split_at(verbatim_length(rest));
            output.push_str(verbatim);
            rest
        };
    }
    Ok(output)
}

/// Renders the formula at the start of the text and returns what follows it.
fn formula<'a>(text: &'a str, output: &mut String) -> Result<&'a str, String> {
    let (mark, display) = match text.starts_with("$$") {
        true => ("$$", MathDisplay::Block),
        false => ("$", MathDisplay::Inline),
    };
    let (_, inner) = text.split_at(mark.len());
    let end = closing(inner, mark)
        .ok_or_else(|| format!("no closing `{mark}` on the line of the formula `{text}`"))?;
    let (tex, rest) = inner.split_at(end);
    output.push_str(&mathml::render(tex, display)?);
    Ok(rest.split_at(mark.len()).1)
}

/// The position of the mark, where a backslash hides the character after it.
fn closing(text: &str, mark: &str) -> Option<usize> {
    let mut hidden = false;
    text.char_indices().map(|(at, _)| at).find(|&at| {
        let (_, rest) = text.split_at(at);
        let found = !hidden && rest.starts_with(mark);
        hidden = !hidden && rest.starts_with('\\');
        found
    })
}

/// The length of a piece at the start of the text which holds no formula.
fn verbatim_length(text: &str) -> usize {
    match text.chars().next() {
        Some('\\') => text.chars().take(2).map(char::len_utf8).sum(),
        Some('`') => code_length(text),
        _ => text.find(['\\', '`', '$']).unwrap_or(text.len()),
    }
}

/// The length of the code span at the start of the text, or of its backticks if they are unpaired.
fn code_length(text: &str) -> usize {
    let ticks = run_length(text);
    let mut at = ticks;
    while let Some(start) = text.split_at(at).1.find('`') {
        let run = run_length(text.split_at(at + start).1);
        at += start + run;
        if run == ticks {
            return at;
        }
    }
    ticks
}

fn run_length(text: &str) -> usize {
    text.len() - text.trim_start_matches('`').len()
}

#[cfg(test)]
mod tests {
    use super::render;

    const X: &str = r#"<math style="padding:.35em 0"><mi>x</mi></math>"#;

    #[test]
    fn inline_formulas_are_replaced_in_place() {
        assert_eq!(
            render(" a $x$ b $ x $.").as_deref(),
            Ok(&*format!(" a {X} b {X}."))
        );
    }

    #[test]
    fn display_formulas_become_blocks() {
        let block = r#" <math display="block" style="padding:.35em 0"><mi>x</mi></math>"#;
        assert_eq!(render(" $$ x $$").as_deref(), Ok(block));
    }

    #[test]
    fn adjacent_formulas_stay_apart() {
        assert_eq!(render("$x$$x$").as_deref(), Ok(&*format!("{X}{X}")));
    }

    #[test]
    fn plain_lines_stay_as_they_are() {
        for line in [
            "",
            " plain *text* ä",
            r" \$5 and \$6",
            r" \`",
            " ends with \\",
        ] {
            assert_eq!(render(line).as_deref(), Ok(line));
        }
    }

    #[test]
    fn code_spans_are_kept() {
        for line in ["`$x$`", "``a ` $x$ ``", r"`\` and `$y`"] {
            assert_eq!(render(line).as_deref(), Ok(line));
        }
    }

    #[test]
    fn unpaired_backticks_hide_nothing() {
        assert_eq!(render("`` $x$ `").as_deref(), Ok(&*format!("`` {X} `")));
        assert_eq!(render(r"\`$x$`").as_deref(), Ok(&*format!(r"\`{X}`")));
    }

    #[test]
    fn escaped_dollars_do_not_close() {
        assert!(render(r"$ \$ x $").is_ok_and(|line| line.contains("&#36;")));
        assert_eq!(render(r"\\$x$").as_deref(), Ok(&*format!(r"\\{X}")));
    }

    #[test]
    fn unclosed_formulas_are_errors() {
        for line in ["a $x", "$$ x $", "$$", r"$ x \$"] {
            assert!(render(line).is_err_and(|reason| reason.contains("no closing")));
        }
    }
}
