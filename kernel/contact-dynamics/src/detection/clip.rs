//! Contact points of two polygons: the incident side is clipped to the extent of the reference side.

use super::axis::SeparatingSide;
use super::{DetectionSettings, Feature, Placed, PointLine, Touch};
use gouge_common::geometry::Vec2;

/// A point of the incident side, in coordinates of the reference side.
#[derive(Clone, Copy, Debug)]
struct End {
    /// Distance along the reference side from its first vertex, in m.
    along: f64,
    /// Distance from the line of the reference side in m.
    gap: f64,
    feature: Feature,
}

/// The polygon whose side is the reference, and the other one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Roles<'a> {
    pub reference: &'a Placed<'a>,
    pub incident: &'a Placed<'a>,
    /// Displacement from the centre of the reference polygon to the centre of the incident one.
    pub d: Vec2,
    /// Whether the reference polygon is the second of the pair.
    pub is_reversed: bool,
}

/// Append the contact points of two polygons.
pub(super) fn clip(
    roles: Roles,
    found: SeparatingSide,
    settings: &DetectionSettings,
    touches: &mut Vec<Touch>,
) {
    let Some(ends) = ends(roles, found) else {
        return;
    };
    let [first, second] = ends.map(|end| (end.gap <= settings.alert_distance).then_some(end));
    let (one, other) = match (first, second) {
        (Some(a), Some(b))
            if distance_squared(a, b) < settings.merge_distance * settings.merge_distance =>
        {
            (if b.gap < a.gap { b } else { a }, None)
        }
        (Some(a), Some(b)) if b.feature < a.feature => (b, Some(a)),
        (Some(a), b) => (a, b),
        (None, Some(b)) => (b, None),
        (None, None) => return,
    };
    let mean = other.map_or(one.gap, |end| 0.5 * (one.gap + end.gap));
    for end in [Some(one), other].into_iter().flatten() {
        let height = match settings.line {
            PointLine::Common => 0.5 * mean,
            PointLine::HalfWay => 0.5 * end.gap,
        };
        touches.push(touch(roles, found.side, end, height));
    }
}

fn distance_squared(a: End, b: End) -> f64 {
    let (along, gap) = (a.along - b.along, a.gap - b.gap);
    along * along + gap * gap
}

/// Both ends of the incident side, clipped to the extent of the reference side; none if the side lies beside it.
fn ends(roles: Roles, found: SeparatingSide) -> Option<[End; 2]> {
    let outline = roles.reference.outline;
    let side = outline.sides[found.side];
    let length = side.length * roles.reference.scale;
    let begin = vertex_end(roles, found, incident_side(roles, found));
    let next = roles.incident.outline.next(incident_side(roles, found));
    let end = vertex_end(roles, found, next);
    // The incident side runs against the reference side.
    let beyond = Feature::of(roles.is_reversed, outline.next(found.side));
    let before = Feature::of(roles.is_reversed, found.side);
    let (low, high) = if begin.along <= end.along {
        (begin, end)
    } else {
        (end, begin)
    };
    if high.along < 0.0 || low.along > length {
        return None;
    }
    let at = |along: f64, feature: Feature| End {
        along,
        gap: low.gap + (high.gap - low.gap) * ((along - low.along) / (high.along - low.along)),
        feature,
    };
    let clipped_low = if low.along < 0.0 {
        at(0.0, before)
    } else {
        low
    };
    let clipped_high = if high.along > length {
        at(length, beyond)
    } else {
        high
    };
    Some([clipped_high, clipped_low])
}

/// The side of the incident polygon whose normal is most opposite to that of the reference side. It ends or begins at
/// the deepest vertex.
fn incident_side(roles: Roles, found: SeparatingSide) -> usize {
    let normal = roles.reference.outline.sides[found.side].normal;
    let inward = roles.incident.to_body(-roles.reference.to_space(normal));
    let outline = roles.incident.outline;
    let (before, after) = (outline.previous(found.vertex), found.vertex);
    if outline.sides[after].normal.dot(inward) > outline.sides[before].normal.dot(inward) {
        after
    } else {
        before
    }
}

fn vertex_end(roles: Roles, found: SeparatingSide, vertex: usize) -> End {
    let reference = roles.reference;
    let side = reference.outline.sides[found.side];
    let in_space = roles.d + roles.incident.to_space(roles.incident.vertex(vertex));
    let point = reference.to_body(in_space);
    let tangent = side.normal.perpendicular();
    End {
        along: tangent.dot(point - reference.vertex(found.side)),
        gap: side.normal.dot(point) - reference.offset(found.side),
        feature: Feature::of(!roles.is_reversed, vertex),
    }
}

fn touch(roles: Roles, side_index: usize, end: End, height: f64) -> Touch {
    let reference = roles.reference;
    let side = reference.outline.sides[side_index];
    let tangent = side.normal.perpendicular();
    let point = reference.vertex(side_index) + tangent * end.along + side.normal * height;
    let arm = reference.to_space(point);
    let normal = reference.to_space(side.normal);
    let (arms, normal) = match roles.is_reversed {
        false => ([arm, arm - roles.d], normal),
        true => ([arm - roles.d, arm], -normal),
    };
    Touch {
        normal,
        arms,
        gap: end.gap,
        feature: end.feature,
    }
}
