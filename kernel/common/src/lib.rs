//! What the kernels of all models share, and nothing that belongs to one of them.
//!
//! Read from the top: numbers, vectors and the box, pairs, neighbour search, the division of work
//! among threads and instructions, and estimators that need no model. A module uses only those
//! above it. All quantities are in SI units.

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
