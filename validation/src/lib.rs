//! Scenes, runs, checks and reports around the gouge kernel.

pub mod checks;
pub mod commands;
pub mod error;
pub mod machine;
pub mod measurements;
pub mod oracles;
pub mod references;
pub mod report;
pub mod run;
pub mod scalars;
pub mod scene;
pub mod verify;
