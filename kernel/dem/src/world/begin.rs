//! The initial state of a world.

use super::choice::NormalChoice;
use super::execution::Execution;
use super::simulation::{Number, World};
use super::state::{Drive, State};
use super::workspace::Workspace;
use crate::balance::Ledger;
use crate::bonds::{BondStart, Bonds};
use crate::contacts::{ContactStart, Contacts};
use crate::error::ModelError;
use crate::forces::{Bookings, Forces};
use crate::integrators::Previous;
use crate::model::Model;
use crate::particles::{Particles, Role};
use gouge_common::geometry::{Metric, Vec2, WithMetric};
use gouge_common::scalar::Real;

/// The initial state of a scene, besides its particles.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// Initial bonds.
    pub bonds: Vec<BondStart>,
    /// Contacts that began before the initial state.
    pub contacts: Vec<ContactStart>,
    /// Initial total driving force in N.
    pub drive_force: Vec2,
}

impl<S: Number, N: NormalChoice<S>> World<S, N> {
    /// A world with its particles, contacts and bonds at t = 0.
    ///
    /// # Errors
    /// If a contact or bond is impossible, a periodic box is narrower than two cells, a driving law has no driven
    /// particle, or a mass or moment of inertia is not finite or has no finite inverse.
    pub fn new(
        model: Model<N>,
        particles: Particles<S>,
        start: &Start,
    ) -> Result<Self, ModelError> {
        check_width(&model, &particles)?;
        check_inertia(&particles)?;
        let particles = with_prescribed_motion(&model, particles);
        let workspace = Workspace::new(&model, &particles);
        if model.driving.is_some() && workspace.driven.is_empty() {
            return Err(ModelError::NothingDriven);
        }
        let mut world = Self {
            execution: Execution::serial(particles.len()),
            state: without_interactions(&model, particles, start.drive_force.cast()),
            workspace,
            model,
        };
        model.domain.with_metric(MakeInteractions {
            world: &mut world,
            start,
        })?;
        world.reserve();
        world.begin_ledger();
        Ok(world)
    }

    /// Start the energy balance at the present state, if the model has a ledger.
    pub(super) fn begin_ledger(&mut self) {
        if self.model.ledger {
            self.state.ledger = Some(Ledger::starting_from(&N::state_energy(self)));
        }
    }
}

/// The particles with the velocity of the driven ones, if the model prescribes it.
fn with_prescribed_motion<S: Real, N>(
    model: &Model<N>,
    mut particles: Particles<S>,
) -> Particles<S> {
    if let Some(velocity) = model.driving.and_then(|law| law.prescribed_velocity()) {
        let driven: Vec<usize> = particles.with_role(Role::Driven).collect();
        for i in driven {
            particles.velocity[i] = velocity.cast();
            particles.angular_velocity[i] = S::zero();
        }
    }
    particles
}

/// A state without contacts and bonds.
fn without_interactions<S: Number, N>(
    model: &Model<N>,
    particles: Particles<S>,
    drive_force: Vec2<S>,
) -> State<S> {
    State {
        bonds: None,
        contacts: None,
        forces: Forces::new(particles.len()),
        drive: Drive {
            force: drive_force,
            applied: drive_force,
            ..Drive::default()
        },
        previous: Previous::new(model.integrator, particles.len()),
        ledger: None,
        bookings: Bookings::default(),
        steps: 0,
        is_evaluated: false,
        particles,
    }
}

/// Creates the bonds and searches the contacts of a new world.
struct MakeInteractions<'a, S: Number, N> {
    world: &'a mut World<S, N>,
    start: &'a Start,
}

impl<S: Number, N: NormalChoice<S>> WithMetric for MakeInteractions<'_, S, N> {
    type Output = Result<(), ModelError>;

    fn call<M: Metric>(self, metric: M) -> Self::Output {
        let World {
            model,
            state,
            workspace,
            ..
        } = self.world;
        if let Some(laws) = model.bond {
            let bonds = &self.start.bonds;
            let edges = laws.has_unbreakable_edges();
            let bonds = Bonds::new(metric, &state.particles, bonds, edges, model.period())?;
            state.bonds = Some(bonds);
        }
        if let (Some(laws), Some(neighbors)) = (model.contact, &mut workspace.neighbors) {
            let mut contacts = Contacts::new(laws.remembers());
            contacts.rebuild(metric, &state.particles, state.bonds.as_ref(), neighbors);
            contacts.remember(metric, &state.particles, &self.start.contacts)?;
            state.contacts = Some(contacts);
        }
        Ok(())
    }
}

/// Check that the masses and moments of inertia of all particles that can move are finite and have finite inverses.
fn check_inertia<S: Real>(particles: &Particles<S>) -> Result<(), ModelError> {
    let columns = [
        ("the mass of a particle", &particles.mass),
        (
            "the moment of inertia of a particle",
            &particles.moment_of_inertia,
        ),
    ];
    for (name, column) in columns {
        for (i, &inertia) in column.iter().enumerate() {
            let inverse = S::from_f64(1.0) / inertia;
            let is_usable = inertia.is_finite() && inverse.is_finite();
            if !particles.is_fixed(i) && !is_usable {
                return Err(ModelError::Parameter {
                    name,
                    value: inertia.to_f64(),
                    accepted: "finite, and so must be its inverse",
                });
            }
        }
    }
    Ok(())
}

/// Check that a periodic box is at least two cells wide, so that a pair does not meet across both sides.
fn check_width<S: Real, N>(model: &Model<N>, particles: &Particles<S>) -> Result<(), ModelError> {
    let cell = 2.0 * particles.largest_radius();
    match model.period() {
        Some(width) if width < 2.0 * cell => Err(ModelError::NarrowBox { width, cell }),
        _ => Ok(()),
    }
}
