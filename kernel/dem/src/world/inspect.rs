//! The contacts and bonds of a world, for inspection and for estimators.

use super::choice::NormalChoice;
use super::dispatch::{WithBondPass, WithContactPass, with_bond_pass, with_contact_pass};
use super::simulation::{Number, World};
use super::state::State;
use crate::forces::{self, Bodies, BondPass, ContactPass, Interaction};
use crate::geometry::Arm;
use crate::laws::{BeamLaw, NormalLaw, TangentialLaw, YieldLaw};
use gouge_common::estimators::ContactNetwork;
use gouge_common::geometry::{Metric, WithMetric};
use gouge_common::pair::Pair;

impl<S: Number, N: NormalChoice<S>> World<S, N> {
    /// All contacts and bonds of the present state, contacts first; each sorted by pair.
    pub fn interactions(&self) -> Vec<Interaction> {
        N::interactions(self)
    }

    /// Implementation of [`Number::interactions`].
    #[doc(hidden)]
    pub fn find_interactions(&self) -> Vec<Interaction> {
        let (model, state) = (&self.model, &self.state);
        let bodies = self.bodies();
        let mut all = Vec::new();
        if let Some(laws) = model.contact {
            all.extend(with_contact_pass(
                model,
                laws,
                0.0,
                Inspect { state, bodies },
            ));
        }
        if let Some(laws) = model.bond {
            all.extend(with_bond_pass(model, laws, Inspect { state, bodies }));
        }
        all
    }

    /// The network of contacts and bonds, for estimators.
    pub fn contact_network(&self) -> ContactNetwork {
        ContactNetwork {
            particles: self.state.particles.len(),
            contacts: self.interactions().iter().map(Into::into).collect(),
        }
    }

    /// Number of pairs that overlap and are not bonded.
    pub fn number_of_contacts(&self) -> usize {
        self.touching_pairs().len()
    }

    /// The pairs that overlap and are not bonded.
    pub(super) fn touching_pairs(&self) -> Vec<Pair> {
        let state = &self.state;
        self.model.domain.with_metric(Overlaps { state })
    }
}

struct Inspect<'a, S> {
    state: &'a State<S>,
    bodies: Bodies<'a, S>,
}

impl<S: Number> WithContactPass for Inspect<'_, S> {
    type Output = Vec<Interaction>;
    fn call<M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw>(
        self,
        pass: ContactPass<M, A, N, T>,
    ) -> Vec<Interaction> {
        let contacts = self.state.contacts.as_ref();
        contacts.map_or_else(Vec::new, |contacts| {
            forces::contact_states(pass, self.bodies, contacts)
        })
    }
}

impl<S: Number> WithBondPass for Inspect<'_, S> {
    type Output = Vec<Interaction>;
    fn call<M: Metric, B: BeamLaw, Y: YieldLaw>(self, pass: BondPass<M, B, Y>) -> Vec<Interaction> {
        let bonds = self.state.bonds.as_ref();
        bonds.map_or_else(Vec::new, |bonds| {
            forces::bond_states(pass, self.bodies, bonds)
        })
    }
}

struct Overlaps<'a, S> {
    state: &'a State<S>,
}

impl<S: Number> WithMetric for Overlaps<'_, S> {
    type Output = Vec<Pair>;
    fn call<M: Metric>(self, metric: M) -> Vec<Pair> {
        let p = &self.state.particles;
        let overlaps = |pair: &&Pair| {
            let (i, j) = pair.indices();
            let d = metric.displacement(p.position[i], p.position[j]);
            let reach = p.radius[i] + p.radius[j];
            d.norm_squared() < reach * reach
        };
        let contacts = self.state.contacts.as_ref();
        let pairs = contacts.map_or(&[][..], |contacts| &contacts.pairs);
        pairs.iter().filter(overlaps).copied().collect()
    }
}
