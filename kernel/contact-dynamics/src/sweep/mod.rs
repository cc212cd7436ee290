//! The impulses of all contact points, by Gauss-Seidel sweeps over body velocities.

mod row;
mod settings;
mod solver;
mod residual;

pub use row::{ContactInput, Row};
pub use settings::{Rule, StopCriterion, SweepOrder, SweepSettings};
pub use solver::{Solver, SweepReport};
