//! The verification gate: one test binary with one module per subject.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod bad_input;
mod bonds;
mod calibration;
mod code_size;
mod collisions;
mod commands;
mod distributions;
mod drafts;
mod dual;
mod equations;
mod errata;
mod estimators;
mod events;
mod geometry;
mod guard;
mod identities;
mod integrators;
mod layering;
mod links;
mod machine;
mod measurements;
mod nothing_lost;
mod original_program;
mod overrides;
mod pay_for_use;
mod program;
mod readings;
mod recorded;
mod register;
mod search;
mod sources;
mod worlds;
