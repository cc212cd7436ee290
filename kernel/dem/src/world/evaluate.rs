//! One evaluation: links, forces and the ledger's tally at the present positions and velocities.

use super::dispatch::{with_metric, with_strong_pass, with_weak_pass};
use super::{Number, World};
use crate::balance::Energy;
use crate::error::StepError;
use crate::forces::{self, BondLoop, ContactLoop, ContactPass, Interaction, PartWorkspace, Tally};
use crate::laws::{Controller, Driven};
use crate::model::{Ambient, External};
use gouge_common::geometry::Metric;
use gouge_common::instructions::Instructions;
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;
use gouge_common::parts::{Ready, Work};

/// Do work as a single part, and book.
fn whole<S: Lanes, D: Work<PartWorkspace<S>>>(
    work: D,
    desks: &mut [PartWorkspace<S>],
    tally: &mut Tally<S>,
    instructions: Instructions,
) {
    if let Some(desk) = desks.first_mut() {
        desk.tally = *tally;
        D::start(Ready {
            work,
            own: desk,
            instructions,
        });
        *tally = desk.tally;
    }
}

impl<S: Number> World<S> {
    /// Forces at the present positions and velocities; bonds break, contacts begin and end. Whether a step
    /// has passed since the previous evaluation decides what the drive and sums over steps gain.
    ///
    /// `forces_are_clear` tells that they are all zero.
    pub(super) fn evaluate(
        &mut self,
        advances: bool,
        forces_are_clear: bool,
    ) -> Result<(), StepError> {
        self.refresh_neighbors()?;
        if !forces_are_clear {
            self.forces.clear();
        }
        self.tally = Tally::default();
        self.add_strong_links();
        self.add_weak_links(advances);
        if let Some(strong) = &mut self.strong
            && !strong.broken.is_empty()
        {
            strong.remove_broken();
        }
        self.add_fields();
        self.add_driving(advances);
        if let Some(ledger) = &mut self.ledger {
            ledger.book(&self.tally);
        }
        Ok(())
    }

    /// Keep the neighbour list valid for the present positions; changes no motion.
    ///
    /// # Errors
    /// As [`check`](Self::check), if particles have moved far.
    pub fn refresh_neighbors(&mut self) -> Result<(), StepError> {
        if self.are_neighbors_stale() || self.weak.is_none() {
            self.check()?;
            let Self {
                model,
                particles,
                weak,
                strong,
                ..
            } = self;
            if let Some(weak) = weak {
                with_metric!(model, metric => weak.rebuild(metric, particles, strong.as_ref()));
            }
        }
        Ok(())
    }

    fn are_neighbors_stale(&mut self) -> bool {
        let Self {
            model,
            particles,
            weak,
            ..
        } = self;
        self.is_stale.take().unwrap_or_else(|| {
            with_metric!(model, metric => {
                weak.as_ref().is_none_or(|weak| weak.neighbors().are_stale(metric, &particles.position))
            })
        })
    }

    fn add_strong_links(&mut self) {
        let Self {
            model,
            particles,
            forces,
            strong,
            tally,
            desks,
            parts,
            instructions,
            ..
        } = self;
        let (Some(strong), Some(bond)) = (strong, model.bond) else {
            return;
        };
        let (sums, edition) = (forces.sums(), strong.edition());
        with_strong_pass!(model, bond, pass => {
            let links = strong.columns();
            if model.ledger {
                whole(BondLoop::<_, _, _, _, true> { pass, particles, links, edition, sums }, desks, tally, *instructions);
            } else {
                parts.run(BondLoop::<_, _, _, _, false> { pass, particles, links, edition, sums }, desks, *instructions);
            }
        });
        for desk in desks {
            desk.strong.arrive(&mut forces.sums());
            strong.broken.append(&mut desk.broken);
        }
    }

    fn add_weak_links(&mut self, advances: bool) {
        let Self {
            model,
            particles,
            forces,
            strong,
            weak,
            tally,
            desks,
            parts,
            instructions,
            ..
        } = self;
        let (Some(weak), Some(contact)) = (weak, model.contact) else {
            return;
        };
        let strong = strong.as_ref();
        if let Some(strong) = strong
            && !strong.broken.is_empty()
        {
            weak.admit_broken(strong);
        }
        let elapsed = if advances { model.time_step } else { 0.0 };
        let (sums, edition) = (forces.sums(), weak.edition());
        with_weak_pass!(model, contact, pass => {
            let pass = ContactPass { elapsed, ..pass };
            let (pairs, memories) = (&*weak.pairs, weak.memories.columns());
            if model.ledger {
                whole(ContactLoop::<_, _, _, _, _, true> { pass, particles, first: 0, pairs, memories, strong, edition, sums }, desks, tally, *instructions);
            } else {
                parts.run(ContactLoop::<_, _, _, _, _, false> { pass, particles, first: 0, pairs, memories, strong, edition, sums }, desks, *instructions);
            }
        });
        for desk in desks {
            desk.weak.arrive(&mut forces.sums());
        }
    }

    fn add_fields(&mut self) {
        let Self {
            model,
            particles,
            forces,
            tally,
            ..
        } = self;
        match (model.ambient, model.ledger) {
            (None, _) => {}
            (Some(Ambient::Creeping(law)), false) => {
                forces::ambient::<_, _, false>(law, particles, forces, tally)
            }
            (Some(Ambient::Creeping(law)), true) => {
                forces::ambient::<_, _, true>(law, particles, forces, tally)
            }
            (Some(Ambient::Correlation(law)), false) => {
                forces::ambient::<_, _, false>(law, particles, forces, tally)
            }
            (Some(Ambient::Correlation(law)), true) => {
                forces::ambient::<_, _, true>(law, particles, forces, tally)
            }
        }
        match model.external {
            None => {}
            Some(External::Gravity(law)) => forces::external(law, particles, forces),
            Some(External::HarmonicWell(law)) => forces::external(law, particles, forces),
        }
    }

    fn add_driving(&mut self, advances: bool) {
        let Self {
            model,
            particles,
            forces,
            tally,
            driven,
            drive,
            ..
        } = self;
        let Some(law) = model.driving else { return };
        let measured = Driven {
            known_velocity: drive.known_velocity,
            haste: model.integrator.haste(),
            ..forces::measure(particles, driven, forces)
        };
        drive.reaction = measured.reaction;
        let before = drive.force;
        if advances || law.controller == Controller::Exact {
            drive.force = law.next_force(before, &measured, model.time_step);
        }
        drive.applied = if model.integrator.evaluates_first() {
            before
        } else {
            drive.force
        };
        if model.ledger {
            forces::driving::<_, true>(drive.force, particles, driven, forces, tally);
        } else {
            forces::driving::<_, false>(drive.force, particles, driven, forces, tally);
        }
    }

    /// Find all pairs that may touch anew.
    pub(super) fn find_neighbors(&mut self) {
        let Self {
            model,
            particles,
            weak,
            strong,
            ..
        } = self;
        if let Some(weak) = weak {
            with_metric!(model, metric => weak.rebuild(metric, particles, strong.as_ref()));
        }
    }

    /// Number of pairs that overlap without being bonded.
    pub fn number_of_contacts(&self) -> usize {
        let Some(weak) = &self.weak else { return 0 };
        let p = &self.particles;
        let overlaps = |pair: &&Pair| {
            let (i, j) = pair.indices();
            let d = with_metric!(self.model, metric => metric.displacement(p.position[i], p.position[j]));
            let reach = p.radius[i] + p.radius[j];
            d.norm_squared() < reach * reach
        };
        weak.pairs.iter().filter(overlaps).count()
    }
    /// Every pair that interacts in the present state, in order, strong links after weak ones.
    pub fn links(&self) -> Vec<Interaction> {
        S::links(self)
    }

    pub(super) fn find_links(&self) -> Vec<Interaction> {
        let Self {
            model, particles, ..
        } = self;
        let mut states = Vec::new();
        if let (Some(weak), Some(contact)) = (&self.weak, model.contact) {
            with_weak_pass!(model, contact, pass => {
                states.extend(forces::inspection::weak(pass, particles, weak));
            });
        }
        if let (Some(strong), Some(bond)) = (&self.strong, model.bond) {
            with_strong_pass!(model, bond, pass => {
                states.extend(forces::inspection::strong(pass, particles, strong));
            });
        }
        states
    }

    /// The energies that are functions of the state, in J.
    pub(super) fn sum_state_energy(&self) -> Energy<S> {
        let Self {
            model, particles, ..
        } = self;
        let mut energy = Energy::of_particles(model, particles);
        if let (Some(weak), Some(contact)) = (&self.weak, model.contact) {
            energy.contact += with_weak_pass!(model, contact, pass => {
                forces::stored_in_contacts(pass, particles, weak)
            });
        }
        if let (Some(strong), Some(bond)) = (&self.strong, model.bond) {
            energy.contact += with_strong_pass!(model, bond, pass => {
                forces::stored_in_bonds(pass, particles, strong)
            });
        }
        energy
    }
}
