//! Tests of the kernel of contact dynamics: consequences of the laws, brute force, exact arithmetic, closed forms.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod detection;
mod detection_exact;
mod generators;
mod local;
mod assemblies;
mod delassus;
mod shapes;
mod steps;
mod solvers;
mod sweeps;
mod systems;
