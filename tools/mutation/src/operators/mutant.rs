//! What a mutant is.

use crate::results::Fault;
use std::fmt;
use std::ops::Range;

/// What is replaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// An operator between numbers, or between their bits.
    Arithmetic,
    /// A comparison.
    Comparison,
    /// `&&` or `||`.
    Logic,
    /// An operator that assigns.
    Assignment,
    /// `-` or `!`, left out.
    Sign,
    /// The guard of an arm.
    Guard,
    /// The condition of an `if`.
    Condition,
    /// The result of a function.
    Result,
}

impl Kind {
    /// All kinds, with their names.
    pub const ALL: [(Self, &str); 8] = [
        (Self::Arithmetic, "arithmetic"),
        (Self::Comparison, "comparison"),
        (Self::Logic, "&& and ||"),
        (Self::Assignment, "assignment"),
        (Self::Sign, "- and !"),
        (Self::Guard, "guard"),
        (Self::Condition, "condition"),
        (Self::Result, "result"),
    ];
}

/// How the code of a place is made of its parts.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// Two operands whose values are taken.
    Arithmetic(Range<usize>, Range<usize>),
    /// Two operands that are looked at.
    Comparison(Range<usize>, Range<usize>),
    /// Two truth values of which the second may not be needed.
    Logic(Range<usize>, Range<usize>),
    /// A place that is written to, and a value.
    Assignment(Range<usize>, Range<usize>),
    /// One operand.
    Sign(Range<usize>),
    /// A truth value that is replaced as a whole.
    Truth,
    /// The beginning of the body of a function.
    Body,
}

/// A place of the code with what can stand there instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// What is replaced.
    pub kind: Kind,
    /// How its code is made of its parts.
    pub form: Form,
    /// Where it stands, in bytes; empty for the beginning of a body.
    pub range: Range<usize>,
    /// Line, from one.
    pub line: usize,
    /// Column, from one.
    pub column: usize,
    /// The function around it.
    pub function: String,
    /// The operator; nothing where none is replaced.
    pub operator: String,
    /// The expression, shortened.
    pub expression: String,
    /// What can stand there instead: operators or values.
    pub others: Vec<String>,
}

/// A place with one of the things that can stand there instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Mutant {
    /// Number of its source, and of its place in it.
    pub place: (usize, usize),
    /// What stands there instead.
    pub other: String,
    /// What is replaced.
    pub kind: Kind,
    /// Number of its switch, once it is drawn.
    pub switch: usize,
    /// Where it is and what it does.
    words: String,
}

impl Mutant {
    /// The mutants of a place of a file.
    pub fn of(file: &str, number: (usize, usize), place: &Place) -> Vec<Self> {
        let Place {
            line,
            column,
            function,
            expression,
            ..
        } = place;
        let at = format!("{file}:{line}:{column} {function}:");
        let with = |other: &String| Self {
            place: number,
            other: other.clone(),
            kind: place.kind,
            switch: 0,
            words: match (&place.form, place.kind) {
                (Form::Body, _) => format!("{at} returns `{other}`"),
                (Form::Truth, Kind::Guard) => format!("{at} guard `{expression}` is {other}"),
                (Form::Truth, _) => format!("{at} condition `{expression}` is {other}"),
                (Form::Sign(_), _) => format!("{at} no `{}` in `{expression}`", place.operator),
                _ => format!("{at} `{}` is `{other}` in `{expression}`", place.operator),
            },
        };
        place.others.iter().map(with).collect()
    }
}

impl Fault for Mutant {
    fn switch(&self) -> usize {
        self.switch
    }
}

impl fmt::Display for Mutant {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.write_str(&self.words)
    }
}
