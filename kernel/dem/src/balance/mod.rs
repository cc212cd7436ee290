//! The energy balance, thesis eqs. (72)-(79): energies of the state, and sums of heat and work over the history.

mod energy;
mod ledger;

pub use energy::Energy;
pub use ledger::Ledger;
