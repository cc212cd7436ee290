//! Writes the text of a source with switches, and finds the mutants that cause a compiler error.
//!
//! Operands are evaluated at most once and in order. Operands that the original does not evaluate are not evaluated.

use super::mutant::{Form, Mutant, Place};
use std::ops::Range;

/// A place with those of its mutants that are built in, ordered by switch.
pub struct Planted<'a> {
    /// The place.
    pub place: &'a Place,
    /// Its mutants; at least one, in order.
    pub mutants: Vec<&'a Mutant>,
}

/// The text of a source in which every place selects between the original and its mutants.
///
/// `library` is the crate that holds the switches, and the places are in order of their beginning.
pub fn written(text: &str, library: &str, places: &[Planted]) -> String {
    let writer = Writer {
        text,
        library,
        places,
    };
    writer.part(&(0..text.len()), 0)
}

struct Writer<'a> {
    text: &'a str,
    library: &'a str,
    places: &'a [Planted<'a>],
}

impl Writer<'_> {
    /// A part of the text with the places in it, the first of which has at least the given number.
    fn part(&self, range: &Range<usize>, from: usize) -> String {
        let (mut written, mut at) = (String::new(), range.start);
        for (number, planted) in self.places.iter().enumerate().skip(from) {
            let inner = &planted.place.range;
            if inner.start >= range.end {
                break;
            }
            if inner.start >= at {
                written += &self.text[at..inner.start];
                written += &self.switch(number);
                at = inner.end;
            }
        }
        written + &self.text[at..range.end]
    }

    /// A place with its mutants, between marks.
    fn switch(&self, number: usize) -> String {
        let Planted { place, mutants } = &self.places[number];
        let part = |range: &Range<usize>| self.part(range, number + 1);
        let [first, last] = [0, mutants.len() - 1].map(|n| mutants[n].switch);
        let chosen = format!(
            "{}::perturbation::chosen({first}, {})",
            self.library,
            last - first + 1
        );
        let choice = |itself: &str, other: &dyn Fn(&str) -> String| {
            format!(
                "match {chosen} {{ 0 => {itself}, {} }}",
                arms(mutants, other)
            )
        };
        let (op, plain) = (&place.operator, |other: &str| other.to_owned());
        let code = match &place.form {
            Form::Arithmetic(left, right) => {
                let choice = choice(&format!("l {op} r"), &|op| format!("l {op} r"));
                format!(
                    "(match ({}, {}) {{ (l, r) => {choice} }})",
                    part(left),
                    part(right)
                )
            }
            Form::Comparison(left, right) => {
                let choice = choice(&format!("*l {op} *r"), &|op| format!("*l {op} *r"));
                let [left, right] = [left, right].map(part);
                format!("(match (&({left}), &({right})) {{ (l, r) => {choice} }})")
            }
            Form::Assignment(left, right) => {
                let choice = choice(&format!("*l {op} r"), &|op| format!("*l {op} r"));
                let [left, right] = [left, right].map(part);
                format!("(match ({right}) {{ r => match &mut ({left}) {{ l => {choice} }} }})")
            }
            Form::Logic(left, right) => {
                let goes_on = if op == "&&" { "==" } else { "!=" };
                let [left, right] = [left, right].map(part);
                format!(
                    "(match ({left}) {{ l => if l {goes_on} ({chosen} == 0) {{ {right} }} else {{ l }} }})"
                )
            }
            Form::Sign(operand) => {
                let choice = choice(&format!("{op}x"), &|_| "x".to_owned());
                format!("(match ({}) {{ x => {choice} }})", part(operand))
            }
            Form::Truth => format!("({})", choice(&part(&place.range), &plain)),
            Form::Body => format!("{};", choice("{}", &|value| format!("return {value}"))),
        };
        let all: Vec<String> = mutants.iter().map(|one| one.switch.to_string()).collect();
        marked('p', &all.join(" "), &code)
    }
}

/// The match arms for the mutants of a place; the last arm matches everything else.
fn arms(mutants: &[&Mutant], code: &dyn Fn(&str) -> String) -> String {
    let arm = |(n, mutant): (usize, &&Mutant)| {
        let number = if n + 1 == mutants.len() {
            "_".to_owned()
        } else {
            (mutant.switch - mutants[0].switch + 1).to_string()
        };
        let code = marked('a', &mutant.switch.to_string(), &code(&mutant.other));
        format!("{number} => {code},")
    };
    mutants.iter().enumerate().map(arm).collect()
}

const OPEN: &str = " /*<";
const CLOSE: &str = "/*</>*/";

fn marked(kind: char, switches: &str, code: &str) -> String {
    format!("{OPEN}{kind} {switches}>*/{code}{CLOSE}")
}

/// The mutants that can cause an error at a position of a written text, and whether the error is in the code of one of
/// them or elsewhere in their place.
pub fn blamed(written: &str, at: usize) -> (bool, Vec<usize>) {
    let mut around = vec![(false, Vec::new())];
    let before = &written[..at.min(written.len())];
    for (place, _) in before.match_indices("/*<") {
        let rest = &written[place..];
        if rest.starts_with(CLOSE) {
            around.pop();
        } else if let Some((words, _)) = rest.trim_start_matches("/*<").split_once(">*/") {
            let switches = words.split(' ').skip(1).filter_map(|n| n.parse().ok());
            around.push((words.starts_with('a'), switches.collect()));
        }
    }
    around.pop().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::super::find::find;
    use super::super::mutant::Mutant;
    use super::{Planted, blamed, written};

    /// A source with all of its mutants.
    fn rewritten(source: &str) -> syn::Result<String> {
        let places = find(source, &syn::parse_file(source)?);
        let mut switch = 0;
        let mutants: Vec<Vec<Mutant>> = places
            .iter()
            .map(|place| {
                let mut own = Mutant::of("", (0, 0), place);
                for mutant in &mut own {
                    mutant.switch = switch;
                    switch += 1;
                }
                own
            })
            .collect();
        let planted: Vec<Planted> = places
            .iter()
            .zip(&mutants)
            .map(|(place, own)| Planted {
                place,
                mutants: own.iter().collect(),
            })
            .collect();
        Ok(written(source, "lib", &planted))
    }

    #[test]
    fn operands_stand_once_and_errors_are_blamed_on_their_mutants() -> syn::Result<()> {
        let source = "fn f(a: bool, x: &Vec2) -> Vec2 { if a && x.y < 0.5 { x.scaled() * 2.0 } else { -*x } }";
        let text = rewritten(source)?;
        syn::parse_file(&text)?;
        for operand in ["x.y", "0.5", "2.0", "*x"] {
            assert_eq!(text.matches(operand).count(), 1);
        }
        let at = |words: &str| text.find(words).map(|place| blamed(&text, place + 1));
        assert_eq!(at("return Default"), Some((true, vec![0])));
        assert_eq!(at("l / r"), Some((true, vec![11])));
        assert_eq!(at("2.0"), Some((false, vec![9, 10, 11, 12])));
        assert_eq!(at("fn f"), Some((false, Vec::new())));
        Ok(())
    }
}
