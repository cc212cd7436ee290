//! Worked examples of other programs, repeated with the kernels.
//!
//! [`contact_dynamics::replay`] reads a folder of JSON files with cases, solves each case from its data alone, and
//! returns the results by file and case. A case that cannot be solved is reported with its file, its identity and the
//! key at fault, and does not keep the others from being solved.

mod error;
mod fields;
mod outcome;

pub mod contact_dynamics;
pub mod peridem;

pub use error::{CaseError, Fault, ReplayError};
pub use outcome::Outcome;
