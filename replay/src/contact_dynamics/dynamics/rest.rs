//! Bodies that come to rest or begin to move.

use super::Setup;
use crate::contact_dynamics::motion::{Motion, Solid, law};
use crate::error::Fault;
use core::f64::consts::FRAC_PI_4;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::step::Scheme;
use serde_json::{Value, json};

/// Largest radius of the disc that meets the floor: small, so that rounding its height does not round the gap.
const SMALL: f64 = 1.0 / 1024.0;

/// A disc meets the floor with a predicted gap.
pub fn gap_closes(setup: &Setup) -> Result<Value, Fault> {
    let fields = &setup.fields;
    let (speed, gap) = (fields.number("v")?, fields.positive("gap")?);
    let time_step = fields.positive("dt")?;
    let friction = fields.number_or("mu", 0.4)?;
    let restitution = fields.number_or("e_n", 0.0)?;
    let law = law(friction, restitution, 0.0, GapRule::Predicted);
    let radius = SMALL * (gap * 64.0).min(1.0);
    let mut motion = Motion::new(time_step, law, 1.0, speed.abs())?;
    motion.settings.detection.alert_distance = 2.0 * gap;
    motion.add(Solid {
        sides: 0,
        radius,
        density: setup.density()?,
        at: (0.0, radius + gap - 0.5 * time_step * speed),
        angle: 0.0,
        velocity: [0.0, speed, 0.0],
    })?;
    motion.add_floor(0.0)?;
    motion.steps(1);
    let first = motion.velocity(0)[1];
    motion.steps(1);
    let Some(&second_gap) = motion.gaps().first() else {
        return Err(fields.refuse("a set-up whose disc meets the floor in the first step"));
    };
    Ok(json!({
        "v_after_first_step": first,
        "v_after_second_step": motion.velocity(0)[1],
        "gap_at_second_detection": second_gap,
        "final_gap": motion.position(0)[1] - radius,
    }))
}

/// A square on the floor is pushed at its centre: the force over its weight at which it tips.
pub fn square_pushed(setup: &Setup) -> Result<Value, Fault> {
    let side = setup.fields.number_or("side", 1.0)?;
    let gravity = setup.gravity()?;
    let time_step = 1e-6 * (side / gravity).sqrt();
    let law = law(setup.friction()?, 0.0, 0.0, GapRule::Closed);
    let push = |force: f64| -> Result<f64, Fault> {
        let mut motion = Motion::new(time_step, law, side, gravity * time_step)?;
        motion.settings.scheme = Scheme::Beginning;
        motion.add(Solid {
            sides: 4,
            radius: side * 0.5f64.sqrt(),
            density: setup.density()?,
            at: (0.0, 0.5 * side),
            angle: FRAC_PI_4,
            velocity: [0.0; 3],
        })?;
        motion.add_floor(0.0)?;
        motion.accelerate(force * gravity, -gravity);
        motion.steps(1);
        Ok(motion.velocity(0)[2].abs() / time_step)
    };
    let (mut below, mut above) = (0.5, 1.5);
    while above - below > 1e-10 {
        let middle: f64 = 0.5 * (below + above);
        if push(middle)? > 1e-11 * gravity / side {
            above = middle;
        } else {
            below = middle;
        }
    }
    let mut results = json!({"angular_acceleration_at_F_1.5mg": push(1.5)?});
    if above < 1.5 {
        results["tips_iff_F_over_mg_above"] = (0.5 * (below + above)).into();
    }
    Ok(results)
}
