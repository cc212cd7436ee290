//! Samples: rows of the series.

use super::super::Scene;
use super::super::scene::{CrackTable, MOST_CRACKS};
use super::balance::ENERGY;
use crate::run::series::{Sample, Value};
use gouge_common::geometry::Vec2;
use gouge_peridem::observables::{Crack, bulk_damage, connected_damage, pieces, softened_area};
use gouge_peridem::world::World;

/// Columns of every scene.
const STATE: [&str; 7] = [
    "momentum_x",
    "momentum_y",
    "bonds",
    "broken_bonds",
    "bulk_damage",
    "softened_area",
    "pieces",
];
/// Share of the grains' area in the container, if there are four walls.
const FRACTION: &str = "solid_fraction";
/// Forces of the grains on the walls in N per metre of depth.
const WALLS: [[&str; 2]; 4] = [
    ["left_force_x", "left_force_y"],
    ["right_force_x", "right_force_y"],
    ["top_force_x", "top_force_y"],
    ["bottom_force_x", "bottom_force_y"],
];
/// Directions in rad and lengths in m of cracks.
const CRACKS: [[&str; 2]; MOST_CRACKS] = [
    ["crack_angle_0", "crack_length_0"],
    ["crack_angle_1", "crack_length_1"],
    ["crack_angle_2", "crack_length_2"],
    ["crack_angle_3", "crack_length_3"],
    ["crack_angle_4", "crack_length_4"],
    ["crack_angle_5", "crack_length_5"],
    ["crack_angle_6", "crack_length_6"],
    ["crack_angle_7", "crack_length_7"],
];
/// Smallest part of the nodes of a grain that counts as a piece.
const PIECE: f64 = 0.05;

/// Names of the values in every sample of a scene.
pub fn columns(scene: &Scene) -> Vec<&'static str> {
    let energy = ENERGY.iter().filter(|_| scene.output.energy);
    let mut names: Vec<&str> = ["time"]
        .iter()
        .chain(energy)
        .chain(&STATE)
        .copied()
        .collect();
    names.extend(has_container(scene).then_some(FRACTION));
    names.extend(walls(scene).flat_map(|wall| WALLS[wall]));
    names.extend(CRACKS.iter().take(scene.cracks.len()).flatten());
    names
}

/// The walls that exist.
fn walls(scene: &Scene) -> impl Iterator<Item = usize> {
    let positions = scene.walls.map(|walls| walls.position);
    let exists = move |wall: &usize| positions.is_some_and(|all| all[*wall].is_finite());
    (0..WALLS.len()).filter(exists)
}

fn has_container(scene: &Scene) -> bool {
    walls(scene).count() == WALLS.len()
}

/// Numbers of pieces of all grains, counted again only for grains that lost bonds.
#[derive(Clone, Debug, Default)]
pub struct Pieces(Vec<(usize, usize)>);

impl Pieces {
    /// The number of pieces of every grain.
    pub fn count(&mut self, world: &World) -> Vec<usize> {
        let (grains, bonds) = (world.grains(), world.bonds());
        self.0.resize(grains.rows.len(), (usize::MAX, 0));
        for (grain, (counted, number)) in self.0.iter_mut().enumerate() {
            let held = bonds.count_of(grains.rows[grain].nodes.clone());
            if held != *counted {
                *number = pieces(grains, bonds, grain, PIECE);
                *counted = held;
            }
        }
        self.0.iter().map(|(_, number)| *number).collect()
    }
}

/// A sample of a world of which `intact` bonds existed at t = 0.
pub fn sample(
    scene: &Scene,
    world: &World,
    terms: Option<&[(&'static str, f64); ENERGY.len()]>,
    (intact, pieces): (usize, usize),
) -> Sample {
    let (grains, bonds) = (world.grains(), world.bonds());
    let mut sample = vec![("time", Value::Number(world.time()))];
    let energies = terms.into_iter().flatten();
    sample.extend(energies.map(|(name, energy)| (*name, Value::Number(*energy))));
    let momentum = momentum(world);
    let grain_numbers = 0..grains.rows.len();
    let state = [
        Value::Number(momentum.x),
        Value::Number(momentum.y),
        Value::Count(bonds.count()),
        Value::Count(intact - bonds.count()),
        Value::Number(bulk_damage(grains, bonds)),
        Value::Number(
            grain_numbers
                .map(|grain| softened_area(grains, bonds, grain))
                .sum(),
        ),
        Value::Count(pieces),
    ];
    sample.extend(STATE.into_iter().zip(state));
    if has_container(scene) {
        sample.push((FRACTION, Value::Number(solid_fraction(world))));
    }
    let reactions = world.reactions();
    for wall in walls(scene) {
        let force = [reactions[wall].x, reactions[wall].y].map(Value::Number);
        sample.extend(WALLS[wall].into_iter().zip(force));
    }
    for (names, table) in CRACKS.into_iter().zip(&scene.cracks) {
        let crack = crack(world, table);
        let numbers = crack.map_or([f64::NAN; 2], |crack| [crack.angle, crack.length]);
        sample.extend(names.into_iter().zip(numbers.map(Value::Number)));
    }
    sample
}

fn momentum(world: &World) -> Vec2 {
    let grains = world.grains();
    let of = |node: usize| world.state().velocity[node] * grains.mass(node);
    (0..grains.nodes()).fold(Vec2::zero(), |sum, node| sum + of(node))
}

/// Area of the undeformed grains over that between the walls.
fn solid_fraction(world: &World) -> f64 {
    let [left, right, top, bottom] = world.state().walls;
    let area: f64 = world.grains().area.iter().sum();
    area / ((right - left) * (top - bottom))
}

/// The crack from a tip; none if no node belongs to it.
pub fn crack(world: &World, table: &CrackTable) -> Option<Crack> {
    let (grains, [low, high]) = (world.grains(), table.within);
    let connected = table.connected.then(|| {
        connected_damage(
            grains,
            world.bonds(),
            table.grain,
            table.tip,
            table.threshold,
        )
    });
    let belongs = |node: usize| {
        let distance = (grains.position[node] - table.tip).norm();
        let is_connected = |nodes: &Vec<usize>| nodes.binary_search(&node).is_ok();
        grains.grain_of[node] as usize == table.grain
            && (low..=high).contains(&distance)
            && connected.as_ref().is_none_or(is_connected)
    };
    Crack::from_tip(grains, world.bonds(), table.tip, table.threshold, belongs)
}
