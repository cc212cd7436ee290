//! Sites: places where a number enters a formula.

use crate::results::Fault;
use std::fmt;
use std::ops::Range;

/// Kind of the number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A literal.
    Literal,
    /// A named constant.
    Constant,
    /// A parameter, as of a law, or a property of a particle, contact or bond.
    Coefficient,
    /// A number given to a function.
    Input,
}

/// A place where a number enters a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// Number of the site and of its switch.
    pub id: usize,
    /// File, from the root of the workspace.
    pub file: String,
    /// Line, counted from one.
    pub line: usize,
    /// The enclosing function.
    pub function: String,
    /// The expression.
    pub expression: String,
    /// The line on which the expression begins, with marks around the expression.
    pub context: String,
    /// Kind of the number.
    pub kind: Kind,
    /// Range of bytes of the expression.
    pub range: Range<usize>,
    /// Field name to be repeated if a structure is initialised by shorthand.
    pub shorthand: bool,
    /// Whether the number may be absent.
    pub optional: bool,
}

/// What has to be done to a file.
#[derive(Debug, Default)]
pub struct Findings {
    /// The sites, in order of their beginning; outer ones before inner ones.
    pub sites: Vec<Site>,
    /// Constants of structures with numbers, to be made values that are computed when first used: type
    /// and value.
    pub structures: Vec<[Range<usize>; 3]>,
    /// Macros that hold literals but cannot be read.
    pub opaque: Vec<String>,
}

/// Which code a file belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The kernel: all kinds of sites count.
    Kernel,
    /// A user of the kernel: only constants that the kernel exports count.
    User,
}

impl Fault for Site {
    fn switch(&self) -> usize {
        self.id
    }
}

impl fmt::Display for Site {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        let Self {
            id,
            file,
            line,
            function,
            expression,
            ..
        } = self;
        write!(out, "{id:4} {file}:{line} {function} `{expression}`")
    }
}
