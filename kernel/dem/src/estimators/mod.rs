//! Estimators read the state and never change it.

mod friction;
mod network;

pub use crate::balance::Energy;
pub use friction::{friction_feedback, friction_load};
pub use network::{contact_network, fragments};
