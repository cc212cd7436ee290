//! Initial states: particle sizes, lattice, bonds and fault, thesis sections 3.7.2-3.7.6.
//!
//! Random choices take `uniform`, a source of uniform random numbers in [0, 1), from the caller.

mod bonding;
mod fault;
mod lattice;
mod sizes;

pub use bonding::{REACH, bonds_within, strength_factors};
pub use fault::{Fault, is_above};
pub use lattice::{Arrangement, Lattice};
pub use sizes::{SizeRange, draw_radii};
