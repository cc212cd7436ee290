//! Contact points of a pair of shapes of any kind.

use super::clip::{Roles, clip};
use super::disc::{disc_disc, polygon_disc, reversed};
use super::{DetectionSettings, Placed, SeparatingSide, Separation, Touch, separating_side};
use gouge_common::geometry::Vec2;

/// Append the contact points of two shapes whose gaps do not exceed the alert distance, ordered by feature.
///
/// `d` is the displacement from the centre of the first to the centre of the second shape in m.
pub fn detect(
    first: &Placed,
    second: &Placed,
    d: Vec2,
    settings: &DetectionSettings,
    touches: &mut Vec<Touch>,
) -> Separation {
    let touch = match (first.disc_radius(), second.disc_radius()) {
        (Some(one), Some(other)) => disc_disc([one, other], d),
        (None, Some(radius)) => polygon_disc(first, radius, d),
        (Some(radius), None) => reversed(polygon_disc(second, radius, -d)),
        (None, None) => return polygons(first, second, d, settings, touches),
    };
    if touch.gap <= settings.alert_distance {
        touches.push(touch);
    }
    Separation {
        distance: touch.gap,
        normal: touch.normal,
    }
}

/// Contact points of two polygons, by the separating axis and clipping.
fn polygons(
    first: &Placed,
    second: &Placed,
    d: Vec2,
    settings: &DetectionSettings,
    touches: &mut Vec<Touch>,
) -> Separation {
    let enough = settings.alert_distance;
    let by_first = separating_side(first, second, d, enough);
    if by_first.separation > enough {
        return separation(first, by_first, false);
    }
    let by_second = separating_side(second, first, -d, enough);
    if by_second.separation > enough {
        return separation(second, by_second, true);
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
    Separation {
        distance: by_first.separation.max(by_second.separation),
        ..separation(reference, found, is_reversed)
    }
}

fn separation(reference: &Placed, found: SeparatingSide, is_reversed: bool) -> Separation {
    let normal = reference.to_space(reference.outline.sides[found.side].normal);
    Separation {
        distance: found.separation,
        normal: if is_reversed { -normal } else { normal },
    }
}
