//! The discrete element model of shearing brittle surfaces.
//!
//! Read from the top, the modules are chapter 3 of the thesis: pair geometry, particles, laws, contacts
//! and bonds, forces, integrators, energy balance; [`World`] ties them together and estimators read it.
//! A module uses only those above it. All quantities are in SI units.

mod error;
pub mod geometry;
pub mod material;
pub mod particles;
pub mod laws;
pub mod model;
mod pairs;
pub mod bonds;
pub mod contacts;
pub mod forces;
pub mod integrators;
pub mod balance;
mod world;
pub mod estimators;
pub mod setup;
pub mod distributions;
pub mod calibration;

pub use error::{ModelError, StepError};
pub use world::{Drive, Number, Start, State, World, stable_step_estimate};
