//! The state of a world: everything that changes with time.

use crate::balance::Ledger;
use crate::bonds::Bonds;
use crate::contacts::Contacts;
use crate::forces::{Bookings, Forces};
use crate::integrators::Previous;
use crate::particles::Particles;
use gouge_common::geometry::Vec2;

/// The driving force and the reaction to it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drive<S> {
    /// Total driving force of the next step, in N.
    pub force: Vec2<S>,
    /// Total driving force of the step that led to the present state, in N.
    pub applied: Vec2<S>,
    /// Reaction: sum of all other forces on the driven particles at the latest evaluation, in N.
    pub reaction: Vec2<S>,
    /// Mean horizontal velocity of the driven particles at the beginning of the step, in m/s.
    pub velocity_at_step_start: S,
}

/// Everything that changes with time: what checkpoints hold and estimators read.
///
/// Optional parts exist only if the model needs them.
#[derive(Clone, Debug)]
pub struct State<S = f64> {
    pub(super) particles: Particles<S>,
    pub(super) bonds: Option<Bonds<S>>,
    pub(super) contacts: Option<Contacts<S>>,
    pub(super) forces: Forces<S>,
    pub(super) drive: Drive<S>,
    pub(super) previous: Previous<S>,
    pub(super) ledger: Option<Ledger<S>>,
    pub(super) bookings: Bookings<S>,
    pub(super) steps: u64,
    pub(super) is_evaluated: bool,
}

impl<S> State<S> {
    /// The particles.
    pub fn particles(&self) -> &Particles<S> {
        &self.particles
    }
    /// The bonds, if the model has them.
    pub fn bonds(&self) -> Option<&Bonds<S>> {
        self.bonds.as_ref()
    }
    /// The contact list, if the model has contacts.
    pub fn contacts(&self) -> Option<&Contacts<S>> {
        self.contacts.as_ref()
    }
    /// The driving force.
    pub fn drive(&self) -> &Drive<S> {
        &self.drive
    }
    /// Forces and torques of the latest evaluation.
    pub fn forces(&self) -> &Forces<S> {
        &self.forces
    }
    /// Number of completed steps.
    pub fn steps(&self) -> u64 {
        self.steps
    }
}
