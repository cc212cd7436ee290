//! The impulses of all contact points, by Gauss-Seidel sweeps over body velocities.

mod unit;
mod row;
mod changes;
mod settings;
mod residual;
mod momentum;
mod visit;
mod iteration;
mod plain;
mod places;
mod division;
mod team;
mod strips;
mod solver;

pub use iteration::SweepReport;
pub use row::{ContactInput, Row};
pub use settings::{Rule, StopCriterion, SweepOrder, SweepSettings};
pub use solver::Solver;
