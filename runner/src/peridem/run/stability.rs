//! The longest stable time steps of a scene.

use super::super::Scene;
use super::begin::built;
use crate::commands::finite;
use crate::error::Error;
use gouge_peridem::limits::Limits;
use gouge_peridem::mesh::smallest_distance;
use gouge_peridem::world::World;
use serde_json::{Map, Value, json};

/// What the answer says.
const COVERED: &str = "Limits of grains in their reference positions, with contacts all around a node. The step must satisfy \
    all but that by row sums, which is sufficient for bonds, not necessary. At 0.4 times the smallest limit the energy of \
    collisions is kept to about 1e-3; the residual in series.csv shows what a run gained or lost.";

/// The limits of the time step of a scene, as JSON.
///
/// # Errors
/// Scenes that the kernel refuses.
pub fn stability(scene: &Scene) -> Result<String, Error> {
    let built = built(scene)?;
    let limits = &built.limits;
    let (name, smallest) = limits.smallest();
    let bounds: Vec<Value> = described(limits)
        .into_iter()
        .map(|(name, meaning, step)| {
            json!({
                "name": name,
                "meaning": meaning,
                "step": finite(step),
                "satisfied": scene.step <= step,
            })
        })
        .collect();
    let text = serde_json::to_string_pretty(&json!({
        "integrator": "velocity-verlet",
        "mode": scene.mode.name(),
        "time_step": scene.step,
        "smallest_bound": finite(smallest),
        "smallest_bound_is_of": name,
        "satisfied": scene.step <= smallest,
        "forced": scene.is_step_forced,
        "covers": COVERED,
        "bounds": bounds,
        "contact_radius_over_spacing": radius_over_spacing(&built.world),
    }));
    Ok(text.unwrap_or_default() + "\n")
}

/// All limits with their names and meanings.
fn described(limits: &Limits) -> [(&'static str, &'static str, f64); 5] {
    [
        (
            "bonds",
            "2 over the largest frequency of the bonds: exact",
            limits.bonds.exact,
        ),
        (
            "bonds-row-sums",
            "the same from the bound on the frequency by row sums: sufficient, up to twice too small",
            limits.bonds.row_sum,
        ),
        (
            "contact",
            "repulsion of a node from others all around it",
            limits.contact,
        ),
        (
            "damping",
            "repulsion and damping of a node among others",
            limits.damping,
        ),
        ("walls", "repulsion and damping of walls", limits.walls),
    ]
}

/// The limits in s by name, for the summary.
pub fn summarized(limits: &Limits) -> Map<String, Value> {
    let all = described(limits).into_iter();
    all.map(|(name, _, step)| (name.to_owned(), finite(step)))
        .collect()
}

/// The contact radius over the smallest distance of two nodes of a grain.
fn radius_over_spacing(world: &World) -> Option<f64> {
    let grains = world.grains();
    let radius = world.settings().contact.as_ref()?.law.radius;
    let spacing = |row: &gouge_peridem::grain::GrainRow| {
        smallest_distance(&grains.position[row.nodes.clone()])
    };
    let smallest = grains.rows.iter().filter_map(spacing).reduce(f64::min)?;
    Some(radius / smallest)
}
