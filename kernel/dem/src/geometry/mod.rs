//! Pair geometry: functions of positions, radii and their rates. Geometry knows no force.

mod angle;
mod contact;
mod mixed_arms;
mod pair_frame;

pub(crate) use angle::small_turn;
pub use angle::{angle_of, reversed, turn, wrapped};
pub use contact::{
    Arm, ContactDistance, FocalArm, MeanArm, RadiusArm, contact_area, contact_half_length,
    cylinder_contact_area, cylinder_displaced_volume, displaced_volume, focal_distance,
    mean_distance, mean_distance_of_extremities,
};
pub use mixed_arms::{Lever, MixedArms, Translation};
pub use pair_frame::{PairFrame, PairMotion, focal_point, overlap_factor};
