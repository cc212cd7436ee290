//! How far both particles have turned in the frame of their pair since a contact or bond began, thesis eqs.
//! (30)-(32).

use crate::geometry::{small_turn, turn, wrapped};
use core::f64::consts::PI;
use gouge_common::geometry::Vec2;
use gouge_common::lanes::Lanes;
use gouge_common::pair::map_ends;

/// Angles in rad by which both particles have turned in the frame, and whether they hold: not if the frame has
/// turned far from its reference, or if an angle must be wrapped to [-pi, pi).
///
/// `angles` are those of the particles, `rest` those at which nothing is turned while the frame points along
/// `reference`; now it points along `normal`.
#[inline(always)]
pub(super) fn turned<S: Lanes>(
    angles: [S; 2],
    (reference, rest): (Vec2<S>, [S; 2]),
    normal: Vec2<S>,
    wraps_angles: bool,
) -> ([S; 2], bool) {
    let (of_frame, is_small) = small_turn(reference, normal);
    let turned = in_frame(angles, rest, of_frame);
    let limit = S::from_f64(if wraps_angles { PI } else { f64::INFINITY });
    let is_wrapped = (turned[0].abs() < limit) & (turned[1].abs() < limit);
    (turned, is_small & is_wrapped)
}

/// The same for any frame.
///
/// If the frame has turned far, its present direction becomes the new reference and the rest angles turn with
/// it, so that angles stay functions of the state and never jump.
pub(super) fn turned_far<S: Lanes>(
    angles: [S; 2],
    (reference, rest): (&mut Vec2<S>, &mut [S; 2]),
    normal: Vec2<S>,
    wraps_angles: bool,
) -> [S; 2] {
    let (of_frame, is_small) = turn(*reference, normal);
    let turned = in_frame(angles, *rest, of_frame);
    if !is_small {
        *reference = normal;
        *rest = map_ends(*rest, |angle| angle + of_frame);
    }
    if wraps_angles {
        map_ends(turned, wrapped)
    } else {
        turned
    }
}

/// Angles of both ends less those at rest and the turn of the frame, all in rad.
#[inline(always)]
fn in_frame<S: Lanes>(angles: [S; 2], rest: [S; 2], of_frame: S) -> [S; 2] {
    map_ends([0, 1], |end| angles[end] - rest[end] - of_frame)
}
