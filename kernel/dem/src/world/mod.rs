//! A model with its state, and how it advances.

mod advance;
mod begin;
mod breaks;
mod choice;
mod continuation;
mod dispatch;
mod energies;
mod evaluate;
mod execution;
mod guard;
mod inspect;
mod network;
mod record;
mod simulation;
mod state;
mod workspace;

pub use begin::Start;
pub use breaks::Break;
pub use choice::NormalChoice;
pub use continuation::Continuation;
pub use guard::{is_surely_stable, stable_step_estimate};
pub use network::network_step;
pub use simulation::{Number, World};
pub use state::{Drive, State};
