//! Nodes as frames, and as what the motion on the page shows.

use super::super::Scene;
use super::begin::mode_text;
use super::mesh::Cells;
use super::tables::{damage, grain_of};
use crate::run::page::Grain;
use crate::run::table::{Table, Values};
use crate::run::trajectory::{Frame, Shapes};
use gouge_common::geometry::Domain;
use gouge_common::pair::Pair;
use gouge_peridem::world::World;
use std::f64::consts::PI;

/// The plane is open; walls are not a box.
const OPEN: Domain = Domain {
    width: None,
    height: None,
    periodic: false,
};

/// A frame of a world: points, and the triangles between them whose sides are not broken.
pub fn frame(scene: &Scene, world: &World, cells: &[Cells]) -> Frame {
    let state = world.state();
    let is_whole = |triangle: &&[u32; 3]| {
        let [a, b, c] = triangle.map(|node| node as usize);
        [[a, b], [b, c], [c, a]]
            .iter()
            .all(|&[i, j]| world.bonds().are_bonded(Pair::new(i, j)))
    };
    let triangles = cells.iter().flat_map(|cells| &cells.triangles);
    Frame {
        time: world.time(),
        note: mode_text(scene.mode),
        domain: OPEN,
        positions: state.places.iter().map(|place| place.position()).collect(),
        shapes: Shapes::Nodes(radii(world), triangles.filter(is_whole).copied().collect()),
        vectors: vec![
            (
                "displacement",
                state
                    .places
                    .iter()
                    .map(|place| place.displacement)
                    .collect(),
            ),
            ("velocity", state.velocity.clone()),
        ],
        scalars: Table {
            columns: vec![
                ("damage", Values::Numbers(damage(world))),
                ("grain", Values::Integers(grain_of(world))),
            ],
        },
        lines: Vec::new(),
    }
}

/// Radii in m of discs with the areas of the nodes.
pub fn radii(world: &World) -> Vec<f64> {
    let areas = world.grains().area.iter();
    areas.map(|area| (area / PI).sqrt()).collect()
}

/// What the motion on the page shows of every node: its damage as a byte.
pub fn nodes(world: &World) -> Vec<Grain> {
    let state = world.state();
    let node = |node: usize| {
        let position = state.places[node].position();
        let speed = state.velocity[node].norm();
        Grain {
            numbers: [position.x as f32, position.y as f32, 0.0, speed as f32, 0.0],
            colour: (255.0 * world.bonds().damage(node)) as u8,
        }
    };
    (0..world.grains().nodes()).map(node).collect()
}
