//! Tests of the kernel of peridynamic grains: consequences of the laws, exact arithmetic, quadrature, closed forms.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod exact;
mod generators;
mod interior;
mod meshes;
mod section_five;
mod shapes;
