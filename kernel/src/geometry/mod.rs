//! What can be said of positions and radii alone; geometry knows no force.

mod angle;
mod contact;
mod metric;
mod mixed_arms;
mod pair_frame;
mod vector;

pub(crate) use angle::small_turn;
pub use angle::{angle_of, reversed, turn, wrapped};
pub use contact::{
    Arm, ContactDistance, FocalArm, MeanArm, RadiusArm, contact_area, contact_half_length,
    cylinder_contact_area, cylinder_displaced_volume, displaced_volume, focal_distance,
    mean_distance, mean_distance_of_extremities,
};
pub use metric::{Metric, Open, PeriodicX};
pub use mixed_arms::{Lever, MixedArms, Translation};
pub use pair_frame::{PairFrame, PairMotion, focal_point, overlap_factor};
pub use vector::Vec2;
