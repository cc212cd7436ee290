//! Contact points of discs, with each other and with polygons.

use super::{Feature, Placed, Touch};
use gouge_common::geometry::Vec2;

/// The point between two discs, whatever their gap.
///
/// The normal of concentric discs is the x axis.
pub(super) fn disc_disc(radii: [f64; 2], d: Vec2) -> Touch {
    let distance = d.norm();
    let normal = if distance > 0.0 {
        d * (1.0 / distance)
    } else {
        Vec2::new(1.0, 0.0)
    };
    let gap = distance - radii[0] - radii[1];
    let arm = normal * (radii[0] + 0.5 * gap);
    Touch {
        normal,
        arms: [arm, arm - d],
        gap,
        feature: Feature::SINGLE,
    }
}

/// The point between a polygon and a disc whose centre is displaced by `d`, whatever their gap: at the nearest side or
/// vertex, half-way between the surfaces.
pub(super) fn polygon_disc(polygon: &Placed, radius: f64, d: Vec2) -> Touch {
    let centre = polygon.to_body(d);
    let side = nearest_side(polygon, centre);
    let (normal, surface, distance) = nearest_point(polygon, side, centre);
    let gap = distance - radius;
    let arm = polygon.to_space(surface + normal * (0.5 * gap));
    Touch {
        normal: polygon.to_space(normal),
        arms: [arm, arm - d],
        gap,
        feature: Feature::SINGLE,
    }
}

/// The touch as seen by the other shape.
pub(super) fn reversed(touch: Touch) -> Touch {
    let [first, second] = touch.arms;
    Touch {
        normal: -touch.normal,
        arms: [second, first],
        ..touch
    }
}

/// The side from which a point of the body frame is farthest outside, or least deep inside.
fn nearest_side(polygon: &Placed, point: Vec2) -> usize {
    let outline = polygon.outline;
    let distance = |side: usize| outline.sides[side].normal.dot(point) - polygon.offset(side);
    let start = outline.side_facing(point);
    let (mut best, mut largest) = (start, distance(start));
    for forward in [true, false] {
        let mut side = start;
        for _ in 1..outline.sides.len() {
            side = if forward {
                outline.next(side)
            } else {
                outline.previous(side)
            };
            if outline.sides[side].normal.dot(point) - polygon.inradius() <= largest {
                break;
            }
            if distance(side) > largest {
                (best, largest) = (side, distance(side));
            }
        }
    }
    best
}

/// Outward normal, surface point and signed distance of a point near a side.
fn nearest_point(polygon: &Placed, side: usize, point: Vec2) -> (Vec2, Vec2, f64) {
    let outline = polygon.outline;
    let normal = outline.sides[side].normal;
    let start = polygon.vertex(side);
    let along = normal.perpendicular().dot(point - start);
    let vertex = if along < 0.0 {
        Some(start)
    } else if along > outline.sides[side].length * polygon.scale {
        Some(polygon.vertex(outline.next(side)))
    } else {
        None
    };
    let distance = normal.dot(point) - polygon.offset(side);
    match vertex {
        Some(corner) if distance > 0.0 => {
            let from_corner = point - corner;
            let length = from_corner.norm();
            (from_corner * (1.0 / length), corner, length)
        }
        _ => (normal, point - normal * distance, distance),
    }
}
