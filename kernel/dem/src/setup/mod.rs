//! Initial states: sizes, lattice, bonds and fault, thesis sections 3.7.2-3.7.6.
//!
//! Random choices come from the caller as a source of uniform numbers in [0, 1).

mod bonding;
mod fault;
mod lattice;
mod sizes;

pub use bonding::{REACH, bonds_within, strength_factors};
pub use fault::{Fault, is_above};
pub use lattice::{Arrangement, Lattice};
pub use sizes::{SizeRange, draw_radii};
