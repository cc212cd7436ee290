//! Estimators read the state and never change it.

mod energy;
mod entropy;
mod fragments;
mod friction;
mod ledger;
mod packing;
mod stress;

pub use energy::Energy;
pub use entropy::{RadialDistribution, Region, radial_distribution, visible_fraction};
pub use fragments::{Fragments, connected, fragments};
pub use friction::{friction_feedback, friction_load};
pub use ledger::Ledger;
pub use packing::{coordination_number, packing_fraction};
pub use stress::mean_stress;
