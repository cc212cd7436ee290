//! Estimators read a state and never change it.
//!
//! Estimators that need no model are in [`gouge_common::estimators`];
//! [`contact_network`](crate::World::contact_network) provides the contacts and bonds of a world for them.

mod friction;
mod fragments;
mod pressure;
mod rolling;
mod specimen;

pub use crate::balance::Energy;
pub use fragments::{debris, fragments};
pub use friction::{friction_feedback, friction_load};
pub use pressure::particle_pressures;
pub use rolling::rolling_and_slip;
pub use specimen::{
    largest_overlap, specimen_packing, specimen_size, specimen_stress, unbalanced_force,
};
