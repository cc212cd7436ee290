//! Scenes of rigid discs and polygons by contact dynamics: what they say, and how they run.

mod means;
mod run;
mod scene;

pub use means::Means;
pub(crate) use run::is_saved;
pub use run::{contacts, run, series_columns, shown, stability};
pub use scene::{Bodies, CellTable, Compaction, Glue, PackingTable, Scene, ShearTable, Sizes};
