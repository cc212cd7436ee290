//! What a state shows: contacts and their forces, stress, anisotropies, coordination, solid fraction.
//!
//! A [`Network`] holds the force-bearing contacts of one step. [`Sums`], [`AngularSums`] and [`Connectivity`] add up
//! what they find in the networks of many steps; ratios are taken of the sums, because a mean of ratios is biased.

mod angular;
mod anisotropy;
mod connectivity;
mod network;
mod points;
mod profile;
mod solid_fraction;
mod sums;
mod columns;
mod vertices;

pub use angular::{AngularSums, Bin};
pub use anisotropy::Anisotropies;
pub use connectivity::{Connectivity, MOST_CONTACTS};
pub use network::{Contact, ContactKind, Network, NetworkSettings, WallContact};
pub use points::{PointForce, add_body_moments, point_forces};
pub use profile::Profile;
pub use solid_fraction::{Slab, area_in_slab, solid_area};
pub use sums::{Harmonic, KindSums, Sums};
pub use vertices::vertex_vertex_contacts;
