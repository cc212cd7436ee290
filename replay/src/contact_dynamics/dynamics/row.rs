//! Equal discs in a row.

use super::Setup;
use crate::contact_dynamics::motion::{Motion, Solid, law};
use crate::error::Fault;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::step::Scheme;
use serde_json::{Value, json};

/// Most discs of a row.
const MOST_DISCS: usize = 1000;

/// Number of steps in which the first disc crosses a gap.
const STEPS_PER_GAP: f64 = 64.0;

/// Most steps until no two discs approach each other any more.
const MOST_STEPS: usize = 1_000_000;

/// The first disc of a frictionless row moves towards the others.
///
/// Discs that touch exchange impulses in one step. With gaps, the row moves until no two neighbours approach each
/// other.
pub fn cradle(setup: &Setup) -> Result<Value, Fault> {
    let fields = &setup.fields;
    let count = fields.count("N", 2, MOST_DISCS)?;
    let (gap, restitution) = (fields.number("gaps")?, fields.number("e_n")?);
    if gap < 0.0 {
        return Err(fields.refuse("a set-up whose gaps are not negative"));
    }
    let speed = fields.number_or("v", 1.0)?;
    let radius = fields.number_or("R", 0.5)?;
    let law = law(0.0, restitution, 0.0, GapRule::Closed);
    let time_step = if gap > 0.0 {
        gap / (STEPS_PER_GAP * speed.abs())
    } else {
        1e-3 * radius
    };
    let mut motion = Motion::new(time_step, law, 2.0 * radius, speed.abs())?;
    motion.settings.scheme = Scheme::Beginning;
    for k in 0..count {
        motion.add(Solid {
            sides: 0,
            radius,
            density: setup.density()?,
            at: (k as f64 * (2.0 * radius + gap), 0.0),
            angle: 0.0,
            velocity: [if k == 0 { speed } else { 0.0 }, 0.0, 0.0],
        })?;
    }
    let before = motion.energy();
    motion.steps(1);
    let mass = motion.mass(0);
    let impulses: Vec<_> = motion.impulses().iter().map(|p| p[0] / mass).collect();
    if gap > 0.0 {
        collide(&mut motion, count, speed.abs(), setup)?;
    }
    let velocities: Vec<_> = (0..count).map(|k| motion.velocity(k)[0]).collect();
    let mut results = json!({
        "velocities": velocities,
        "kinetic_energy_ratio": motion.energy() / before,
    });
    if gap == 0.0 {
        results["impulses_over_m"] = json!(impulses);
    }
    Ok(results)
}

/// Step until no two neighbours approach each other.
fn collide(motion: &mut Motion, count: usize, speed: f64, setup: &Setup) -> Result<(), Fault> {
    for _ in 0..MOST_STEPS {
        let approaches = |k: usize| motion.velocity(k - 1)[0] - motion.velocity(k)[0];
        if (1..count).all(|k| approaches(k) <= 1e-12 * speed) {
            return Ok(());
        }
        motion.steps(1);
    }
    Err(setup.fields.refuse(format!(
        "a set-up whose discs separate within {MOST_STEPS} steps"
    )))
}
