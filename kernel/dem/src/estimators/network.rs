//! What general estimators see of a world.

use crate::world::{Number, World};
use gouge_common::estimators::{ContactNetwork, Fragments, NetworkContact, connected};

/// Every contact and bond of a world, contacts first, each in the order of pairs.
pub fn contact_network<S: Number>(world: &World<S>) -> ContactNetwork {
    let contact = |link: crate::forces::Interaction| {
        let (normal, tangent) = (link.normal, link.normal.perpendicular());
        NetworkContact {
            pair: link.pair,
            branch: normal * link.distance,
            force: normal * link.normal_force + tangent * link.tangential_force,
        }
    };
    ContactNetwork {
        particles: world.particles().len(),
        contacts: world.links().into_iter().map(contact).collect(),
    }
}

/// What the bonds of a world hold together; a particle without bonds is a fragment of its own.
pub fn fragments<S: Number>(world: &World<S>) -> Fragments {
    let pairs = world.bonds().map_or(&[][..], |bonds| bonds.pairs());
    connected(
        world.particles().len(),
        pairs.iter().map(|pair| pair.indices()),
    )
}
