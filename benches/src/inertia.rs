//! Effect of the moment of inertia used by the thesis's author on friction: the small fault with several seeds.

use gouge_dem::World;
use gouge_dem::estimators::{friction_feedback, friction_load};
use gouge_dem::model::Reading;
use gouge_runner::error::Error;
use gouge_runner::run::{advance, run_setup};
use gouge_runner::scene::{Overrides, Scene};
use std::io::Write;
use std::path::Path;

/// The scene.
const SCENE: &str = "granite-fault-small";
/// Time in s from which samples count as sliding: after 5 mm of slip, past the peak of friction.
const SLIDING: f64 = 2.5e-3;

/// Run every seed with the moment of inertia of spheres and with the author's. Print one row per run as CSV: means of
/// both friction coefficients over all samples during sliding, and the number of broken bonds.
///
/// # Errors
/// A state that becomes invalid, or output that cannot be written.
pub fn measure(seeds: u64) -> Result<(), Error> {
    let mut out = std::io::stdout().lock();
    let mut say = |row: String| {
        let said = writeln!(out, "{row}").and_then(|()| out.flush());
        said.map_err(|error| Error::file("write", Path::new("standard output"), error))
    };
    say("seed,inertia_factor,samples,friction_load,friction_feedback,bonds_broken".to_owned())?;
    for seed in 0..seeds {
        for reading in [Reading::Corrected, Reading::Thesis] {
            say(row(seed, reading.inertia_factor())?)?;
        }
    }
    Ok(())
}

/// The scene with a seed and an inertia factor.
fn scene(seed: u64, factor: f64) -> Result<Scene, Error> {
    let keys = [
        format!("setup.seed={seed}"),
        format!("material.inertia_factor={factor:?}"),
    ];
    Scene::load_with(SCENE, &Overrides::parse(&keys)?)
}

/// Run a scene; return its row.
fn row(seed: u64, factor: f64) -> Result<String, Error> {
    let scene = scene(seed, factor)?;
    let mut world = run_setup(&scene)?;
    let bonds = |world: &World| world.bonds().map_or(0, |bonds| bonds.len());
    let began = bonds(&world);
    let (interval, whole) = (
        (scene.output.interval / scene.step).round() as u64,
        scene.steps(),
    );
    let (mut samples, mut sums) = (0_u32, [0.0; 2]);
    for _ in 0..whole / interval {
        advance(&mut world, interval, "run")?;
        if world.time() > SLIDING - 0.5 * scene.step {
            samples += 1;
            sums[0] += friction_load(world.drive());
            sums[1] += friction_feedback(world.drive());
        }
    }
    let [load, feedback] = sums.map(|sum| sum / f64::from(samples));
    let broken = began - bonds(&world);
    Ok(format!(
        "{seed},{factor},{samples},{load:?},{feedback:?},{broken}"
    ))
}
