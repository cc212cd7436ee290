//! Which particles are near each other.

mod cells;
mod list;

pub use cells::{Cells, Index, precedes};
pub use list::{Neighbors, Reaching, Staleness};
