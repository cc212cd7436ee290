//! `[setup]`, `[cell]` and `[shear]`: packings between two walls, and what is done to them.

use super::Result;
use crate::scene::table::{Range, Table};
use gouge_contact_dynamics::cell::{Drive, Speed};
use gouge_contact_dynamics::preparation::DiameterRange;

/// `[setup]`: deposit circles, inscribe bodies, compact them without friction, glue what is near the walls.
#[derive(Clone, Debug, PartialEq)]
pub struct PackingTable {
    /// Seed of all random numbers.
    pub seed: u64,
    /// Number of bodies.
    pub bodies: usize,
    /// Number of sides of regular polygons; none for discs.
    pub sides: Option<usize>,
    /// Diameters of the circumscribed circles.
    pub sizes: Sizes,
    /// How the packing is compacted.
    pub compaction: Compaction,
    /// What is glued to the walls.
    pub glue: Glue,
}

/// Diameters of circumscribed circles, uniform by volume.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes(DiameterRange);

impl Sizes {
    /// The range of diameters.
    pub fn range(self) -> DiameterRange {
        self.0
    }
}

/// `[setup.compaction]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compaction {
    /// Time step in s.
    pub step: f64,
    /// Load, speed limit and end.
    pub drive: Drive,
    /// Friction between all bodies, which is usually none.
    pub friction: f64,
    /// Largest change of an impulse in mean impulses.
    pub tolerance: f64,
    /// Most sweeps of a step.
    pub max_sweeps: usize,
    /// Most steps.
    pub max_steps: u64,
    /// Mass per width of the roof in kg/m.
    pub roof_mass: f64,
}

/// `[setup.glue]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glue {
    /// Largest distance in m between a body and the wall to which it is glued.
    pub distance: f64,
}

/// `[cell]`: a fixed floor at y = 0 and a roof above the bodies that the scene lists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellTable {
    /// Height of the roof in m.
    pub height: f64,
    /// Mass of the roof in kg, with what is glued to it.
    pub roof_mass: f64,
}

/// `[shear]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearTable {
    /// Stress on the roof in Pa.
    pub normal_stress: f64,
    /// Its horizontal velocity.
    pub speed: Speed,
}

impl ShearTable {
    /// What the kernel needs of it.
    pub fn drive(&self) -> Drive {
        Drive::Shear {
            normal_stress: self.normal_stress,
            speed: self.speed,
        }
    }
}

/// Most bodies of a packing.
const MOST_BODIES: u64 = 10_000_000;
/// Most sides of a polygon.
pub(super) const MOST_SIDES: u64 = 10_000;

pub(super) fn packing(root: &Table, density: f64, step: f64) -> Result<Option<PackingTable>> {
    let Some(table) = root.optional_table("setup")? else {
        return Ok(None);
    };
    table.allow(&[
        "seed",
        "particles",
        "sides",
        "mean_diameter",
        "size_ratio",
        "sizes",
        "compaction",
        "glue",
    ])?;
    let missing = |key: &str| table.error(key, "missing; must be a whole number");
    let bodies = table.optional_whole_within("particles", 1, MOST_BODIES)?;
    let sizes = sizes(&table)?;
    Ok(Some(PackingTable {
        seed: table
            .optional_whole("seed")?
            .ok_or_else(|| missing("seed"))?,
        bodies: bodies.ok_or_else(|| missing("particles"))? as usize,
        sides: sides(&table)?,
        sizes,
        compaction: compaction(&table, density, step, sizes.range().mean())?,
        glue: Glue {
            distance: table
                .table("glue")?
                .number("distance", Range::NonNegative)?,
        },
    }))
}

/// The number of sides; none for a disc, which is written as 0.
pub(super) fn sides(table: &Table) -> Result<Option<usize>> {
    let accepted = "must be a whole number of at least 3, or 0 for a disc";
    let sides = table.optional_whole_within("sides", 0, MOST_SIDES)?;
    match sides {
        Some(0) => Ok(None),
        Some(1 | 2) => Err(table.error("sides", accepted)),
        Some(sides) => Ok(Some(sides as usize)),
        None => Err(table.error("sides", &format!("missing; {accepted}"))),
    }
}

fn sizes(table: &Table) -> Result<Sizes> {
    let mean = table.number("mean_diameter", Range::Positive)?;
    let rules = [("mean-exact", true), ("printed", false)];
    let is_exact = table.optional_choice("sizes", &rules)?.unwrap_or(true);
    let ratio = table.optional_number("size_ratio", Range::Positive)?;
    let refused = |key: &str, reason: String| table.error(key, &reason);
    if !is_exact {
        if ratio.is_some() {
            return Err(table.error("size_ratio", "has no meaning for sizes = \"printed\""));
        }
        let range = DiameterRange::printed(mean);
        return Ok(Sizes(
            range.map_err(|error| refused("mean_diameter", error.to_string()))?,
        ));
    }
    let ratio = ratio.ok_or_else(|| table.error("size_ratio", "missing; must be at least 1"))?;
    let range = DiameterRange::with_mean(mean, ratio);
    let range = range.map_err(|error| refused("size_ratio", error.to_string()))?;
    Ok(Sizes(range))
}

fn compaction(setup: &Table, density: f64, step: f64, diameter: f64) -> Result<Compaction> {
    let table = setup.table("compaction")?;
    table.allow(&[
        "step",
        "normal_stress",
        "largest_speed",
        "slowing",
        "window",
        "settled_distance",
        "friction",
        "tolerance",
        "max_sweeps",
        "max_steps",
        "roof_mass",
    ])?;
    let number = |key| table.number(key, Range::Positive);
    let whole = |key, default| {
        let given = table.optional_whole_within(key, 1, u64::from(u32::MAX))?;
        Ok(given.unwrap_or(default))
    };
    let or = |key, range, default| Ok(table.optional_number(key, range)?.unwrap_or(default));
    let drive = Drive::Compaction {
        normal_stress: number("normal_stress")?,
        largest_speed: number("largest_speed")?,
        slowing: table.number("slowing", Range::NonNegative)?,
        window: whole("window", 1500)?,
        settled_distance: number("settled_distance")?,
    };
    let refused = |error: gouge_contact_dynamics::error::SetupError| {
        table.error("slowing", &error.to_string())
    };
    drive.validate().map_err(refused)?;
    Ok(Compaction {
        step: or("step", Range::Positive, step)?,
        drive,
        friction: or("friction", Range::NonNegative, 0.0)?,
        tolerance: or("tolerance", Range::Positive, 1e-2)?,
        max_sweeps: whole("max_sweeps", 200)? as usize,
        max_steps: whole("max_steps", 100_000)?,
        roof_mass: or("roof_mass", Range::Positive, density * diameter)?,
    })
}

pub(super) fn cell(root: &Table) -> Result<Option<CellTable>> {
    let Some(table) = root.optional_table("cell")? else {
        return Ok(None);
    };
    table.allow(&["height", "roof_mass"])?;
    Ok(Some(CellTable {
        height: table.number("height", Range::Positive)?,
        roof_mass: table.number("roof_mass", Range::Positive)?,
    }))
}

pub(super) fn shear(root: &Table) -> Result<Option<ShearTable>> {
    let Some(table) = root.optional_law("shear")? else {
        return Ok(None);
    };
    table.allow(&["rate", "velocity", "normal_stress"])?;
    let rate = table.optional_number("rate", Range::Finite)?;
    let velocity = table.optional_number("velocity", Range::Finite)?;
    let speed = match (rate, velocity) {
        (Some(rate), None) => Speed::Rate(rate),
        (None, Some(velocity)) => Speed::Constant(velocity),
        (Some(_), Some(_)) => return Err(table.error("velocity", "cannot be combined with rate")),
        (None, None) => {
            return Err(table.error("rate", "missing; either rate in 1/s or velocity in m/s"));
        }
    };
    Ok(Some(ShearTable {
        normal_stress: table.number("normal_stress", Range::NonNegative)?,
        speed,
    }))
}
