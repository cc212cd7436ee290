//! The discrete element model of shearing brittle surfaces.
//!
//! Read down, the modules are chapter 3 of the thesis: particles, geometry, laws, links, forces,
//! integrators, estimators, set-up. [`World`] ties them together.
//! All quantities are in SI units.

pub mod scalar;
pub mod geometry;
pub mod material;
pub mod particles;
pub mod laws;
pub mod model;
pub mod links;
pub mod forces;
pub mod integrators;
pub mod estimators;
pub mod setup;
pub mod distributions;
pub mod calibration;
mod error;
mod world;
mod world_record;

pub use error::{ModelError, StepError};
pub use world::{Drive, Start, World};
