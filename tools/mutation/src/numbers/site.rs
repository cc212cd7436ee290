//! What a site is.

use crate::results::Fault;
use std::fmt;
use std::ops::Range;

/// What kind of number enters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A literal.
    Literal,
    /// A named constant.
    Constant,
    /// A parameter of a law or the like, or a property of a particle or a link.
    Coefficient,
    /// A number given to a function.
    Input,
}

/// A place where a number enters a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// Number of the site, by which it is switched on.
    pub id: usize,
    /// File, from the root of the workspace.
    pub file: String,
    /// Line, from one.
    pub line: usize,
    /// The function around it.
    pub function: String,
    /// The expression.
    pub expression: String,
    /// The line on which it begins, with marks around it.
    pub context: String,
    /// What kind of number it is.
    pub kind: Kind,
    /// Where it stands, in bytes.
    pub range: Range<usize>,
    /// Name to be repeated where a structure is filled by shorthand.
    pub shorthand: bool,
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
