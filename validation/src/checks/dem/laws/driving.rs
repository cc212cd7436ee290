//! The exact controller of the driving force.

use crate::checks::dem::scenes::advance;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use crate::scenes::{Draft, Grain};
use gouge_dem::World;
use gouge_dem::laws::Controller;
use gouge_runner::scene::DrivingTable;

pub(super) fn checks() -> Vec<Check> {
    vec![Check {
        id: "laws.exact-speed",
        claim: "The exact controller brings driven grains to the required speed within one step of the two Euler methods and of Taylor's. With velocity Verlet the speed error shrinks, after the first steps, by a factor of (7 + sqrt(17)) / 16 per step; with Beeman it follows the recurrence of that method.",
        equations: thesis("(22), (51)-(58)"),
        scene: "Two driven grains of radius 1 and 1.7 mm that start at 0.4 m/s and are to move at 1 m/s; twelve steps",
        oracle: "Recurrences for the speed error e, with e1 and e2 the errors one and two steps earlier: e' = e - (e + e1)/8 for velocity Verlet, solved by the roots (7 -+ sqrt(17)) / 16, and e' = e - (2 e + 5 e1 - e2)/24 for Beeman. They follow from an acceleration of a quarter of the error per time step",
        norm: "Largest error of the mean speed in m/s",
        origin: Origin::Exact,
        reason: "A few roundings of numbers below one in each of twelve steps",
        effort: Effort::Quick,
        measure: approach,
    }]
}

const STEPS: usize = 12;
const BEGIN: f64 = 0.4;

/// Mean speed after each step.
fn speeds(integrator: &str) -> Result<[f64; STEPS], Failure> {
    let grain = |x: f64, radius: f64| Grain::at([x, 0.0], radius).moving([BEGIN, 0.0]).driven();
    let draft = Draft::open_box(integrator, 1e-6)
        .driving(DrivingTable {
            controller: Controller::Exact,
            speed: 1.0,
            pressure: 3.0,
            area: Some(2.0),
            initial_force: [0.0; 2],
        })
        .grain(grain(0.0, 1e-3))
        .grain(grain(1.0, 1.7e-3));
    let mut world: World = draft.world()?;
    let mut speeds = [0.0; STEPS];
    for speed in &mut speeds {
        advance(&mut world, 1)?;
        let v = &world.particles().velocity;
        *speed = 0.5 * (v[0].x + v[1].x);
    }
    Ok(speeds)
}

fn verlet() -> [f64; STEPS] {
    let root = 17.0_f64.sqrt();
    let [fast, slow] = [(7.0 - root) / 16.0, (7.0 + root) / 16.0];
    // The errors at n = -1 and n = 0 are both one, which fixes the weights of fast^n and slow^n.
    let weight = fast * (1.0 - slow) / (fast - slow);
    let error = |n: i32| weight * fast.powi(n) + (1.0 - weight) * slow.powi(n);
    std::array::from_fn(|n| error(n as i32 + 1))
}

fn beeman() -> [f64; STEPS] {
    let mut errors = [1.0; 3];
    std::array::from_fn(|_| {
        let [e2, e1, e] = errors;
        errors = [e1, e, e - (2.0 * e + 5.0 * e1 - e2) / 24.0];
        errors[2]
    })
}

fn approach() -> Outcome {
    let mut measured = Vec::new();
    let at_once = ["euler", "symplectic-euler", "taylor"].map(|name| (name, [0.0; STEPS]));
    let slowly = [("velocity-verlet", verlet()), ("beeman", beeman())];
    for (integrator, errors) in at_once.into_iter().chain(slowly) {
        for (error, speed) in errors.iter().zip(speeds(integrator)?) {
            let expected = 1.0 - (1.0 - BEGIN) * error;
            measured.push(Measurement::absolute(expected, speed, 1e-14));
        }
    }
    Ok(Measurement::worst(measured).into())
}
