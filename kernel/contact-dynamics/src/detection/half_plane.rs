//! Flat walls.

use super::{DetectionSettings, Feature, Placed, PointLine, Touch};
use gouge_common::geometry::Vec2;

/// A flat wall: the bodies are on the side to which the normal points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfPlane {
    /// A point of the surface in m.
    pub position: Vec2,
    /// Unit normal, out of the wall.
    pub normal: Vec2,
}

impl HalfPlane {
    /// Append the points of a shape, whose centre is displaced by `d` from the wall's position, within the alert
    /// distance. The wall is the first of the pair.
    ///
    /// All vertices of a polygon within the alert distance count, so that a polygon with many sides may have more than
    /// two points; vertices nearer to each other than the merge distance count once. Returns the smallest gap.
    pub fn detect(
        &self,
        shape: &Placed,
        d: Vec2,
        settings: &DetectionSettings,
        touches: &mut Vec<Touch>,
    ) -> f64 {
        let height = self.normal.dot(d);
        if let Some(radius) = shape.disc_radius() {
            let gap = height - radius;
            if gap <= settings.alert_distance {
                let arm = -self.normal * (radius + 0.5 * gap);
                touches.push(self.touch(d, arm, gap, Feature::SINGLE));
            }
            return gap;
        }
        let start = touches.len();
        let (deepest, reach) = shape.outline.support(shape.to_body(-self.normal));
        self.append_vertices(shape, d, deepest, settings, touches);
        let found = &mut touches[start..];
        found.sort_unstable_by_key(|touch| touch.feature);
        if settings.line == PointLine::Common && !found.is_empty() {
            self.align(found);
        }
        height - shape.scale * reach
    }

    fn touch(&self, d: Vec2, arm: Vec2, gap: f64, feature: Feature) -> Touch {
        Touch {
            normal: self.normal,
            arms: [d + arm, arm],
            gap,
            feature,
        }
    }

    /// Walk from the deepest vertex both ways while vertices are near.
    fn append_vertices(
        &self,
        shape: &Placed,
        d: Vec2,
        deepest: usize,
        settings: &DetectionSettings,
        touches: &mut Vec<Touch>,
    ) {
        let outline = shape.outline;
        let first = touches.len();
        let mut left = outline.vertices.len();
        for is_forward in [true, false] {
            let mut vertex = deepest;
            if !is_forward {
                vertex = outline.previous(deepest);
            }
            while left > 0 {
                let arm = shape.to_space(shape.vertex(vertex));
                let gap = self.normal.dot(d + arm);
                if gap > settings.alert_distance || gap.is_nan() {
                    break;
                }
                let feature = Feature::of_second(vertex);
                let half_way = arm - self.normal * (0.5 * gap);
                let touch = self.touch(d, half_way, gap, feature);
                if !is_repeated(&touches[first..], &touch, settings.merge_distance) {
                    touches.push(touch);
                }
                left -= 1;
                vertex = if is_forward {
                    outline.next(vertex)
                } else {
                    outline.previous(vertex)
                };
            }
        }
    }

    /// Move all points along the normal to half the mean of their gaps.
    fn align(&self, touches: &mut [Touch]) {
        let mean = touches.iter().map(|touch| touch.gap).sum::<f64>() / touches.len() as f64;
        for touch in touches {
            let shift = self.normal * (0.5 * mean - 0.5 * touch.gap);
            touch.arms = touch.arms.map(|arm| arm + shift);
        }
    }
}

/// Whether a deeper vertex of the same shape has been kept nearby. On each side of the deepest vertex, vertices come in
/// the order of their depth.
fn is_repeated(kept: &[Touch], new: &Touch, merge_distance: f64) -> bool {
    let near = |touch: &Touch| (touch.arms[1] - new.arms[1]).norm() < merge_distance;
    kept.iter().any(near)
}
