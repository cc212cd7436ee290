//! Checks, oracles and the report for the kernels.

pub mod checks;
mod lines;
pub mod measurements;
pub mod oracles;
pub mod references;
pub mod report;
pub mod scenes;
pub mod verify;
