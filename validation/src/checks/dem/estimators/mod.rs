//! Estimators, the preparation of initial states, and the properties of particles and of the solid.

mod contacts;
mod forces;
mod fragments;
mod links;
mod matter;
mod radial;
mod setup;

use crate::checks::Topic;

/// The topic.
pub fn topic() -> Topic {
    let mut checks = radial::checks();
    checks.extend(forces::checks());
    checks.extend(links::checks());
    checks.extend(contacts::checks());
    checks.extend(fragments::checks());
    checks.extend(setup::checks());
    checks.extend(matter::checks());
    Topic {
        id: "estimators",
        title: "Estimators and initial states",
        about: "Estimators of a state: disorder, fragments, friction, stress and packing. Preparation of initial states: sizes, lattices, bonds and faults. Properties: mass, inertia and moduli.",
        checks,
    }
}
