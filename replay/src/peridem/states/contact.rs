//! Contact of two nodes.

use super::constants::object;
use super::{Found, Sheet, two_nodes};
use crate::error::Fault;
use crate::fields::Fields;
use crate::peridem::refusals::{CONTACT, of_parameter};
use gouge_common::geometry::Vec2;
use gouge_peridem::contact_law::{
    ContactForce, ContactLaw, ContactReading, FrictionStep, Motion, Node, NodePair,
};
use gouge_peridem::mode::Mode;
use serde_json::{Value, json};

/// Lists of cases.
pub(super) const LISTS: [&str; 4] = [
    "node_node",
    "self_contact",
    "two_node_collision",
    "two_node_bond",
];

const NODE_NODE: [&str; 12] = [
    "px", "py", "vx", "vy", "Vx", "Vy", "rho", "K_n", "R_c", "mu", "r_d", "dt",
];
const SELF_CONTACT: [&str; 6] = ["c", "R_c", "reference_distance", "distance", "Vx", "Vy"];
const COLLISION: [&str; 8] = [
    "reading",
    "R_c",
    "K_n",
    "rho",
    "V",
    "relative_speed",
    "r_d",
    "note",
];
const BOND: [&str; 7] = ["weight", "c", "s0", "length", "eps", "V", "rho"];

/// Readings of the contact of nodes by name.
const READINGS: [(&str, ContactReading); 3] = [
    ("symmetric", ContactReading::Symmetric),
    ("one_sided", ContactReading::OneSided),
    ("authors", ContactReading::Authors),
];

pub(super) fn solve(sheet: &mut Sheet, mode: Mode) -> Result<(), Fault> {
    sheet.solve("node_node", &NODE_NODE, node_node)?;
    sheet.solve("self_contact", &SELF_CONTACT, self_contact)?;
    sheet.solve("two_node_collision", &COLLISION, |case| {
        two_nodes::collision(case, reading(case, mode)?)
    })?;
    sheet.solve("two_node_bond", &BOND, two_nodes::bond)
}

/// The reading of a case, or that of the mode if the case has none.
fn reading(case: &Fields, mode: Mode) -> Result<ContactReading, Fault> {
    if case.optional("reading").is_none() {
        return Ok(mode.contact());
    }
    let name = case.word("reading", &READINGS.map(|(name, _)| name))?;
    let found = READINGS.iter().find(|(known, _)| *known == name);
    Ok(found.map_or(ContactReading::Symmetric, |&(_, reading)| reading))
}

fn node_node(case: &Fields) -> Result<Found, Fault> {
    let node = |area: &str| {
        Ok::<_, Fault>(Node {
            area: case.usable(area)?,
            density: case.usable("rho")?,
        })
    };
    let on_x = NodePair {
        separation: case.vector("py")? - case.vector("px")?,
        velocity: case.vector("vx")? - case.vector("vy")?,
        x: node("Vx")?,
        y: node("Vy")?,
    };
    let on_y = NodePair {
        separation: -on_x.separation,
        velocity: -on_x.velocity,
        x: on_x.y,
        y: on_x.x,
    };
    let step = FrictionStep {
        time_step: case.positive("dt")?,
        stick_share: 1.0,
    };
    let stiffness = case.usable("K_n")?;
    let mut found = Found::new();
    for (name, reading) in READINGS {
        let law = ContactLaw {
            radius: case.usable("R_c")?,
            damping_ratio: case.not_negative("r_d")?,
            friction: case.not_negative("mu")?,
            reading,
        };
        let validated = law.validate();
        validated.map_err(|error| of_parameter(case, &CONTACT, error))?;
        let spring = law.between_grains(stiffness);
        let force = |pair: &NodePair| parts(pair, &law.force(pair, &spring, &step));
        let forces = json!({"on_x": force(&on_x), "on_y": force(&on_y)});
        found.insert(name.to_owned(), forces);
    }
    Ok(found)
}

fn parts(pair: &NodePair, force: &ContactForce) -> Value {
    let branch = match force.motion {
        Motion::Separate => "none",
        Motion::Stick => "stick",
        Motion::Slip => "slip",
    };
    let vector = |value: Vec2| [value.x, value.y];
    json!({
        "d": pair.separation.norm(),
        "repulsion": vector(force.repulsion),
        "damping": vector(force.damping),
        "friction": vector(force.friction),
        "branch": branch,
    })
}

fn self_contact(case: &Fields) -> Result<Found, Fault> {
    let node = |area: &str| {
        Ok::<_, Fault>(Node {
            area: case.usable(area)?,
            density: 1.0,
        })
    };
    let pair = NodePair {
        separation: Vec2::new(case.positive("distance")?, 0.0),
        velocity: Vec2::zero(),
        x: node("Vx")?,
        y: node("Vy")?,
    };
    let law = ContactLaw {
        radius: case.usable("R_c")?,
        damping_ratio: 0.0,
        friction: 0.0,
        reading: ContactReading::Symmetric,
    };
    let spring = law.within_grain(case.usable("c")?, case.positive("reference_distance")?);
    let step = FrictionStep {
        time_step: 1.0,
        stick_share: 1.0,
    };
    let force = law.force(&pair, &spring, &step);
    Ok(object([("repulsion", (0.0 - force.repulsion.x).into())]))
}
