//! Tests of the kernel of contact dynamics: consequences of the laws, brute force, exact arithmetic, closed forms.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod detection;
mod detection_bounds;
mod detection_exact;
mod directions;
mod generators;
mod cells;
mod lmgc90;
mod local;
mod local_bounds;
mod preparation;
mod profile;
mod observables;
mod observables_exact;
mod assemblies;
mod delassus;
mod shapes;
mod solid_fraction;
mod refusals;
mod siconos;
mod steps;
mod stored;
mod solvers;
mod step_bounds;
mod strips;
mod sweep_stops;
mod sweeps;
mod systems;
mod worlds;
