//! Detection of contact points between two shapes: azema section II, where it is given in words.
//!
//! All functions work relative to the centre of the first shape, so that their errors do not grow with the distance
//! from the origin. They append to a list and allocate nothing once it is large enough.

mod placed;
mod touch;
mod axis;
mod clip;
mod disc;
mod half_plane;
mod pair;

pub use axis::{SeparatingSide, separating_side};
pub use half_plane::HalfPlane;
pub use pair::detect;
pub use placed::Placed;
pub use touch::{DetectionSettings, Feature, PointLine, Separation, Touch};
