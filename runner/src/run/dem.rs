//! Outputs of the thesis's model: values of the series, columns of particles, frames.

use super::displacements::Displacements;
use super::friction::DriveSample;
use super::links;
use super::measures::{measured, names as measured_names};
use super::page::{DRIVEN, FIXED, Grain, SINGLE};
use super::series::{Sample, Value};
use super::table::{Kinds, Table, Values};
use super::trajectory::{Frame, LinkFrame, Shapes};
use crate::scene::{Scene, role_name};
use gouge_common::geometry::Vec2;
use gouge_dem::estimators::{
    Energy, fragments, friction_feedback, friction_load, particle_pressures,
};
use gouge_dem::forces::Interaction;
use gouge_dem::laws::characteristic_length;
use gouge_dem::particles::{Particles, Role, sphere_mass};
use gouge_dem::{Drive, World};

/// A sample of a world: with the energies if the scene keeps the balance, and with strains if displacements are given.
/// `evaluated` is the world with the forces in its state.
pub fn sample(
    scene: &Scene,
    world: &World,
    evaluated: &World,
    energy: Option<&Energy>,
    displacements: Option<&Displacements>,
) -> Sample {
    let mut sample = vec![("time", Value::Number(world.time()))];
    if let Some(energy) = energy {
        let energies = Energy::<f64>::NAMES.into_iter().zip(energy.values());
        sample.extend(energies.map(|(name, energy)| (name, Value::Number(energy))));
    }
    if scene.driving.is_some() {
        let drive = evaluated.drive();
        let numbers = [
            friction_load(drive),
            friction_feedback(drive),
            drive.applied.x,
            drive.applied.y,
        ];
        sample.extend(DRIVE.into_iter().zip(numbers.map(Value::Number)));
    }
    if scene.bond.is_some() {
        let fragments = fragments(world.state()).number;
        let counts = [number_of_bonds(world), fragments];
        sample.extend(BONDS.into_iter().zip(counts.map(Value::Count)));
    }
    sample.extend(measured(scene, world, evaluated, displacements));
    sample
}

/// What a sample says about the drive; none if the work of the drive is not known.
pub fn drive_sample(world: &World, drive: &Drive<f64>) -> Option<DriveSample> {
    let [shearing, sliding] = world.shearing_and_sliding()?;
    let p = world.particles();
    let driven = || (0..p.len()).filter(|&i| p.role[i] == Role::Driven);
    let velocity: f64 = driven().map(|i| p.velocity[i].x).sum();
    Some(DriveSample {
        time: world.time(),
        shearing,
        sliding,
        velocity: velocity / driven().count() as f64,
        coefficient: friction_load(drive),
    })
}

/// Columns of a scene with a drive.
const DRIVE: [&str; 4] = [
    "friction_load",
    "friction_feedback",
    "drive_force_x",
    "drive_force_y",
];
/// Columns of a scene with bonds.
const BONDS: [&str; 2] = ["bonds", "fragments"];

/// Names of the values in every sample of a scene.
pub fn series_columns(scene: &Scene) -> Vec<&'static str> {
    let mut names = vec!["time"];
    if scene.output.energy {
        names.extend(Energy::<f64>::NAMES);
    }
    if scene.driving.is_some() {
        names.extend(DRIVE);
    }
    if scene.bond.is_some() {
        names.extend(BONDS);
    }
    let measures = scene.output.measure.iter();
    names.extend(measures.flat_map(|&measure| measured_names(measure)));
    names
}

/// The first energy of a sample that is not finite.
pub fn infinite_energy(sample: &Sample) -> Option<&'static str> {
    let infinite = sample.iter().find(|(name, value)| match value {
        Value::Number(number) => Energy::<f64>::NAMES.contains(name) && !number.is_finite(),
        Value::Count(_) => false,
    });
    infinite.map(|(name, _)| *name)
}

/// The energies of a world by name.
pub fn energies(world: &World) -> serde_json::Map<String, serde_json::Value> {
    let values = world.energy().values();
    Energy::<f64>::NAMES
        .iter()
        .zip(values)
        .map(|(name, value)| ((*name).to_owned(), serde_json::json!(value)))
        .collect()
}

/// Number of bonds; zero if the model has no bonds.
pub fn number_of_bonds(world: &World) -> usize {
    world.bonds().map_or(0, |bonds| bonds.len())
}

/// The final particles, with the columns of `particles.csv`. There is a column of densities only if it is needed to
/// read the masses back.
pub fn particles(scene: &Scene, particles: &Particles) -> Table {
    let component =
        |column: &[Vec2], of: fn(&Vec2) -> f64| Values::Numbers(column.iter().map(of).collect());
    let p = particles;
    let mut columns = vec![
        ("id", Values::Integers((0..p.len()).collect())),
        ("x", component(&p.position, |v| v.x)),
        ("y", component(&p.position, |v| v.y)),
        ("vx", component(&p.velocity, |v| v.x)),
        ("vy", component(&p.velocity, |v| v.y)),
        ("angle", Values::Numbers(p.angle.clone())),
        (
            "angular_velocity",
            Values::Numbers(p.angular_velocity.clone()),
        ),
        ("radius", Values::Numbers(p.radius.clone())),
        ("role", Values::Kinds(roles(&p.role))),
    ];
    let is_of_material =
        |(mass, &radius): (&f64, &f64)| *mass == sphere_mass(scene.material.density, radius);
    if !p.mass.iter().zip(&p.radius).all(is_of_material) {
        let densities = p
            .mass
            .iter()
            .zip(&p.radius)
            .map(|(&mass, &radius)| density(mass, radius));
        columns.push(("density", Values::Numbers(densities.collect())));
    }
    Table { columns }
}

/// Density that gives the mass of a sphere: exactly, if there is such a number, and otherwise up to rounding.
pub fn density(mass: f64, radius: f64) -> f64 {
    let near = mass / sphere_mass(1.0, radius);
    let candidates = [near, near.next_up(), near.next_down()];
    let is_exact = |density: &f64| sphere_mass(*density, radius) == mass;
    candidates.into_iter().find(is_exact).unwrap_or(near)
}

/// Roles as categories.
pub fn roles(roles: &[Role]) -> Kinds {
    let names = [Role::Free, Role::Driven, Role::Fixed].map(role_name);
    let code = |role: &Role| match role {
        Role::Free => 0,
        Role::Driven => 1,
        Role::Fixed => 2,
    };
    Kinds {
        names: names.to_vec(),
        codes: roles.iter().map(code).collect(),
    }
}

/// A frame of a world.
pub fn frame(scene: &Scene, world: &World) -> Frame {
    let p = world.particles();
    let labels = fragments(world.state()).label;
    let columns = vec![
        ("angle", Values::Numbers(p.angle.clone())),
        (
            "angular_velocity",
            Values::Numbers(p.angular_velocity.clone()),
        ),
        ("fragment", Values::Integers(labels)),
        ("role", Values::Kinds(roles(&p.role))),
    ];
    Frame {
        time: world.time(),
        note: String::new(),
        domain: scene.domain,
        positions: p.position.clone(),
        shapes: Shapes::Discs(p.radius.clone()),
        vectors: vec![("velocity", p.velocity.clone())],
        scalars: Table { columns },
        lines: lines(scene, world).collect(),
    }
}

/// The links of a world at the time of a frame.
pub fn link_frame(scene: &Scene, world: &World) -> LinkFrame {
    let links = links::sorted(world);
    let position = &world.particles().position;
    let segment = |link: &Interaction| {
        let from = position[link.pair.i as usize];
        [from, from + link.normal * link.distance]
    };
    let segments: Vec<[Vec2; 2]> = links.iter().map(segment).collect();
    let ends = || segments.iter().flatten().chain(position);
    let least = |of: fn(&Vec2) -> f64| ends().map(of).fold(f64::INFINITY, f64::min);
    let most = |of: fn(&Vec2) -> f64| ends().map(of).fold(f64::NEG_INFINITY, f64::max);
    let (left, right) = match scene.domain.period() {
        Some(width) => (0.0, width),
        None => (least(|x| x.x), most(|x| x.x)),
    };
    LinkFrame {
        time: world.time(),
        steps: world.steps(),
        is_periodic: scene.domain.periodic,
        bounds: [
            Vec2::new(left, least(|x| x.y)),
            Vec2::new(right, most(|x| x.y)),
        ],
        links: links::table_of_links(&links),
        segments,
    }
}

/// Bonds that can be drawn as lines between their particles: all except those across the periodic boundary.
pub fn lines(scene: &Scene, world: &World) -> impl Iterator<Item = (usize, usize)> {
    let position = &world.particles().position;
    let half = scene
        .domain
        .period()
        .map_or(f64::INFINITY, |width| 0.5 * width);
    let bonded = world.bonds().map_or(&[][..], |bonds| bonds.pairs());
    let pairs = bonded.iter().map(|pair| pair.indices());
    pairs.filter(move |&(i, j)| (position[i].x - position[j].x).abs() <= half)
}

/// What the motion on the page shows of every particle.
pub fn grains(world: &World) -> Vec<Grain> {
    let p = world.particles();
    let fragments = fragments(world.state());
    let mut sizes = vec![0_usize; fragments.number];
    fragments.label.iter().for_each(|&label| sizes[label] += 1);
    let thickness = characteristic_length(&p.radius);
    let pressures = particle_pressures(p, &world.interactions(), thickness);
    let grain = |i: usize| Grain {
        numbers: [
            p.position[i].x as f32,
            p.position[i].y as f32,
            p.angle[i] as f32,
            p.velocity[i].norm() as f32,
            pressures[i] as f32,
        ],
        colour: match (p.role[i], sizes[fragments.label[i]]) {
            (Role::Fixed, _) => FIXED,
            (Role::Driven, _) => DRIVEN,
            (Role::Free, 1) => SINGLE,
            (Role::Free, _) => (fragments.label[i] % usize::from(SINGLE)) as u8,
        },
    };
    (0..p.len()).map(grain).collect()
}
