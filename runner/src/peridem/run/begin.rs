//! The world at the beginning of a scene.

use super::super::Scene;
use super::mesh::{Cells, Meshed, meshed, refused, refused_by_runner};
use crate::error::{Error, SceneError};
use crate::machine::chosen;
use gouge_common::geometry::Vec2;
use gouge_peridem::contacts::Contact;
use gouge_peridem::error::{SetupError, TooFast};
use gouge_peridem::forces::Settings;
use gouge_peridem::grain::Grains;
use gouge_peridem::limits::Limits;
use gouge_peridem::mode::Mode;
use gouge_peridem::state::State;
use gouge_peridem::world::World;

/// The world of a scene, and what is known beforehand.
pub struct Built {
    /// The world at t = 0.
    pub world: World,
    /// What the meshes of the grains say besides.
    pub cells: Vec<Cells>,
    /// The longest stable steps.
    pub limits: Limits,
}

/// The world at t = 0 of a scene, whatever its time step and contact radius are.
///
/// # Errors
/// What the kernel refuses.
pub fn built(scene: &Scene) -> Result<Built, Error> {
    let Meshed {
        grains,
        bonds,
        cells,
    } = meshed(scene)?;
    let mut state = State::at_rest(&grains, bonds);
    set_velocities(scene, &grains, &mut state);
    let settings = settings(scene)?;
    if let Some(walls) = &scene.walls {
        state.walls = walls.position;
    }
    let limits = Limits::of(&grains, &state.bonds, &settings);
    let world = World::new(grains, settings, state, scene.mode.beginning())?;
    let world = world.with_instructions(chosen()?.instructions);
    Ok(Built {
        world,
        cells,
        limits,
    })
}

/// The world at t = 0 of a scene, with a time step, a contact radius and velocities that are safe or forced.
///
/// # Errors
/// What the kernel refuses, and an unsafe step or radius that the scene does not force.
pub fn checked(scene: &Scene) -> Result<Built, Error> {
    let mut built = built(scene)?;
    let contact = built.world.settings().contact.as_ref();
    let is_forced = scene.contact.is_none_or(|contact| contact.is_forced);
    if let Some(contact) = contact.filter(|_| !is_forced) {
        let checked = contact.check_radius(built.world.grains());
        let radius = scene.refusals.radius.as_ref();
        checked.map_err(|error| with_advice(refused(radius, &error), "contact.forced = true"))?;
    }
    if !scene.is_step_forced {
        let checked = built.limits.check(scene.step);
        let step = scene.refusals.step.as_ref();
        checked.map_err(|error| {
            let advice = "time.forced = true; `gouge stability` prints all limits";
            with_advice(refused(step, &error), advice)
        })?;
    }
    if let Some(lost) = built.world.lost_node() {
        let position = scene.refusals.grains.get(lost.grain);
        let reason = format!("{lost}, so that nothing would push it back");
        return Err(refused_by_runner(
            position.map(|all| &all.position),
            lost.grain,
            &reason,
        ));
    }
    if !is_forced {
        let guarded = built.world.guarded();
        built.world = guarded.map_err(|error| {
            let reason = refused(motion_of(scene, &error), &error.into());
            with_advice(reason, "contact.forced = true")
        })?;
    }
    Ok(built)
}

/// The error about what makes a node too fast: most of its speed, or else the time step.
fn motion_of<'a>(scene: &'a Scene, error: &TooFast) -> Option<&'a SceneError> {
    let (refusals, table) = (&scene.refusals, scene.grains.get(error.grain)?);
    let grain = refusals.grains.get(error.grain)?;
    let turns = table.velocity.norm() < 0.5 * error.speed;
    let [main, other] = match turns {
        true => [&grain.angular_velocity, &grain.velocity],
        false => [&grain.velocity, &grain.angular_velocity],
    };
    [main, other, &refusals.step]
        .into_iter()
        .find_map(Option::as_ref)
}

/// The world at t = 0 of a scene, for programs that step it themselves.
///
/// # Errors
/// As for a run.
pub fn world(scene: &Scene) -> Result<World, Error> {
    Ok(checked(scene)?.world)
}

/// An error that also says how to run the scene nevertheless.
fn with_advice(error: Error, advice: &str) -> Error {
    match error {
        Error::Scene(mut error) => {
            error.accepted += &format!("; to run it nevertheless: {advice}");
            Error::Scene(error)
        }
        other => other,
    }
}

fn settings(scene: &Scene) -> Result<Settings, SetupError> {
    let contact: Option<Contact> = match &scene.contact {
        Some(table) => Some(table.between(scene)?),
        None => None,
    };
    let walls = scene.walls.as_ref().zip(contact.as_ref());
    Ok(Settings {
        time_step: scene.step,
        gravity: scene.gravity,
        break_order: scene.bonds.order,
        walls: walls.map(|(table, contact)| table.among(contact)),
        contact,
    })
}

/// Every grain moves as a rigid body at first.
fn set_velocities(scene: &Scene, grains: &Grains, state: &mut State) {
    for (row, table) in grains.rows.iter().zip(&scene.grains) {
        let centre = centre(grains, row.nodes.clone(), |node| grains.position[node]);
        for node in row.nodes.clone() {
            let arm = grains.position[node] - centre;
            let turning = arm.perpendicular() * table.angular_velocity;
            state.velocity[node] = table.velocity + turning;
        }
    }
}

/// The mean over some nodes of a vector, weighted with their areas.
pub fn centre(grains: &Grains, nodes: std::ops::Range<usize>, of: impl Fn(usize) -> Vec2) -> Vec2 {
    let mut sum = Vec2::zero();
    let mut area = 0.0;
    for node in nodes {
        sum += of(node) * grains.area[node];
        area += grains.area[node];
    }
    sum * (1.0 / area)
}

/// How outputs state the reading of the source.
pub fn mode_text(mode: Mode) -> String {
    format!("mode = \"{}\"", mode.name())
}
