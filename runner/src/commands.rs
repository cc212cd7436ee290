//! The commands of the program, without the parsing of arguments.

use crate::error::Error;
use crate::run::run_setup;
use crate::scene::{Scene, builtin, integrator_name};
use gouge_dem::forces::InteractionKind;
use gouge_dem::integrators::{Oscillator, crack_bound, critical_step, wave_bound};
use gouge_dem::material::Elastic;
use gouge_dem::model::ContactNormal;
use gouge_dem::{World, stable_step_estimate};
use serde_json::{Value, json};
use std::borrow::Cow;
use std::fmt::Write;

/// Characteristic Mach number of cracks, thesis section 4.2.
const MACH_NUMBER: f64 = 15.0;

/// Every pair that interacts at t = 0, after the set-up, as CSV.
///
/// # Errors
/// Scenes that the kernel refuses.
pub fn links(scene: &Scene) -> Result<String, Error> {
    let mut text = String::from(
        "i,j,kind,overlap_factor,focal_x,focal_y,normal_x,normal_y,normal_displacement,\
         adjusted_normal_displacement,tangential_displacement_i,tangential_displacement_j,\
         normal_velocity,tangential_velocity_i,tangential_velocity_j,normal_force,\
         tangential_force,torque_i,torque_j\n",
    );
    let mut links = run_setup(scene)?.interactions();
    links.sort_by_key(|link| link.pair.indices());
    for link in links {
        let kind = match link.kind {
            InteractionKind::Contact => "weak",
            InteractionKind::Bond => "strong",
        };
        let numbers = [
            link.overlap_factor,
            link.focal_point.x,
            link.focal_point.y,
            link.normal.x,
            link.normal.y,
            link.normal_displacement,
            link.adjusted_normal_displacement,
            link.tangential_displacement[0],
            link.tangential_displacement[1],
            link.normal_velocity,
            link.tangential_velocity[0],
            link.tangential_velocity[1],
            link.normal_force,
            link.tangential_force,
            link.torque[0],
            link.torque[1],
        ];
        let _ = write!(text, "{},{},{kind}", link.pair.i, link.pair.j);
        numbers.iter().for_each(|number| {
            let _ = write!(text, ",{number:?}");
        });
        text.push('\n');
    }
    Ok(text)
}

/// The time-step bounds of a scene and its integrator at t = 0, after the set-up, as JSON.
///
/// # Errors
/// Scenes that the kernel refuses.
pub fn stability(scene: &Scene) -> Result<String, Error> {
    let world = run_setup(scene)?;
    let mut bounds = pair_bounds(scene, &world);
    bounds.extend(wave_bounds(scene, &world));
    let estimate = stable_step_estimate(&world);
    bounds.push(json!({
        "name": "network",
        "meaning": "upper bound on the stiffness of every mode of the interacting particles (Gershgorin): smaller steps are stable",
        "step": finite(estimate),
        "satisfied": scene.step <= estimate,
    }));
    let steps = bounds.iter().filter_map(|bound| bound["step"].as_f64());
    let smallest = steps.fold(f64::INFINITY, f64::min);
    let text = serde_json::to_string_pretty(&json!({
        "integrator": integrator_name(scene.integrator),
        "time_step": scene.step,
        "smallest_bound": finite(smallest),
        "satisfied": scene.step <= smallest,
        "bounds": bounds,
    }));
    Ok(text.unwrap_or_default() + "\n")
}

/// The number, or null if it is not finite: JSON has no infinity.
fn finite(number: f64) -> Value {
    if number.is_finite() {
        json!(number)
    } else {
        Value::Null
    }
}

/// Bound from one oscillation; `k` and `c` are stiffness and damping per mass, in 1/s^2 and 1/s.
fn pair_bound(scene: &Scene, name: &str, meaning: &str, [k, c]: [f64; 2]) -> Value {
    let oscillator = Oscillator {
        frequency_squared: k,
        damping_rate: c,
    };
    let step = critical_step(scene.integrator, oscillator);
    json!({
        "name": name,
        "meaning": meaning,
        "angular_frequency": k.sqrt(),
        "damping_ratio": finite(c / (2.0 * k.sqrt())),
        "step": finite(step),
        "satisfied": scene.step <= step,
    })
}

/// Bounds from the oscillations of a pair of the lightest particles.
fn pair_bounds(scene: &Scene, world: &World) -> Vec<Value> {
    let p = world.particles();
    let by_mass = |i: &usize, j: &usize| p.mass[*i].total_cmp(&p.mass[*j]);
    let (lightest, inverse_inertia) = match (0..p.len()).min_by(by_mass) {
        Some(i) => (p.mass[i], p.inverse_inertia_factor(i)),
        None => (f64::INFINITY, 0.0),
    };
    let smallest = p.radius.iter().copied().fold(f64::INFINITY, f64::min);
    // Inverse reduced mass of two equal particles; for tangential motion times 1 + m r^2 / J, which is 7/2 for spheres.
    let (push, roll) = (2.0 / lightest, 2.0 * (1.0 + inverse_inertia) / lightest);
    let bound = |name, meaning, k, c| pair_bound(scene, name, meaning, [k, c]);
    let mut bounds = Vec::new();
    if let Some(contact) = &scene.contact {
        let [k, c] = contact.normal.constants([smallest; 2]);
        bounds.push(bound(
            "contact normal",
            "collision of the two lightest particles",
            push * k,
            push * c,
        ));
        if let Some(law) = contact.tangential {
            let [k, c] = law.constants();
            bounds.push(bound(
                "contact tangential",
                "sticking or viscous slip of the two lightest particles",
                roll * k,
                roll * c,
            ));
        }
    }
    if let Some(bond) = &scene.bond {
        let law = bond.normal;
        bounds.push(bound(
            "bond axial",
            "stretching of a two-particle beam",
            push * law.stiffness,
            push * law.damping,
        ));
        if let Some(beam) = bond.tangential {
            // Equal particles in touch, rotating in the same and in opposite senses: 7/2 k / m and 5/2 k / m for
            // spheres.
            let [shear, turn] = [1.0, 0.0].map(|shift| (shift + inverse_inertia) / lightest);
            bounds.push(bound(
                "bond shear",
                "both ends rotate in the same sense",
                shear * beam.stiffness,
                shear * beam.damping,
            ));
            bounds.push(bound(
                "bond bending",
                "both ends rotate in opposite senses",
                turn * beam.stiffness,
                turn * beam.damping,
            ));
        }
    }
    bounds
}

/// Bounds (61) and (62), if the scene gives elastic constants.
fn wave_bounds(scene: &Scene, world: &World) -> Vec<Value> {
    let Some(ContactNormal::Bshp(law)) = scene.contact.map(|contact| contact.normal) else {
        return Vec::new();
    };
    let elastic = Elastic {
        youngs_modulus: law.youngs_modulus,
        poissons_ratio: law.poissons_ratio,
    };
    let radius = world
        .particles()
        .radius
        .iter()
        .copied()
        .fold(f64::INFINITY, f64::min);
    let bound = |name: &str, meaning: &str, step: f64| json!({ "name": name, "meaning": meaning, "step": finite(step), "satisfied": scene.step <= step });
    vec![
        bound(
            "wave",
            "a primary wave crosses the smallest particle (61)",
            wave_bound(elastic, scene.material.density, radius),
        ),
        bound(
            "crack",
            "a crack at Mach 15 crosses the smallest particle (62)",
            crack_bound(elastic, scene.material.density, radius, MACH_NUMBER),
        ),
    ]
}

/// The list of built-in scenes, or the text of one of them.
///
/// # Errors
/// A name that is not built in.
pub fn scenes(name: Option<&str>) -> Result<String, Error> {
    let Some(name) = name else {
        let line = |(name, purpose, _): &(&str, &str, &str)| format!("{name:22} {purpose}\n");
        let lines: String = builtin::SCENES.iter().map(line).collect();
        return Ok(lines
            + "lammps/..., yade/...   ENGINE/CASE/RUN: the scene of a stored reference run, e.g. lammps/kelvin-voigt/thesis\n");
    };
    let text = builtin::named_text(name).map(Cow::into_owned);
    text.ok_or_else(|| {
        let names = builtin::names().join(", ");
        Error::Argument(format!(
            "'{name}' is not a built-in scene; must be one of: {names}"
        ))
    })
}
