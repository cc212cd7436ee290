//! The kernel of deformable, breakable grains by bond-based peridynamics (PeriDEM).
//!
//! Each grain is a cloud of nodes with areas. Bonds within a horizon hold it together and break when they are stretched
//! too far; nodes of different grains, and nodes of one grain without a bond, repel each other within the contact radius.
//! Source: D. Bhattacharya and R. P. Lipton, *Simulating grain shape effects and damage in granular media using PeriDEM*,
//! SIAM J. Sci. Comput. 45, B1 (2023), cited as peridem (3.2).
//!
//! In order of dependency, and each module uses only modules listed above it. All quantities are in SI units; areas stand
//! for volumes of unit thickness, so that masses and forces are per metre of depth.

pub mod error;
pub mod shape;
pub mod interior;
pub mod mesh;
pub mod material;
pub mod bond_law;
pub mod contact_law;
pub mod wall_law;
pub mod grain;
pub mod bonds;
pub mod contacts;
pub mod state;
pub mod forces;
pub mod limits;
pub mod energy;
mod guard;
pub mod world;
pub mod mode;
pub mod record;
pub mod observables;
