//! The energy balance, thesis eqs. (72)-(79): terms of the state and sums over the history.

mod energy;
mod ledger;

pub use energy::Energy;
pub use ledger::Ledger;
