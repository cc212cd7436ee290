//! Sweeps: runs of one scene with every combination of some values of its keys.
//!
//! The state of a sweep is files. Each run has a folder `runs/HASH`, named after its scene with all keys resolved, so
//! that a changed sweep runs only what is new and a killed one goes on where it was.

mod cost;
mod execute;
mod export;
mod file;
mod finished;
mod observe;
mod page;
mod plan;
mod quantity;
mod specimen;
mod state;
mod table;

pub use cost::{Cost, estimate};
pub use execute::{Execution, Program, Progress, execute, retry};
pub use export::{Chunks, Script};
pub use file::Sweep;
pub use finished::Finished;
pub use observe::{Observation, Statistic};
pub use plan::{Planned, open, plan};
pub use quantity::Quantity;
pub use state::{State, Status, status};
pub use table::{COST, RUN, STATE, collect};
