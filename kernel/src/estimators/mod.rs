//! Estimators read the state and never change it.

mod entropy;
mod fragments;
mod friction;
mod packing;
mod stress;

pub use crate::balance::Energy;
pub use entropy::{RadialDistribution, Region, radial_distribution, visible_fraction};
pub use fragments::{Fragments, connected, fragments};
pub use friction::{friction_feedback, friction_load};
pub use packing::{coordination_number, packing_fraction};
pub use stress::mean_stress;
