//! The verification gate: one test binary, a module a subject.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod bad_input;
mod collisions;
mod machine;
mod measurements;
mod integrators;
mod links;
mod nothing_lost;
mod original_program;
mod overrides;
mod pay_for_use;
mod program;
mod readings;
mod recorded;
mod register;
mod worlds;
mod code_size;
mod commands;
mod estimators;
mod distributions;
mod dual;
mod calibration;
mod geometry;
mod equations;
mod events;
mod errata;
mod identities;
mod layering;
mod sources;
