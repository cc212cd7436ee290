//! Tests of the kernel of peridynamic grains: consequences of the laws, exact arithmetic, quadrature, closed forms.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod quadrature;

mod cloud;

mod material;

mod bond_law;

mod contact_law;

mod wall_law;

mod lattice_sums;

mod vibrations;

mod balance;

mod breaking;

mod identical;

mod crack_start;

mod friction;

mod robust;

mod observables;
