//! Neighbour search.

mod cells;
mod list;
mod sizes;

pub use cells::{CellIndex, Cells, Run, precedes};
pub use list::{Neighbors, SearchSpheres, Staleness};
