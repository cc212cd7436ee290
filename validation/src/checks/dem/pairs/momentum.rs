//! Momentum of a colliding pair.

use super::collision::Collision;
use crate::checks::{Measurement, Outcome};
use gouge_dem::World;

const STEPS: usize = 2000;

fn sum(world: &World, size: impl Fn(f64) -> f64) -> f64 {
    let p = world.particles();
    let terms = p.mass.iter().zip(&p.velocity);
    terms.map(|(mass, velocity)| size(mass * velocity.x)).sum()
}

pub fn momentum() -> Outcome {
    let mut all = Vec::new();
    for radii in [[1e-2, 1e-2], [1e-2, 1.7e-2], [1e-2, 1e-1]] {
        let spheres = [
            Collision::kelvin_voigt(1e7, 30.0, radii, 1.0),
            Collision::viscoelastic([5e10, 0.22], 1e-5, radii, 1.0),
        ];
        for spheres in spheres {
            let whole = spheres.follow(1e-8, 1_000_000)?;
            let last = whole.free.time;
            let track = spheres.follow(last / (STEPS as f64 - 0.5), 2 * STEPS)?;
            let [a, b] = spheres.masses();
            let before = a * (b / (a + b) * spheres.speed) - b * (a / (a + b) * spheres.speed);
            let scale = 2.0 * spheres.reduced_mass() * spheres.speed;
            let change = sum(&track.world, |p| p) - before;
            let bound = (5 * track.samples.len()) as f64 * 0.5 * f64::EPSILON;
            all.push(Measurement::scaled(0.0, change, scale, bound));
            if radii[0] == radii[1] {
                let v = &track.world.particles().velocity;
                all.push(Measurement::absolute(0.0, v[0].x + v[1].x, 0.0));
            }
        }
    }
    Ok(Measurement::worst(all).into())
}
