//! Momentum and angular momentum of bonded particles.

use super::modes::bond;
use crate::checks::dem::scenes::advance;
use crate::checks::{Check, Effort, Measurement, Origin, Outcome, thesis};
use crate::oracles::beams::Springs;
use crate::scenes::{Draft, Grain};
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use rand::RngExt;
use rand_pcg::Pcg64;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "beams.conservation",
        claim: "Damped and undamped bonds conserve momentum and angular momentum.",
        equations: thesis("(7), (26)-(27), (43)-(45)"),
        scene: "A cluster of 16 bonded particles of random radii with random velocities and spins that bend it by large angles, damped and undamped, 20000 steps of velocity Verlet",
        oracle: "The initial momentum and angular momentum",
        norm: "Change in units of the sum of all absolute contributions",
        origin: Origin::Exact,
        reason: "Every step rounds each contribution a few times; errors of the same sign would add up to 20000 x 4 x 2^-52 = 2e-11, errors of random sign to 1e-13; the tolerance is 1e-12",
        effort: Effort::Quick,
        measure: cluster,
    }]
}

const SIDE: usize = 4;
const STEPS: u64 = 20_000;

fn lattice(damping: f64) -> Draft {
    let mut random = Pcg64::new(7, 1);
    let mut uniform = move || 2.0 * random.random::<f64>() - 1.0;
    let springs = Springs {
        normal: 1e7,
        tangential: 1e7,
    };
    let dashpots = Springs {
        normal: damping,
        tangential: damping,
    };
    let mut draft = Draft::open_box(Integrator::VelocityVerlet, 2e-8).and(&bond(springs, dashpots));
    for n in 0..SIDE * SIDE {
        let (row, column) = (n / SIDE, n % SIDE);
        let position = [2e-3 * column as f64, 2e-3 * row as f64];
        let velocity = [3.0 + 20.0 * uniform(), 20.0 * uniform()];
        draft = draft.grain(
            Grain::at(position, 1e-3 + 2e-4 * uniform())
                .moving(velocity)
                .spinning(2e4 * uniform()),
        );
    }
    for n in 0..SIDE * SIDE {
        if n % SIDE + 1 < SIDE {
            draft = draft.bonded(n, n + 1);
        }
        if n + SIDE < SIDE * SIDE {
            draft = draft.bonded(n, n + SIDE);
        }
    }
    draft
}

/// Momentum along x and y and angular momentum, each with the sum of its absolute contributions.
fn momenta(world: &World) -> [[f64; 2]; 3] {
    let p = world.particles();
    let mut sums = [[0.0; 2]; 3];
    for i in 0..p.len() {
        let (x, v, m) = (p.position[i], p.velocity[i], p.mass[i]);
        let parts = [
            (0, m * v.x),
            (1, m * v.y),
            (2, m * x.x * v.y),
            (2, -m * x.y * v.x),
            (2, p.moment_of_inertia[i] * p.angular_velocity[i]),
        ];
        for (place, part) in parts {
            sums[place][0] += part;
            sums[place][1] += part.abs();
        }
    }
    sums
}

fn cluster() -> Outcome {
    let mut measured = Vec::new();
    for damping in [0.0, 10.0] {
        let mut world = lattice(damping).world()?;
        let before = momenta(&world);
        advance(&mut world, STEPS)?;
        let pairs = before.into_iter().zip(momenta(&world));
        measured.extend(pairs.map(|([start, scale], [end, later])| {
            Measurement::scaled(start, end, scale.max(later), 1e-12)
        }));
    }
    Ok(Measurement::worst(measured).into())
}
