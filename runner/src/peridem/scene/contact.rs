//! `[contact]` and `[walls]`.

use super::materials::refused;
use super::{Result, Scene};
use crate::scene::table::{Range, Table};
use gouge_peridem::contact_law::{ContactLaw, ContactReading, ContactStiffness};
use gouge_peridem::contacts::Contact;
use gouge_peridem::error::SetupError;
use gouge_peridem::forces::Walls;
use gouge_peridem::mode::Mode;
use gouge_peridem::wall_law::{WallLaw, WallReading};

/// Names of the walls, in the order of the kernel.
pub const WALLS: [&str; 4] = ["left", "right", "top", "bottom"];

/// `[contact]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactTable {
    /// Repulsion, damping and friction.
    pub law: ContactLaw,
    /// How the stiffness follows from the materials.
    pub stiffness: ContactStiffness,
    /// Whether the sticking force of a node is shared among its contacts.
    pub shares_sticking: bool,
    /// Whether nodes of one grain without a bond repel each other.
    pub touches_itself: bool,
    /// Whether the radius may be so small that grains pass through each other.
    pub is_forced: bool,
}

/// `[walls]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallTable {
    /// Positions in m of the left, right, top and bottom wall; infinite if there is none.
    pub position: [f64; 4],
    /// Their velocities in m/s.
    pub velocity: [f64; 4],
    /// The law of the force.
    pub reading: WallReading,
    /// Stiffness in N/m^6, if the scene gives it.
    pub stiffness: Option<f64>,
}

/// Read `[contact]`.
pub(super) fn contact(root: &Table, mode: Mode) -> Result<Option<ContactTable>> {
    let Some(table) = root.optional_law("contact")? else {
        return Ok(None);
    };
    table.allow(&[
        "radius",
        "friction",
        "damping_ratio",
        "stiffness",
        "reading",
        "share_sticking",
        "self_contact",
        "forced",
    ])?;
    let readings = [
        ("symmetric", ContactReading::Symmetric),
        ("one-sided", ContactReading::OneSided),
        ("authors", ContactReading::Authors),
        ("printed", ContactReading::Printed),
    ];
    let law = ContactLaw {
        radius: table.number("radius", Range::Positive)?,
        friction: optional(&table, "friction")?,
        damping_ratio: optional(&table, "damping_ratio")?,
        reading: table
            .optional_choice("reading", &readings)?
            .unwrap_or(mode.contact()),
    };
    if law.damping_ratio > 1.0 {
        return Err(table.error("damping_ratio", "must be a number from 0 to 1"));
    }
    let truth = |key, default| Ok(table.optional_truth(key)?.unwrap_or(default));
    Ok(Some(ContactTable {
        law,
        stiffness: stiffness(&table)?,
        shares_sticking: truth("share_sticking", mode == Mode::Corrected)?,
        touches_itself: truth("self_contact", true)?,
        is_forced: truth("forced", false)?,
    }))
}

fn optional(table: &Table, key: &str) -> Result<f64> {
    let given = table.optional_number(key, Range::NonNegative)?;
    Ok(given.unwrap_or(0.0))
}

fn stiffness(table: &Table) -> Result<ContactStiffness> {
    let key = "stiffness";
    let names = [
        ("from-bonds", ContactStiffness::FromBonds),
        ("published", ContactStiffness::Published),
        ("printed", ContactStiffness::Printed),
    ];
    if !table.has(key) {
        return Ok(ContactStiffness::default());
    }
    let accepted =
        "must be one of: from-bonds, published, printed, or a number greater than zero in N/m^6";
    let read = match table.has_text(key) {
        true => table.choice(key, &names),
        false => table
            .number(key, Range::Positive)
            .map(ContactStiffness::Given),
    };
    read.map_err(|_| table.error(key, accepted))
}

/// Read `[walls]`, whose coefficients are those of `[contact]`.
pub(super) fn walls(
    root: &Table,
    mode: Mode,
    contact: Option<&ContactTable>,
) -> Result<Option<WallTable>> {
    let Some(table) = root.optional_law("walls")? else {
        return Ok(None);
    };
    let Some(contact) = contact else {
        return Err(root.error(
            "walls",
            "needs [contact], which has the coefficients of walls",
        ));
    };
    table.allow(&[&WALLS[..], &["velocity", "law", "stiffness"]].concat())?;
    let far = [
        f64::NEG_INFINITY,
        f64::INFINITY,
        f64::INFINITY,
        f64::NEG_INFINITY,
    ];
    let mut position = far;
    for (wall, name) in WALLS.into_iter().enumerate() {
        let given = table.optional_number(name, Range::Finite)?;
        position[wall] = given.unwrap_or(far[wall]);
    }
    if position == far {
        let accepted = "must have the position of at least one of: left, right, top, bottom";
        return Err(root.error("walls", accepted));
    }
    let laws = [
        ("paper", WallReading::Paper),
        ("exact", WallReading::Exact),
        ("two_fixes", WallReading::TwoFixes),
        ("authors", WallReading::Authors),
    ];
    let law = table.optional_choice("law", &laws)?;
    let walls = WallTable {
        position,
        velocity: velocities(&table, &position)?,
        reading: law.unwrap_or(mode.walls()),
        stiffness: table.optional_number("stiffness", Range::Positive)?,
    };
    if walls
        .stiffness
        .is_some_and(|stiffness| !(1e-100..=1e100).contains(&stiffness))
    {
        return Err(table.error("stiffness", "must be a number from 1e-100 to 1e100"));
    }
    let acting = walls.with_stiffness(1.0, &contact.law);
    let checked = acting.validate(&position);
    checked.map_err(|error| root.error("walls", &error.to_string()))?;
    let end = root.table("time")?.number("end", Range::Positive)?;
    let moved = std::array::from_fn(|wall| position[wall] + walls.velocity[wall] * end);
    let checked = acting.validate(&moved);
    checked.map_err(|error| table.error("velocity", &format!("at time.end, {error}")))?;
    Ok(Some(walls))
}

/// The velocities in m/s of walls at positions in m.
fn velocities(table: &Table, position: &[f64; 4]) -> Result<[f64; 4]> {
    let mut velocity = [0.0; 4];
    if let Some(moving) = table.optional_table("velocity")? {
        moving.allow(&WALLS)?;
        for (wall, name) in WALLS.into_iter().enumerate() {
            let given = moving.optional_number(name, Range::Finite)?;
            if given.is_some() && position[wall].is_infinite() {
                return Err(moving.error(name, "is the velocity of a wall that does not exist"));
            }
            velocity[wall] = given.unwrap_or(0.0);
        }
    }
    Ok(velocity)
}

impl WallTable {
    fn with_stiffness(&self, stiffness: f64, law: &ContactLaw) -> Walls {
        Walls {
            law: WallLaw {
                radius: law.radius,
                stiffness,
                damping_ratio: law.damping_ratio,
                friction: law.friction,
                reading: self.reading,
            },
            velocity: self.velocity,
        }
    }

    /// The walls among grains that touch in this way: as stiff as the stiffest contact between two of them, unless the
    /// scene gives the stiffness.
    pub fn among(&self, contact: &Contact) -> Walls {
        let all = contact.stiffness.iter().flatten();
        let stiffest = all.copied().fold(0.0, f64::max);
        self.with_stiffness(self.stiffness.unwrap_or(stiffest), &contact.law)
    }
}

impl ContactTable {
    /// Contact between the materials of the grains.
    ///
    /// # Errors
    /// Numbers that the kernel refuses.
    pub fn between(&self, scene: &Scene) -> std::result::Result<Contact, SetupError> {
        let radius = self.law.radius;
        let is_used = |material: usize| scene.grains.iter().any(|one| one.material == material);
        let between = |first: usize, second: usize| {
            if !is_used(first) || !is_used(second) {
                return Ok(f64::NAN);
            }
            let [first, second] =
                [first, second].map(|one| scene.materials[one].contact(&scene.bonds));
            self.stiffness.between(&first, &second, radius)
        };
        let number = scene.materials.len();
        let row = |first| (0..number).map(|second| between(first, second)).collect();
        Ok(Contact {
            law: self.law,
            stiffness: (0..number)
                .map(row)
                .collect::<std::result::Result<_, _>>()?,
            shares_sticking: self.shares_sticking,
        })
    }
}

/// Check that all materials have what the stiffness of contacts needs.
pub(super) fn check_stiffness(root: &Table, contact: &ContactTable, scene: &Scene) -> Result<()> {
    let needs_bulk = matches!(
        contact.stiffness,
        ContactStiffness::Published | ContactStiffness::Printed
    );
    let table = root.table("contact")?;
    for grain in &scene.grains {
        let material = &scene.materials[grain.material];
        if needs_bulk && material.bulk_modulus.is_none() {
            let accepted = format!("needs materials.{}.bulk_modulus", material.name);
            return Err(table.error("stiffness", &accepted));
        }
        let valid = contact.law.validate();
        valid.map_err(|error| refused(root, material, &error))?;
        let own = material.contact(&scene.bonds);
        let stiffness = contact.stiffness.between(&own, &own, contact.law.radius);
        stiffness.map_err(|error| refused(root, material, &error))?;
    }
    let made = contact.between(scene);
    made.map(drop)
        .map_err(|error| table.error("stiffness", &error.to_string()))
}
