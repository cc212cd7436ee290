//! Nodes moved to the centres of the triangles around them.

use crate::shape::predicates::orientation;
use gouge_common::geometry::Vec2;

/// Triangles around each node, in one column.
struct Stars {
    first: Vec<usize>,
    members: Vec<usize>,
}

impl Stars {
    fn new(nodes: usize, triangles: &[[u32; 3]]) -> Self {
        let mut first = vec![0; nodes + 1];
        for &node in triangles.iter().flatten() {
            first[node as usize + 1] += 1;
        }
        for k in 0..nodes {
            first[k + 1] += first[k];
        }
        let mut next = first.clone();
        let mut members = vec![0; 3 * triangles.len()];
        for (t, triangle) in triangles.iter().enumerate() {
            for &node in triangle {
                members[next[node as usize]] = t;
                next[node as usize] += 1;
            }
        }
        Self { first, members }
    }

    fn of(&self, node: usize) -> &[usize] {
        &self.members[self.first[node]..self.first[node + 1]]
    }
}

/// Move each node from a given one on, in order, to the centroid of the triangles around it.
///
/// A node stays where it is if the move would turn a triangle over. The triangles cover the same area afterwards.
pub(super) fn sweep(position: &mut [Vec2], triangles: &[[u32; 3]], first_free: usize) {
    let stars = Stars::new(position.len(), triangles);
    for node in first_free..position.len() {
        let star = stars.of(node);
        let Some(centre) = centroid(position, triangles, star) else {
            continue;
        };
        let place = core::mem::replace(&mut position[node], centre);
        let overturned = |&t: &usize| {
            let [a, b, c] = corners(position, triangles[t]);
            orientation(a, b, c) <= 0.0
        };
        if star.iter().any(overturned) {
            position[node] = place;
        }
    }
}

/// Nodes without those from a given one on that are too close to a neighbour that stays.
pub(super) fn thinned(
    position: &[Vec2],
    triangles: &[[u32; 3]],
    first_free: usize,
    closest: f64,
) -> Vec<Vec2> {
    let stars = Stars::new(position.len(), triangles);
    let mut stays = vec![true; position.len()];
    for node in first_free..position.len() {
        let around = stars.of(node).iter().flat_map(|&t| triangles[t]);
        let too_close = |other: u32| {
            let other = other as usize;
            let distance = (position[other] - position[node]).norm();
            other != node && stays[other] && distance < closest
        };
        stays[node] = !around.into_iter().any(too_close);
    }
    let nodes = position.iter().zip(stays);
    nodes
        .filter_map(|(&place, stays)| stays.then_some(place))
        .collect()
}

/// Positions of the vertices of a triangle.
pub(super) fn corners(position: &[Vec2], triangle: [u32; 3]) -> [Vec2; 3] {
    triangle.map(|node| position[node as usize])
}

/// Common centroid of some triangles, unless they have no area.
fn centroid(position: &[Vec2], triangles: &[[u32; 3]], star: &[usize]) -> Option<Vec2> {
    let (mut weight, mut moment) = (0.0, Vec2::zero());
    for &t in star {
        let [a, b, c] = corners(position, triangles[t]);
        let area = (b - a).cross(c - a);
        weight += area;
        moment += (a + b + c) * (area / 3.0);
    }
    (weight > 0.0).then(|| moment * (1.0 / weight))
}
