//! The method of section 5 of peridem against the exact rule.

use crate::generators::{plain, ring, slot, spiral};
use gouge_common::geometry::Vec2;
use gouge_peridem::interior::{Interceptors, Interior, SectionFive};
use gouge_peridem::mesh::Mesh;
use gouge_peridem::shape::Outline;

/// Pairs decided otherwise than by the exact rule.
#[derive(Debug, Default, PartialEq)]
struct Differences {
    kept: Vec<[usize; 2]>,
    removed: Vec<[usize; 2]>,
}

impl Differences {
    fn none(&self) -> bool {
        *self == Self::default()
    }
}

/// Compare all pairs of nodes within three triangle sizes.
fn differences(shape: &Outline, mesh: &Mesh, size: f64, interceptors: Interceptors) -> Differences {
    let method = SectionFive::new(shape, 0.05 * size, interceptors).unwrap();
    let interior = Interior::new(shape);
    let nodes: Vec<(usize, Vec2)> = mesh.position.iter().copied().enumerate().collect();
    let mut found = Differences::default();
    for (k, &(i, a)) in nodes.iter().enumerate() {
        for &(j, b) in nodes[..k]
            .iter()
            .filter(|node| (node.1 - a).norm() <= 3.0 * size)
        {
            match (interior.admits(a, b), method.admits(a, b)) {
                (false, true) => found.kept.push([i, j]),
                (true, false) => found.removed.push([i, j]),
                _ => {}
            }
        }
    }
    found
}

fn both(shape: &Outline, size: f64) -> (Mesh, [Differences; 2]) {
    let mesh = Mesh::triangulated(shape, size).unwrap();
    let kinds = [Interceptors::Bisectors, Interceptors::BisectorsAndBoundary];
    let found = kinds.map(|kind| differences(shape, &mesh, size, kind));
    (mesh, found)
}

#[test]
fn both_agree_for_the_shapes_of_the_source() {
    let numbers = [0.1, 0.9, 0.4, 0.8, 0.0, 0.3, 0.7, 0.2, 1.0, 0.5];
    let numbers: Vec<f64> = numbers.into_iter().chain(numbers).collect();
    let shapes = [
        Outline::disc(1.0, 20).unwrap(),
        Outline::square(1.0).unwrap(),
        Outline::plus(1.0, 0.2).unwrap(),
        Outline::plus(1.0, 0.5).unwrap().rotated(0.3).unwrap(),
        Outline::perturbed_disc(1.0, 0.6, &numbers).unwrap(),
    ];
    for shape in shapes {
        let (_, [_, with_boundary]) = both(&shape, 0.1);
        assert!(with_boundary.none(), "{with_boundary:?}");
    }
}

/// Bisectors from the bottom of a deep slot reach its sides half-way up.
#[test]
fn bisectors_alone_leak_in_a_deep_slot() {
    let (_, [alone, with_boundary]) = both(&slot(0.25, 1.25), 0.1);
    assert!(alone.kept.len() > 20, "{}", alone.kept.len());
    assert!(alone.removed.is_empty());
    assert!(with_boundary.none());
}

/// A bisector of the inside of a turn ends on the outside of the previous one, where it meets bonds along the edge.
#[test]
fn a_spiral_loses_bonds_along_its_edge() {
    let shape = spiral(60, 2.0, 0.1);
    let (mesh, [alone, with_boundary]) = both(&shape, 0.05);
    assert!(!alone.kept.is_empty());
    assert!(with_boundary.kept.is_empty());
    assert!(!with_boundary.removed.is_empty());
    for [i, j] in with_boundary.removed {
        assert!(mesh.on_rim[i] && mesh.on_rim[j], "{i} {j}");
    }
}

#[test]
fn holes_and_cuts_are_ignored() {
    let (_, [_, ring]) = both(&Outline::annulus(1.0, 0.2, 12).unwrap(), 0.15);
    assert!(!ring.kept.is_empty());
    let square = Outline::square(1.0).unwrap();
    let cut = [Vec2::new(0.013, 0.0), Vec2::new(1.0, 0.017)];
    let notched = Outline::new(square.outer().to_vec(), Vec::new(), vec![cut]).unwrap();
    let (_, [_, cut]) = both(&notched, 0.15);
    assert!(!cut.kept.is_empty());
}

/// Bisectors of a square point away from it at 45 degrees, that of a wedge into the wedge.
#[test]
fn bisectors_point_outwards() {
    let wedge = plain(ring(&[
        (-1.0, -1.0),
        (1.0, -1.0),
        (1.0, 1.0),
        (0.5, 1.0),
        (0.0, 0.0),
        (-0.5, 1.0),
        (-1.0, 1.0),
    ]));
    let alone = SectionFive::new(&wedge, 0.1, Interceptors::Bisectors).unwrap();
    let [[from, to]] = alone.interceptors() else {
        panic!("one re-entrant vertex")
    };
    assert_eq!(*from, Vec2::zero());
    assert!(
        to.x.abs() < 1e-15 && (to.y - 2f64.sqrt()).abs() < 1e-15,
        "{to:?}"
    );
    let moved = SectionFive::new(&wedge, 0.1, Interceptors::BisectorsAndBoundary).unwrap();
    let first = moved.interceptors()[1][0];
    let expected = -1.0 - 0.1 * core::f64::consts::FRAC_1_SQRT_2;
    assert!((first.x - expected).abs() < 1e-15 && (first.y - expected).abs() < 1e-15);
}

/// The midpoint of a side is moved along the normal of the side.
#[test]
fn a_straight_vertex_moves_along_the_normal() {
    let square = plain(ring(&[
        (0.0, 0.0),
        (1.0, 0.0),
        (2.0, 0.0),
        (2.0, 2.0),
        (0.0, 2.0),
    ]));
    let method = SectionFive::new(&square, 0.25, Interceptors::BisectorsAndBoundary).unwrap();
    assert_eq!(method.interceptors().len(), 5);
    assert_eq!(method.interceptors()[1][0], Vec2::new(1.0, -0.25));
    assert!(SectionFive::new(&square, 0.0, Interceptors::Bisectors).is_err());
}

/// The difference of nearly equal tangents has no accurate direction; their sum has one.
#[test]
fn a_nearly_straight_vertex_moves_along_the_normal() {
    let angle = 0.3_f64;
    let at = |x: f64, y: f64| {
        let (sin, cos) = angle.sin_cos();
        (cos * x - sin * y, sin * x + cos * y)
    };
    for bend in [1e-12, -1e-12] {
        let shape = plain(ring(&[
            at(0.0, 0.0),
            at(1.1, bend),
            at(2.0, 0.0),
            at(2.0, 2.0),
        ]));
        let method = SectionFive::new(&shape, 0.25, Interceptors::BisectorsAndBoundary).unwrap();
        let moved = method.interceptors()[method.interceptors().len() - 3][0];
        let (x, y) = at(1.1, -0.25);
        assert!((moved - Vec2::new(x, y)).norm() < 1e-11, "{moved:?}");
    }
}

/// A bisector passes the tip of a tooth by less than a millionth of its side, or meets it.
#[test]
fn a_bisector_ends_at_the_first_edge_that_it_meets() {
    let reach = |tip: f64| {
        let shape = plain(ring(&[
            (-6.0, -1.0),
            (6.0, -1.0),
            (6.0, 4.0),
            (tip, 3.0),
            (5.0, 2.5),
            (1.0, 1.0),
            (0.0, 0.0),
            (-1.0, 1.0),
            (-6.0, 1.0),
        ]));
        let method = SectionFive::new(&shape, 0.1, Interceptors::Bisectors).unwrap();
        let mut from_bottom = method
            .interceptors()
            .iter()
            .filter(|one| one[0] == Vec2::zero());
        from_bottom.next().unwrap()[1].y
    };
    assert!((reach(3e-6) / 52.0_f64.sqrt() - 1.0).abs() < 1e-14);
    assert!((reach(-3e-6) - 3.0).abs() < 1e-5);
}
