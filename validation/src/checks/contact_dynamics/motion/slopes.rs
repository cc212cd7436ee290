//! Bodies on inclines and on floors with friction.

use super::super::system::{GRAVITY, System, exact_steps, law, moving};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    azema,
};
use crate::oracles::contact_dynamics::bodies::{block_on_incline, disc_on_incline};
use gouge_contact_dynamics::law::GapRule;
use std::f64::consts::FRAC_PI_4;

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "contact-dynamics.motion.incline",
            claim: "A block rests up to the friction angle and slides beyond it, and a disc rolls until friction cannot carry a third of the weight's component: both with the accelerations of rigid bodies.",
            equations: azema("(1), (A1)-(A3), (A6)-(A9), (A16)-(A17), E3, E5"),
            scene: "A square of side 1 m and a disc of 1 m on inclines of 0.05 to 0.75 rad, friction 0.2, 200 steps of 1 ms",
            oracle: "Newton's and Euler's laws of a block and of a disc on an incline",
            norm: "Largest error of the velocity along the incline or of that of the rotation, in units of g times the time",
            origin: Origin::Exact,
            reason: "Accelerations are constant, so that a step is exact; sweeps stop at 1e-14 m/s, 200 steps add 2e-12 m/s at most, which is 1e-12 of 1.96 m/s",
            effort: Effort::Quick,
            measure: incline,
        },
        Check {
            id: "contact-dynamics.motion.stopping",
            claim: "A sliding block stops after v^2/(2 mu g); only the last step, in which it stops, has an error.",
            equations: azema("(A3), (A28)-(A32)"),
            scene: "A square of side 1 m that slides at 1 m/s on a floor with friction 0.3, steps of 1 to 16 ms",
            oracle: "The distance of uniform deceleration",
            norm: "Largest error of the distance, in units of mu g dt^2",
            origin: Origin::Convergent,
            reason: "With the velocity v left at the last step, the block goes v dt/2 instead of v^2/(2 mu g), with v between 0 and mu g dt: the difference is at most mu g dt^2/8, at half of that velocity. 1/1000 is left for rounding",
            effort: Effort::Quick,
            measure: stopping,
        },
        Check {
            id: "contact-dynamics.motion.sliding-to-rolling",
            claim: "A disc that begins by sliding rolls at two thirds of its velocity.",
            equations: azema("(A3), (A6)-(A7), (A29)-(A30)"),
            scene: "A disc of 1 m at 1 m/s on a floor with friction 0.05 to 0.6, steps of 1 ms for 1.5 times the time that sliding takes",
            oracle: "Conservation of angular momentum about a point of the floor",
            norm: "Largest error of the velocity and of the radius times the angular velocity, in units of the initial velocity",
            origin: Origin::Exact,
            reason: "The result does not depend on how friction acts; sweeps stop at 1e-14 m/s, and up to 1000 steps add 1e-11",
            effort: Effort::Quick,
            measure: sliding_to_rolling,
        },
    ]
}

const FRICTION: f64 = 0.2;
const STEP: f64 = 1e-3;
const STEPS: usize = 200;

/// A square of side 1 m or a disc of 1 m on a floor.
fn on_floor(sides: usize, friction: f64, step: f64, speed: f64) -> Result<System, Failure> {
    let settings = exact_steps(step, law(friction, 0.0, GapRule::Predicted));
    let mut system = System::new(settings);
    let (radius, angle) = match sides {
        0 => (0.5, 0.0),
        _ => (0.5_f64.sqrt(), FRAC_PI_4),
    };
    system.body(sides, radius, [0.0, 0.5], angle, moving(speed, 0.0, 0.0))?;
    system.floor()?;
    Ok(system)
}

fn incline() -> Outcome {
    let scale = GRAVITY * STEP * STEPS as f64;
    let time = STEP * STEPS as f64;
    let (mut all, mut marks) = (Vec::new(), [Vec::new(), Vec::new()]);
    for slope in 1..=15 {
        let angle = 0.05 * f64::from(slope);
        let block = after(4, angle)?;
        let expected = block_on_incline(GRAVITY, angle, FRICTION) * time;
        all.push(Measurement::scaled(expected, block[0], scale, 1e-12));
        all.push(Measurement::scaled(0.0, block[1], scale, 1e-12));
        marks[0].push([angle, block[0] / time]);
        let disc = after(0, angle)?;
        let expected = disc_on_incline(GRAVITY, angle, FRICTION).map(|a| a * time);
        all.push(Measurement::scaled(expected[0], disc[0], scale, 1e-12));
        all.push(Measurement::scaled(expected[1], disc[1], scale, 1e-12));
        marks[1].push([angle, disc[0] / time]);
    }
    let line = |of: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
        (0..=150)
            .map(|k| 0.005 * f64::from(k))
            .map(|x| [x, of(x)])
            .collect()
    };
    let [block, disc] = marks;
    let curves = vec![
        Curve::line(
            "block, theory",
            line(&|x| block_on_incline(GRAVITY, x, FRICTION)),
        ),
        Curve::line(
            "disc, theory",
            line(&|x| disc_on_incline(GRAVITY, x, FRICTION)[0]),
        ),
        Curve::marks("block", block),
        Curve::marks("disc", disc),
    ];
    let figure = Figure::new(
        "Acceleration on an incline with friction 0.2: a block rests up to 0.197 rad, a disc rolls up to 0.540 rad",
        Axis::linear("slope", "rad"),
        Axis::linear("acceleration", "m/s^2"),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(figure)]))
}

/// Velocity down the incline and radius times angular velocity (positive if rolling down) after all steps.
fn after(sides: usize, angle: f64) -> Result<[f64; 2], Failure> {
    let mut system = on_floor(sides, FRICTION, STEP, 0.0)?;
    system.tilted(angle);
    system.steps(STEPS);
    let v = system.velocity(0);
    Ok([v.linear.x, -0.5 * v.angular])
}

fn stopping() -> Outcome {
    let friction = 0.3;
    let expected = 0.5 / (friction * GRAVITY);
    let mut all = Vec::new();
    let mut table = Table::new(
        "Distance until a block stops",
        &[
            "step (ms)",
            "distance (m)",
            "error (m)",
            "bound mu g dt^2/8 (m)",
        ],
    );
    for step in [1.0, 1.7, 2.9, 4.9, 9.3, 16.0].map(|step| 1e-3 * step) {
        let mut system = on_floor(4, friction, step, 1.0)?;
        system.gravity([0.0, -GRAVITY]);
        let steps = 1.0 / (friction * GRAVITY * step);
        system.steps(steps as usize + 10);
        let distance = system.position(0)[0];
        let unit = friction * GRAVITY * step * step;
        all.push(Measurement::scaled(expected, distance, unit, 0.126));
        let speed = system.velocity(0).linear.x;
        all.push(Measurement::absolute(0.0, speed, 1e-12));
        table.push([
            format!("{:.1}", 1e3 * step),
            format!("{distance:.9}"),
            format!("{:.2e}", distance - expected),
            format!("{:.2e}", unit / 8.0),
        ]);
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn sliding_to_rolling() -> Outcome {
    let mut all = Vec::new();
    for friction in [0.05, 0.1, 0.2, 0.4, 0.6] {
        let mut system = on_floor(0, friction, STEP, 1.0)?;
        system.gravity([0.0, -GRAVITY]);
        let sliding = 1.0 / (3.0 * friction * GRAVITY);
        system.steps((1.5 * sliding / STEP) as usize);
        let v = system.velocity(0);
        for found in [v.linear.x, -0.5 * v.angular] {
            all.push(Measurement::absolute(2.0 / 3.0, found, 1e-11));
        }
    }
    Ok(Measurement::worst(all).into())
}
