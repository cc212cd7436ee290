//! The discrete element model of shearing brittle surfaces.
//!
//! Read down, the modules are chapter 3 of the thesis: particles, geometry, laws, links, forces,
//! integrators, energy balance; [`World`] ties them together, estimators look at it. A module uses
//! only those above it. All quantities are in SI units.

mod error;
mod instructions;
mod parts;
pub mod scalar;
pub mod geometry;
pub mod material;
pub mod particles;
pub mod laws;
pub mod model;
pub mod links;
pub mod forces;
pub mod integrators;
pub mod balance;
mod world;
pub mod estimators;
pub mod setup;
pub mod distributions;
pub mod calibration;

pub use error::{ModelError, StepError};
pub use instructions::Instructions;
pub use world::{Drive, Number, Start, World, stable_step_estimate};
