//! Distances by which parts of grains are apart.

use crate::grain::Grains;
use crate::state::State;
use gouge_common::geometry::{Domain, Open, Vec2};
use gouge_common::neighbors::{Neighbors, SearchSpheres};
use gouge_common::pair::Pair;

/// Grains move in the open plane.
const OPEN: Domain = Domain {
    width: None,
    height: None,
    periodic: false,
};

/// Smallest distance in m of two nodes that have no bond, of the same grain or of different ones; `None` if no two are
/// nearer than `reach` in m.
pub fn free_distance(grains: &Grains, state: &State, reach: f64) -> Option<f64> {
    let positions: Vec<Vec2> = state.places.iter().map(|place| place.position()).collect();
    let radii = vec![0.5 * reach; positions.len()];
    let spheres = SearchSpheres {
        positions: &positions,
        radii: &radii,
    };
    let mut pairs = Vec::new();
    Neighbors::new(spheres, &OPEN).rebuild(Open, spheres, |_, _| true, &mut pairs);
    let is_free = |pair: Pair| {
        let (i, j) = pair.indices();
        grains.grain_of[i] != grains.grain_of[j] || !state.bonds.are_bonded(pair)
    };
    let distances = pairs.iter().filter_map(|&pair| {
        let (i, j) = pair.indices();
        let distance = state.places[i].to(state.places[j]).norm();
        (distance < reach && is_free(pair)).then_some(distance)
    });
    distances.reduce(f64::min)
}

/// Smallest distance in m of the nodes of one face of a crack from the other face, a chain of nodes; negative if a node is
/// on the right of the chain, that is behind it. `None` if the chain has no edge or the face no node.
///
/// The distance of a node is that from the nearest edge of the chain.
pub fn face_gap(state: &State, face: &[usize], chain: &[usize]) -> Option<f64> {
    let at = |&node: &usize| state.places[node].position();
    let gap = |node: &usize| {
        let point = at(node);
        let edges = chain.windows(2);
        let distances = edges.map(|edge| signed_distance(point, at(&edge[0]), at(&edge[1])));
        distances.min_by(|a, b| a.abs().total_cmp(&b.abs()))
    };
    let gaps: Option<Vec<f64>> = face.iter().map(gap).collect();
    gaps?.into_iter().reduce(f64::min)
}

/// Distance of a point from a segment, negative on its right.
fn signed_distance(point: Vec2, from: Vec2, to: Vec2) -> f64 {
    let (edge, arm) = (to - from, point - from);
    let along = (arm.dot(edge) / edge.norm_squared()).clamp(0.0, 1.0);
    let distance = (arm - edge * along).norm();
    distance.copysign(edge.cross(arm))
}
