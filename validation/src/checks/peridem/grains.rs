//! Grains and worlds of the checks.

use crate::checks::Failure;
use crate::checks::random::Random;
use crate::oracles::peridem::WeightFunction;
use crate::oracles::peridem::elastic::Cloud;
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::contact_law::{ContactLaw, ContactReading};
use gouge_peridem::contacts::Contact;
use gouge_peridem::forces::Settings;
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::{BondConstants, Material, Plane, Weight};
use gouge_peridem::mesh::Mesh;
use gouge_peridem::shape::Outline;
use gouge_peridem::state::State;
use gouge_peridem::world::{Beginning, World};

/// The second material of table 2, with its fracture energy.
pub const MATERIAL: Material = Material {
    young_modulus: 1.23e9,
    poisson_ratio: 1.0 / 3.0,
    fracture_energy: 135.0,
    density: 1200.0,
    plane: Plane::Stress,
};

/// The weights in the order of those of the oracles.
pub const WEIGHTS: [Weight; 3] = [Weight::Constant, Weight::Conic, Weight::Parabolic];

/// Nodes with areas as a grain of the material that does not break.
pub fn grain(position: Vec<Vec2>, area: Vec<f64>, constants: BondConstants) -> Grain {
    Grain {
        position,
        area,
        density: MATERIAL.density,
        constants,
        breaking: None,
        touches_itself: false,
        contact_stiffness: constants.stiffness,
        material: 0,
        clamped: Vec::new(),
        load: Vec::new(),
    }
}

/// A rectangle of square cells of a side in m.
pub fn block(
    [columns, rows]: [usize; 2],
    side: f64,
    ratio: f64,
    weight: Weight,
) -> Result<Grain, Failure> {
    let constants = MATERIAL.bond_constants(weight, ratio * side)?;
    let place = |k: usize| Vec2::new((k % columns) as f64 * side, (k / columns) as f64 * side);
    let nodes = columns * rows;
    let position = (0..nodes).map(place).collect();
    Ok(grain(position, vec![side * side; nodes], constants))
}

/// A disc of 20 sides and a radius of 1 mm around a point.
pub fn disc(size: f64, centre: Vec2, weight: Weight) -> Result<Grain, Failure> {
    let mesh = Mesh::triangulated(&Outline::disc(1e-3, 20)?, size)?;
    let constants = MATERIAL.bond_constants(weight, 4.015 * size)?;
    let position = mesh.position.iter().map(|&place| place + centre).collect();
    Ok(grain(position, mesh.area, constants))
}

/// A rough grain of random radii with up to 1 mm around a point.
pub fn rough(size: f64, centre: Vec2, seed: u64) -> Result<Grain, Failure> {
    let mut random = Random::new(seed);
    let numbers: Vec<f64> = (0..20).map(|_| random.between(0.0, 1.0)).collect();
    let outline = Outline::perturbed_disc(1e-3, 0.6, &numbers)?;
    let mesh = Mesh::triangulated(&outline, size)?;
    let constants = MATERIAL.bond_constants(Weight::Constant, 4.015 * size)?;
    let position = mesh.position.iter().map(|&place| place + centre).collect();
    Ok(grain(position, mesh.area, constants))
}

/// The same nodes for the oracles.
pub fn cloud(grain: &Grain, weight: WeightFunction) -> Cloud {
    Cloud {
        nodes: grain.position.iter().map(|p| [p.x, p.y]).collect(),
        areas: grain.area.clone(),
        density: grain.density,
        horizon: grain.constants.horizon,
        stiffness: grain.constants.stiffness,
        weight,
    }
}

/// Nothing but bonds.
pub fn bonds_only(time_step: f64) -> Settings {
    Settings {
        time_step,
        gravity: Vec2::zero(),
        break_order: BreakOrder::BreakFirst,
        contact: None,
        walls: None,
    }
}

/// Contact within a radius in m, as stiff as bonds.
pub fn contact(radius: f64, damping_ratio: f64, friction: f64) -> Result<Contact, Failure> {
    let stiffness = MATERIAL.bond_constants(Weight::Constant, 4.0 * radius)?;
    Ok(Contact {
        law: ContactLaw {
            radius,
            damping_ratio,
            friction,
            reading: ContactReading::Symmetric,
        },
        stiffness: vec![vec![stiffness.stiffness / radius]],
        shares_sticking: false,
    })
}

/// A world of grains with velocities, bonds within the horizon.
pub fn world(
    grains: &[Grain],
    settings: Settings,
    velocity: impl Fn(usize, Vec2) -> Vec2,
) -> Result<World, Failure> {
    let all = Grains::new(grains)?;
    let bonds = Bonds::within_horizon(&all, |_, _, _| true)?;
    let mut state = State::at_rest(&all, bonds);
    for (node, own) in state.velocity.iter_mut().enumerate() {
        *own = velocity(all.grain_of[node] as usize, all.position[node]);
    }
    Ok(World::new(all, settings, state, Beginning::Forces)?)
}

/// A grain whose bonds break in tension.
pub fn breakable(mut grain: Grain) -> Grain {
    grain.breaking = Some(BreakingRule::TensionOnly);
    grain
}

/// The whole energy with what was lost, in J/m.
pub fn balance(world: &World) -> f64 {
    let (energies, work) = (world.energies(), world.state().work);
    energies.kinetic + energies.bonds + energies.contacts + energies.external - work.walls
        + work.damping
        + work.friction
        + work.broken
}
