//! Nodes, grains and bonds as tables.

use super::begin::centre;
use crate::run::table::{Table, Values};
use gouge_common::geometry::Vec2;
use gouge_peridem::observables::grain_damage;
use gouge_peridem::world::World;

/// The final nodes; those of a grain are counted from its first.
pub fn nodes(world: &World) -> Table {
    let (grains, state) = (world.grains(), world.state());
    let all = 0..grains.nodes();
    let numbers = |of: &dyn Fn(usize) -> f64| Values::Numbers(all.clone().map(of).collect());
    let place = |node: usize| state.places[node];
    Table {
        columns: vec![
            ("grain", Values::Integers(grain_of(world))),
            (
                "node",
                Values::Integers(all.clone().map(|node| local(world, node)).collect()),
            ),
            ("x", numbers(&|node| place(node).position().x)),
            ("y", numbers(&|node| place(node).position().y)),
            ("ux", numbers(&|node| place(node).displacement.x)),
            ("uy", numbers(&|node| place(node).displacement.y)),
            ("vx", numbers(&|node| state.velocity[node].x)),
            ("vy", numbers(&|node| state.velocity[node].y)),
            ("area", Values::Numbers(grains.area.clone())),
            ("damage", Values::Numbers(damage(world))),
        ],
    }
}

/// The final grains, with the number of pieces of each.
pub fn grains(world: &World, pieces: &[usize]) -> Table {
    let (grains, state) = (world.grains(), world.state());
    let all = 0..grains.rows.len();
    let rows = || grains.rows.iter().map(|row| row.nodes.clone());
    let centres: Vec<Vec2> = rows()
        .map(|nodes| centre(grains, nodes, |node| state.places[node].position()))
        .collect();
    let velocities: Vec<Vec2> = rows()
        .map(|nodes| centre(grains, nodes, |node| state.velocity[node]))
        .collect();
    let numbers = |of: &dyn Fn(usize) -> f64| Values::Numbers(all.clone().map(of).collect());
    let integers = |of: &dyn Fn(usize) -> usize| Values::Integers(all.clone().map(of).collect());
    let nodes = |grain: usize| grains.rows[grain].nodes.clone();
    let area = |grain| grains.area[nodes(grain)].iter().sum();
    Table {
        columns: vec![
            ("grain", integers(&|grain| grain)),
            ("nodes", integers(&|grain| nodes(grain).len())),
            ("area", numbers(&area)),
            ("x", numbers(&|grain| centres[grain].x)),
            ("y", numbers(&|grain| centres[grain].y)),
            ("vx", numbers(&|grain| velocities[grain].x)),
            ("vy", numbers(&|grain| velocities[grain].y)),
            (
                "bonds",
                integers(&|grain| world.bonds().count_of(nodes(grain))),
            ),
            (
                "damage",
                numbers(&|grain| grain_damage(grains, world.bonds(), grain)),
            ),
            ("pieces", integers(&|grain| pieces[grain])),
        ],
    }
}

/// All bonds: their grain, nodes counted from its first, and reference lengths in m.
pub fn bonds(world: &World) -> Table {
    let grain_of = |later: usize| world.grains().grain_of[later] as usize;
    let all: Vec<(usize, usize, f64)> = world.bonds().all().collect();
    let integers =
        |of: &dyn Fn(&(usize, usize, f64)) -> usize| Values::Integers(all.iter().map(of).collect());
    Table {
        columns: vec![
            ("grain", integers(&|bond| grain_of(bond.1))),
            ("i", integers(&|bond| local(world, bond.0))),
            ("j", integers(&|bond| local(world, bond.1))),
            (
                "length",
                Values::Numbers(all.iter().map(|bond| bond.2).collect()),
            ),
        ],
    }
}

/// The number of a node, counted from the first of its grain.
pub fn local(world: &World, node: usize) -> usize {
    node - world.grains().of(node).nodes.start
}

/// The grain of every node.
pub fn grain_of(world: &World) -> Vec<usize> {
    let all = world.grains().grain_of.iter();
    all.map(|&grain| grain as usize).collect()
}

/// The damage of every node.
pub fn damage(world: &World) -> Vec<f64> {
    let nodes = 0..world.grains().nodes();
    nodes.map(|node| world.bonds().damage(node)).collect()
}
