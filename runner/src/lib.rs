//! Scenes in, outputs out: scene files, built-in scenes, runs, checkpoints, pictures, comparisons.

pub mod any_scene;
pub mod build;
pub mod commands;
pub mod compare;
pub mod contact_dynamics;
pub mod error;
pub mod machine;
pub mod peridem;
pub mod random;
pub mod references;
pub mod run;
pub mod scene;
pub mod stability;
