//! Scenes, runs, checks and reports around the gouge kernel.

pub mod commands;
pub mod error;
//pub mod oracles;
pub mod run;
pub mod scene;
