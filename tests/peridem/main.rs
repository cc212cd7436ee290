//! Tests of the kernel of peridynamic grains: consequences of the laws, exact arithmetic, quadrature, closed forms.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod quadrature;

mod material;

mod bond_law;

mod contact_law;

mod wall_law;
