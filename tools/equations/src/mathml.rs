//! Converts TeX to MathML that Markdown does not change.

use math_core::{LatexToMathML, MathDisplay};

/// Converts a formula, or returns an error with the formula and the reason why it has no MathML.
pub fn render(tex: &str, display: MathDisplay) -> Result<String, String> {
    let tex = tex.trim();
    LatexToMathML::default()
        .convert_with_local_state(tex, display)
        .map(|result| protect(&adjust(&result.mathml)))
        .map_err(|error| format!("the formula `{tex}` cannot be rendered: {error}"))
}

/// Works around flaws in how browsers draw MathML.
///
/// The combining arrow of a vector has no width, so it is drawn over the symbol to the left. It is replaced by a small
/// arrow with a width. The padding makes room for accents and limits, which otherwise overflow the paragraph and give
/// it a scroll bar.
fn adjust(mathml: &str) -> String {
    let arrow = r#"<mo stretchy="false" style="font-size:75%">→</mo>"#;
    let mathml = mathml.replace("<mo stretchy=\"false\">\u{20d7}</mo>", arrow);
    match mathml.split_once('>') {
        Some((tag, rest)) => format!(r#"{tag} style="padding:.35em 0">{rest}"#),
        None => mathml,
    }
}

#[derive(Clone, Copy)]
enum Place {
    Text,
    Tag,
    Entity,
}

/// Writes every character with a meaning in Markdown as a numeric entity.
fn protect(mathml: &str) -> String {
    let mut output = String::with_capacity(2 * mathml.len());
    let mut place = Place::Text;
    for character in mathml.chars() {
        place = match (place, character) {
            (Place::Text, '<') => Place::Tag,
            (Place::Text, '&') => Place::Entity,
            _ => place,
        };
        match meaningful(place, character) {
            true => output.push_str(&format!("&#{};", u32::from(character))),
            false => output.push(character),
        }
        place = match (place, character) {
            (Place::Tag, '>') | (Place::Entity, ';') => Place::Text,
            _ => place,
        };
    }
    output
}

/// Whether Markdown would interpret the character. Within a tag it only interprets a bar, which ends the cell of a
/// table.
fn meaningful(place: Place, character: char) -> bool {
    match place {
        Place::Text => character.is_ascii_punctuation() || character.is_ascii_control(),
        Place::Tag => character == '|' || character.is_ascii_control(),
        Place::Entity => false,
    }
}

#[cfg(test)]
mod tests {
    use super::{MathDisplay, protect, render};

    fn block(tex: &str) -> String {
        render(tex, MathDisplay::Block).unwrap_or_else(|reason| reason)
    }

    /// Asserts that the formula converts to MathML with all the given parts.
    fn shows(tex: &str, parts: &[&str]) {
        let mathml = block(tex);
        assert!(
            mathml.starts_with(r#"<math display="block" style="#),
            "{mathml}"
        );
        assert!(
            mathml.ends_with("</math>") && !mathml.contains(['\n', '|']),
            "{mathml}"
        );
        for part in parts {
            assert!(mathml.contains(part), "{part} is not in {mathml}");
        }
    }

    #[test]
    fn text_is_protected_and_tags_are_not() {
        assert_eq!(
            protect("<mo a=\"b_c\">*_|</mo>"),
            "<mo a=\"b_c\">&#42;&#95;&#124;</mo>"
        );
        assert_eq!(protect("<mo>&lt;</mo>\n`"), "<mo>&lt;</mo>&#10;&#96;");
        assert_eq!(protect("<mo a=\"|\n\">["), "<mo a=\"&#124;&#10;\">&#91;");
    }

    #[test]
    fn inline_formulas_are_not_blocks() {
        let x = r#"<math style="padding:.35em 0"><mi>x</mi></math>"#;
        assert_eq!(render(" x ", MathDisplay::Inline).as_deref(), Ok(x));
    }

    #[test]
    fn cases_are_tables() {
        let tex = r"f = \begin{cases} a, & x > 0 \\ b, & x \le 0 \end{cases}";
        shows(
            tex,
            &["&#123;", "<mtable", "<mtr", "<mtd", "&gt;", "≤", "&#44;"],
        );
    }

    #[test]
    fn letters_and_accents() {
        shows(r"\alpha \Delta \xi", &["<mi>α</mi>", "Δ", "<mi>ξ</mi>"]);
        shows(
            r"\vec x_i + \bar k",
            &["<mover", "<mi>x</mi>", "<mi>k</mi>", "<msub>"],
        );
        shows(r"\partial_t u", &["∂", "<mi>t</mi>"]);
        shows(r"\mathrm{per}\, x", &["per", "<mspace"]);
        shows(r"a \text{ for } b", &["<mtext>", "for"]);
    }

    #[test]
    fn arrows_of_vectors_have_a_width() {
        let mathml = block(r"\vec x");
        assert!(
            mathml.contains(">→</mo>") && !mathml.contains('\u{20d7}'),
            "{mathml}"
        );
    }

    #[test]
    fn fractions_and_roots() {
        shows(
            r"\frac12 + \frac{a}{b}",
            &["<mfrac><mn>1</mn><mn>2</mn></mfrac>", "<mi>a</mi>"],
        );
        shows(r"\tfrac12", &[r#"<mfrac displaystyle="false"><mn>1</mn>"#]);
        shows(r"\sqrt{x^2}", &["<msqrt><msup>"]);
    }

    #[test]
    fn delimiters() {
        shows(r"\min\{0, x\}", &["min", "&#123;", "&#125;"]);
        shows(r"\lvert x \rvert", &["&#124;"]);
        shows(r"|x|", &["&#124;"]);
        shows(r"\left\lfloor \frac{x}{l} \right\rfloor", &["⌊", "⌋"]);
        shows(r"[a * b]", &["&#91;", "&#93;"]);
    }

    #[test]
    fn bad_formulas_are_named_with_the_reason() {
        let reason = block(r"\frac{a}{b");
        assert!(reason.contains(r"`\frac{a}{b`"), "{reason}");
        assert!(block(r"\nonsense x").contains("nonsense"));
        assert!(render(r"\left( x", MathDisplay::Inline).is_err());
    }
}
