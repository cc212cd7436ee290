//! Mutants: places of the code with one replacement.

use crate::results::Fault;
use std::fmt;
use std::ops::Range;

/// Kind of the replaced code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// An operator between numbers, or between their bits.
    Arithmetic,
    /// A comparison.
    Comparison,
    /// `&&` or `||`.
    Logic,
    /// A compound assignment operator.
    Assignment,
    /// `-` or `!`, removed.
    Sign,
    /// The guard of a match arm.
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

/// Syntactic form of a place, with the byte ranges of its operands.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// Two operands used by value.
    Arithmetic(Range<usize>, Range<usize>),
    /// Two operands used by reference.
    Comparison(Range<usize>, Range<usize>),
    /// Two booleans, the second of which is evaluated only if needed.
    Logic(Range<usize>, Range<usize>),
    /// A location that is written to, and a value.
    Assignment(Range<usize>, Range<usize>),
    /// One operand.
    Sign(Range<usize>),
    /// A boolean that is replaced as a whole.
    Truth,
    /// The beginning of the body of a function.
    Body,
}

/// A place of the code with its possible replacements.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Kind of the replaced code.
    pub kind: Kind,
    /// Syntactic form.
    pub form: Form,
    /// Range of bytes; empty for the beginning of a body.
    pub range: Range<usize>,
    /// Line, counted from one.
    pub line: usize,
    /// Column, counted from one.
    pub column: usize,
    /// The enclosing function.
    pub function: String,
    /// The operator; empty if no operator is replaced.
    pub operator: String,
    /// The expression, shortened.
    pub expression: String,
    /// Possible replacements: operators or values.
    pub others: Vec<String>,
}

/// A place with one replacement.
#[derive(Clone, Debug, PartialEq)]
pub struct Mutant {
    /// Index of the source, and of the place in the source.
    pub place: (usize, usize),
    /// The replacement.
    pub other: String,
    /// Kind of the replaced code.
    pub kind: Kind,
    /// Number of the switch; set when the mutant is drawn.
    pub switch: usize,
    /// Description: position and change.
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
