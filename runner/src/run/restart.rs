//! The final state as text: bonds, and a scene that continues from it bit by bit.

use super::dem::{density, roles};
use super::folder::{BONDS, RESTART, RESTART_CONTACTS, RESTART_PARTICLES, write_soon, write_whole};
use super::table::{Column, Table, Values};
use crate::error::Error;
use crate::scene::{Scene, initial_angles};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_dem::World;
use gouge_dem::bonds::Bond;
use gouge_dem::contacts::ContactMemory;
use gouge_dem::forces::{Interaction, InteractionKind};
use gouge_dem::geometry::ContactDistance;
use gouge_dem::laws::Driving;
use gouge_dem::particles::{Particles, moment_of_inertia, sphere_mass};
use std::path::Path;

/// A remembered contact.
type Contact = (Pair, ContactMemory<f64>);

/// Write `bonds.csv`, if the scene has bonds.
///
/// # Errors
/// Failures of the file system.
pub fn write_bonds(folder: &Path, world: &World) -> Result<(), Error> {
    if world.bonds().is_none() {
        return Ok(());
    }
    write_whole(&folder.join(BONDS), bonds(world).to_csv().as_bytes())
}

/// Write `restart.toml` and the files that it reads besides `bonds.csv`.
///
/// # Errors
/// Failures of the file system.
pub fn write_restart(folder: &Path, scene: &Scene, world: &World) -> Result<(), Error> {
    let particles = particles(scene, world.particles());
    write_soon(
        &folder.join(RESTART_PARTICLES),
        particles.to_csv().as_bytes(),
    )?;
    let contacts: Vec<Contact> = world
        .contacts()
        .map_or_else(Vec::new, |contacts| contacts.remembered().collect());
    if !contacts.is_empty() {
        let table = contacts_table(scene, &contacts);
        write_soon(&folder.join(RESTART_CONTACTS), table.to_csv().as_bytes())?;
    }
    let text = restart(scene, world, !contacts.is_empty());
    let text = text.map_err(|error| {
        Error::file("write", &folder.join(RESTART), std::io::Error::other(error))
    })?;
    write_soon(&folder.join(RESTART), text.as_bytes())
}

/// The scene that continues from the final state.
fn restart(scene: &Scene, world: &World, has_contacts: bool) -> Result<String, toml::ser::Error> {
    let mut table = scene.laws.clone();
    let mut name = |key: &str, file: &str| table.insert(key.to_owned(), file.into());
    name("particles_file", RESTART_PARTICLES);
    if world.bonds().is_some() {
        name("bonds_file", BONDS);
    }
    if has_contacts {
        name("contacts_file", RESTART_CONTACTS);
    }
    // The force of a prescribed motion follows from the state.
    let has_force = |law: &Driving| law.prescribed_velocity().is_none();
    if let Some(toml::Value::Table(driving)) = table.get_mut("driving")
        && world.model().driving.as_ref().is_some_and(has_force)
    {
        let force = world.drive().force;
        driving.insert("initial_force".to_owned(), vec![force.x, force.y].into());
    }
    let about = format!(
        "# The state at t = {:?} s of a run. Times count from there.\n",
        world.time()
    );
    Ok(about + &toml::to_string(&table)?)
}

/// All bonds with the columns of a `bonds_file`, and their forces.
fn bonds(world: &World) -> Table {
    let bonds: Vec<Bond<f64>> = world.bonds().iter().flat_map(|all| all.iter()).collect();
    let links = world.interactions();
    let is_bond = |link: &&Interaction| link.kind == InteractionKind::Bond;
    let links: Vec<&Interaction> = links.iter().filter(is_bond).collect();
    let of_bond = |of: fn(&Bond<f64>) -> f64| Values::Numbers(bonds.iter().map(of).collect());
    let of_link =
        |of: fn(&Interaction) -> f64| Values::Numbers(links.iter().map(|link| of(link)).collect());
    let mut columns = pairs(bonds.iter().map(|bond| bond.pair));
    columns.extend([
        ("strength_factor", of_bond(|bond| bond.strength_factor)),
        ("initial_distance", of_bond(|bond| bond.rest.distance)),
    ]);
    let beginnings = bonds
        .iter()
        .map(|bond| (bond.rest.reference, bond.rest.angles));
    columns.extend(angles(beginnings.clone()));
    columns.extend(references(beginnings.clone()));
    columns.extend(ends(["rest_angle_i", "rest_angle_j"], beginnings));
    columns.extend([
        ("normal_force", of_link(|link| link.normal_force)),
        ("tangential_force", of_link(|link| link.tangential_force)),
    ]);
    Table { columns }
}

/// Remembered contacts with the columns of a `contacts_file`. Lever arms that accumulate have no initial angles.
fn contacts_table(scene: &Scene, contacts: &[Contact]) -> Table {
    let mut columns = pairs(contacts.iter().map(|(pair, _)| *pair));
    let beginnings = contacts
        .iter()
        .map(|(_, memory)| (memory.reference, memory.ends));
    let accumulates =
        |laws: gouge_dem::model::ContactLaws| matches!(laws.distance, ContactDistance::Mixed(_));
    if !scene.contact.is_some_and(accumulates) {
        columns.extend(angles(beginnings.clone()));
    }
    columns.extend(references(beginnings.clone()));
    columns.extend(ends(["memory_i", "memory_j"], beginnings));
    let states = contacts.iter().map(|(_, memory)| memory.state);
    columns.push(("history", Values::Numbers(states.collect())));
    Table { columns }
}

fn pairs(pairs: impl Iterator<Item = Pair> + Clone) -> Vec<Column> {
    let first = pairs.clone().map(|pair| pair.i as usize).collect();
    let second = pairs.map(|pair| pair.j as usize).collect();
    vec![
        ("i", Values::Integers(first)),
        ("j", Values::Integers(second)),
    ]
}

/// Reference directions and the entries of both ends.
type Beginning = (Vec2, [f64; 2]);

fn angles(beginnings: impl Iterator<Item = Beginning>) -> Vec<Column> {
    let initial =
        beginnings.map(|(reference, angles)| (reference, initial_angles(reference, angles)));
    let initial: Vec<Beginning> = initial.collect();
    ends(["initial_angle_i", "initial_angle_j"], initial.into_iter())
}

fn references(beginnings: impl Iterator<Item = Beginning>) -> Vec<Column> {
    let components = beginnings.map(|(reference, _)| (reference, [reference.x, reference.y]));
    let components: Vec<Beginning> = components.collect();
    ends(["reference_x", "reference_y"], components.into_iter())
}

fn ends([i, j]: [&'static str; 2], beginnings: impl Iterator<Item = Beginning>) -> Vec<Column> {
    let (of_i, of_j) = beginnings.map(|(_, [of_i, of_j])| (of_i, of_j)).unzip();
    vec![(i, Values::Numbers(of_i)), (j, Values::Numbers(of_j))]
}

/// All particles with the columns of a `particles_file`: with densities if masses and moments of inertia follow from
/// them to the bit, otherwise with both.
fn particles(scene: &Scene, p: &Particles) -> Table {
    let component =
        |column: &[Vec2], of: fn(&Vec2) -> f64| Values::Numbers(column.iter().map(of).collect());
    let mut columns = vec![
        ("x", component(&p.position, |v| v.x)),
        ("y", component(&p.position, |v| v.y)),
        ("radius", Values::Numbers(p.radius.clone())),
        ("vx", component(&p.velocity, |v| v.x)),
        ("vy", component(&p.velocity, |v| v.y)),
        ("angle", Values::Numbers(p.angle.clone())),
        (
            "angular_velocity",
            Values::Numbers(p.angular_velocity.clone()),
        ),
    ];
    let densities: Vec<f64> = (0..p.len())
        .map(|i| density(p.mass[i], p.radius[i]))
        .collect();
    let factor = scene.material.inertia_factor;
    let follows = |i: usize| {
        let mass = sphere_mass(densities[i], p.radius[i]);
        let moment = moment_of_inertia(factor, mass, p.radius[i]);
        [mass, moment] == [p.mass[i], p.moment_of_inertia[i]]
    };
    match (0..p.len()).all(follows) {
        true => columns.push(("density", Values::Numbers(densities))),
        false => columns.extend([
            ("mass", Values::Numbers(p.mass.clone())),
            (
                "moment_of_inertia",
                Values::Numbers(p.moment_of_inertia.clone()),
            ),
        ]),
    }
    columns.push(("role", Values::Kinds(roles(&p.role))));
    Table { columns }
}
