//! Estimators read the state and never change it.
//!
//! Those that need no model are in [`gouge_common::estimators`];
//! [`contact_network`](crate::World::contact_network) shows them the contacts and bonds of a world.

mod friction;
mod fragments;

pub use crate::balance::Energy;
pub use fragments::fragments;
pub use friction::{friction_feedback, friction_load};
