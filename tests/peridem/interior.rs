//! Which bonds stay in a grain, against exact rational arithmetic and cases decided by hand.

use crate::exact::{Domain, Point, on_segment};
use crate::generators::{pierced, place, plain, point, ring, shape, spiral};
use gouge_common::geometry::Vec2;
use gouge_peridem::error::SetupError;
use gouge_peridem::interior::Interior;
use gouge_peridem::shape::Outline;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(80))]

    /// Nodes lie on vertices, edges, extensions of edges, a grid, and one digit beside vertices.
    #[test]
    fn bonds_are_those_of_exact_arithmetic(
        shape in shape(), places in prop::collection::vec(place(), 8),
    ) {
        let interior = Interior::new(&shape);
        let domain = Domain::new(&shape);
        let nodes: Vec<_> = places.iter().map(|place| place.of(&shape)).collect();
        for (k, &a) in nodes.iter().enumerate() {
            let inside = domain.contains(&Point::new(a));
            prop_assert_eq!(interior.contains(a), inside);
            prop_assert_eq!(shape.contains(a), inside);
            for &b in &nodes[..k] {
                let expected = domain.admits(a, b);
                prop_assert_eq!(interior.admits(a, b), expected, "{:?} to {:?}", a, b);
                prop_assert_eq!(interior.admits(b, a), expected, "{:?} to {:?}", b, a);
            }
        }
    }

    /// The result does not depend on the frame, if moving and scaling are exact.
    #[test]
    fn bonds_do_not_depend_on_the_unit(shape in shape(), places in [place(), place()]) {
        let [a, b] = places.map(|place| place.of(&shape));
        let scaled = shape.scaled(2f64.powi(-12)).unwrap();
        let admitted = Interior::new(&scaled).admits(a * 2f64.powi(-12), b * 2f64.powi(-12));
        prop_assert_eq!(admitted, Interior::new(&shape).admits(a, b));
    }

    #[test]
    fn nodes_on_cuts_are_those_of_exact_arithmetic(t in -0.5..1.5f64, cut in 0usize..3) {
        let shape = pierced();
        let [a, b] = shape.cuts()[cut];
        let node = a + (b - a) * t;
        let ends = shape.cuts()[cut].map(Point::new);
        let expected = on_segment(&Point::new(node), &ends);
        let found = Interior::new(&shape).require_off_cuts(&[node]);
        prop_assert_eq!(found.is_err(), expected);
    }
}

/// A bond between two points, whether it is allowed, and what it does.
type Case = ([f64; 4], bool, &'static str);

fn check(shape: &Outline, cases: &[Case]) {
    let interior = Interior::new(shape);
    for &([ax, ay, bx, by], expected, text) in cases {
        let (a, b) = (point(ax, ay), point(bx, by));
        assert_eq!(interior.admits(a, b), expected, "{text}");
        assert_eq!(
            interior.admits(b, a),
            expected,
            "{text}, in the other direction"
        );
    }
}

/// An L of three unit squares, with the re-entrant vertex at (1, 1).
fn corner() -> Outline {
    plain(ring(&[
        (0.0, 0.0),
        (2.0, 0.0),
        (2.0, 1.0),
        (1.0, 1.0),
        (1.0, 2.0),
        (0.0, 2.0),
    ]))
}

#[test]
fn bonds_of_a_corner_are_as_decided_by_hand() {
    let shape = corner();
    check(
        &shape,
        &[
            ([1.0, 1.0, 2.0, 1.0], true, "along an edge"),
            (
                [0.0, 1.0, 2.0, 1.0],
                true,
                "along an edge and through the re-entrant vertex",
            ),
            ([0.5, 1.5, 1.5, 0.5], true, "touching the re-entrant vertex"),
            (
                [1.0, 2.0, 2.0, 1.0],
                false,
                "across the pocket between vertices",
            ),
            ([0.5, 1.25, 1.5, 0.5], true, "below the re-entrant vertex"),
            ([0.75, 1.75, 1.5, 0.5], false, "above the re-entrant vertex"),
            (
                [1.0, 1.5, 1.5, 1.0],
                false,
                "across the pocket between edges",
            ),
            ([1.0, 1.5, 1.0, 0.5], true, "along an edge, then inside"),
            (
                [0.0, 0.0, 1.0, 1.0],
                true,
                "ending at the re-entrant vertex",
            ),
            (
                [0.0, 0.0, 1.5, 1.5],
                false,
                "leaving at the re-entrant vertex",
            ),
            ([1.0, 1.0, 1.0, 1.0], true, "from a point to itself"),
            (
                [2.0, 0.0, 0.0, 2.0],
                true,
                "a diagonal through the re-entrant vertex",
            ),
            ([2.5, 0.5, 0.5, 0.5], false, "from outside"),
            (
                [1.5, 1.5, 1.5, 1.5],
                false,
                "from a point outside to itself",
            ),
        ],
    );
}

#[test]
fn bonds_at_holes_and_cuts_are_as_decided_by_hand() {
    let shape = pierced();
    check(
        &shape,
        &[
            (
                [-1.5, 0.5, -0.5, 0.5],
                true,
                "touching the upper corner of the diamond",
            ),
            (
                [-1.0, 0.5, -1.0, -0.5],
                false,
                "across the diamond between vertices",
            ),
            ([-1.0, 0.5, -0.5, 0.0], true, "along a side of the diamond"),
            (
                [-1.5, 1.0, 0.0, -0.5],
                true,
                "along a side of the diamond and beyond",
            ),
            (
                [0.75, 1.5, 1.5, 0.75],
                true,
                "between the arms of the corner, outside it",
            ),
            ([0.5, 1.0, 0.75, 1.0], false, "across an arm of the corner"),
            ([0.0, -0.5, 1.0, -1.5], false, "across the middle of a cut"),
            ([-0.5, -1.0, 0.5, -2.0], true, "through the end of a cut"),
            ([0.25, -1.25, 0.75, -0.75], true, "along a cut"),
            (
                [1.75, -0.5, 1.75, 0.5],
                false,
                "across a cut that ends outside",
            ),
            (
                [0.0, 0.0, 0.0, 0.5],
                false,
                "between the holes, across the cut",
            ),
        ],
    );
}

#[test]
fn a_node_on_a_cut_is_named() {
    let interior = Interior::new(&pierced());
    let nodes = [point(0.0, 1.0), point(0.5, -1.0), point(0.0, -1.5)];
    let expected = SetupError::NodeOnCut { node: 1, cut: 0 };
    assert_eq!(interior.require_off_cuts(&nodes), Err(expected));
    assert_eq!(interior.require_off_cuts(&nodes[..1]), Ok(()));
    assert!(interior.require_off_cuts(&nodes[2..]).is_err());
}

#[test]
fn points_that_are_not_finite_have_no_bonds() {
    let interior = Interior::new(&corner());
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for bad in [point(value, 0.5), point(0.5, value), point(value, value)] {
            assert!(!interior.admits(bad, point(0.5, 0.5)));
            assert!(!interior.admits(point(0.5, 0.5), bad));
            assert!(!interior.contains(bad));
        }
    }
}

/// Bonds in a thin strip along a spiral, between points of the middle line.
#[test]
fn no_bond_jumps_from_turn_to_turn() {
    let interior = Interior::new(&spiral(120, 2.0, 0.1));
    let middle = |k: usize| {
        let angle = core::f64::consts::TAU * 2.0 * k as f64 / 120.0;
        Vec2::new(libm::cos(angle), libm::sin(angle)) * (0.35 + 0.04 * angle)
    };
    for k in 0..60 {
        assert!(interior.admits(middle(k), middle(k + 1)));
        assert!(!interior.admits(middle(k), middle(k + 60)));
    }
}

/// Squares on a corner and on a side, on either side of the origin: what leaves them at their extreme points.
#[test]
fn bonds_do_not_leave_at_extreme_points() {
    for sign in [1.0, -1.0] {
        let centre = 10.0 * sign;
        let at = |x: f64, y: f64| (centre + x, centre + y);
        let diamond = plain(ring(&[
            at(2.0, 0.0),
            at(0.0, 2.0),
            at(-2.0, 0.0),
            at(0.0, -2.0),
        ]));
        let square = plain(ring(&[
            at(2.0, 2.0),
            at(-2.0, 2.0),
            at(-2.0, -2.0),
            at(2.0, -2.0),
        ]));
        let inside = point(centre, centre);
        for (x, y) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)] {
            let out = Vec2::new(x, y);
            let extreme = inside + out * 2.0;
            for shape in [&diamond, &square] {
                assert!(Interior::new(shape).admits(inside, extreme));
                assert!(!Interior::new(shape).admits(extreme, extreme + out));
                assert!(!Interior::new(shape).admits(inside, extreme + out));
            }
            for side in [out.perpendicular(), -out.perpendicular()] {
                assert!(!Interior::new(&diamond).admits(extreme, extreme + side));
                assert!(Interior::new(&square).admits(extreme, extreme + side));
            }
        }
    }
}

#[test]
fn points_below_a_nearly_level_side_are_inside() {
    let (low, high) = (1.0, 1.0 + 4e-7);
    for (left, right) in [(low, high), (high, low)] {
        let shape = plain(ring(&[(0.0, 0.0), (4.0, 0.0), (4.0, right), (0.0, left)]));
        let level = 0.5 * (low + high);
        for x in [1.0, 3.0] {
            let is_below = level < left + 0.25 * (right - left) * x;
            assert_eq!(
                shape.contains(point(x, level)),
                is_below,
                "{left} {right} {x}"
            );
        }
    }
}
