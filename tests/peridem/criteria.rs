//! Where meshes have nodes: the distances of the method, to the last digits.

use crate::generators::{plain, point};
use crate::meshes::first_moment;
use gouge_peridem::mesh::Mesh;
use gouge_peridem::shape::Outline;

/// Height of an equilateral triangle of side 1.
fn row() -> f64 {
    0.75_f64.sqrt()
}

/// Number of nodes of a rectangle about a point, for triangles of size 1.
fn nodes(width: f64, height: f64) -> usize {
    let at = |x: f64, y: f64| point(10.0 + 0.5 * x * width, 20.0 + 0.5 * y * height);
    let corners = vec![at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
    Mesh::triangulated(&plain(corners), 1.0)
        .unwrap()
        .position
        .len()
}

#[test]
fn inner_nodes_are_farther_than_their_clearance_from_the_boundary() {
    // 28 nodes on the boundary. Rows of 7, 6, 7, 6 and 7 inner ones from below, and another two rows of 6 whose
    // distance from the boundary decides.
    let found =
        [1.0 - 1e-7, 1.0 + 1e-7].map(|factor| nodes(8.0, 2.0 * (3.0 * row() + 0.55 * factor)));
    assert_eq!(found, [28 + 33, 28 + 33 + 12]);
}

#[test]
fn inner_nodes_are_farther_than_the_least_distance_from_others() {
    // 14 nodes on the boundary, and a row of 3. Two rows of 2 are 0.4 beside the nodes on the boundary.
    let found = [1.0 - 1e-7, 1.0 + 1e-7].map(|factor| {
        let least = 0.7 * factor;
        nodes(3.6, 2.0 * (row() + (least * least - 0.16_f64).sqrt()))
    });
    assert_eq!(found, [14 + 3, 14 + 3 + 4]);
}

#[test]
fn edges_are_divided_into_equal_pieces() {
    for (side, number) in [(2.5, 3), (2.499, 2)] {
        let corners = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)];
        let outline = plain(corners.map(|(x, y)| point(x, y)).to_vec());
        let mesh = Mesh::triangulated(&outline, 1.0).unwrap();
        let rim = mesh.on_rim.iter().filter(|on_rim| **on_rim).count();
        assert_eq!(rim, 4 * number);
        let bottom = mesh.position.iter().filter(|place| place.y == 0.0);
        let mut places: Vec<f64> = bottom.map(|place| place.x).collect();
        places.sort_by(f64::total_cmp);
        assert_eq!(places.len(), number + 1);
        for (k, place) in places.iter().enumerate() {
            let expected = side * k as f64 / number as f64;
            assert!((place - expected).abs() < 1e-14, "{place} {expected}");
        }
    }
}

#[test]
fn a_single_inner_node_is_at_the_centroid() {
    let (height, y) = (row(), 20.0);
    let corners = [
        (11.0, y),
        (10.5, y + height),
        (9.5, y + height),
        (8.8, y),
        (9.5, y - height),
        (10.5, y - height),
    ];
    let outline = plain(corners.map(|(x, y)| point(x, y)).to_vec());
    let mesh = Mesh::triangulated(&outline, 1.0).unwrap();
    let inner: Vec<_> = (0..mesh.position.len())
        .filter(|&node| !mesh.on_rim[node])
        .collect();
    assert_eq!(inner.len(), 1);
    let centroid = first_moment(&outline) * (1.0 / outline.area());
    assert!((mesh.position[inner[0]] - centroid).norm() < 1e-12);
}

#[test]
fn discs_have_equal_sides() {
    let disc = Outline::disc(2.0, 7).unwrap();
    let vertices = disc.outer();
    for k in 0..7 {
        let side = (vertices[(k + 1) % 7] - vertices[k]).norm();
        let expected = 4.0 * (std::f64::consts::PI / 7.0).sin();
        assert!((side / expected - 1.0).abs() < 1e-14, "{k} {side}");
    }
}
