//! Commands of the program, without the parsing of arguments.

use crate::error::Error;
use crate::references;
use crate::run::{Phase, run_setup_with};
use crate::scene::{Scene, builtin, integrator_name};
use crate::stability::{Bound, bounds, pair_bounds, smallest};
use gouge_dem::World;
use serde_json::{Value, json};

/// The time-step bounds of a scene and its integrator at t = 0, after the set-up, and of the phases of the set-up, as
/// JSON.
///
/// # Errors
/// Scenes that the kernel refuses.
pub fn stability(scene: &Scene) -> Result<String, Error> {
    let mut phases = Vec::new();
    let world = run_setup_with(scene, &mut |phase, world| {
        phases.push(phase_bound(scene, phase, world))
    })?;
    let bounds = bounds(&world, scene.material.density);
    let smallest = smallest_step(&bounds);
    let are_met = phases.iter().all(|phase| phase["satisfied"] == true);
    let text = serde_json::to_string_pretty(&json!({
        "integrator": integrator_name(scene.integrator),
        "time_step": scene.step,
        "smallest_bound": finite(smallest),
        "satisfied": scene.step <= smallest && are_met,
        "covers": COVERED,
        "bounds": bounds.iter().map(|bound| described(scene, bound)).collect::<Vec<_>>(),
        "phases": phases,
    }));
    Ok(text.unwrap_or_default() + "\n")
}

/// What the bounds say and what they do not.
const COVERED: &str = "Below the bounds, oscillations of contacts and bonds that last do not grow. \
    They are those of t = 0: contacts that form later can lower that of the network, usually by less than \
    a half, which a run finds out. A contact that begins inside a step may gain 4 (step / bound)^2 of the \
    energy of the collision: 4 % at a tenth of the bound. The residual of the balance shows what a run \
    gained or lost.";

/// A bound as JSON.
fn described(scene: &Scene, bound: &Bound) -> Value {
    let mut text = json!({
        "name": bound.name,
        "meaning": bound.meaning,
        "step": finite(bound.step),
        "satisfied": scene.step <= bound.step,
    });
    if let Some(oscillator) = bound.oscillator {
        let frequency = oscillator.frequency_squared.sqrt();
        text["angular_frequency"] = json!(frequency);
        text["damping_ratio"] = finite(oscillator.damping_rate / (2.0 * frequency));
    }
    text
}

/// The bound of a phase of the set-up, in the state in which it begins.
fn phase_bound(scene: &Scene, phase: &Phase, world: &World) -> Value {
    let step = world.model().time_step;
    let smallest = smallest_step(&pair_bounds(world, scene.material.density));
    json!({
        "name": phase.name,
        "time_step": step,
        "smallest_bound": finite(smallest),
        "satisfied": step <= smallest,
    })
}

/// The smallest bound in s; infinite without bounds.
fn smallest_step(bounds: &[Bound]) -> f64 {
    smallest(bounds).map_or(f64::INFINITY, |bound| bound.step)
}

/// The number, or null if it is not finite: JSON has no infinity.
pub(crate) fn finite(number: f64) -> Value {
    if number.is_finite() {
        json!(number)
    } else {
        Value::Null
    }
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
            + "lammps, yade           the scenes of stored runs of these programs: `gouge scenes lammps` lists them\n");
    };
    if let Some(text) = builtin::named_text(name) {
        return Ok(text.into_owned());
    }
    let stored = references::names().filter(|stored| is_below(stored, name));
    let lines: String = stored.map(|stored| stored + "\n").collect();
    (!lines.is_empty()).then_some(lines).ok_or_else(|| {
        let names = builtin::names().join(", ");
        Error::Argument(format!(
            "'{name}' is not a built-in scene; must be one of: {names}"
        ))
    })
}

/// Whether a path such as `lammps/kelvin-voigt/thesis` is inside a folder such as `lammps`.
fn is_below(path: &str, folder: &str) -> bool {
    let folder = folder.trim_end_matches('/');
    path.strip_prefix(folder)
        .is_some_and(|rest| rest.starts_with('/'))
}
