//! Rotations of both ends of a pair in the pair frame since the interaction began, thesis eqs. (30)-(32).

use crate::geometry::{small_turn, turn, wrapped};
use core::f64::consts::PI;
use gouge_common::geometry::Vec2;
use gouge_common::lanes::Lanes;
use gouge_common::pair::map_ends;

/// Rotations of both ends in rad by the regular path, and whether that path applies.
///
/// It applies if the frame has rotated little from its reference direction and no angle needs wrapping to [-pi, pi).
///
/// `angles` are the angles of the particles. `rest` are those without rotation, for a frame along `reference`.
/// `normal` is the present direction of the frame.
#[inline(always)]
pub(super) fn regular_rotations<S: Lanes>(
    angles: [S; 2],
    (reference, rest): (Vec2<S>, [S; 2]),
    normal: Vec2<S>,
    wraps_angles: bool,
) -> ([S; 2], bool) {
    let (frame_rotation, is_small) = small_turn(reference, normal);
    let rotations = relative_to_frame(angles, rest, frame_rotation);
    let limit = S::from_f64(if wraps_angles { PI } else { f64::INFINITY });
    let is_wrapped = (rotations[0].abs() < limit) & (rotations[1].abs() < limit);
    (rotations, is_small & is_wrapped)
}

/// Rotations of both ends in rad by the general path.
///
/// If the frame has rotated far, its present direction becomes the new reference direction and the rest angles rotate
/// with it. Rotations thus remain functions of state and never jump.
pub(super) fn general_rotations<S: Lanes>(
    angles: [S; 2],
    (reference, rest): (&mut Vec2<S>, &mut [S; 2]),
    normal: Vec2<S>,
    wraps_angles: bool,
) -> [S; 2] {
    let (frame_rotation, is_small) = turn(*reference, normal);
    let rotations = relative_to_frame(angles, *rest, frame_rotation);
    if !is_small {
        *reference = normal;
        *rest = map_ends(*rest, |angle| angle + frame_rotation);
    }
    if wraps_angles {
        map_ends(rotations, wrapped)
    } else {
        rotations
    }
}

/// Particle angles less rest angles less the rotation of the frame, all in rad.
#[inline(always)]
fn relative_to_frame<S: Lanes>(angles: [S; 2], rest: [S; 2], frame_rotation: S) -> [S; 2] {
    map_ends([0, 1], |end| angles[end] - rest[end] - frame_rotation)
}
