//! Bodies that friction slows down on a horizontal floor.

use super::Setup;
use crate::contact_dynamics::motion::{Motion, Solid};
use crate::error::Fault;
use core::f64::consts::FRAC_PI_4;
use serde_json::{Value, json};

/// Number of steps after which the speed of the block is asked.
const ASKED: usize = 100;

/// Put a body on the floor.
fn start(setup: &Setup, solid: Solid, speed: f64, gravity: f64) -> Result<Motion, Fault> {
    let time_step = setup.fields.positive("dt")?;
    let diameter = 2.0 * solid.radius;
    let mut motion = Motion::new(time_step, setup.slow_law()?, diameter, speed)?;
    motion.add(solid)?;
    motion.add_floor(0.0)?;
    motion.accelerate(0.0, -gravity);
    Ok(motion)
}

/// A square slides until it stops.
pub fn block(setup: &Setup) -> Result<Value, Fault> {
    let (side, speed) = (setup.fields.positive("side")?, setup.fields.number("v0")?);
    let (gravity, time_step) = (setup.gravity()?, setup.fields.positive("dt")?);
    let time = speed.abs() / (setup.friction()? * gravity);
    let steps = setup.steps_for(time, time_step)?.max(ASKED);
    let solid = Solid {
        sides: 4,
        radius: side * 0.5f64.sqrt(),
        density: setup.density()?,
        at: (0.0, 0.5 * side),
        angle: FRAC_PI_4,
        velocity: [speed, 0.0, 0.0],
    };
    let mut motion = start(setup, solid, speed.abs(), gravity)?;
    let (mut stop, mut after, mut change) = (None, 0.0, 0.0);
    for step in 1..=steps {
        motion.steps(1);
        let now = motion.velocity(0)[0];
        if step == 1 {
            change = (now - speed) / time_step;
        }
        if step == ASKED {
            after = now;
        }
        if stop.is_none() && now.abs() <= 1e-12 * speed.abs() {
            stop = Some(step);
        }
    }
    let distance = motion.position(0)[0];
    let stop = stop.ok_or_else(|| setup.fields.refuse("a set-up in which the block stops"))?;
    let mut results = json!({"discrete": {
        "steps_to_stop": stop,
        "distance": distance,
        "speed_after_100_steps": after,
    }});
    // While it slides, the block slows down evenly, so that the first step gives the limit of small steps.
    if stop > 1 {
        let time = -speed / change;
        results["continuum"] = json!({"time": time, "distance": 0.5 * speed * time});
    }
    Ok(results)
}

/// A disc slips until it rolls.
pub fn disc(setup: &Setup) -> Result<Value, Fault> {
    let radius = setup.fields.positive("R")?;
    let (speed, spin) = (setup.fields.number("v0")?, setup.fields.number("w0")?);
    let (gravity, time_step) = (setup.gravity()?, setup.fields.positive("dt")?);
    let slip = (speed + radius * spin).abs();
    // Friction changes the slip by mu g, and twice as much by turning the disc.
    let time = slip / (3.0 * setup.friction()? * gravity);
    let steps = setup.steps_for(time, time_step)?;
    let solid = Solid {
        sides: 0,
        radius,
        density: setup.density()?,
        at: (0.0, radius),
        angle: 0.0,
        velocity: [speed, 0.0, spin],
    };
    let fastest = speed.abs().max(radius * spin.abs());
    let mut motion = start(setup, solid, fastest, gravity)?;
    let (mut first, mut changes) = (None, [0.0; 2]);
    for step in 1..=steps {
        motion.steps(1);
        let v = motion.velocity(0);
        if step == 1 {
            let now = v[0] + radius * v[2];
            changes = [v[0] - speed, now - speed - radius * spin].map(|change| change / time_step);
        }
        if first.is_none() && (v[0] + radius * v[2]).abs() <= 1e-10 * fastest {
            first = Some(step);
        }
    }
    let first = first.ok_or_else(|| setup.fields.refuse("a set-up in which the disc rolls"))?;
    let v = motion.velocity(0);
    let mut results = json!({
        "rolling_speed": v[0],
        "rolling_spin": v[2],
        "discrete": {"first_rolling_step": first},
    });
    // While it slips, speed and slip change evenly, so that the first step gives the limit of small steps.
    if first > 1 {
        let time = -(speed + radius * spin) / changes[1];
        results["time_to_roll"] = time.into();
        results["slip_distance"] = (speed * time + 0.5 * changes[0] * time * time).into();
    }
    Ok(results)
}
