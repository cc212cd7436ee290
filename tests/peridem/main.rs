//! Tests of the kernel of peridynamic grains: consequences of the laws, exact arithmetic, quadrature, closed forms.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod bond_law;
mod contact_law;
mod exact;
mod generators;
mod interior;
mod material;
mod meshes;
mod quadrature;
mod section_five;
mod shapes;
mod wall_law;
