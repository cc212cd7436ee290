//! Bonds and contacts as a table.

use super::super::Scene;
use super::begin::built;
use super::tables::local;
use crate::error::Error;
use crate::run::table::{Kinds, Table, Values};
use gouge_common::geometry::Vec2;
use gouge_peridem::world::World;

/// A bond or a contact.
struct Link {
    kind: usize,
    nodes: [usize; 2],
    /// Length in m at which it exerts no force, and present distance in m.
    lengths: [f64; 2],
    /// Force of the second node on the first in N per metre of depth: along the line between them, negative if they repel
    /// each other, and along this line turned by +90 degrees.
    forces: [f64; 2],
}

/// All bonds and contacts between nodes at t = 0.
///
/// # Errors
/// Scenes that the kernel refuses.
pub fn links(scene: &Scene) -> Result<Table, Error> {
    let world = built(scene)?.world;
    let links: Vec<Link> = bonds(&world).chain(contacts(&world)).collect();
    let integers = |of: &dyn Fn(&Link) -> usize| Values::Integers(links.iter().map(of).collect());
    let numbers = |of: &dyn Fn(&Link) -> f64| Values::Numbers(links.iter().map(of).collect());
    let grain = |node: usize| world.grains().grain_of[node] as usize;
    let kinds = Kinds {
        names: vec!["bond", "contact"],
        codes: links.iter().map(|link| link.kind).collect(),
    };
    Ok(Table {
        columns: vec![
            ("grain_i", integers(&|link| grain(link.nodes[0]))),
            ("i", integers(&|link| local(&world, link.nodes[0]))),
            ("grain_j", integers(&|link| grain(link.nodes[1]))),
            ("j", integers(&|link| local(&world, link.nodes[1]))),
            ("kind", Values::Kinds(kinds)),
            ("length", numbers(&|link| link.lengths[0])),
            ("distance", numbers(&|link| link.lengths[1])),
            ("normal_force", numbers(&|link| link.forces[0])),
            ("tangential_force", numbers(&|link| link.forces[1])),
        ],
    })
}

fn bonds(world: &World) -> impl Iterator<Item = Link> + '_ {
    let (grains, state) = (world.grains(), world.state());
    world.bonds().all().map(move |(earlier, later, length)| {
        let (from, to) = (state.places[earlier], state.places[later]);
        let elongation = from.elongation_to(to, length);
        let constants = &grains.of(later).constants;
        let areas = grains.area[earlier] * grains.area[later];
        let weight = constants.weight.at(length, constants.horizon);
        let pull = constants.stiffness * weight * elongation.stretch() * areas;
        Link {
            kind: 0,
            nodes: [earlier, later],
            lengths: [length, elongation.distance],
            forces: [pull, 0.0],
        }
    })
}

fn contacts(world: &World) -> impl Iterator<Item = Link> {
    world.contacts().into_iter().map(|touching| {
        let (i, j) = touching.pair.indices();
        let distance = touching.separation.norm();
        // Nodes at the same place have no direction and exert no force.
        let direction = match distance > 0.0 {
            true => touching.separation * (1.0 / distance),
            false => Vec2::zero(),
        };
        let total = touching.on_first.total();
        Link {
            kind: 1,
            nodes: [i, j],
            lengths: [touching.rest_distance, distance],
            forces: [total.dot(direction), direction.cross(total)],
        }
    })
}
