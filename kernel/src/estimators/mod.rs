//! Estimators read the state and never change it.

mod energy;
mod friction;
mod ledger;

pub use energy::Energy;
pub use friction::{friction_feedback, friction_load};
pub use ledger::Ledger;
