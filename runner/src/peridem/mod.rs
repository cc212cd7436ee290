//! Scenes of deformable, breakable grains by peridynamics: what they say, and how they run.

mod run;
mod scene;

pub(crate) use run::is_saved;
pub use run::{damage_colours, links, run, series_columns, shown, stability, world};
pub use scene::Scene;
