//! Options of a case: switches, and velocities of the walls. What cannot be honoured is refused.

use crate::error::Fault;
use crate::fields::Fields;
use serde_json::Value;

/// Keys of `conf` with a meaning, besides velocities of walls.
const CONF: [&str; 9] = [
    "timesteps",
    "modulo",
    "dt",
    "enable_fracture",
    "self_contact",
    "allow_damping",
    "allow_friction",
    // How the other program runs, not what it computes.
    "is_parallel",
    "save_file",
];
/// Keys of `contact`.
const CONTACT: [&str; 4] = ["R_c", "K_n", "r_d", "mu"];
/// Keys of a grain.
const GRAIN: [&str; 21] = [
    "x",
    "y",
    "V",
    "rho",
    "eps",
    "c",
    "s0",
    "vx",
    "vy",
    "ax",
    "ay",
    "force_density_x",
    "force_density_y",
    "bonds",
    "n_bonds",
    "clamped",
    "movable",
    "breakable",
    // For people, or for the other program.
    "first_node",
    "name",
    "note",
];
/// Names of the walls, in their order.
const WALLS: [&str; 4] = ["left", "right", "top", "bottom"];

/// Whether a key gives velocities of walls.
fn is_velocity(key: &str) -> bool {
    key.contains("speed") || key.contains("velocity")
}

/// Refuse options that are on and have no meaning here.
pub(super) fn require_known(conf: &Fields, contact: &Fields) -> Result<(), Fault> {
    let require = |fields: &Fields, known: &[&str]| {
        let is_on = |key: &&String| {
            let value = fields.value().get(key.as_str());
            let is_off = |value: &Value| {
                matches!(value, Value::Null | Value::Bool(false)) || value.as_f64() == Some(0.0)
            };
            !known.contains(&key.as_str()) && !is_velocity(key) && !value.is_some_and(is_off)
        };
        let mut keys = fields
            .value()
            .as_object()
            .into_iter()
            .flat_map(|keys| keys.keys());
        match keys.find(is_on) {
            None => Ok(()),
            Some(key) => Err(fields.refuse_key(
                key,
                format!("0 or absent: only {} have a meaning", known.join(", ")),
            )),
        }
    };
    require(conf, &CONF)?;
    require(contact, &CONTACT)
}

/// Keys of a grain that have a value and no meaning.
pub(super) fn without_meaning(grain: &Fields) -> Vec<String> {
    let keys = grain.value().as_object().into_iter().flatten();
    let unknown = keys.filter(|(key, value)| !GRAIN.contains(&key.as_str()) && !value.is_null());
    unknown.map(|(key, _)| key.clone()).collect()
}

/// Velocities of the walls: a list in their order, or a key per wall, whose names have `speed` or `velocity` in them.
pub(super) fn wall_velocity(case: &Fields, conf: &Fields) -> Result<[f64; 4], Fault> {
    let mut velocity = [0.0; 4];
    for fields in [case, conf] {
        let keys = fields
            .value()
            .as_object()
            .into_iter()
            .flat_map(|keys| keys.keys());
        for key in keys.filter(|key| is_velocity(key)) {
            let Some(value) = fields.optional(key) else {
                continue;
            };
            let is_of = |wall: &&str| key.contains(*wall);
            let named: Vec<_> = (0..4).filter(|&k| is_of(&WALLS[k])).collect();
            match named.as_slice() {
                [wall] => velocity[*wall] = value.as_number()?,
                _ => velocity = value.as_array()?,
            }
        }
    }
    Ok(velocity)
}
