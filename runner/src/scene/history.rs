//! What a state that was written as text knows of its past to the bit: masses, unstrained bonds, memories of contacts.
//!
//! `particles_file`, `bonds_file` and `contacts_file` have further columns for it, which a run writes for its restart.

use super::rows::{Row, Rows};
use super::table::Range;
use crate::error::SceneError;
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_dem::bonds::Rest;
use gouge_dem::contacts::ContactMemory;
use gouge_dem::geometry::{angle_of, reversed, wrapped};

type Result<T> = std::result::Result<T, SceneError>;

/// What files tell of the past besides the usual columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    /// Mass in kg and moment of inertia in kg m^2 per particle; empty if they follow from densities.
    pub inertia: Vec<[f64; 2]>,
    /// Unstrained states of bonds; empty if they follow from initial angles.
    pub rests: Vec<(Pair, Rest<f64>)>,
    /// Memories of all contacts; none if they follow from initial angles.
    pub memories: Option<Vec<(Pair, ContactMemory<f64>)>>,
}

/// Columns of masses and moments of inertia.
pub const INERTIA: [&str; 2] = ["mass", "moment_of_inertia"];
/// Columns of unstrained bonds.
pub const REST: [&str; 4] = ["reference_x", "reference_y", "rest_angle_i", "rest_angle_j"];
/// Columns of memories of contacts.
pub const MEMORY: [&str; 5] = [
    "reference_x",
    "reference_y",
    "memory_i",
    "memory_j",
    "history",
];
/// Columns of both initial angles, thesis (30).
pub const INITIAL_ANGLES: [&str; 2] = ["initial_angle_i", "initial_angle_j"];
/// Columns that a run writes for its reader only.
pub const FORCES: [&str; 2] = ["normal_force", "tangential_force"];

/// Largest difference in rad between an initial angle and the same angle in other columns.
const AGREEMENT: f64 = 1e-6;

/// Whether a file has the columns of this module.
pub fn is_exact(rows: &Rows) -> Result<bool> {
    let header = rows.header()?;
    let names = INERTIA.iter().chain(&REST).chain(&MEMORY);
    let mut names = names.copied();
    Ok(names.any(|name| header.iter().any(|own| own == name)))
}

/// Mass and moment of inertia of a row.
pub fn inertia(row: &Row) -> Result<[f64; 2]> {
    Ok([
        row.number(INERTIA[0], Range::Positive)?,
        row.number(INERTIA[1], Range::Positive)?,
    ])
}

/// The unstrained state of a bond; its distance is that of the usual column.
pub fn rest(row: &Row) -> Result<(Pair, Rest<f64>)> {
    let rest = Rest {
        reference: reference(row)?,
        angles: [
            row.number(REST[2], Range::Finite)?,
            row.number(REST[3], Range::Finite)?,
        ],
        distance: row.number("initial_distance", Range::Positive)?,
    };
    check_angles(row, rest.reference, rest.angles)?;
    Ok((ordered(row)?, rest))
}

/// The memory of a contact.
pub fn memory(row: &Row) -> Result<(Pair, ContactMemory<f64>)> {
    let memory = ContactMemory {
        touches: true,
        reference: reference(row)?,
        ends: [
            row.number(MEMORY[2], Range::Finite)?,
            row.number(MEMORY[3], Range::Finite)?,
        ],
        state: row.number(MEMORY[4], Range::Finite)?,
    };
    check_angles(row, memory.reference, memory.ends)?;
    Ok((ordered(row)?, memory))
}

fn reference(row: &Row) -> Result<Vec2> {
    let reference = Vec2::new(
        row.number(REST[0], Range::Finite)?,
        row.number(REST[1], Range::Finite)?,
    );
    match (reference.norm() - 1.0).abs() < AGREEMENT {
        true => Ok(reference),
        false => Err(row.error(REST[0], "must be the component of a unit vector")),
    }
}

fn ordered(row: &Row) -> Result<Pair> {
    let [i, j] = row.pair()?;
    match i < j {
        true => Ok(Pair::new(i, j)),
        false => Err(row.error(
            "j",
            "must be greater than i, because the reference points from i to j",
        )),
    }
}

/// Initial angles in the pair frame along a reference, from the angles of both particles.
pub fn initial_angles(reference: Vec2, angles: [f64; 2]) -> [f64; 2] {
    let frame = angle_of(reference);
    [
        wrapped(angles[0] - frame),
        wrapped(angles[1] - reversed(frame)),
    ]
}

/// Check that the initial angles of a row, if it has them, are those of its other columns.
fn check_angles(row: &Row, reference: Vec2, angles: [f64; 2]) -> Result<()> {
    let expected = initial_angles(reference, angles);
    for (name, expected) in INITIAL_ANGLES.into_iter().zip(expected) {
        if row.cell(name).is_none() {
            continue;
        }
        let given = row.number(name, Range::Finite)?;
        if wrapped(given - expected).abs() > AGREEMENT {
            let accepted = format!(
                "must be {expected:?}, as the reference and the angle of this end say, or absent"
            );
            return Err(row.error(name, &accepted));
        }
    }
    Ok(())
}
