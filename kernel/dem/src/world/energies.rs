//! The energies of a world.

use super::choice::NormalChoice;
use super::dispatch::{
    WithBondPass, WithContactPass, WithExternalLaw, with_bond_pass, with_contact_pass,
    with_external_law,
};
use super::simulation::{Number, World};
use super::state::State;
use crate::balance::Energy;
use crate::forces::{Bodies, BondPass, ContactPass};
use crate::geometry::Arm;
use crate::laws::{BeamLaw, ExternalLaw, NormalLaw, TangentialLaw, YieldLaw};
use gouge_common::geometry::Metric;

impl<S: Number, N: NormalChoice<S>> World<S, N> {
    /// All terms of the energy balance in J, thesis (72). Without a ledger, heat, work and residual are zero.
    pub fn energy(&self) -> Energy<S> {
        let energy = N::state_energy(self);
        match &self.state.ledger {
            Some(ledger) => ledger.balance(energy),
            None => energy,
        }
    }

    /// Work of the horizontal driving force since t = 0, and the integral of the load over the slip of the driven
    /// particles, both in J: their ratio is the mean coefficient of friction. None without a ledger.
    pub fn shearing_and_sliding(&self) -> Option<[S; 2]> {
        let ledger = self.state.ledger.as_ref();
        ledger.map(|ledger| [ledger.shearing, ledger.sliding])
    }

    /// Implementation of [`Number::state_energy`].
    #[doc(hidden)]
    pub fn sum_state_energy(&self) -> Energy<S> {
        let (model, state) = (&self.model, &self.state);
        let bodies = self.bodies();
        let stored = || Stored { state, bodies };
        let mut energy = Energy::kinetic_of(&state.particles);
        if let Some(external) = model.external {
            energy.external = with_external_law(external, stored());
        }
        if let Some(laws) = model.contact {
            energy.contact += with_contact_pass(model, laws, 0.0, stored());
        }
        if let Some(laws) = model.bond {
            energy.contact += with_bond_pass(model, laws, stored());
        }
        energy
    }
}

impl<S: Number> WithExternalLaw for Stored<'_, S> {
    type Output = S;
    fn call<L: ExternalLaw>(self, law: L) -> S {
        let p = &self.state.particles;
        let mut sum = S::zero();
        for i in (0..p.len()).filter(|&i| !p.is_fixed(i)) {
            sum += law.potential(p.mass[i], p.position[i]);
        }
        sum
    }
}

/// Energy stored in contacts, in bonds or in the external potential, in J.
struct Stored<'a, S> {
    state: &'a State<S>,
    bodies: Bodies<'a, S>,
}

impl<S: Number> WithContactPass for Stored<'_, S> {
    type Output = S;
    fn call<M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw>(
        self,
        pass: ContactPass<M, A, N, T>,
    ) -> S {
        let contacts = self.state.contacts.as_ref();
        contacts.map_or(S::zero(), |contacts| {
            pass.total_stored_energy(self.bodies, contacts)
        })
    }
}

impl<S: Number> WithBondPass for Stored<'_, S> {
    type Output = S;
    fn call<M: Metric, B: BeamLaw, Y: YieldLaw>(self, pass: BondPass<M, B, Y>) -> S {
        let bonds = self.state.bonds.as_ref();
        bonds.map_or(S::zero(), |bonds| {
            pass.total_stored_energy(self.bodies, bonds)
        })
    }
}
