//! Momentum and angular momentum.

use super::spheres::RADIUS;
use crate::checks::dem::scenes::advance;
use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, thesis};
use crate::scenes::{Draft, Grain};
use gouge_dem::World;
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli, KelvinVoigt};
use gouge_runner::scene::INTEGRATORS;
use std::f64::consts::PI;

pub(super) fn checks() -> Vec<Check> {
    let check = |id, scene, effort, measure| Check {
        id,
        claim: "Over a long run, velocity Verlet and symplectic Euler conserve momentum and angular momentum to rounding; every integrator conserves momentum.",
        equations: thesis("(26), (27), (45), (54)-(58)"),
        scene,
        oracle: "The initial momenta: with these two integrators, the change of x cross v in a step is exactly a mean of torques",
        norm: "Largest drift of a momentum component over the initial sum of absolute momenta, and of the angular momentum over the initial sum of absolute angular momenta",
        origin: Origin::Exact,
        reason: "Ten roundings of 2^-53 per step and grain, accumulating like a random walk: 1e-15 sqrt(N) for momentum. Lever arms are rounded as often, and there are twice as many products: 3e-15 sqrt(N) for angular momentum",
        effort,
        measure,
    };
    vec![
        check(
            "closure.momentum",
            "Six bonded grains in a ring, spinning and swinging, and a seventh that rattles inside, with friction: 2e4 steps, other integrators a tenth of that",
            Effort::Quick,
            || long(20_000),
        ),
        check(
            "closure.momentum-long",
            "Six bonded grains in a ring, spinning and swinging, and a seventh that rattles inside, with friction: 1e6 steps, other integrators a tenth of that",
            Effort::Thorough,
            || long(1_000_000),
        ),
    ]
}

/// A ring of six bonded grains around a smaller one that rattles inside.
fn ring(integrator: &str) -> Draft {
    let mut draft = Draft::open_box(integrator, 1e-8)
        .law(KelvinVoigt {
            stiffness: 1e6,
            damping: 0.0,
        })
        .friction("cundall-strack-truncated", 0.5, 1e6)
        .law(AdjustedKelvinVoigt {
            stiffness: 1e6,
            damping: 0.0,
        })
        .law(EulerBernoulli {
            stiffness: 1e6,
            damping: 0.0,
        });
    for i in 0..6 {
        let (sine, cosine) = (PI / 3.0 * f64::from(i)).sin_cos();
        let place = [2.0 * RADIUS * cosine, 2.0 * RADIUS * sine];
        let velocity = [-0.4 * sine + 0.3, 0.4 * cosine + 0.1 * f64::from(i % 3)];
        draft = draft.grain(
            Grain::at(place, RADIUS)
                .moving(velocity)
                .spinning(40.0 * f64::from(i)),
        );
        draft = draft.bonded(i as usize, (i as usize + 1) % 6);
    }
    draft.grain(
        Grain::at([1e-4, -5e-5], 0.7 * RADIUS)
            .moving([2.0, 0.7])
            .spinning(-300.0),
    )
}

/// Momentum and angular momentum, and the sums of the absolute contributions.
fn momenta(world: &World) -> ([f64; 3], [f64; 3]) {
    let p = world.particles();
    let (mut sums, mut scales) = ([0.0; 3], [0.0; 3]);
    for i in 0..p.len() {
        let (m, x, v) = (p.mass[i], p.position[i], p.velocity[i]);
        let orbit = m * x.cross(v);
        let spin = p.moment_of_inertia[i] * p.angular_velocity[i];
        let parts = [m * v.x, m * v.y, orbit + spin];
        let sizes = [
            m * v.norm(),
            m * v.norm(),
            m * x.norm() * v.norm() + spin.abs(),
        ];
        for n in 0..3 {
            sums[n] += parts[n];
            scales[n] += sizes[n];
        }
    }
    (sums, scales)
}

/// Largest drifts of momentum and of angular momentum over their scales.
fn drifts(integrator: &str, steps: u64) -> Result<[f64; 2], Failure> {
    let mut world = ring(integrator).world()?;
    let (first, scales) = momenta(&world);
    let mut worst = [0.0_f64; 2];
    for _ in 0..10 {
        advance(&mut world, steps / 10)?;
        let now = momenta(&world).0;
        for n in 0..3 {
            let drift = (now[n] - first[n]).abs() / scales[n];
            worst[n / 2] = worst[n / 2].max(drift);
        }
    }
    Ok(worst)
}

fn long(steps: u64) -> Outcome {
    let root = (steps as f64).sqrt();
    let (mut all, mut table) = (
        Vec::new(),
        Table::new(
            &format!(
                "Drifts over {steps} steps (a tenth of that for Euler, Taylor and Beeman), relative to the sums of absolute momenta"
            ),
            &["method", "momentum", "angular momentum"],
        ),
    );
    for (integrator, _) in INTEGRATORS {
        let keeps = ["velocity-verlet", "symplectic-euler"].contains(&integrator);
        // The other integrators run a tenth as long: undamped, they gain energy.
        let [linear, angular] = drifts(integrator, if keeps { steps } else { steps / 10 })?;
        all.push(Measurement::absolute(0.0, linear, 1e-15 * root));
        if keeps {
            all.push(Measurement::absolute(0.0, angular, 3e-15 * root));
        }
        table.push([
            integrator.to_owned(),
            format!("{linear:.1e}"),
            format!("{angular:.1e}"),
        ]);
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}
