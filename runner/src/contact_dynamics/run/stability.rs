//! What is known beforehand about a time step of contact dynamics.

use super::super::Scene;
use super::contacts::at_beginning;
use crate::error::Error;
use gouge_contact_dynamics::cell::{Drive, Speed, roof_height};
use gouge_contact_dynamics::world::World;
use serde_json::{Value, json};

/// What the answer says.
const COVERED: &str = "Contact dynamics has no stability bound: impulses are implicit, and without restitution no step \
    creates energy. The step decides how far bodies move before they meet, and how many sweeps are needed. Overlaps come \
    from sweeps that end too early: see largest_overlap and velocity_residual in series.csv.";

/// What limits the time step of a scene, as JSON.
///
/// # Errors
/// Scenes that the kernel refuses.
pub fn stability(scene: &Scene) -> Result<String, Error> {
    let world = at_beginning(scene)?;
    let friction = scene.settings.law.friction;
    let limit = uniqueness_limit(&world);
    let text = serde_json::to_string_pretty(&json!({
        "integrator": "contact-dynamics",
        "time_step": scene.settings.time_step,
        "smallest_bound": Value::Null,
        "satisfied": true,
        "covers": COVERED,
        "bounds": [],
        "friction": friction,
        "friction_below_which_every_point_has_one_solution": limit,
        "has_one_solution_per_point": limit.is_none_or(|limit| friction < limit),
        "shear": scene.shear.map(|shear| described(scene, &world, &shear.drive())),
    }));
    Ok(text.unwrap_or_default() + "\n")
}

/// The friction below which the local problem of a vertex contact has exactly one solution; none if all bodies are discs.
///
/// With j the moment of inertia over mass and squared circumradius, mu abs(W_nt) < W_nn holds at every contact of two
/// regular polygons if mu < 2 sqrt(j (1 + j)).
fn uniqueness_limit(world: &World) -> Option<f64> {
    let assembly = world.assembly();
    let polygon = |&shape: &_| {
        let outline = assembly.shapes.outline(shape);
        let measures = outline.measures;
        let square = measures.circumradius * measures.circumradius;
        let j = measures.second_moment / (measures.area * square);
        (!outline.is_disc()).then(|| 2.0 * (j * (1.0 + j)).sqrt())
    };
    assembly.shape.iter().filter_map(polygon).reduce(f64::min)
}

fn described(scene: &Scene, world: &World, drive: &Drive) -> Value {
    let Drive::Shear {
        normal_stress,
        speed,
    } = *drive
    else {
        return Value::Null;
    };
    let height = roof_height(world.state());
    let rate = match speed {
        Speed::Rate(rate) => rate,
        Speed::Constant(velocity) => velocity / height,
    };
    let diameter = super::statistics::mean_diameter(world.assembly());
    let time = (scene.density / normal_stress).sqrt() * diameter;
    json!({
        "strain_per_step": rate * scene.settings.time_step,
        "inertial_number": rate * time,
        "step_over_time_of_rearrangement": scene.settings.time_step / time,
        "strain": rate * scene.end,
    })
}
