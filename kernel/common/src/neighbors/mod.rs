//! Neighbour search.

mod cells;
mod list;

pub use cells::{CellIndex, Cells, precedes};
pub use list::{Neighbors, SearchSpheres, Staleness};
