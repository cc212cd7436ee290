//! The memory of a world, in the terms of a scene.

use gouge_common::geometry::{Metric, Open, PeriodicX, Vec2};
use gouge_common::pair::Pair;
use gouge_dem::bonds::{Bond, BondStart};
use gouge_dem::contacts::{ContactMemory, ContactStart};
use gouge_dem::geometry::{PairFrame, angle_of, reversed, turn};
use gouge_dem::model::ContactTangential;
use gouge_dem::{Start, World};

/// Bonds, contacts and driving force with which a new world at the present state continues like this
/// one, up to rounding.
pub fn start(world: &World) -> Start {
    let p = world.particles();
    let strong = world.bonds().into_iter().flat_map(|strong| strong.iter());
    let touches = |pair: &Pair| {
        let (i, j) = pair.indices();
        frame(world, *pair).distance < p.radius[i] + p.radius[j]
    };
    let weak = world
        .contacts()
        .into_iter()
        .flat_map(|weak| weak.remembered());
    Start {
        bonds: strong.map(|link| bond(world, &link)).collect(),
        contacts: weak
            .filter(|(pair, _)| touches(pair))
            .map(|(pair, memory)| contact(world, pair, &memory))
            .collect(),
        drive_force: world.drive().force,
    }
}

fn frame(world: &World, pair: Pair) -> PairFrame<f64> {
    let (i, j) = pair.indices();
    let (a, b) = (world.particles().position[i], world.particles().position[j]);
    PairFrame::new(match world.model().period() {
        Some(length) => PeriodicX { length }.displacement(a, b),
        None => Open.displacement(a, b),
    })
}

/// Angles of both ends in the frame of the pair when the contact or bond began.
fn initial_angles(world: &World, pair: Pair, reference: Vec2, rest: [f64; 2]) -> [f64; 2] {
    let normal = frame(world, pair).normal;
    let (turned, _) = turn(reference, normal);
    let lambda = angle_of(normal);
    [
        rest[0] + turned - lambda,
        rest[1] + turned - reversed(lambda),
    ]
}

fn bond(world: &World, link: &Bond<f64>) -> BondStart {
    let (i, j) = link.pair.indices();
    BondStart {
        between: [i, j],
        strength_factor: link.strength_factor,
        initial_distance: Some(link.rest.distance),
        initial_angles: Some(initial_angles(
            world,
            link.pair,
            link.rest.reference,
            link.rest.angles,
        )),
    }
}

/// The slip of a truncated spring is represented as a smaller rotation of both ends.
fn contact(world: &World, pair: Pair, memory: &ContactMemory<f64>) -> ContactStart {
    let (i, j) = pair.indices();
    let slip = match world.model().contact.and_then(|contact| contact.tangential) {
        Some(ContactTangential::CundallStrackTruncated(_)) => memory.state,
        _ => 0.0,
    };
    let turned = slip / (world.particles().radius[i] + world.particles().radius[j]);
    let angles = initial_angles(world, pair, memory.reference, memory.ends);
    ContactStart {
        between: [i, j],
        initial_angles: angles.map(|angle| angle + turned),
    }
}
