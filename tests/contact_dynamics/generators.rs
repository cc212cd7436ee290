//! Random shapes and numbers for property tests.

use gouge_common::geometry::Vec2;
use proptest::prelude::*;

/// A convex polygon with integer vertices, anticlockwise: the hull of random lattice points.
pub fn lattice_polygon() -> impl Strategy<Value = Vec<(i64, i64)>> {
    prop::collection::vec((-12i64..=12, -12i64..=12), 3..16)
        .prop_map(hull)
        .prop_filter("a hull with an area", |hull| hull.len() >= 3)
}

pub fn vectors(points: &[(i64, i64)]) -> Vec<Vec2> {
    points
        .iter()
        .map(|&(x, y)| Vec2::new(x as f64, y as f64))
        .collect()
}

fn turn(a: (i64, i64), b: (i64, i64), c: (i64, i64)) -> i64 {
    (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)
}

/// Convex hull without points on its sides, by monotone chains.
pub fn hull(mut points: Vec<(i64, i64)>) -> Vec<(i64, i64)> {
    points.sort_unstable();
    points.dedup();
    let mut hull: Vec<(i64, i64)> = Vec::new();
    for pass in 0..2 {
        let start = hull.len();
        for &p in &points {
            while hull.len() >= start + 2
                && turn(hull[hull.len() - 2], hull[hull.len() - 1], p) <= 0
            {
                hull.pop();
            }
            hull.push(p);
        }
        hull.pop();
        if pass == 0 {
            points.reverse();
        }
    }
    hull
}

/// Number of sides of a regular polygon.
pub fn sides() -> impl Strategy<Value = usize> {
    prop::sample::select(vec![3usize, 4, 5, 6, 7, 8, 11, 17, 40, 60])
}

/// A reproducible sequence of numbers in [0, 1).
pub struct Uniform(u64);

impl Uniform {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }
    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}
