//! Samples: rows of the series.

use super::super::Scene;
use super::since::Since;
use crate::run::series::{Sample, Value};
use gouge_contact_dynamics::cell::{Drive, Speed, roof_height};
use gouge_contact_dynamics::world::World;

/// Terms of the balance of energy, in J.
const ENERGY: [&str; 7] = [
    "kinetic",
    "collision",
    "friction",
    "correction",
    "load",
    "driving",
    "residual",
];
/// Columns of a cell that is sheared: strain, height of the roof in m, stresses on the roof in Pa.
const SHEAR: [&str; 4] = ["strain", "height", "shear_stress", "normal_stress"];
/// Columns of every scene: the numbers of the steps since the sample before.
const STEPS: [&str; 7] = [
    "points",
    "sweeps",
    "unconverged",
    "not_unique",
    "large_overlaps",
    "largest_overlap",
    "velocity_residual",
];

/// Names of the values in every sample of a scene.
pub fn columns(scene: &Scene) -> Vec<&'static str> {
    let energy = ENERGY.iter().filter(|_| scene.output.energy);
    let shear = SHEAR.iter().filter(|_| scene.shear.is_some());
    let names = ["time"].iter().chain(energy).chain(shear).chain(&STEPS);
    names.copied().collect()
}

/// The terms of the balance of energy in J since a beginning with a kinetic energy in J.
pub fn energies(world: &World, beginning: f64) -> Option<[(&'static str, f64); 7]> {
    let work = world.work()?;
    let kinetic = world.kinetic_energy();
    let residual = kinetic - beginning - work.total();
    let numbers = [
        kinetic,
        work.collision,
        work.friction,
        work.correction,
        work.load,
        work.drive,
        residual,
    ];
    Some(std::array::from_fn(|k| (ENERGY[k], numbers[k])))
}

/// The residual of the balance over the sum of the magnitudes of its terms; none if no work is booked.
pub fn balance_error(world: &World, beginning: f64) -> Option<f64> {
    let terms = energies(world, beginning)?;
    let (_, residual) = terms[6];
    let scale: f64 = terms[..6].iter().map(|(_, term)| term.abs()).sum();
    let scale = scale + beginning;
    Some(if scale > 0.0 {
        residual.abs() / scale
    } else {
        0.0
    })
}

/// A sample of a world: `beginning` is its kinetic energy in J at t = 0, and `strain` its shear strain since then.
pub fn sample(scene: &Scene, world: &World, since: &Since, beginning: f64, strain: f64) -> Sample {
    let mut sample = vec![("time", Value::Number(world.time()))];
    if let Some(energies) = energies(world, beginning) {
        let terms = energies.map(|(name, energy)| (name, Value::Number(energy)));
        sample.extend(terms);
    }
    if scene.shear.is_some() {
        let area = scene.domain.width.unwrap_or(0.0) * scene.settings.time_step;
        let stress = since.on_roof * (1.0 / area);
        let numbers = [
            strain,
            roof_height(world.state()),
            since.per_step(-stress.x),
            since.per_step(stress.y),
        ];
        sample.extend(SHEAR.into_iter().zip(numbers.map(Value::Number)));
    }
    let solver = world.workspace().solver();
    let steps = [
        Value::Count(solver.rows().len()),
        Value::Number(since.per_step(since.sweeps as f64)),
        Value::Count(since.unconverged as usize),
        Value::Count(since.not_unique as usize),
        Value::Count(since.large_overlaps as usize),
        Value::Number(since.largest_overlap),
        Value::Number(solver.residual(&world.state().configuration.velocity)),
    ];
    sample.extend(STEPS.into_iter().zip(steps));
    sample
}

/// The shear strain of a step.
pub fn strain_of_step(world: &World) -> f64 {
    let step = world.settings().time_step;
    match world.drive() {
        Some(Drive::Shear {
            speed: Speed::Rate(rate),
            ..
        }) => rate * step,
        Some(Drive::Shear {
            speed: Speed::Constant(velocity),
            ..
        }) => velocity * step / roof_height(world.state()),
        _ => 0.0,
    }
}
