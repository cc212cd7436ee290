//! Where detection begins and ends: each bound holds to a billionth of itself.

use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::detection::{
    DetectionSettings, Feature, HalfPlane, Placed, PointLine, Separation, Touch, detect,
    separating_side,
};
use gouge_contact_dynamics::shape::Shapes;

/// A little more and a little less than one.
const MORE: f64 = 1.0 + 1e-9;
const LESS: f64 = 1.0 - 1e-9;
/// Gaps up to 0.04 m count, points nearer than 2e-4 m are merged, ties are within 2e-6 m.
const DIAMETER: f64 = 2.0;
const FLOOR: HalfPlane = HalfPlane {
    position: Vec2 { x: 0.0, y: 0.0 },
    normal: Vec2 { x: 0.0, y: 1.0 },
};
/// Tilt of a box in rad.
const TILT: f64 = 0.01;
/// A foot with a side of 0.1 m that rises by 0.5 rad, and one with a level side of 0.1 m.
const SLANTED: [(f64, f64); 4] = [
    (0.0, 0.0),
    (0.08775825618903728, 0.0479425538604203),
    (1.0, 2.0),
    (-1.0, 1.0),
];
const LEVEL: [(f64, f64); 4] = [(0.0, 0.0), (0.1, 0.0), (1.0, 2.0), (-1.0, 2.0)];

#[derive(Clone, Copy)]
enum Kind {
    /// With this radius.
    Disc(f64),
    /// With this half width and this angle.
    Box(f64, f64),
    /// With a lowest vertex, and of this scale.
    Foot([(f64, f64); 4], f64),
}
use Kind::{Box, Disc, Foot};

fn with<T>(kinds: [Kind; 2], action: impl FnOnce(&Placed, &Placed) -> T) -> T {
    let mut shapes = Shapes::new();
    let disc = shapes.add_disc();
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let mut polygon = |corners: [(f64, f64); 4]| {
        let corners = corners.map(|(x, y)| Vec2::new(x, y));
        shapes.add_polygon(&corners).unwrap()
    };
    let made = kinds.map(|kind| match kind {
        Disc(radius) => (disc, radius, 0.0),
        Box(half, angle) => (polygon(corners), half, angle),
        Foot(corners, scale) => (polygon(corners), scale, 0.0),
    });
    let [a, b] = made.map(|(id, scale, angle)| Placed::new(shapes.outline(id), scale, angle));
    action(&a, &b)
}

fn found(
    kinds: [Kind; 2],
    d: (f64, f64),
    settings: &DetectionSettings,
) -> (Separation, Vec<Touch>) {
    let mut touches = Vec::new();
    let d = Vec2::new(d.0, d.1);
    let separation = with(kinds, |a, b| detect(a, b, d, settings, &mut touches));
    (separation, touches)
}

fn points(kinds: [Kind; 2], d: (f64, f64)) -> usize {
    let settings = DetectionSettings::for_diameter(DIAMETER);
    found(kinds, d, &settings).1.len()
}

/// Points of a shape whose lowest vertex has a gap from the floor; the floor is at the origin.
fn on_floor(kind: Kind, gap: f64, settings: &DetectionSettings) -> Vec<Touch> {
    let mut touches = Vec::new();
    with([kind, Disc(1.0)], |shape, _| {
        let d = Vec2::new(0.3, gap - lowest(shape));
        FLOOR.detect(shape, d, settings, &mut touches)
    });
    touches
}

fn lowest(shape: &Placed) -> f64 {
    if let Some(radius) = shape.disc_radius() {
        return -radius;
    }
    let heights = (0..4).map(|k| shape.to_space(shape.vertex(k)).y);
    heights.fold(f64::MAX, f64::min)
}

#[test]
fn gaps_up_to_the_alert_distance_have_points() {
    let settings = DetectionSettings::for_diameter(DIAMETER);
    let rise = 2.0 * TILT.sin();
    for (factor, counts) in [(LESS, 1), (MORE, 0)] {
        let gap = 0.04 * factor;
        let (disc, square) = (Disc(1.0), Box(1.0, 0.0));
        for kinds in [[disc, disc], [square, disc], [disc, square]] {
            assert_eq!(points(kinds, (2.0 + gap, 0.0)), counts);
        }
        assert_eq!(points([square; 2], (2.0 + gap, 0.1)), 2 * counts);
        assert_eq!(on_floor(disc, gap, &settings).len(), counts);
        assert_eq!(on_floor(square, gap, &settings).len(), 2 * counts);
        // Only the higher one of two vertices is near the limit, or only the lower one.
        let tilted = Box(1.0, TILT);
        let foot = TILT.cos() + TILT.sin();
        let height = |gap: f64| 3.0 + foot + gap;
        let wide = Box(3.0, 0.0);
        assert_eq!(
            points([wide, tilted], (0.0, height(gap - rise))),
            1 + counts
        );
        assert_eq!(on_floor(tilted, gap - rise, &settings).len(), 1 + counts);
        assert_eq!(points([wide, tilted], (0.0, height(gap))), counts);
        assert_eq!(points([tilted, wide], (0.0, -height(gap))), counts);
    }
}

#[test]
fn points_nearer_than_the_merge_distance_are_one() {
    for (factor, counts) in [(LESS, 1), (MORE, 2)] {
        let shared = 2e-4 * factor;
        assert_eq!(points([Box(1.0, 0.0); 2], (2.0 - shared, 2.0)), counts);
        let settings = DetectionSettings {
            alert_distance: 0.5,
            merge_distance: 0.1,
            ..DetectionSettings::for_diameter(DIAMETER)
        };
        assert_eq!(on_floor(Foot(LEVEL, factor), 0.1, &settings).len(), counts);
        let slanted = Foot(SLANTED, factor);
        let wide = Box(3.0, 0.0);
        let lowest = with([slanted, wide], |shape, _| lowest(shape));
        let (_, touches) = found([wide, slanted], (0.3, 3.05 - lowest), &settings);
        assert_eq!(touches.len(), counts);
    }
}

/// The first shape has the reference side, unless the second one separates by more than the tie distance.
#[test]
fn ties_are_within_the_tie_distance() {
    let kinds = [Box(1.0, TILT), Box(3.0, 0.0)];
    let d = Vec2::new(0.0, -(3.0 + TILT.cos() + TILT.sin() + 0.03));
    let [first, second] = with(kinds, |a, b| {
        let sides = [
            separating_side(a, b, d, 1.0),
            separating_side(b, a, -d, 1.0),
        ];
        sides.map(|side| side.separation)
    });
    assert!(second > first + 1e-3 && (second - 0.03).abs() < 1e-14);
    for (factor, is_second) in [(LESS, true), (MORE, false)] {
        let settings = DetectionSettings {
            tie_distance: (second - first) * factor,
            ..DetectionSettings::for_diameter(DIAMETER)
        };
        let (separation, _) = found(kinds, (d.x, d.y), &settings);
        assert_eq!(separation.normal == Vec2::new(0.0, -1.0), is_second);
        assert!((separation.distance - second).abs() < 1e-14);
    }
    // Of equal separations, that of the first shape.
    let exact = DetectionSettings {
        alert_distance: 0.5,
        tie_distance: 0.0,
        ..DetectionSettings::for_diameter(DIAMETER)
    };
    let (_, touches) = found([Box(3.0, 0.0), Box(1.0, 0.0)], (4.25, 0.0), &exact);
    let features: Vec<_> = touches.iter().map(|touch| touch.feature).collect();
    assert_eq!(features, [0, 3].map(Feature::of_second));
    let usual = DetectionSettings::for_diameter(DIAMETER);
    let near = |length: f64, expected: f64| assert!((length / expected - 1.0).abs() < 1e-15);
    near(usual.tie_distance / usual.merge_distance, 0.01);
    near(usual.merge_distance / usual.alert_distance, 0.005);
}

/// Beyond the end of a side there are no points; at its end, the corner of the side makes the point.
#[test]
fn sides_end_at_their_corners() {
    let kinds = [Box(3.0, 0.0), Box(1.0, 0.0)];
    let settings = DetectionSettings::for_diameter(DIAMETER);
    for (beyond, counts) in [(-6e-9, 1), (6e-9, 0)] {
        assert_eq!(points(kinds, (-4.0 - beyond, 4.01)), counts);
        let (_, touches) = found(kinds, (-2.0 - beyond, 4.01), &settings);
        let corners: Vec<_> = (0..4).map(Feature::of_second).collect();
        let own = touches.iter().filter(|t| corners.contains(&t.feature));
        assert_eq!((touches.len(), own.count()), (2, 1 + counts));
    }
    // A disc so near to the corner feels its direction.
    let (_, touches) = found([Box(1.0, 0.0), Disc(0.005)], (-1.0 - 1e-6, 1.01), &settings);
    assert!((touches[0].normal.x + 1e-4).abs() < 1e-9);
}

/// The side that separates most is found where another one is nearly as good.
#[test]
fn the_best_side_is_best_by_a_little() {
    let boxes = [Box(1.0, 0.0); 2];
    let separation = |x: f64, y: f64, enough: f64| {
        with(boxes, |a, b| separating_side(a, b, Vec2::new(x, y), enough)).separation
    };
    for lead in [1e-7, -1e-7] {
        let found = separation(2.5, 2.5 + lead, 9.0);
        assert!((found - (0.5 + lead.max(0.0))).abs() < 1e-14, "{found}");
    }
    assert!((separation(2.5, 2.6, 0.5 * MORE) - 0.6).abs() < 1e-14);
    // A disc whose centre is in the box.
    let settings = DetectionSettings::for_diameter(DIAMETER);
    for lead in [1e-7, -1e-7] {
        let (inside, _) = found([Box(1.0, 0.0), Disc(0.1)], (0.9, 0.9 + lead), &settings);
        assert!((inside.distance - (lead.max(0.0) - 0.2)).abs() < 1e-14);
    }
}

/// Points lie in the middle between body and floor, or on one line at the mean of their heights.
#[test]
fn points_lie_half_way_to_the_floor() {
    let settings = |line| DetectionSettings {
        alert_distance: 0.1,
        line,
        ..DetectionSettings::for_diameter(DIAMETER)
    };
    let height = |touch: &Touch| touch.arms[0].y;
    let half_way = settings(PointLine::HalfWay);
    let disc = on_floor(Disc(1.0), 0.06, &half_way);
    assert!((height(&disc[0]) - 0.03).abs() < 1e-14 && (disc[0].arms[1].y + 1.03).abs() < 1e-14);
    let rise = 2.0 * TILT.sin();
    let tilted = on_floor(Box(1.0, TILT), 0.06, &half_way);
    let mut heights: Vec<_> = tilted.iter().map(height).collect();
    heights.sort_unstable_by(f64::total_cmp);
    assert!((heights[0] - 0.03).abs() < 1e-14 && (heights[1] - 0.03 - 0.5 * rise).abs() < 1e-14);
    let common = on_floor(Box(1.0, TILT), 0.06, &settings(PointLine::Common));
    for touch in &common {
        assert!((height(touch) - 0.03 - 0.25 * rise).abs() < 1e-14);
    }
}

/// Discs in the same place separate along x.
#[test]
fn concentric_discs_separate_along_x() {
    let settings = DetectionSettings::for_diameter(DIAMETER);
    let (separation, touches) = found([Disc(1.0), Disc(0.5)], (0.0, 0.0), &settings);
    assert_eq!(
        (separation.distance, separation.normal),
        (-1.5, Vec2::new(1.0, 0.0))
    );
    assert_eq!(touches.len(), 1);
}
