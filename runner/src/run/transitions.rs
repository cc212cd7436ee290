//! Transitions from one phase to the next.

use super::measures::check_strain;
use super::phases::{Phase, PhaseKind, phase_model, phases};
use super::setup_states::{bonded_block, loose_grains, roles};
use super::start::continued;
use crate::error::Error;
use crate::machine::with_chosen_execution;
use crate::scene::{Scene, Setup};
use gouge_dem::{ModelError, World};

/// The world at the beginning of a phase, made from the world at the end of the previous phase.
///
/// # Errors
/// A state that the kernel rejects, no state from which the run can begin, or one whose strain cannot be measured.
pub fn begin_phase(
    scene: &Scene,
    phases: &[Phase],
    index: usize,
    before: Option<World>,
) -> Result<World, Error> {
    let world = match (&scene.start, &scene.setup) {
        (Some(start), _) => continued(scene, start)?,
        (None, None) => scene.initial_world().map(with_chosen_execution)?,
        (None, Some(setup)) => next_phase(scene, setup, phases, index, before)?,
    };
    if index + 1 == phases.len() {
        check_strain(scene, &world)?;
    }
    Ok(world)
}

/// The world at the beginning of a phase of a scene with a set-up.
fn next_phase(
    scene: &Scene,
    setup: &Setup,
    phases: &[Phase],
    index: usize,
    before: Option<World>,
) -> Result<World, ModelError> {
    let kind = phases[index].kind;
    let world = match before {
        None => loose_grains(scene, setup, kind)?,
        Some(world) => world,
    };
    let made_before = index > 0 && !matches!(phases[index - 1].kind, PhaseKind::Settle(_));
    let world = if matches!(kind, PhaseKind::Settle(_)) || made_before {
        world
    } else {
        bonded_block(scene, setup, world, kind)?
    };
    let radii = world.particles().radius.clone();
    let had_roles = index > 0 && matches!(phases[index - 1].kind, PhaseKind::Press(_));
    let gets_roles = matches!(kind, PhaseKind::Press(_) | PhaseKind::Main) && !had_roles;
    let roles = gets_roles.then(|| roles(scene, setup, world.particles()));
    world.continue_with(phase_model(scene, kind, &radii), roles)
}

/// The world at t = 0 of the scene proper, after all phases of its set-up, without any output.
///
/// # Errors
/// A state that the kernel rejects, or that becomes invalid.
pub fn run_setup(scene: &Scene) -> Result<World, Error> {
    run_setup_with(scene, &mut |_, _| {})
}

/// Like [`run_setup`]; `look` is called with each phase of the set-up and the world in which it begins.
///
/// # Errors
/// As [`run_setup`].
pub fn run_setup_with(scene: &Scene, look: &mut dyn FnMut(&Phase, &World)) -> Result<World, Error> {
    let phases = phases(scene);
    let mut world = begin_phase(scene, &phases, 0, None)?;
    for (index, phase) in phases.iter().enumerate().take(phases.len() - 1) {
        look(phase, &world);
        advance(&mut world, phase.steps, &phase.name)?;
        world = begin_phase(scene, &phases, index + 1, Some(world))?;
    }
    Ok(world)
}

/// Advance a world by a number of steps; errors name the given phase.
///
/// # Errors
/// A state that becomes invalid.
pub fn advance(world: &mut World, steps: u64, phase: &str) -> Result<(), Error> {
    for _ in 0..steps {
        world.step().map_err(|source| Error::Step {
            phase: phase.to_owned(),
            source,
        })?;
    }
    Ok(())
}
