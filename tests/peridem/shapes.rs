//! Shapes: areas, containment, and what is refused.

use crate::exact::{doubled_area, edges, meetings};
use crate::generators::{comb, pierced, plain, point, ring, shape};
use core::f64::consts::PI;
use gouge_common::geometry::Vec2;
use gouge_peridem::error::SetupError;
use gouge_peridem::shape::Outline;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use proptest::prelude::*;

fn relative(value: f64, expected: f64) -> f64 {
    (value / expected - 1.0).abs()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn areas_are_those_of_exact_arithmetic(shape in shape()) {
        let doubled: BigRational = shape.rings().map(doubled_area).sum();
        prop_assert!(relative(shape.area(), 0.5 * doubled.to_f64().unwrap()) < 1e-13);
        prop_assert!(doubled_area(shape.outer()).is_positive());
        prop_assert!(shape.holes().iter().all(|hole| doubled_area(hole).is_negative()));
    }

    /// Any few points of a small grid: a ring is accepted if and only if it is a simple polygon.
    #[test]
    fn simple_polygons_are_accepted(
        vertices in prop::collection::vec((0i8..6, 0i8..6), 3..7),
    ) {
        let ring: Vec<_> = vertices.iter().map(|&(x, y)| point(x.into(), y.into())).collect();
        let result = Outline::new(ring.clone(), Vec::new(), Vec::new());
        prop_assert_eq!(result.is_ok(), is_simple(&ring), "{:?}", result);
    }

    #[test]
    fn any_input_is_accepted_or_refused(
        rings in prop::collection::vec(prop::collection::vec(any_point(), 0..6), 1..4),
        cuts in prop::collection::vec([any_point(), any_point()], 0..3),
    ) {
        let [outer, holes @ ..] = rings.as_slice() else {
            unreachable!()
        };
        if let Ok(shape) = Outline::new(outer.clone(), holes.to_vec(), cuts) {
            prop_assert!(shape.area() > 0.0);
            prop_assert!(shape.outer().iter().all(|&vertex| shape.contains(vertex)));
        }
    }

    /// The mean over independent numbers is the mean over their extremes, because areas are linear in each.
    #[test]
    fn the_mean_perturbed_disc_is_smaller_than_its_smooth_limit(roundness in 0.2..0.9f64) {
        let sides = 8;
        let extremes = (0..1usize << sides).map(|bits| {
            let numbers: Vec<_> = (0..sides).map(|k| (bits >> k & 1) as f64).collect();
            Outline::perturbed_disc(1.0, roundness, &numbers).unwrap().area()
        });
        let mean = extremes.sum::<f64>() / f64::from(1 << sides);
        let disc = Outline::disc(1.0, sides).unwrap().area();
        let smooth = PI * (0.5 * (1.0 + roundness)).powi(2);
        prop_assert!(relative(mean, disc * (0.5 * (1.0 + roundness)).powi(2)) < 1e-13);
        prop_assert!(mean < 0.91 * smooth);
    }
}

/// Grid points, and now and then a number that is no coordinate.
fn any_point() -> impl Strategy<Value = Vec2> {
    let coordinate = || {
        prop_oneof![
            9 => (-4i8..5).prop_map(f64::from),
            1 => prop::num::f64::ANY,
        ]
    };
    (coordinate(), coordinate()).prop_map(|(x, y)| point(x, y))
}

/// Whether two edges share a point only if it is their common vertex: by rational parameters.
fn is_simple(ring: &[Vec2]) -> bool {
    let sides = edges(ring);
    let count = sides.len();
    let distinct = sides.iter().all(|[a, b]| a != b);
    let pairs = (0..count).flat_map(|j| (0..j).map(move |i| (i, j)));
    distinct
        && pairs.into_iter().all(|(i, j)| {
            let mut common = meetings(&sides[i][0], &sides[i][1], &sides[j]);
            common.sort();
            common.dedup();
            let neighbours = j == i + 1 || (i == 0 && j == count - 1);
            common.len() == usize::from(neighbours)
        })
}

/// The corrected area of Table 3 is that of the polygon; the printed one is not.
#[test]
fn the_plus_has_the_corrected_area() {
    for ratio in [0.1, 0.2, 0.5, 0.9] {
        for radius in [1.0, 3e-4] {
            let area = Outline::plus(radius, ratio).unwrap().area();
            let root = (2.0 / (ratio * ratio) - 1.0_f64).sqrt();
            let scale = (ratio * radius).powi(2);
            assert!(relative(area, scale * (4.0 * root - 2.0)) < 1e-13);
            assert!(relative(area, scale * (4.0 * root + 1.0)) > 0.05);
        }
    }
    let area = Outline::plus(1.0, 0.2).unwrap().area();
    assert!((area - 1.04).abs() < 0.001);
}

/// A plus is the union of two bars that share a square.
#[test]
fn the_plus_is_two_bars() {
    let shape = Outline::plus(1.0, 0.3).unwrap();
    let upper = shape.bounds().upper;
    let half_width = 0.3 * 0.5_f64.sqrt();
    let bars = 2.0 * (2.0 * upper.x) * (2.0 * half_width) - (2.0 * half_width).powi(2);
    assert!(relative(shape.area(), bars) < 1e-14);
    let distances: Vec<_> = shape.outer().iter().map(|vertex| vertex.norm()).collect();
    let at = |radius: f64| {
        distances
            .iter()
            .filter(|&&d| (d - radius).abs() < 1e-15)
            .count()
    };
    assert_eq!((at(1.0), at(0.3)), (8, 4));
}

/// Doubling the number of sides divides the missing area by four.
#[test]
fn polygons_converge_to_the_disc_and_the_ring() {
    let missing = |sides: usize| {
        let disc = PI - Outline::disc(1.0, sides).unwrap().area();
        let annulus = PI * 0.64 - Outline::annulus(1.0, 0.6, sides).unwrap().area();
        [disc, annulus]
    };
    for (coarse, fine) in missing(64).into_iter().zip(missing(128)) {
        assert!(coarse > 0.0 && relative(coarse / fine, 4.0) < 1e-3);
    }
}

#[test]
fn families_are_inscribed_in_their_disc() {
    let numbers = [0.0, 0.2, 1.0, 0.7, 0.4];
    let shapes = [
        Outline::disc(2.0, 20),
        Outline::square(2.0),
        Outline::plus(2.0, 0.2),
        Outline::annulus(2.0, 0.6, 24),
        Outline::perturbed_disc(2.0, 0.6, &numbers),
    ];
    for shape in shapes {
        assert!(relative(shape.unwrap().circumradius(), 2.0) < 1e-15);
    }
    let square = Outline::square(2.0).unwrap();
    assert!(relative(square.area(), 8.0) < 1e-15);
    let perturbed = Outline::perturbed_disc(2.0, 0.6, &numbers).unwrap();
    let least = perturbed
        .outer()
        .iter()
        .map(|v| v.norm())
        .fold(9.0, f64::min);
    assert!(relative(least, 1.2) < 1e-15);
}

#[test]
fn shapes_are_scaled_turned_and_moved() {
    let shape = pierced();
    let area = shape.area();
    assert!(relative(shape.scaled(0.25).unwrap().area(), area / 16.0) < 1e-15);
    assert!(relative(shape.rotated(1.0).unwrap().area(), area) < 1e-14);
    let moved = shape.moved(point(5.0, -3.0)).unwrap();
    assert!(relative(moved.area(), area) < 1e-14);
    assert_eq!(moved.bounds().lower, point(3.0, -5.0));
    assert_eq!(moved.bounds().upper, point(7.0, -1.0));
    assert_eq!(moved.cuts()[0], [point(5.0, -4.5), point(6.0, -3.5)]);
    let turned = shape.rotated(0.5 * PI).unwrap();
    assert!(turned.contains(point(0.0, -0.4)) && !turned.contains(point(0.0, -1.0)));
    assert!(shape.scaled(0.0).is_err() && shape.scaled(f64::NAN).is_err());
    assert!(shape.rotated(f64::INFINITY).is_err());
}

#[test]
fn both_directions_give_the_same_shape() {
    let shape = pierced();
    let reversed = |ring: &[Vec2]| ring.iter().rev().copied().collect::<Vec<_>>();
    let holes = shape.holes().iter().map(|hole| reversed(hole)).collect();
    let again = Outline::new(reversed(shape.outer()), holes, shape.cuts().to_vec()).unwrap();
    assert_eq!(again, shape);
}

fn refused(outer: &[(f64, f64)], holes: &[&[(f64, f64)]]) -> SetupError {
    let holes = holes.iter().map(|hole| ring(hole)).collect();
    Outline::new(ring(outer), holes, Vec::new()).unwrap_err()
}

const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];

#[test]
fn rings_that_are_no_polygons_are_refused() {
    let two = refused(&SQUARE[..2], &[]);
    assert_eq!(
        two,
        SetupError::TooFewVertices {
            ring: 0,
            vertices: 2
        }
    );
    let line = refused(&[(0.0, 0.0), (2.0, 2.0), (1.0, 1.0)], &[]);
    assert_eq!(line, SetupError::ZeroArea { ring: 0 });
    let bow = refused(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)], &[]);
    let (first, second) = (0, 2);
    assert_eq!(
        bow,
        SetupError::SelfIntersection {
            ring: 0,
            first,
            second
        }
    );
    for value in [f64::NAN, f64::INFINITY, 1e-80, 1e80] {
        let error = refused(&SQUARE, &[&[(1.0, 1.0), (2.0, value), (1.0, 2.0)]]);
        assert_eq!(error, SetupError::InvalidVertex { ring: 1, vertex: 1 });
    }
    let spike = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (4.0, 2.0), (0.0, 2.0)];
    assert!(matches!(
        refused(&spike, &[]),
        SetupError::SelfIntersection { .. }
    ));
    let twice = [(0.0, 0.0), (4.0, 0.0), (4.0, 0.0), (0.0, 4.0)];
    assert!(matches!(
        refused(&twice, &[]),
        SetupError::SelfIntersection { .. }
    ));
    let touching = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 0.0), (0.0, 4.0)];
    assert!(matches!(
        refused(&touching, &[]),
        SetupError::SelfIntersection { .. }
    ));
}

#[test]
fn misplaced_holes_are_refused() {
    let small: &[_] = &[(1.0, 1.0), (2.0, 1.0), (1.0, 2.0)];
    let outside: &[_] = &[(5.0, 5.0), (6.0, 5.0), (5.0, 6.0)];
    let crossing: &[_] = &[(3.0, 1.0), (5.0, 1.0), (3.0, 2.0)];
    let touching: &[_] = &[(0.0, 1.0), (1.0, 1.0), (1.0, 2.0)];
    let around: &[_] = &[(-1.0, -1.0), (9.0, -1.0), (-1.0, 9.0)];
    for hole in [outside, crossing, touching, around] {
        assert_eq!(
            refused(&SQUARE, &[small, hole]),
            SetupError::HoleOutside { hole: 1 }
        );
    }
    let within: &[_] = &[(1.25, 1.25), (1.5, 1.25), (1.25, 1.5)];
    let beside: &[_] = &[(2.0, 1.0), (3.0, 1.0), (3.0, 2.0)];
    let across: &[_] = &[(1.5, 0.5), (1.75, 3.0), (1.25, 3.0)];
    for hole in [within, beside, across] {
        let (first, second) = (0, 1);
        assert_eq!(
            refused(&SQUARE, &[small, hole]),
            SetupError::HolesMeet { first, second }
        );
    }
    let (first, second) = (0, 1);
    assert_eq!(
        refused(&SQUARE, &[within, small]),
        SetupError::HolesMeet { first, second }
    );
}

#[test]
fn wrong_cuts_and_parameters_are_refused() {
    let cut = |a, b| Outline::new(ring(&SQUARE), Vec::new(), vec![[a, b]]);
    let invalid = Err(SetupError::InvalidCut { cut: 0 });
    assert_eq!(cut(point(1.0, 1.0), point(1.0, 1.0)), invalid);
    assert_eq!(cut(point(1.0, 1.0), point(f64::NAN, 1.0)), invalid);
    assert!(cut(point(1.0, 1.0), point(9.0, 1.0)).is_ok());
    assert!(Outline::disc(0.0, 20).is_err() && Outline::disc(1.0, 2).is_err());
    assert!(Outline::square(-1.0).is_err());
    assert!(Outline::plus(1.0, 0.0).is_err() && Outline::plus(1.0, 1.0).is_err());
    assert!(Outline::annulus(1.0, 1.0, 24).is_err() && Outline::annulus(1.0, 0.5, 2).is_err());
    assert!(Outline::perturbed_disc(1.0, 0.0, &[0.5; 20]).is_err());
    assert!(Outline::perturbed_disc(1.0, 0.6, &[1.5; 20]).is_err());
    assert!(Outline::perturbed_disc(1.0, 0.6, &[0.5; 2]).is_err());
}

/// A straight vertex is no error.
#[test]
fn vertices_within_a_side_are_allowed() {
    let mut vertices = ring(&SQUARE);
    vertices.insert(1, point(1.0, 0.0));
    assert_eq!(plain(vertices).area(), 16.0);
    assert_eq!(comb(2, 1.0).area(), 5.0);
}

/// A square on its corner, away from the origin, from each of its vertices.
#[test]
fn bounds_do_not_depend_on_the_first_vertex() {
    for sign in [1.0, -1.0] {
        let (x, y) = (10.0 * sign, 20.0 * sign);
        let mut vertices = ring(&[(x + 2.0, y), (x, y + 2.0), (x - 2.0, y), (x, y - 2.0)]);
        for _ in 0..4 {
            vertices.rotate_left(1);
            let bounds = plain(vertices.clone()).bounds();
            assert_eq!(bounds.lower, point(x - 2.0, y - 2.0));
            assert_eq!(bounds.upper, point(x + 2.0, y + 2.0));
        }
    }
}

/// A straight vertex on the left side does not say in which direction a ring turns.
#[test]
fn vertices_on_the_left_side_do_not_change_the_direction() {
    for height in [2.0, 1.0 + 5e-7] {
        let corners = [
            (2.0, 1.0),
            (5.0, 1.0),
            (5.0, 3.0),
            (2.0, 3.0),
            (2.0, height),
        ];
        let mut vertices = ring(&corners);
        for _ in 0..5 {
            vertices.rotate_left(1);
            assert_eq!(plain(vertices.clone()).area(), 6.0);
            let reversed = vertices.iter().rev().copied().collect();
            assert_eq!(plain(reversed).area(), 6.0);
        }
    }
}

#[test]
fn shapes_turn_by_the_given_angle() {
    let disc = Outline::disc(2.0, 5).unwrap();
    for angle in [0.3, -1.2, 3.0_f64] {
        let turned = disc.rotated(angle).unwrap();
        for (before, after) in disc.outer().iter().zip(turned.outer()) {
            let found = before.cross(*after).atan2(before.dot(*after));
            assert!((found - angle).abs() < 1e-14, "{found} {angle}");
        }
    }
}
