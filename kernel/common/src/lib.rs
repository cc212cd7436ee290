//! The parts of a kernel that do not depend on the model.
//!
//! In order of dependency: numbers, vectors and the box, pairs, instruction sets and threads, neighbour search,
//! estimators that need no model, records. A module uses only modules listed above it. All quantities are in
//! SI units.

pub mod scalar;
pub mod geometry;
pub mod pair;
pub mod instructions;
pub mod lanes;
pub mod parts;
pub mod columns;
pub mod neighbors;
pub mod estimators;
pub mod record;
