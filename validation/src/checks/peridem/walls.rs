//! Walls: the force of the part of a disc beyond them, sliding, and the bounce of a grain.

use super::grains::{MATERIAL, balance, bonds_only, disc, grain, world};
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, peridem};
use crate::oracles::quadrature::{integral_over, root};
use gouge_common::geometry::Vec2;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::forces::{Settings, Walls};
use gouge_peridem::grain::Grains;
use gouge_peridem::material::Weight;
use gouge_peridem::state::State;
use gouge_peridem::wall_law::{WallLaw, WallReading};
use gouge_peridem::world::{Beginning, World};
use std::f64::consts::FRAC_PI_2;

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "peridem.walls.quadrature",
            claim: "The force of a wall is that at the centroid of the part of the disc beyond it, and the exact law the integral of the repulsion over that part, on both sides of the wall.",
            equations: peridem("(4.7)"),
            scene: "One node, distances from -0.99 to 0.99 contact radii",
            oracle: "Quadrature over strips of the segment",
            norm: "Largest error, in units of the largest force of each law",
            origin: Origin::Exact,
            reason: "The quadrature has an error of 1e-13",
            effort: Effort::Quick,
            measure: quadrature,
        },
        Check {
            id: "peridem.walls.sliding",
            claim: "A node that a load presses against a wall is slowed down by the coefficient of friction times the load, and comes to rest.",
            equations: peridem("(4.3), (4.7), P3"),
            scene: "One node on the floor at the depth where wall and load balance, friction 0.3, 1 m/s along the floor",
            oracle: "v = v0 - mu N t/m",
            norm: "Largest error of the velocity over the first one, before the stop and 70 steps after it",
            origin: Origin::Exact,
            reason: "400 steps add up with rounding errors of 1e-16, and the depth balances to 1e-12; sticking halves the square of the velocity per step, 2^-35 in 70 steps",
            effort: Effort::Quick,
            measure: sliding,
        },
        Check {
            id: "peridem.walls.bounce",
            claim: "A grain bounces off a floor and out of a corner without loss or gain: the work of the walls is the change of all other energy, with second order in the step.",
            equations: peridem("(4.7)-(4.8), Q3"),
            scene: "A disc hits the floor, and the corner, at 20 m/s; steps of 50 and 25 ns",
            oracle: "The theorem of work and energy",
            norm: "Ratio of the errors of the balance, as distance of the order from 2, and the error itself at the longer step",
            origin: Origin::Convergent,
            reason: "The next term is of fourth order; nodes begin to touch between steps: 0.5",
            effort: Effort::Quick,
            measure: bounce,
        },
    ]
}

fn law(reading: WallReading, radius: f64, friction: f64) -> WallLaw {
    WallLaw {
        radius,
        stiffness: 2.8e23,
        damping_ratio: 0.0,
        friction,
        reading,
    }
}

/// Chords of the disc beyond the wall, as integrals over their distance from the node: area, moment, and the exact law.
fn segment(distance: f64) -> [f64; 3] {
    // A chord is not smooth in its distance at the rim, and an angle removes the root; at the node the exact law has a
    // logarithm.
    let over = |of: &dyn Fn(f64, f64) -> f64| {
        let end = distance.acos();
        integral_over(&[0.0, end.min(FRAC_PI_2), end], |angle: f64| {
            let (at, half) = (angle.cos(), angle.sin());
            of(at, half) * half
        })
    };
    let area = over(&|_, half| 2.0 * half);
    let moment = over(&|at, half| 2.0 * half * at);
    let exact = over(&|at, half| {
        // The normal part of (1 - r) along a chord; the integral of at (1/r - 1) over it in closed form.
        let inverse = 2.0 * (half / at.abs()).asinh();
        at * (inverse - 2.0 * half)
    });
    [area, moment, exact]
}

fn quadrature() -> Outcome {
    const RADIUS: f64 = 1e-4;
    const AREA: f64 = 4e-9;
    let mut all = Vec::new();
    for k in -33..=33 {
        let distance = f64::from(k) * 0.03;
        if k == 0 {
            continue;
        }
        let [area, moment, exact] = segment(distance);
        for (reading, expected, largest) in [
            (WallReading::Paper, area - moment, std::f64::consts::PI),
            (WallReading::Exact, exact, 1.0 / 3.0),
        ] {
            let law = law(reading, RADIUS, 0.0);
            let unit = law.stiffness * AREA * RADIUS.powi(3);
            let found = law.push(distance * RADIUS, AREA) / unit;
            all.push(Measurement::scaled(expected, found, largest, 1e-11));
        }
    }
    Ok(Measurement::worst(all).into())
}

fn sliding() -> Outcome {
    const RADIUS: f64 = 1e-4;
    const AREA: f64 = 4e-9;
    const FRICTION: f64 = 0.3;
    let law = law(WallReading::Paper, RADIUS, FRICTION);
    let load = 0.3 * law.push(0.0, AREA);
    let depth = root(0.0, RADIUS, |d| law.push(d, AREA) - load);
    let constants = MATERIAL.bond_constants(Weight::Constant, RADIUS)?;
    let mut node = grain(vec![Vec2::new(0.0, depth)], vec![AREA], constants);
    node.load = vec![Vec2::new(0.0, -load / AREA)];
    let deceleration = FRICTION * load / (MATERIAL.density * AREA);
    let step = 1.0 / deceleration / 200.5;
    let settings = Settings {
        walls: Some(Walls {
            law,
            velocity: [0.0; 4],
        }),
        ..bonds_only(step)
    };
    let grains = Grains::new(&[node])?;
    let bonds = Bonds::within_horizon(&grains, |_, _, _| true)?;
    let mut state = State::at_rest(&grains, bonds);
    state.velocity[0] = Vec2::new(1.0, 0.0);
    state.walls[3] = 0.0;
    let mut world = World::new(grains, settings, state, Beginning::Forces)?;
    let mut all = Vec::new();
    for k in 1..=400 {
        world.step()?;
        let speed = world.state().velocity[0].x;
        let expected = (1.0 - deceleration * step * f64::from(k)).max(0.0);
        // It rings as it stops: friction acts with the velocity of the step before, which halves the square per step.
        if (198..=270).contains(&k) {
            continue;
        }
        all.push(Measurement::absolute(expected, speed, 1e-9));
    }
    Ok(Measurement::worst(all).into())
}

/// Relative errors of the balance with a step, into the floor or into the corner.
fn error(step: f64, direction: Vec2) -> Result<f64, Failure> {
    const SIZE: f64 = 2e-4;
    const RADIUS: f64 = 3e-4;
    let grain = disc(SIZE, Vec2::new(1.35e-3, 1.35e-3), Weight::Constant)?;
    let settings = Settings {
        walls: Some(Walls {
            law: law(WallReading::Paper, RADIUS, 0.0),
            velocity: [0.0; 4],
        }),
        ..bonds_only(step)
    };
    let world = world(&[grain], settings.clone(), |_, _| direction * 20.0)?;
    let mut state = world.state().clone();
    (state.walls[0], state.walls[3]) = (0.0, 0.0);
    let grains = world.grains().clone();
    let mut world = World::new(grains, settings, state, Beginning::Forces)?;
    let start = balance(&world);
    let mut worst = 0.0_f64;
    for k in 1..=(2e-5 / step).round() as usize {
        world.step()?;
        if k % 8 == 0 {
            worst = worst.max((balance(&world) / start - 1.0).abs());
        }
    }
    Ok(worst)
}

fn bounce() -> Outcome {
    let mut all = Vec::new();
    let half = 0.5_f64.sqrt();
    for direction in [Vec2::new(0.0, -1.0), Vec2::new(-half, -half)] {
        let errors = [error(5e-8, direction)?, error(2.5e-8, direction)?];
        let order = (errors[0] / errors[1]).log2();
        all.push(Measurement::absolute(2.0, order, 0.5));
        all.push(Measurement::absolute(0.0, errors[0], 1e-3));
    }
    Ok(Measurement::worst(all).into())
}
