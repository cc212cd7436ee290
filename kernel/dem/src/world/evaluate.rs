//! One evaluation: contacts, bonds, forces, heat and work at the present positions and velocities.

use super::choice::NormalChoice;
use super::dispatch::{
    WithAmbientLaw, WithBondPass, WithContactPass, WithExternalLaw, with_ambient_law,
    with_bond_pass, with_contact_pass, with_external_law,
};
use super::simulation::{Number, World};
use crate::bonds::Bonds;
use crate::error::StepError;
use crate::forces::{
    self, Bodies, BondForces, BondPass, Bookings, ContactForces, ContactPass, PairLoop,
};
use crate::geometry::Arm;
use crate::laws::{AmbientLaw, BeamLaw, Driven, ExternalLaw, NormalLaw, TangentialLaw, YieldLaw};
use gouge_common::geometry::{Metric, WithMetric};

impl<S: Number, N: NormalChoice<S>> World<S, N> {
    /// Evaluate forces, contacts and bonds at the present positions, unless they are up to date. The next step
    /// would do so, too.
    ///
    /// # Errors
    /// As for [`step`](Self::step).
    pub fn evaluate_if_pending(&mut self) -> Result<(), StepError> {
        if self.is_pending() {
            return N::evaluate(self);
        }
        Ok(())
    }

    /// Whether the next step begins with an evaluation, because the forces are not those of the present state.
    pub fn is_pending(&self) -> bool {
        !self.state.is_evaluated
    }

    /// Implementation of [`Number::evaluate`].
    #[doc(hidden)]
    pub fn evaluate_first(&mut self) -> Result<(), StepError> {
        self.store_drive_velocity();
        self.evaluate(self.model.integrator.evaluates_first(), false)?;
        self.state.is_evaluated = true;
        Ok(())
    }

    /// Evaluate forces at the present positions and velocities. Bonds break, contacts begin and end.
    ///
    /// `advances`: whether a step has passed since the previous evaluation; only then do the driving force and
    /// accumulated displacements change. `forces_are_clear`: whether all forces are zero already.
    pub(super) fn evaluate(
        &mut self,
        advances: bool,
        forces_are_clear: bool,
    ) -> Result<(), StepError> {
        self.refresh_neighbors()?;
        if !forces_are_clear {
            self.state.forces.clear();
        }
        self.state.bookings = Bookings::default();
        self.add_bonds();
        self.add_contacts(advances);
        self.remove_broken(advances);
        self.add_fields();
        self.add_driving(advances);
        if let Some(ledger) = &mut self.state.ledger {
            ledger.book(&self.state.bookings);
        }
        Ok(())
    }

    /// Remove the bonds that broke in this evaluation, after what they carried was kept.
    fn remove_broken(&mut self, advances: bool) {
        let breaks = |bonds: &Bonds<S>| !bonds.broken.is_empty();
        if !self.state.bonds.as_ref().is_some_and(breaks) {
            return;
        }
        // Methods that move particles first count the step after the evaluation.
        let is_ahead = advances && !self.model.integrator.evaluates_first();
        self.keep_breaks(self.state.steps + u64::from(is_ahead));
        if let Some(bonds) = &mut self.state.bonds {
            bonds.remove_broken();
        }
    }

    /// Rebuild the neighbour list if it is stale. No result depends on when it is rebuilt.
    ///
    /// # Errors
    /// As for [`check`](Self::check), if the list is stale.
    pub fn refresh_neighbors(&mut self) -> Result<(), StepError> {
        if self.are_neighbors_stale() || self.state.contacts.is_none() {
            self.check()?;
            self.find_neighbors();
        }
        Ok(())
    }

    fn are_neighbors_stale(&mut self) -> bool {
        let known = self.workspace.is_stale.take();
        known.unwrap_or_else(|| self.model.domain.with_metric(AreStale { world: self }))
    }

    /// Search all pairs that may touch.
    pub(super) fn find_neighbors(&mut self) {
        let domain = self.model.domain;
        domain.with_metric(FindNeighbors { world: self });
    }

    fn add_bonds(&mut self) {
        let model = self.model;
        if let Some(laws) = model.bond {
            with_bond_pass(&model, laws, AddForces { world: self });
        }
    }

    fn add_contacts(&mut self, advances: bool) {
        let model = self.model;
        if let (Some(contacts), Some(bonds)) = (&mut self.state.contacts, &self.state.bonds)
            && !bonds.broken.is_empty()
        {
            contacts.add_broken(bonds);
        }
        let elapsed = if advances { model.time_step } else { 0.0 };
        if let Some(laws) = model.contact {
            with_contact_pass(&model, laws, elapsed, AddForces { world: self });
        }
    }

    fn add_fields(&mut self) {
        if let Some(ambient) = self.model.ambient {
            with_ambient_law(ambient, AddForces { world: self });
        }
        if let Some(external) = self.model.external {
            with_external_law(external, AddForces { world: self });
        }
    }

    fn add_driving(&mut self, advances: bool) {
        let Some(law) = self.model.driving else {
            return;
        };
        let state = &mut self.state;
        let (driven, integrator) = (&self.workspace.driven, self.model.integrator);
        let measured = Driven {
            velocity_at_step_start: state.drive.velocity_at_step_start,
            velocity_gain: integrator.velocity_gain(),
            ..forces::measure_driven(&state.particles, driven, &state.forces)
        };
        state.drive.reaction = measured.reaction;
        let before = state.drive.force;
        if advances || law.is_instantaneous() {
            state.drive.force = law.next_force(before, &measured, self.model.time_step);
        }
        // The force of a prescribed motion belongs to the state in which it was measured.
        let lags = integrator.evaluates_first() && law.prescribed_velocity().is_none();
        state.drive.applied = if lags { before } else { state.drive.force };
        let force = state.drive.force;
        let (particles, forces) = (&state.particles, &mut state.forces);
        if self.model.ledger {
            forces::driving::<_, true>(force, particles, driven, forces, &mut state.bookings);
        } else {
            forces::driving::<_, false>(force, particles, driven, forces, &mut state.bookings);
        }
    }
}

struct AreStale<'a, S: Number, N> {
    world: &'a World<S, N>,
}

impl<S: Number, N: NormalChoice<S>> WithMetric for AreStale<'_, S, N> {
    type Output = bool;
    fn call<M: Metric>(self, metric: M) -> bool {
        let neighbors = self.world.workspace.neighbors.as_ref();
        let positions = &self.world.state.particles.position;
        neighbors.is_none_or(|neighbors| neighbors.is_stale(metric, positions))
    }
}

struct FindNeighbors<'a, S: Number, N> {
    world: &'a mut World<S, N>,
}

impl<S: Number, N: NormalChoice<S>> WithMetric for FindNeighbors<'_, S, N> {
    type Output = ();
    fn call<M: Metric>(self, metric: M) {
        let (state, workspace) = (&mut self.world.state, &mut self.world.workspace);
        let (particles, bonds) = (&state.particles, state.bonds.as_ref());
        if let (Some(contacts), Some(neighbors)) = (&mut state.contacts, &mut workspace.neighbors) {
            contacts.rebuild(metric, particles, bonds, neighbors);
        }
    }
}

/// Adds the forces of a pass, and records their heat and work.
struct AddForces<'a, S: Number, N> {
    world: &'a mut World<S, N>,
}

impl<S: Number, N: NormalChoice<S>> WithBondPass for AddForces<'_, S, N> {
    type Output = ();
    fn call<M: Metric, B: BeamLaw, Y: YieldLaw>(self, pass: BondPass<M, B, Y>) {
        if self.world.model.ledger {
            self.add_bonds::<_, _, _, true>(pass);
        } else {
            self.add_bonds::<_, _, _, false>(pass);
        }
    }
}

impl<S: Number, N: NormalChoice<S>> AddForces<'_, S, N> {
    /// Add the forces of bonds, and list the bonds that break.
    fn add_bonds<M: Metric, B: BeamLaw, Y: YieldLaw, const LEDGER: bool>(
        self,
        pass: BondPass<M, B, Y>,
    ) {
        let World {
            state,
            workspace,
            execution,
            ..
        } = self.world;
        let Some(bonds) = &mut state.bonds else {
            return;
        };
        let bodies = Bodies {
            particles: &state.particles,
            inverse_mass: &workspace.inverse_mass,
        };
        let work = PairLoop {
            list_version: bonds.list_version(),
            sums: state.forces.sums(),
            bodies,
            forces: BondForces::<_, _, _, _, LEDGER> {
                pass,
                bodies,
                bonds: bonds.columns(),
            },
        };
        execution.run_pairs::<_, _, LEDGER>(work, &mut workspace.parts, &mut state.bookings);
        for part in &mut workspace.parts {
            part.bonds.add_to(&mut state.forces.sums());
            bonds.broken.append(&mut part.broken);
        }
    }
}

impl<S: Number, N: NormalChoice<S>> WithContactPass for AddForces<'_, S, N> {
    type Output = ();
    fn call<M: Metric, A: Arm, L: NormalLaw, T: TangentialLaw>(
        self,
        pass: ContactPass<M, A, L, T>,
    ) {
        if self.world.model.ledger {
            self.add_contacts::<_, _, _, _, true>(pass);
        } else {
            self.add_contacts::<_, _, _, _, false>(pass);
        }
    }
}

impl<S: Number, N: NormalChoice<S>> AddForces<'_, S, N> {
    /// Add the forces of contacts, and begin and end contact memories.
    fn add_contacts<M: Metric, A: Arm, L: NormalLaw, T: TangentialLaw, const LEDGER: bool>(
        self,
        pass: ContactPass<M, A, L, T>,
    ) {
        let World {
            state,
            workspace,
            execution,
            ..
        } = self.world;
        let (Some(contacts), Some(neighbors)) = (&mut state.contacts, &workspace.neighbors) else {
            return;
        };
        let work = PairLoop {
            list_version: contacts.list_version(neighbors),
            sums: state.forces.sums(),
            bodies: Bodies {
                particles: &state.particles,
                inverse_mass: &workspace.inverse_mass,
            },
            forces: ContactForces::<_, _, _, _, _, LEDGER> {
                pass,
                first: 0,
                pairs: &contacts.pairs,
                memories: contacts.memories.columns(),
                bonds: state.bonds.as_ref(),
            },
        };
        execution.run_pairs::<_, _, LEDGER>(work, &mut workspace.parts, &mut state.bookings);
        for part in &workspace.parts {
            part.contacts.add_to(&mut state.forces.sums());
        }
    }
}

impl<S: Number, N: NormalChoice<S>> WithAmbientLaw for AddForces<'_, S, N> {
    fn call<L: AmbientLaw>(self, law: L) {
        let state = &mut self.world.state;
        let (particles, sums, bookings) =
            (&state.particles, &mut state.forces, &mut state.bookings);
        if self.world.model.ledger {
            forces::ambient::<_, _, true>(law, particles, sums, bookings);
        } else {
            forces::ambient::<_, _, false>(law, particles, sums, bookings);
        }
    }
}

impl<S: Number, N: NormalChoice<S>> WithExternalLaw for AddForces<'_, S, N> {
    type Output = ();
    fn call<L: ExternalLaw>(self, law: L) {
        let state = &mut self.world.state;
        forces::external(law, &state.particles, &mut state.forces);
    }
}
