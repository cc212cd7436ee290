//! Bodies on an incline that falls to the left.

use super::{MOST_STEPS, Setup};
use crate::contact_dynamics::motion::{Motion, Solid};
use crate::error::Fault;
use core::f64::consts::FRAC_PI_4;
use serde_json::{Value, json};

struct Incline {
    angle: f64,
    time_step: f64,
    steps: usize,
    gravity: f64,
}

impl Incline {
    fn new(setup: &Setup) -> Result<Self, Fault> {
        Ok(Self {
            angle: setup.fields.number("incline")?,
            time_step: setup.fields.positive("dt")?,
            steps: setup.fields.count("steps", 1, MOST_STEPS)?,
            gravity: setup.gravity()?,
        })
    }

    /// Largest speed that a body can reach.
    fn fastest(&self) -> f64 {
        self.gravity * self.time_step * self.steps as f64
    }

    /// Above a point of the surface.
    fn above(&self, height: f64) -> (f64, f64) {
        (-height * self.angle.sin(), height * self.angle.cos())
    }

    /// The component down the incline.
    fn down(&self, x: f64, y: f64) -> f64 {
        -(x * self.angle.cos() + y * self.angle.sin())
    }

    /// Let a body go at a height of its centre above the surface.
    fn run(&self, setup: &Setup, solid: Solid) -> Result<Motion, Fault> {
        let diameter = 2.0 * solid.radius;
        let speed = self.fastest().min(1.0);
        let mut motion = Motion::new(self.time_step, setup.slow_law()?, diameter, speed)?;
        motion.add(solid)?;
        motion.add_floor(self.angle)?;
        motion.accelerate(0.0, -self.gravity);
        motion.steps(self.steps);
        Ok(motion)
    }
}

/// A square on its side, from rest.
pub fn square(setup: &Setup) -> Result<Value, Fault> {
    let incline = Incline::new(setup)?;
    let side = setup.fields.positive("side")?;
    let mass = setup.fields.positive("mass")?;
    let start = incline.above(0.5 * side);
    let angle = incline.angle + FRAC_PI_4;
    let motion = incline.run(
        setup,
        Solid {
            sides: 4,
            radius: side * 0.5f64.sqrt(),
            density: mass / (side * side),
            at: start,
            angle,
            velocity: [0.0; 3],
        },
    )?;
    let (v, r) = (motion.velocity(0), motion.position(0));
    let impulses = motion.impulses();
    let sum = |k: usize| impulses.iter().map(|p| p[k]).sum::<f64>() / incline.time_step;
    let normal = |p: Option<&[f64; 2]>| p.map_or(0.0, |p| p[0] / incline.time_step);
    let [one, other] = [normal(impulses.first()), normal(impulses.get(1))];
    let is_moving = v[0].hypot(v[1]) > 1e-9 * incline.fastest();
    Ok(json!({
        "status": if is_moving { "slide" } else { "stick" },
        "speed_down": incline.down(v[0], v[1]),
        "distance_down": incline.down(r[0] - start.0, r[1] - start.1),
        "rotation": motion.angle(0) - angle,
        "normal_resultant": sum(0),
        "friction_resultant": sum(1).abs(),
        "difference_of_the_two_normal_forces": (one - other).abs(),
        "larger_normal_force": one.max(other),
    }))
}

/// A disc, from rest.
pub fn disc(setup: &Setup) -> Result<Value, Fault> {
    let incline = Incline::new(setup)?;
    let radius = setup.fields.positive("R")?;
    let start = incline.above(radius);
    let motion = incline.run(
        setup,
        Solid {
            sides: 0,
            radius,
            density: setup.density()?,
            at: start,
            angle: 0.0,
            velocity: [0.0; 3],
        },
    )?;
    let (v, r) = (motion.velocity(0), motion.position(0));
    let speed = incline.down(v[0], v[1]);
    let is_slipping = (speed - radius * v[2]).abs() > 1e-9 * incline.fastest();
    Ok(json!({
        "status": if is_slipping { "slide" } else { "roll" },
        "speed_down": speed,
        "distance_down": incline.down(r[0] - start.0, r[1] - start.1),
        "spin_magnitude": v[2].abs(),
    }))
}
