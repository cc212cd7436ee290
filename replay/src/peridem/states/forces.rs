//! Forces and energies of bonds, and which of them break, in given displacements.

use super::constants::{WEIGHTS, object};
use super::{Found, Sheet};
use crate::error::Fault;
use crate::fields::Fields;
use crate::peridem::pairs;
use crate::peridem::refusals::{MATERIAL, of_parameter};
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule, Elongation};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::forces::Settings;
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::{BondConstants, Material, Plane, Weight};
use gouge_peridem::state::State;
use gouge_peridem::world::{Beginning, World};
use serde_json::{Value, json};
use std::collections::BTreeSet;

const INPUTS: [&str; 12] = [
    "name", "note", "E", "nu", "eps", "Gc", "x", "y", "V", "ux", "uy", "bonds",
];

pub(super) fn solve(sheet: &mut Sheet) -> Result<(), Fault> {
    sheet.solve("cases", &INPUTS, case)
}

/// Nodes with areas and displacements, and their bonds.
struct Cloud {
    position: Vec<Vec2>,
    displacement: Vec<Vec2>,
    area: Vec<f64>,
    bonds: Vec<[usize; 2]>,
}

impl Cloud {
    fn read(case: &Fields) -> Result<Self, Fault> {
        let nodes = case.filled_list("x", "number")?.len();
        let position = case.vectors("x", "y", nodes)?;
        Ok(Self {
            displacement: case.vectors("ux", "uy", nodes)?,
            area: case.usables_of("V", nodes)?,
            bonds: pairs::read(&case.list("bonds")?, &position)?,
            position,
        })
    }

    fn elongation(&self, [i, j]: [usize; 2]) -> Elongation {
        let reference = self.position[j] - self.position[i];
        let change = self.displacement[j] - self.displacement[i];
        Elongation::new(reference, change, reference.norm())
    }

    /// The nodes as a grain of density one, whose accelerations are force densities.
    fn world(
        &self,
        constants: BondConstants,
        breaking: Option<BreakingRule>,
    ) -> Result<World, Fault> {
        let grains = Grains::new(&[Grain {
            position: self.position.clone(),
            area: self.area.clone(),
            density: 1.0,
            constants,
            breaking,
            touches_itself: false,
            contact_stiffness: constants.stiffness,
            material: 0,
            clamped: Vec::new(),
            load: Vec::new(),
        }])?;
        let bonds = Bonds::from_pairs(&grains, std::slice::from_ref(&self.bonds))?;
        let mut state = State::at_rest(&grains, bonds);
        for (place, &displacement) in state.places.iter_mut().zip(&self.displacement) {
            place.displacement = displacement;
        }
        let settings = Settings {
            time_step: 1.0,
            gravity: Vec2::zero(),
            break_order: BreakOrder::BreakFirst,
            contact: None,
            walls: None,
        };
        Ok(World::new(grains, settings, state, Beginning::Forces)?)
    }

    /// Places in the list of bonds of those that broke.
    fn broken(&self, world: &World) -> Vec<usize> {
        let all: BTreeSet<_> = world.broken().iter().map(|pair| pair.indices()).collect();
        let broken = |&[i, j]: &[usize; 2]| all.contains(&(i.min(j), i.max(j)));
        let places = self.bonds.iter().enumerate();
        places
            .filter(|(_, bond)| broken(bond))
            .map(|(k, _)| k)
            .collect()
    }
}

fn case(case: &Fields) -> Result<Found, Fault> {
    let cloud = Cloud::read(case)?;
    let weights = case.inside("weights")?;
    weights.require_keys(&WEIGHTS.map(|(name, _)| name))?;
    let mut found = Found::new();
    for (name, weight) in WEIGHTS {
        if weights.optional(name).is_some() {
            let constants = constants(case, &weights.inside(name)?, weight)?;
            found.insert(name.to_owned(), readings(&cloud, constants)?.into());
        }
    }
    Ok(object([("weights", found.into())]))
}

/// Constants that a weight gives, or those of the material if it gives none.
fn constants(case: &Fields, given: &Fields, weight: Weight) -> Result<BondConstants, Fault> {
    let horizon = case.usable("eps")?;
    if given.optional("c").is_some() || given.optional("s0").is_some() {
        return Ok(BondConstants {
            weight,
            horizon,
            stiffness: given.usable("c")?,
            critical_stretch: given.positive("s0")?,
        });
    }
    let material = Material {
        young_modulus: case.positive("E")?,
        poisson_ratio: case.number("nu")?,
        fracture_energy: case.positive("Gc")?,
        density: 1.0,
        plane: Plane::Stress,
    };
    let constants = material.bond_constants(weight, horizon);
    constants.map_err(|error| of_parameter(case, &MATERIAL, error))
}

fn readings(cloud: &Cloud, constants: BondConstants) -> Result<Found, Fault> {
    let whole = cloud.world(constants, None)?;
    let tension = cloud.world(constants, Some(BreakingRule::TensionOnly))?;
    let two_sided = cloud.world(constants, Some(BreakingRule::TwoSided))?;
    let densities = |world: &World| {
        world
            .state()
            .acceleration
            .iter()
            .map(vector)
            .collect::<Vec<_>>()
    };
    let forces = whole.state().acceleration.iter();
    let largest = forces.flat_map(|force| [force.x.abs(), force.y.abs()]);
    let mut found = pairs(cloud, &constants);
    found.extend(object([
        ("c", constants.stiffness.into()),
        ("s0", constants.critical_stretch.into()),
        ("total_energy", whole.energies().bonds.into()),
        ("broken_tension_only", cloud.broken(&tension).into()),
        ("broken_two_sided", cloud.broken(&two_sided).into()),
        (
            "force_density",
            json!({
                "all": densities(&whole),
                "surviving_tension_only": densities(&tension),
                "surviving_two_sided": densities(&two_sided),
            }),
        ),
        ("max_force_density", largest.fold(0.0, f64::max).into()),
    ]));
    Ok(found)
}

fn vector(value: &Vec2) -> Value {
    json!([value.x, value.y])
}

/// What is computed per bond, and sums over the bonds of each node.
fn pairs(cloud: &Cloud, constants: &BondConstants) -> Found {
    let mut densities = vec![0.0; cloud.position.len()];
    let mut magnitudes = densities.clone();
    let (mut stretches, mut forces, mut energies) = (Vec::new(), Vec::new(), Vec::new());
    for &[i, j] in &cloud.bonds {
        let elongation = cloud.elongation([i, j]);
        let pull = elongation.pull(constants.weight, constants.horizon) * constants.stiffness;
        let energy = elongation.energy(constants);
        let (own, other) = (cloud.area[i], cloud.area[j]);
        stretches.push(elongation.stretch());
        forces.push(vector(&(pull * (own * other))));
        energies.push(energy * (own * other));
        for (node, partner) in [(i, other), (j, own)] {
            densities[node] += 0.5 * energy * partner;
            magnitudes[node] += pull.norm() * partner;
        }
    }
    object([
        ("stretch", stretches.into()),
        ("pair_force_on_i", forces.into()),
        ("bond_energy", energies.into()),
        ("node_energy_density", densities.into()),
        ("sum_abs_pair_force_density", magnitudes.into()),
    ])
}
