//! Tests of the kernel of peridynamic grains: consequences of the laws, exact arithmetic, quadrature, closed forms.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod balance;
mod bond_law;
mod breaking;
mod cloud;
mod contact_law;
mod crack_start;
mod criteria;
mod exact;
mod faces;
mod friction;
mod generators;
mod guard;
mod identical;
mod interior;
mod lattice_sums;
mod limits;
mod material;
mod meshes;
mod mode;
mod observables;
mod quadrature;
mod refused;
mod robust;
mod section_five;
mod shapes;
mod single_steps;
mod vibrations;
mod wall_law;
