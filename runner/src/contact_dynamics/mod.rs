//! Scenes of rigid discs and polygons by contact dynamics: what they say, and how they run.

mod run;
mod scene;

pub use run::{contacts, run, series_columns, stability};
pub use scene::{Bodies, CellTable, Compaction, Glue, PackingTable, Scene, ShearTable, Sizes};
