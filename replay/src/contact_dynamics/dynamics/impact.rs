//! Impacts, by the law of closed contacts in a single step.

use super::Setup;
use crate::contact_dynamics::geometry::MOST_SIDES;
use crate::contact_dynamics::motion::{Motion, Solid, law};
use crate::error::Fault;
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use serde_json::{Value, json};

/// Friction at which no landing polygon slips: the largest that is needed is 0.6, that of a square.
const NO_SLIP: f64 = 2.0;

/// A disc hits another one along x.
pub fn two_discs(setup: &Setup) -> Result<Value, Fault> {
    let fields = &setup.fields;
    let radii = [fields.positive("R1")?, fields.positive("R2")?];
    let second = fields.array::<2>("v2")?;
    let first = match fields.optional("v1") {
        Some(v) => v.as_array()?,
        None => [0.0; 2],
    };
    let spins = [fields.number("w1")?, fields.number("w2")?];
    let law = ContactLaw {
        restitution: gouge_contact_dynamics::local::Components {
            n: fields.number("e_n")?,
            t: fields.number("e_t")?,
        },
        ..setup.impact_law()?
    };
    let speed = fastest(&[
        second[0],
        second[1],
        first[0],
        first[1],
        spins[0] * radii[0],
    ]);
    let mut motion = Motion::impact(law, radii[0] + radii[1], speed)?;
    // The distance of the centres is rounded.
    motion.settings.detection.alert_distance = 1e-9 * (radii[0] + radii[1]);
    let distances = [0.0, radii[0] + radii[1]];
    for k in 0..2 {
        let v = [first, second][k];
        motion.add(Solid {
            sides: 0,
            radius: radii[k],
            density: setup.density()?,
            at: (distances[k], 0.0),
            angle: 0.0,
            velocity: [v[0], v[1], spins[k]],
        })?;
    }
    motion.steps(1);
    let (a, b, p) = (motion.velocity(0), motion.velocity(1), motion.impulse());
    let tangential = b[1] - a[1] - b[2] * radii[1] - a[2] * radii[0];
    Ok(json!({
        "status": if p[0] == 0.0 { "separate" } else if is_at_limit(p, law.friction) { "slide" } else { "stick" },
        "P_n": p[0], "P_t": p[1],
        "v1": [a[0], a[1]], "v2": [b[0], b[1]], "w1": a[2], "w2": b[2],
        "u_n_plus": b[0] - a[0], "u_t_plus": tangential,
    }))
}

fn fastest(speeds: &[f64]) -> f64 {
    let largest = speeds
        .iter()
        .fold(0.0, |largest: f64, v| largest.max(v.abs()));
    if largest > 0.0 { largest } else { 1.0 }
}

fn is_at_limit(impulse: [f64; 2], friction: f64) -> bool {
    impulse[1].abs() >= (1.0 - 1e-12) * friction * impulse[0]
}

/// A polygon on a floor below one of its vertices, which is at `arm` from its centre.
fn drop(setup: &Setup, arm: [f64; 2], law: ContactLaw) -> Result<Motion, Fault> {
    let fields = &setup.fields;
    let (sides, radius) = (fields.count("n", 3, MOST_SIDES)?, fields.positive("R")?);
    let (v, spin) = (fields.array::<2>("v")?, fields.number("w")?);
    let speed = fastest(&[v[0], v[1], radius * spin]);
    let mut motion = Motion::impact(law, 2.0 * radius, speed)?;
    motion.add(Solid {
        sides,
        radius,
        density: setup.density()?,
        at: (0.0, -arm[1]),
        angle: arm[1].atan2(arm[0]),
        velocity: [v[0], v[1], spin],
    })?;
    motion.add_floor(0.0)?;
    motion.steps(1);
    Ok(motion)
}

/// A polygon hits the floor with a corner.
pub fn corner_drop(setup: &Setup) -> Result<Value, Fault> {
    let law = setup.impact_law()?;
    let motion = drop(setup, setup.fields.array("corner_arm")?, law)?;
    let (v, p) = (motion.velocity(0), motion.impulse());
    let status = match (p[0] == 0.0, is_at_limit(p, law.friction)) {
        (true, _) => "separate",
        (_, false) => "stick",
        _ if p[1] < 0.0 => "slide-",
        _ if p[1] > 0.0 => "slide+",
        _ => "stick",
    };
    Ok(json!({"status": status, "v": [v[0], v[1]], "w": v[2], "P": p}))
}

/// A polygon that turns about one corner lands on the next one.
///
/// The ratio of the angular velocities without slip, and the friction it needs, are those of an impact with much
/// friction; both are absent if the polygon stops.
pub fn landing(setup: &Setup) -> Result<Value, Fault> {
    let arms = setup.fields.list_of("arms", 2)?;
    let arm = arms[1].as_array::<2>()?;
    let spin = setup.fields.number("w")?;
    let friction = setup.friction()?;
    let after = |friction: f64| drop(setup, arm, law(friction, 0.0, 0.0, GapRule::Closed));
    let v = after(friction)?.velocity(0);
    let mut results = json!({"v": [v[0], v[1]], "w": v[2]});
    let free = after(friction.max(NO_SLIP))?;
    let ratio = free.velocity(0)[2] / spin;
    if ratio.abs() > 1e-9 {
        let larger = |largest: [f64; 2], p: [f64; 2]| if p[0] > largest[0] { p } else { largest };
        let p = free.impulses().into_iter().fold([0.0; 2], larger);
        results["no_slip_ratio"] = ratio.into();
        results["friction_needed_for_no_slip"] = (p[1].abs() / p[0]).into();
    }
    Ok(results)
}
