//! Estimators, the preparation of initial states, and the properties of particles and solid.

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
        title: "Estimators",
        about: "What is read from a state, and how initial states are made: disorder, fragments, friction, stress and packing; sizes, lattices, bonds and faults; mass, inertia and moduli.",
        checks,
    }
}
