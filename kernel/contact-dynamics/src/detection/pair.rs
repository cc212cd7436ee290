//! Contact points of a pair of shapes of any kind.

use super::clip::{Roles, clip};
use super::disc::{disc_disc, polygon_disc, reversed};
use super::{DetectionSettings, Placed, Touch, separating_side};
use gouge_common::geometry::Vec2;

/// Append the contact points of two shapes whose gaps do not exceed the alert distance, ordered by feature.
///
/// `d` is the displacement from the centre of the first to the centre of the second shape in m. Returns the separation
/// of the shapes in m: for polygons, that of the best separating side, which is their distance unless two vertices face
/// each other; beyond the alert distance, a lower bound.
pub fn detect(
    first: &Placed,
    second: &Placed,
    d: Vec2,
    settings: &DetectionSettings,
    touches: &mut Vec<Touch>,
) -> f64 {
    let touch = match (first.disc_radius(), second.disc_radius()) {
        (Some(one), Some(other)) => disc_disc([one, other], d),
        (None, Some(radius)) => polygon_disc(first, radius, d),
        (Some(radius), None) => reversed(polygon_disc(second, radius, -d)),
        (None, None) => return polygons(first, second, d, settings, touches),
    };
    if touch.gap <= settings.alert_distance {
        touches.push(touch);
    }
    touch.gap
}

/// Contact points of two polygons, by the separating axis and clipping.
fn polygons(
    first: &Placed,
    second: &Placed,
    d: Vec2,
    settings: &DetectionSettings,
    touches: &mut Vec<Touch>,
) -> f64 {
    let enough = settings.alert_distance;
    let by_first = separating_side(first, second, d, enough);
    if by_first.separation > enough {
        return by_first.separation;
    }
    let by_second = separating_side(second, first, -d, enough);
    if by_second.separation > enough {
        return by_second.separation;
    }
    let is_reversed = by_second.separation > by_first.separation + settings.tie_distance;
    let (reference, incident, d, found) = match is_reversed {
        false => (first, second, d, by_first),
        true => (second, first, -d, by_second),
    };
    let roles = Roles {
        reference,
        incident,
        d,
        is_reversed,
    };
    clip(roles, found, settings, touches);
    by_first.separation.max(by_second.separation)
}
