//! Damage that is connected with a point.

use crate::bonds::Bonds;
use crate::grain::Grains;
use gouge_common::geometry::Vec2;
use std::collections::BTreeMap;

/// Largest distance in horizons of two damaged nodes that belong together.
const LINK: f64 = 0.5;

/// Nodes by cells of their reference positions.
struct Cells<'a> {
    position: &'a [Vec2],
    /// Size of a cell in m.
    size: f64,
    nodes: BTreeMap<[i64; 2], Vec<usize>>,
}

impl Cells<'_> {
    fn cell(&self, at: Vec2) -> [i64; 2] {
        [at.x, at.y].map(|x| libm::floor(x / self.size) as i64)
    }

    fn add(&mut self, node: usize) {
        let cell = self.cell(self.position[node]);
        self.nodes.entry(cell).or_default().push(node);
    }

    /// Take out the nodes within a radius in m of a point, and append them to others.
    fn take(&mut self, at: Vec2, radius: f64, taken: &mut Vec<usize>) {
        let corner = Vec2::new(radius, radius);
        let [[left, bottom], [right, top]] = [at - corner, at + corner].map(|at| self.cell(at));
        for x in left..=right {
            for (_, nodes) in self.nodes.range_mut([x, bottom]..=[x, top]) {
                let position = self.position;
                nodes.retain(|&node| {
                    let is_near = (position[node] - at).norm() <= radius;
                    taken.extend(is_near.then_some(node));
                    !is_near
                });
            }
        }
    }
}

/// The nodes of a grain whose damage exceeds a threshold, and from which steps of at most half a horizon lead over such nodes
/// to one within a horizon of a point. Distances are those of the reference, in m.
pub fn connected_damage(
    grains: &Grains,
    bonds: &Bonds,
    grain: usize,
    point: Vec2,
    threshold: f64,
) -> Vec<usize> {
    let row = &grains.rows[grain];
    let mut cells = Cells {
        position: &grains.position,
        size: row.constants.horizon,
        nodes: BTreeMap::new(),
    };
    let damaged = |node: &usize| bonds.damage(*node) > threshold;
    row.nodes
        .clone()
        .filter(damaged)
        .for_each(|node| cells.add(node));
    let mut found = Vec::new();
    cells.take(point, row.constants.horizon, &mut found);
    let mut next = 0;
    while let Some(&node) = found.get(next) {
        cells.take(
            grains.position[node],
            LINK * row.constants.horizon,
            &mut found,
        );
        next += 1;
    }
    found.sort_unstable();
    found
}
