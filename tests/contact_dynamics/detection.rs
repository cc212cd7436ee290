//! Contact points of random pairs: brute force over directions, symmetries, surfaces.

use crate::generators::sides;
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::detection::{
    DetectionSettings, Feature, HalfPlane, Placed, PointLine, Separation, Touch, detect,
};
use gouge_contact_dynamics::shape::Shapes;
use proptest::prelude::*;

/// Sides (0 for a disc), size and angle of a body.
type Body = (usize, f64, f64);

fn polygon() -> impl Strategy<Value = Body> {
    (sides(), 0.3..1.2, -4.0..4.0)
}

fn any_shape() -> impl Strategy<Value = Body> {
    (
        prop_oneof![1 => Just(0usize), 3 => sides()],
        0.3..1.2,
        -4.0..4.0,
    )
}

fn with_pair<T>(bodies: [Body; 2], action: impl FnOnce(&Placed, &Placed) -> T) -> T {
    let mut shapes = Shapes::new();
    let ids = bodies.map(|(n, ..)| match n {
        0 => shapes.add_disc(),
        _ => shapes.add_regular(n).unwrap(),
    });
    let placed = |k: usize| Placed::new(shapes.outline(ids[k]), bodies[k].1, bodies[k].2);
    action(&placed(0), &placed(1))
}

fn found(bodies: [Body; 2], d: Vec2, settings: &DetectionSettings) -> (Separation, Vec<Touch>) {
    let mut touches = Vec::new();
    let separation = with_pair(bodies, |a, b| detect(a, b, d, settings, &mut touches));
    (separation, touches)
}

/// Extent of a shape in a direction of space.
fn reach(shape: &Placed, direction: Vec2) -> f64 {
    if let Some(radius) = shape.disc_radius() {
        return radius;
    }
    let vertex = |k| shape.to_space(shape.vertex(k)).dot(direction);
    (0..shape.outline.vertices.len())
        .map(vertex)
        .fold(f64::MIN, f64::max)
}

fn unit(angle: f64) -> Vec2 {
    Vec2::new(angle.cos(), angle.sin())
}

/// Distance of a point of space, relative to the centre, from the surface of a shape.
fn distance_from_surface(shape: &Placed, point: Vec2) -> f64 {
    if let Some(radius) = shape.disc_radius() {
        return (point.norm() - radius).abs();
    }
    let n = shape.outline.vertices.len();
    let vertex = |k: usize| shape.to_space(shape.vertex(k % n));
    (0..n)
        .map(|k| {
            let (start, along) = (vertex(k), vertex(k + 1) - vertex(k));
            let part = ((point - start).dot(along) / along.norm_squared()).clamp(0.0, 1.0);
            (point - start - along * part).norm()
        })
        .fold(f64::MAX, f64::min)
}

fn settings(line: PointLine, alert_distance: f64) -> DetectionSettings {
    DetectionSettings {
        alert_distance,
        line,
        ..DetectionSettings::for_diameter(1.0)
    }
}

/// Displacement such that the bodies touch to within a gap along a direction.
fn displacement(bodies: [Body; 2], direction: f64, gap: f64) -> Vec2 {
    let n = unit(direction);
    n * (with_pair(bodies, |a, b| reach(a, n) + reach(b, -n)) + gap)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// The separation is the largest over all directions of space, not only those of sides. The step between sampled
    /// directions costs at most the extent of the pair times that step.
    #[test]
    fn no_direction_separates_overlapping_shapes_more(
        a in any_shape(), b in any_shape(), direction in -4.0..4.0, gap in -0.3..0.0,
    ) {
        let d = displacement([a, b], direction, gap);
        // Without ties: the reference side is then the best one, and its normal that of the separation.
        let without_ties = DetectionSettings { tie_distance: 0.0, ..settings(PointLine::Common, 0.02) };
        let (separation, touches) = found([a, b], d, &without_ties);
        let samples = 20_000;
        let step = core::f64::consts::TAU / samples as f64;
        let best = with_pair([a, b], |a, b| {
            let along = |k: i32| {
                let n = unit(step * f64::from(k));
                n.dot(d) - reach(a, n) - reach(b, -n)
            };
            (0..samples).map(along).fold(f64::MIN, f64::max)
        });
        if separation.distance > 0.0 {
            return Ok(());
        }
        prop_assert!(best <= separation.distance + 1e-12, "{best} {separation:?}");
        prop_assert!(best >= separation.distance - step * d.norm() - 1e-12, "{best} {separation:?}");
        // Overlapping shapes have a contact point at the deepest vertex.
        let deepest = touches.iter().map(|touch| touch.gap).fold(f64::MAX, f64::min);
        prop_assert!((deepest - separation.distance).abs() <= 1e-12, "{deepest} {separation:?}");
    }

    /// Half-way points lie half a gap from both surfaces.
    #[test]
    fn half_way_points_lie_between_the_surfaces(
        a in any_shape(), b in any_shape(), direction in -4.0..4.0, gap in -0.03..0.02,
    ) {
        let d = displacement([a, b], direction, gap);
        let (_, touches) = found([a, b], d, &settings(PointLine::HalfWay, 0.02));
        for touch in touches {
            let half = touch.normal * (0.5 * touch.gap);
            let (one, other) = (touch.arms[0] - half, touch.arms[1] + half);
            let distances = with_pair([a, b], |a, b| [distance_from_surface(a, one), distance_from_surface(b, other)]);
            prop_assert!(distances[0] < 1e-13 && distances[1] < 1e-13, "{distances:?} {touch:?}");
            prop_assert!((touch.normal.norm() - 1.0).abs() < 1e-15);
            prop_assert!((touch.arms[0] - touch.arms[1] - d).norm() < 1e-15);
            prop_assert!(touch.gap <= 0.02);
        }
    }

    /// Both points of a pair lie on one line along the tangent, at the mean height of the half-way points.
    #[test]
    fn common_points_share_one_line(
        a in polygon(), b in polygon(), direction in -4.0..4.0, gap in -0.03..0.02,
    ) {
        let d = displacement([a, b], direction, gap);
        let (_, common) = found([a, b], d, &settings(PointLine::Common, 0.02));
        let (_, half_way) = found([a, b], d, &settings(PointLine::HalfWay, 0.02));
        prop_assert_eq!(common.len(), half_way.len());
        prop_assert!(common.len() <= 2);
        let height = |touch: &Touch| touch.normal.dot(touch.arms[0]);
        let sum = |touches: &[Touch]| touches.iter().map(height).sum::<f64>();
        prop_assert!((sum(&common) - sum(&half_way)).abs() < 1e-14);
        for (one, other) in common.iter().zip(&half_way) {
            prop_assert!((height(one) - height(&common[0])).abs() < 1e-14);
            prop_assert!((one.normal.cross(one.arms[0] - other.arms[0])).abs() < 1e-14);
            prop_assert_eq!(one.feature, other.feature);
        }
        if let [one, other] = common.as_slice() {
            prop_assert!(one.feature < other.feature);
            prop_assert!((one.arms[0] - other.arms[0]).norm() > 0.9e-4);
        }
    }

    /// Turned space, and bodies in the other order, give the same points.
    #[test]
    fn points_do_not_depend_on_the_frame_or_the_order(
        a in any_shape(), b in any_shape(), direction in -4.0..4.0, gap in -0.03..0.01, turn in -3.0..3.0,
    ) {
        let d = displacement([a, b], direction, gap);
        let settings = settings(PointLine::Common, 0.02);
        let (separation, touches) = found([a, b], d, &settings);
        let turned = |v: Vec2| unit(turn) * v.x + unit(turn).perpendicular() * v.y;
        let bodies = [a, b].map(|(n, scale, angle)| (n, scale, angle + turn));
        let (again, others) = found(bodies, turned(d), &settings);
        let is_clear = touches.len() == others.len() && (turned(separation.normal) - again.normal).norm() < 1e-6;
        prop_assume!(is_clear);
        prop_assert!(separation.distance > 0.02 || (separation.distance - again.distance).abs() < 1e-13);
        for (one, other) in touches.iter().zip(&others) {
            prop_assert!((turned(one.arms[0]) - other.arms[0]).norm() < 1e-10);
            prop_assert!((one.gap - other.gap).abs() < 1e-12);
        }
        let (exchanged, mut others) = found([b, a], -d, &settings);
        // Beyond the alert distance the separation is a lower bound.
        let is_near = separation.distance <= 0.02 && exchanged.distance <= 0.02;
        prop_assert!(!is_near || (separation.distance - exchanged.distance).abs() < 1e-13);
        if (separation.normal + exchanged.normal).norm() < 1e-12 && others.len() == touches.len() {
            let along = |touch: &Touch| exchanged.normal.cross(touch.arms[1]);
            others.sort_by(|x, y| along(x).total_cmp(&along(y)));
            let mut touches = touches;
            touches.sort_by(|x, y| exchanged.normal.cross(x.arms[0]).total_cmp(&exchanged.normal.cross(y.arms[0])));
            for (one, other) in touches.iter().zip(&others) {
                prop_assert!((one.arms[0] - other.arms[1]).norm() < 1e-11);
            }
        }
    }

    /// A polygon of 60 sides touches like a disc.
    #[test]
    fn sixty_sides_are_nearly_a_disc(scale in 0.3..1.2, angle in -4.0..4.0, b in any_shape(), direction in -4.0..4.0) {
        let disc = (0, scale, 0.0);
        let d = displacement([disc, b], direction, -0.01);
        let (smooth, _) = found([disc, b], d, &settings(PointLine::Common, 0.02));
        let (angular, _) = found([(60, scale, angle), b], d, &settings(PointLine::Common, 0.05));
        let missing = scale * (1.0 - (core::f64::consts::PI / 60.0).cos());
        // Of shapes that are apart with vertices facing each other, the separating side gives less than the distance.
        prop_assert!(smooth.distance > 0.0 || angular.distance >= smooth.distance - 1e-13);
        prop_assert!(angular.distance <= smooth.distance + missing + 1e-13);
    }

    /// A wall touches exactly the vertices within the alert distance, except those next to a deeper one.
    #[test]
    fn a_wall_touches_all_vertices_that_are_near(body in polygon(), direction in -4.0..4.0, gap in -0.05..0.03f64) {
        let wall = HalfPlane { position: Vec2::new(3.0, 4.0), normal: unit(direction) };
        with_pair([body, body], |shape, _| -> Result<(), TestCaseError> {
            let d = wall.normal * (reach(shape, -wall.normal) + gap) + wall.normal.perpendicular() * 0.7;
            let mut touches = Vec::new();
            let smallest = wall.detect(shape, d, &settings(PointLine::HalfWay, 0.02), &mut touches);
            let heights = (0..body.0).map(|k| (k, wall.normal.dot(d + shape.to_space(shape.vertex(k)))));
            let near: Vec<_> = heights.filter(|&(_, height)| height <= 0.02).collect();
            prop_assert!((smallest - gap).abs() < 1e-13);
            prop_assert_eq!(near.len(), touches.len());
            for ((k, height), touch) in near.into_iter().zip(&touches) {
                prop_assert_eq!(touch.feature, Feature::of_second(k));
                prop_assert!((touch.gap - height).abs() < 1e-14);
            }
            Ok(())
        })?;
    }
}

/// Two aligned squares: both vertices of the smaller one, and they stay the features when the other side is the
/// reference.
#[test]
fn features_survive_a_change_of_the_reference_side() {
    let angle = core::f64::consts::FRAC_PI_4;
    for tilt in [-1e-4, 1e-4] {
        let bodies = [(4, 1.0, angle), (4, 0.5, angle + tilt)];
        let d = displacement(bodies, 0.5 * core::f64::consts::PI, -1e-3);
        let (_, touches) = found(bodies, d, &settings(PointLine::Common, 0.02));
        let features: Vec<_> = touches.iter().map(|touch| touch.feature).collect();
        assert_eq!(features, [Feature::of_second(2), Feature::of_second(3)]);
    }
}

/// A tilt that lets either square be the reference: the lower index keeps the role within the tie distance.
#[test]
fn ties_are_decided_for_the_first_body() {
    let angle = core::f64::consts::FRAC_PI_4;
    let bodies = [(4, 1.0, angle), (4, 1.0, angle + 1e-8)];
    let d = displacement(bodies, 0.5 * core::f64::consts::PI, -1e-3);
    let (forward, _) = found(bodies, d, &settings(PointLine::Common, 0.02));
    assert!((forward.normal - Vec2::new(0.0, 1.0)).norm() < 1e-15);
    let (backward, _) = found(
        [bodies[1], bodies[0]],
        -d,
        &settings(PointLine::Common, 0.02),
    );
    assert!((backward.normal - -unit(angle + 1e-8 + angle)).norm() < 1e-15);
}

/// Corners that pass each other across a gap have no point, although their separating side is near.
#[test]
fn corners_beside_each_other_do_not_touch() {
    let bodies = [(4, 1.0, 0.0), (4, 1.0, 0.0)];
    let d = Vec2::new(2.01, 0.005);
    let (separation, touches) = found(bodies, d, &settings(PointLine::Common, 0.02));
    assert!(separation.distance > 0.0 && separation.distance < 0.02);
    assert!(touches.is_empty(), "{touches:?}");
}

proptest! {
    /// The gap of a small disc is the distance of its centre from the surface of the polygon.
    #[test]
    fn a_disc_touches_the_nearest_feature(body in polygon(), x in -1.5..1.5, y in -1.5..1.5) {
        let d = Vec2::new(x, y);
        let disc = (0, 0.01, 0.0);
        let (separation, _) = found([body, disc], d, &settings(PointLine::Common, 0.02));
        let (distance, is_outside) = with_pair([body, disc], |shape, _| {
            let local = shape.to_body(d);
            let outside = |k: usize| shape.outline.sides[k].normal.dot(local) > shape.offset(k);
            (distance_from_surface(shape, d), (0..body.0).any(outside))
        });
        let expected = if is_outside { distance } else { -distance };
        prop_assert!((separation.distance + 0.01 - expected).abs() < 1e-13);
    }
}
