//! The discrete element model of the thesis: shearing of brittle surfaces.
//!
//! In order of dependency, the modules follow chapter 3 of the thesis: pair geometry, particles, laws, bonds and
//! contacts, forces, integrators, energy balance. A [`World`] combines them, and estimators read its state. A module
//! uses only modules listed above it. All quantities are in SI units.
//!
//! *Contact* and *bond* are the weak and the strong link of the thesis; *interaction* means either.
//!
//! A complete program, `examples/collision.rs`, which `cargo run --release --bin collision` runs; the folder has others,
//! among them one with a normal law of its own. A program elsewhere depends on this crate by
//! `gouge-dem = { path = "gouge/kernel/dem" }`.
//! ```
#![doc = include_str!("../../../examples/collision.rs")]
//! ```

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
pub use gouge_common as common;
pub use world::{
    Break, Continuation, Drive, NormalChoice, Number, Start, State, World, is_surely_stable,
    network_step, stable_step_estimate,
};
