//! Estimators that need no model: they read points, radii or a contact network.

mod deformation;
mod fragments;
mod network;
mod packing;
mod radial;
mod stress;
mod tensor;

pub use deformation::displacement_gradient;
pub use fragments::{Fragments, connected};
pub use network::{ContactNetwork, NetworkContact};
pub use packing::packing_fraction;
pub use radial::{RadialDistribution, Region, radial_distribution, visible_fraction};
pub use tensor::Tensor;
