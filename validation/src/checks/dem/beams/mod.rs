//! Bonded particles as beams.

mod breaking;
mod cantilever;
mod chain;
mod conservation;
mod elastica;
mod modes;
mod oscillation;
mod packing;
mod stiffness;
mod tension;
mod waves;

use crate::checks::Topic;

/// The topic.
pub fn topic() -> Topic {
    let parts = [
        modes::checks(),
        cantilever::checks(),
        elastica::checks(),
        chain::checks(),
        waves::checks(),
        tension::checks(),
        packing::checks(),
        breaking::checks(),
        conservation::checks(),
    ];
    Topic {
        id: "beams",
        title: "Bonds as beams",
        about: "Modes, statics, waves and breaking of bonded particles, compared with independently solved linear networks, lattice elasticity and beam theory.",
        checks: parts.into_iter().flatten().collect(),
    }
}
