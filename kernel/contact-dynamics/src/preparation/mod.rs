//! Initial states: sizes, geometric deposition, and what is glued to the walls.
//!
//! Random choices take `uniform`, a source of uniform random numbers in [0, 1), from the caller.

mod sizes;
mod deposition;
mod front;
mod inscribed;
mod glue;

pub use deposition::{Deposited, deposit};
pub use glue::glue;
pub use inscribed::{Filling, inscribe};
pub use sizes::{DiameterRange, draw_diameters};
