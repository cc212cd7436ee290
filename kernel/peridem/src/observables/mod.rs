//! Quantities that are read off a state.

mod connected;
mod crack;
mod damage;
mod gaps;
mod stress;

pub use connected::connected_damage;
pub use crack::Crack;
pub use damage::{bulk_damage, grain_damage, pieces, softened_area};
pub use gaps::{face_gap, free_distance};
pub use stress::grain_stress;
