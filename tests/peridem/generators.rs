//! Shapes and nodes for tests: many coincidences on a coarse grid, and coordinates with all their digits.

use gouge_common::geometry::Vec2;
use gouge_peridem::shape::Outline;
use proptest::prelude::*;

pub fn point(x: f64, y: f64) -> Vec2 {
    Vec2::new(x, y)
}

pub fn ring(coordinates: &[(f64, f64)]) -> Vec<Vec2> {
    coordinates.iter().map(|&(x, y)| point(x, y)).collect()
}

pub fn plain(outer: Vec<Vec2>) -> Outline {
    Outline::new(outer, Vec::new(), Vec::new()).unwrap()
}

/// Star with alternating radii.
pub fn star(tips: usize, ratio: f64, turn: f64) -> Outline {
    let vertex = |k: usize| {
        let angle = turn + core::f64::consts::PI * k as f64 / tips as f64;
        let radius = [1.0, ratio][k % 2];
        point(radius * libm::cos(angle), radius * libm::sin(angle))
    };
    plain((0..2 * tips).map(vertex).collect())
}

/// Square with a slot from the top.
pub fn slot(width: f64, depth: f64) -> Outline {
    let half = 0.5 * width;
    plain(ring(&[
        (-1.0, -1.0),
        (1.0, -1.0),
        (1.0, 1.0),
        (half, 1.0),
        (half, 1.0 - depth),
        (-half, 1.0 - depth),
        (-half, 1.0),
        (-1.0, 1.0),
    ]))
}

/// Comb with teeth upwards.
pub fn comb(teeth: usize, gap: f64) -> Outline {
    let mut outer = ring(&[(0.0, 0.0), (2.0 * teeth as f64 - 1.0, 0.0)]);
    for tooth in (0..teeth).rev() {
        let left = 2.0 * tooth as f64;
        outer.extend(ring(&[(left + 1.0, 2.0), (left, 2.0)]));
        if tooth > 0 {
            outer.extend(ring(&[(left, gap), (left - 1.0, gap)]));
        }
    }
    plain(outer)
}

/// Strip that is wound around the origin.
pub fn spiral(pieces: usize, turns: f64, thickness: f64) -> Outline {
    let at = |k: usize, offset: f64| {
        let angle = core::f64::consts::TAU * turns * k as f64 / pieces as f64;
        let radius = 0.3 + 0.04 * angle + offset;
        point(radius * libm::cos(angle), radius * libm::sin(angle))
    };
    let outside = (0..=pieces).map(|k| at(k, thickness));
    let inside = (0..=pieces).rev().map(|k| at(k, 0.0));
    plain(outside.chain(inside).collect())
}

/// Square with two holes, and cuts within it, across its side and between the holes.
pub fn pierced() -> Outline {
    let outer = ring(&[(-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0)]);
    let diamond = ring(&[(-1.0, -0.5), (-0.5, 0.0), (-1.0, 0.5), (-1.5, 0.0)]);
    let corner = ring(&[
        (0.5, 0.5),
        (1.5, 0.5),
        (1.5, 0.75),
        (0.75, 0.75),
        (0.75, 1.5),
        (0.5, 1.5),
    ]);
    let cuts = vec![
        [point(0.0, -1.5), point(1.0, -0.5)],
        [point(1.0, 0.0), point(3.0, 0.125)],
        [point(-0.5, 0.0), point(0.5, 0.5)],
    ];
    Outline::new(outer, vec![diamond, corner], cuts).unwrap()
}

/// Any of the shapes, with its coordinates as they are or rounded to multiples of 1/16.
pub fn shape() -> impl Strategy<Value = Outline> {
    let exact = prop_oneof![
        (0.1..0.9f64).prop_map(|ratio| Outline::plus(1.0, ratio).unwrap()),
        (0.3..0.8f64, 3usize..9).prop_map(|(r, n)| Outline::annulus(1.0, r, n).unwrap()),
        (3usize..7, 0.2..0.9f64, 0.0..1.0f64).prop_map(|(n, ratio, turn)| star(n, ratio, turn)),
        (0.1..1.0f64, 0.2..1.9f64).prop_map(|(width, depth)| slot(width, depth)),
        (2usize..4, 0.25..1.5f64).prop_map(|(teeth, gap)| comb(teeth, gap)),
        (6usize..14, 0.05..0.15f64).prop_map(|(n, width)| spiral(n, 1.2, width)),
        Just(pierced()),
        prop::collection::vec(0.0..1.0f64, 3..12)
            .prop_map(|numbers| Outline::perturbed_disc(1.0, 0.4, &numbers).unwrap()),
    ];
    (exact, any::<bool>()).prop_map(|(shape, coarse)| {
        let rounded = coarse.then(|| on_grid(&shape)).flatten();
        rounded.unwrap_or(shape)
    })
}

/// A shape with vertices on a grid, if it is still one.
fn on_grid(shape: &Outline) -> Option<Outline> {
    let round = |p: &Vec2| point((16.0 * p.x).round() / 16.0, (16.0 * p.y).round() / 16.0);
    let rounded = |ring: &Vec<Vec2>| ring.iter().map(round).collect();
    let outer = shape.outer().iter().map(round).collect();
    let holes = shape.holes().iter().map(rounded).collect();
    Outline::new(outer, holes, shape.cuts().to_vec()).ok()
}

/// How a node relates to a shape.
#[derive(Clone, Copy, Debug)]
pub enum Place {
    /// A vertex.
    Vertex(usize),
    /// A point on an edge, rounded.
    OnEdge(usize, f64),
    /// A point on the line of two vertices, rounded.
    OnLine(usize, usize, f64),
    /// A point of a grid.
    Grid(i32, i32),
    /// A vertex with one coordinate changed by its last digit.
    Beside(usize, usize),
}

pub fn place() -> impl Strategy<Value = Place> {
    let index = || 0usize..64;
    let eighths = (-8i32..=16).prop_map(|k| f64::from(k) / 8.0);
    prop_oneof![
        index().prop_map(Place::Vertex),
        (index(), 0.0..1.0f64).prop_map(|(k, t)| Place::OnEdge(k, t)),
        (index(), (0i32..8).prop_map(|k| f64::from(k) / 8.0))
            .prop_map(|(k, t)| Place::OnEdge(k, t)),
        (index(), index(), eighths).prop_map(|(a, b, t)| Place::OnLine(a, b, t)),
        (-24i32..=24, -24i32..=24).prop_map(|(i, j)| Place::Grid(i, j)),
        (index(), 0usize..4).prop_map(|(k, way)| Place::Beside(k, way)),
    ]
}

impl Place {
    /// The node.
    pub fn of(self, shape: &Outline) -> Vec2 {
        let vertices: Vec<_> = shape.rings().flatten().copied().collect();
        let vertex = |k: usize| vertices[k % vertices.len()];
        match self {
            Self::Vertex(k) => vertex(k),
            Self::OnEdge(k, t) => vertex(k) + (vertex(k + 1) - vertex(k)) * t,
            Self::OnLine(a, b, t) => vertex(a) + (vertex(b) - vertex(a)) * t,
            Self::Grid(i, j) => point(f64::from(i) / 16.0, f64::from(j) / 16.0),
            Self::Beside(k, way) => {
                let v = vertex(k);
                let step = [f64::EPSILON, -f64::EPSILON][way % 2];
                let changed = |value: f64| {
                    if value == 0.0 {
                        step
                    } else {
                        value * (1.0 + step)
                    }
                };
                if way < 2 {
                    point(changed(v.x), v.y)
                } else {
                    point(v.x, changed(v.y))
                }
            }
        }
    }
}
