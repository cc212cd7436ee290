//! Meshes: areas, moments, quality, topology, determinism.

use crate::exact::{Domain, Point};
use crate::generators::{comb, pierced, plain, point, ring, shape, slot, star};
use gouge_common::geometry::Vec2;
use gouge_peridem::error::SetupError;
use gouge_peridem::mesh::{Mesh, smallest_distance};
use gouge_peridem::shape::Outline;
use proptest::prelude::*;
use std::collections::BTreeMap;

fn numbers() -> Vec<f64> {
    (0..20).map(|k| f64::from(k * k * 7 % 11) / 10.0).collect()
}

/// Shapes without sharp corners, and with them.
fn blunt() -> Vec<Outline> {
    vec![
        Outline::disc(1.0, 20).unwrap(),
        Outline::square(1.0).unwrap().rotated(0.4).unwrap(),
        Outline::plus(1.0, 0.3).unwrap(),
        Outline::annulus(1.0, 0.6, 24).unwrap(),
        Outline::perturbed_disc(1.0, 0.6, &numbers()).unwrap(),
    ]
}

fn all() -> Vec<Outline> {
    let mut shapes = blunt();
    shapes.extend([star(5, 0.4, 0.1), slot(0.15, 1.2), comb(3, 0.5), pierced()]);
    shapes
}

/// Sum with compensation: adding thousands of equal numbers one by one loses more than the mesh does.
fn total(areas: &[f64]) -> f64 {
    let mut lost = 0.0;
    areas.iter().fold(0.0, |sum, &area| {
        let corrected = area - lost;
        let next = sum + corrected;
        lost = (next - sum) - corrected;
        next
    })
}

fn corners(mesh: &Mesh, triangle: [u32; 3]) -> [Vec2; 3] {
    triangle.map(|node| mesh.position[node as usize])
}

fn angles(corners: [Vec2; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| {
        let (a, b) = (
            corners[(k + 1) % 3] - corners[k],
            corners[(k + 2) % 3] - corners[k],
        );
        a.cross(b).atan2(a.dot(b))
    })
}

/// First moment of area of a shape, by the theorem of Green.
pub fn first_moment(shape: &Outline) -> Vec2 {
    let mut sum = Vec2::zero();
    for ring in shape.rings() {
        for (k, &a) in ring.iter().enumerate() {
            let b = ring[(k + 1) % ring.len()];
            sum += (a + b) * (a.cross(b) / 6.0);
        }
    }
    sum
}

/// Areas and first moments are those of the shape, because a linear function is integrated exactly.
#[test]
fn node_areas_integrate_linear_functions() {
    for shape in all() {
        for size in [0.3, 0.11] {
            let mesh = Mesh::triangulated(&shape, size).unwrap();
            assert!((total(&mesh.area) / shape.area() - 1.0).abs() < 1e-13);
            assert!(mesh.area.iter().all(|&area| area > 0.0));
            let nodes = mesh.position.iter().zip(&mesh.area);
            let moment = nodes.fold(Vec2::zero(), |sum, (&place, &area)| sum + place * area);
            assert!((moment - first_moment(&shape)).norm() < 1e-12 * shape.area());
        }
    }
}

#[test]
fn no_node_is_outside() {
    for shape in all() {
        let domain = Domain::new(&shape);
        for mesh in [
            Mesh::triangulated(&shape, 0.2).unwrap(),
            Mesh::lattice(&shape, 0.2, point(0.013, 0.0)).unwrap(),
        ] {
            let outside = |place: &&Vec2| !domain.contains(&Point::new(**place));
            assert_eq!(mesh.position.iter().filter(outside).count(), 0);
        }
    }
}

#[test]
fn triangles_are_well_shaped() {
    for shape in blunt() {
        for size in [0.1, 0.06] {
            let mesh = Mesh::triangulated(&shape, size).unwrap();
            let all = mesh.triangles.iter().map(|&t| corners(&mesh, t));
            let least = all.clone().flat_map(angles).fold(9.0, f64::min);
            assert!(least.to_degrees() > 28.0, "{}", least.to_degrees());
            let longest = all.flat_map(|[a, b, c]| [b - a, c - b, a - c].map(Vec2::norm));
            assert!(longest.fold(0.0, f64::max) < 1.5 * size);
            assert!(smallest_distance(&mesh.position).unwrap() > 0.55 * size);
        }
    }
}

/// Edges have one or two triangles, rim edges one; vertices, edges and triangles obey Euler's formula.
#[test]
fn triangles_fill_the_shape_without_gaps() {
    for shape in all() {
        let mesh = Mesh::triangulated(&shape, 0.15).unwrap();
        let mut opposite: BTreeMap<[u32; 2], Vec<f64>> = BTreeMap::new();
        for &triangle in &mesh.triangles {
            let angles = angles(corners(&mesh, triangle));
            assert!(angles.iter().all(|&angle| angle > 0.0));
            for k in 0..3 {
                let mut edge = [triangle[(k + 1) % 3], triangle[(k + 2) % 3]];
                edge.sort_unstable();
                opposite.entry(edge).or_default().push(angles[k]);
            }
        }
        let outer = opposite.values().filter(|angles| angles.len() == 1);
        let rim = mesh.on_rim.iter().filter(|&&on_rim| on_rim).count();
        assert_eq!(outer.count(), rim);
        assert!(opposite.values().all(|angles| angles.len() <= 2));
        let [nodes, edges, triangles] =
            [mesh.position.len(), opposite.len(), mesh.triangles.len()].map(|count| count as i64);
        assert_eq!(nodes - edges + triangles, 1 - shape.holes().len() as i64);
        let delaunay =
            |angles: &Vec<f64>| angles.iter().sum::<f64>() < core::f64::consts::PI + 1e-9;
        let inner = opposite.values().filter(|angles| angles.len() == 2);
        assert!(inner.into_iter().all(delaunay));
    }
}

/// Meshes are made afresh, in another order and on other threads.
#[test]
fn meshes_are_equal_to_the_bit() {
    let make = || -> Vec<Mesh> {
        let shapes = all();
        let meshes = shapes
            .iter()
            .map(|shape| Mesh::triangulated(shape, 0.15).unwrap());
        meshes.collect()
    };
    let here = make();
    let there = std::thread::spawn(make).join().unwrap();
    for (a, b) in here.iter().zip(&there) {
        let bits = |mesh: &Mesh| -> Vec<[u64; 3]> {
            let nodes = mesh.position.iter().zip(&mesh.area);
            nodes
                .map(|(p, area)| [p.x.to_bits(), p.y.to_bits(), area.to_bits()])
                .collect()
        };
        assert_eq!(bits(a), bits(b));
        assert_eq!(a.triangles, b.triangles);
    }
}

/// Powers of two change no rounding.
#[test]
fn meshes_do_not_depend_on_the_unit() {
    let factor = 2f64.powi(-11);
    for shape in blunt() {
        let large = Mesh::triangulated(&shape, 0.2).unwrap();
        let small = Mesh::triangulated(&shape.scaled(factor).unwrap(), 0.2 * factor).unwrap();
        let scaled: Vec<_> = large.position.iter().map(|&place| place * factor).collect();
        assert_eq!(scaled, small.position);
    }
}

#[test]
fn vertices_are_nodes() {
    for shape in all() {
        let mesh = Mesh::triangulated(&shape, 0.5).unwrap();
        let nodes = mesh.position.iter().zip(&mesh.on_rim);
        let rim: Vec<_> = nodes.filter(|node| *node.1).map(|node| *node.0).collect();
        assert!(shape.rings().flatten().all(|vertex| rim.contains(vertex)));
    }
}

#[test]
fn lattice_areas_are_those_of_the_shape() {
    for shape in all() {
        for (spacing, origin) in [(0.2, point(0.0, 0.0)), (0.07, point(0.013, 5.021))] {
            let mesh = Mesh::lattice(&shape, spacing, origin).unwrap();
            assert!((total(&mesh.area) / shape.area() - 1.0).abs() < 1e-13);
            let cell = spacing * spacing;
            for (&area, &on_rim) in mesh.area.iter().zip(&mesh.on_rim) {
                assert!(on_rim || (area / cell - 1.0).abs() < 1e-12);
            }
            assert!(mesh.on_rim.contains(&true));
            let distance = smallest_distance(&mesh.position).unwrap();
            assert!((distance / spacing - 1.0).abs() < 1e-12);
        }
    }
}

/// Strips of 3.25 x 2 cells, by hand: a cell without a node gives its area to the node beside it.
#[test]
fn lattice_areas_of_a_strip_are_as_by_hand() {
    let strip = plain(ring(&[(0.0, 0.0), (3.25, 0.0), (3.25, 2.0), (0.0, 2.0)]));
    let areas = |x: f64| Mesh::lattice(&strip, 1.0, point(x, 0.5)).unwrap().area;
    assert_eq!(areas(0.5), [1.0, 1.0, 1.25, 1.0, 1.0, 1.25]);
    assert_eq!(areas(0.25), [0.75, 1.0, 1.0, 0.5, 0.75, 1.0, 1.0, 0.5]);
    assert_eq!(areas(-0.5), [1.0, 1.0, 1.25, 1.0, 1.0, 1.25]);
    let hole = ring(&[(0.5, 0.5), (2.5, 0.5), (2.5, 1.5), (0.5, 1.5)]);
    let pierced = Outline::new(strip.outer().to_vec(), vec![hole], Vec::new()).unwrap();
    let mesh = Mesh::lattice(&pierced, 1.0, point(0.25, 0.25)).unwrap();
    assert_eq!(mesh.position.len(), 6);
    assert_eq!(mesh.area.iter().sum::<f64>(), 4.5);
    let corner = mesh
        .position
        .iter()
        .position(|&p| p == point(0.25, 0.25))
        .unwrap();
    assert_eq!(mesh.area[corner], 0.75 * 0.75 - 0.25 * 0.25);
}

/// A corner cell without neighbours along its sides gives its area to the node across its corner, a far one to the
/// nearest node.
#[test]
fn lattice_areas_go_to_the_nearest_nodes() {
    let kite = plain(ring(&[(0.0, 0.0), (0.45, 0.45), (0.0, 0.2)]));
    let mesh = Mesh::lattice(&kite, 0.5, point(0.01, 0.1)).unwrap();
    assert_eq!(mesh.position, [point(0.01, 0.1)]);
    assert!((mesh.area[0] / kite.area() - 1.0).abs() < 1e-14);
    let needle = plain(ring(&[
        (-0.25, -0.25),
        (0.25, -0.25),
        (3.9, 0.3),
        (0.25, 0.25),
    ]));
    let mesh = Mesh::lattice(&needle, 1.0, point(0.0, 0.0)).unwrap();
    assert!((total(&mesh.area) / needle.area() - 1.0).abs() < 1e-14);
}

#[test]
fn a_rectangle_has_equal_cells() {
    let mesh = Mesh::rectangle(4, 3, 0.5, point(-1.0, 2.0)).unwrap();
    assert_eq!(mesh.position.len(), 12);
    assert_eq!(mesh.position[0], point(-0.75, 2.25));
    assert_eq!(mesh.position[11], point(0.75, 3.25));
    assert_eq!(mesh.position[1], point(-0.25, 2.25));
    assert!(mesh.area.iter().all(|&area| area == 0.25));
    let inner = mesh.on_rim.iter().filter(|&&on_rim| !on_rim).count();
    assert_eq!(inner, 2);
    assert!(Mesh::rectangle(0, 3, 0.5, Vec2::zero()).is_err());
    assert!(Mesh::rectangle(4, 3, -0.5, Vec2::zero()).is_err());
    assert!(Mesh::rectangle(4, 3, 0.5, point(f64::NAN, 0.0)).is_err());
    assert!(Mesh::rectangle(4000, 3000, 0.5, Vec2::zero()).is_err());
}

/// The lattice of a rectangle whose cells fit is the plain rectangle.
#[test]
fn a_lattice_in_a_rectangle_is_the_plain_one() {
    let outline = plain(ring(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.5), (0.0, 1.5)]));
    let lattice = Mesh::lattice(&outline, 0.5, point(0.25, 0.25)).unwrap();
    assert_eq!(lattice, Mesh::rectangle(4, 3, 0.5, Vec2::zero()).unwrap());
}

#[test]
fn meshes_that_cannot_be_made_are_refused() {
    let square = Outline::square(1.0).unwrap();
    for size in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Mesh::triangulated(&square, size).is_err());
        assert!(Mesh::lattice(&square, size, Vec2::zero()).is_err());
    }
    let refused = |result: Result<Mesh, SetupError>| matches!(result, Err(SetupError::Mesh { .. }));
    assert!(refused(Mesh::triangulated(&square, 1e-9)));
    assert!(refused(Mesh::lattice(&square, 1e-9, Vec2::zero())));
    assert!(refused(Mesh::lattice(&square, 10.0, point(5.0, 5.0))));
    assert!(Mesh::lattice(&square, 0.1, point(f64::NAN, 0.0)).is_err());
}

#[test]
fn shapes_as_thin_as_rounding_are_refused() {
    let mesh = |corners: [(f64, f64); 3]| Mesh::triangulated(&plain(ring(&corners)), 2e-4);
    let flat = |height: f64| mesh([(0.0, 0.0), (1e-3, 0.0), (5e-4, height)]);
    assert!(flat(1e-3).is_ok() && flat(1e-6).is_ok() && flat(1e-9).is_ok());
    let error = flat(1e-12).unwrap_err();
    let SetupError::MeshArea {
        size,
        area,
        expected,
    } = error
    else {
        panic!("{error}");
    };
    assert_eq!(size, 2e-4);
    assert!((expected / 5e-16 - 1.0).abs() < 1e-12 && (area / expected - 1.0).abs() < 1e-5);
    for height in [1e-19, 1e-50] {
        assert!(
            matches!(flat(height), Err(SetupError::Mesh { .. })),
            "{height:e}"
        );
    }
    // Corners of a thick shape may be far from the origin of its frame.
    assert!(mesh([(1.0, 1.0), (1.001, 1.0), (1.0005, 1.001)]).is_ok());
    let far = mesh([(1e5, 1e5), (1e5 + 1e-3, 1e5), (1e5 + 5e-4, 1e5 + 1e-3)]);
    assert!(matches!(far, Err(SetupError::MeshArea { .. })));
    let thin = plain(ring(&[
        (1e5, 1e5),
        (1e5 + 1e-3, 1e5),
        (1e5 + 5e-4, 1e5 + 1e-3),
    ]));
    let lattice = Mesh::lattice(&thin, 2e-4, point(1e5, 1e5));
    assert!(
        matches!(lattice, Err(SetupError::MeshArea { size: 2e-4, .. })),
        "{lattice:?}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn meshes_of_slivers_have_their_area_or_are_refused(
        exponent in -18.0..0.0f64, place in 0.0..100.0f64, size in 0.05..0.5f64,
    ) {
        let height = 10.0_f64.powf(exponent);
        let corners = [(place, place), (place + 1.0, place), (place + 0.5, place + height)];
        let Ok(shape) = Outline::new(ring(&corners), Vec::new(), Vec::new()) else {
            return Ok(());
        };
        let meshes = [
            Mesh::triangulated(&shape, size),
            Mesh::lattice(&shape, size, point(place, place)),
        ];
        for mesh in meshes.into_iter().flatten() {
            prop_assert!((total(&mesh.area) / shape.area() - 1.0).abs() <= 1e-9);
            prop_assert!(mesh.area.iter().all(|&area| area > 0.0));
        }
    }

    #[test]
    fn smallest_distances_are_those_of_all_pairs(
        points in prop::collection::vec((-1.0..1.0f64, -1.0..1.0f64), 0..30), stretch in 0.01..100.0f64,
    ) {
        let points: Vec<_> = points.iter().map(|&(x, y)| point(stretch * x, y)).collect();
        let pairs = (0..points.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let distances = pairs.map(|(i, j)| (points[i] - points[j]).norm());
        prop_assert_eq!(smallest_distance(&points), distances.reduce(f64::min));
    }

    #[test]
    fn any_shape_is_meshed(shape in shape(), size in 0.05..2.0f64) {
        let sum = |mesh: &Mesh| total(&mesh.area) / shape.area() - 1.0;
        let mesh = Mesh::triangulated(&shape, size).unwrap();
        prop_assert!(sum(&mesh).abs() < 1e-13);
        prop_assert!(mesh.position.iter().all(|&place| shape.contains(place)));
        if let Ok(mesh) = Mesh::lattice(&shape, size, Vec2::zero()) {
            prop_assert!(sum(&mesh).abs() < 1e-13);
        }
    }
}
