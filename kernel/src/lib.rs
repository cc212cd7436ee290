//! The discrete element model of shearing brittle surfaces.
//!
//! Read down, the modules are chapter 3 of the thesis: particles, geometry, laws, links, forces,
//! integrators, estimators, set-up. A module uses only those above it; [`World`] ties them together.
//! All quantities are in SI units.

mod error;
pub mod estimators;
pub mod forces;
pub mod geometry;
pub mod integrators;
pub mod laws;
pub mod links;
pub mod material;
pub mod model;
pub mod particles;
pub mod scalar;
pub mod setup;
mod world;
mod world_record;

pub use error::{ModelError, StepError};
pub use world::{Drive, Start, World};
