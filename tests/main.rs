//! The verification gate: one test binary, a module a subject.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod program;
mod worlds;
mod links;
mod integrators;
