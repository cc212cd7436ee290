//! `[setup]`: the protocol that generates the particles of a scene, thesis section 3.7.

use super::laws;
use super::particles::{Material, mass_problem};
use super::shape::{Shape, check_within_box, cut};
use super::strength::{BondStrength, bond_strength};
use super::table::{Range, Table};
use crate::error::SceneError;
use gouge_common::geometry::{Domain, Vec2};
use gouge_dem::laws::Controller;
use gouge_dem::model::{Ambient, External, Reading};
use gouge_dem::setup::{Arrangement, Lattice, REACH, SizeRange};

use std::path::Path;

type Result<T> = std::result::Result<T, SceneError>;

/// The protocol: place grains on a lattice, settle, clip, bond, correct the density, cut, relax, press.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Seed of all random numbers.
    pub seed: u64,
    /// Interval of radii.
    pub sizes: SizeRange,
    /// Lattice on which the particles are placed.
    pub lattice: LatticeTable,
    /// Phases before the particles are bonded, without friction.
    pub settle: Vec<PhaseTable>,
    /// Whether particles outside the box are removed after settling.
    pub clip: bool,
    /// Shape outside of which particles are removed after that.
    pub cut: Option<Shape>,
    /// Bonds between neighbours.
    pub bonding: Option<Bonding>,
    /// Whether masses are increased so that the packing as a whole has the density of the material.
    pub correct_density: bool,
    /// Fault along which bonds are cut.
    pub fault: Option<FaultTable>,
    /// Phases in which the block relaxes.
    pub relax: Vec<PhaseTable>,
    /// Limits that determine the roles of particles, applied after relaxing.
    pub roles: Option<Roles>,
    /// Phases in which the driven particles build up the pressure.
    pub press: Vec<PhaseTable>,
}

/// `[setup.lattice]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LatticeTable {
    /// Square or hexagonal arrangement.
    pub arrangement: Arrangement,
    /// Distance between neighbouring lattice points in m.
    pub pitch: f64,
    /// Largest random displacement of a particle from its lattice point in m.
    pub perturbation: f64,
    /// Number of lattice points per row.
    pub columns: usize,
    /// Number of particles.
    pub amount: Amount,
    /// First lattice point in m.
    pub origin: [f64; 2],
}

impl LatticeTable {
    /// The lattice, without its random displacements.
    pub fn lattice(&self) -> Lattice {
        Lattice {
            arrangement: self.arrangement,
            pitch: self.pitch,
            columns: self.columns,
            origin: Vec2::new(self.origin[0], self.origin[1]),
        }
    }
}

/// How the number of particles on a lattice is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// As a number of rows.
    Rows(usize),
    /// As the fraction of the area of the box that the discs cover.
    Filling(f64),
}

/// One phase of the set-up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhaseTable {
    /// Duration in s.
    pub duration: f64,
    /// Time step in s.
    pub step: f64,
    /// Drag.
    pub ambient: Option<Ambient>,
    /// External potential.
    pub external: Option<External>,
    /// Target speed in m/s; only for pressing.
    pub speed: f64,
}

/// `[setup.bonding]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Bonding {
    /// Largest distance of bonded particles in units of the sum of their radii.
    pub reach: f64,
    /// How strong the bonds are.
    pub strength: BondStrength,
}

/// `[setup.fault]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaultTable {
    /// Mean height in m.
    pub level: f64,
    /// Height of the asperities in m.
    pub height: f64,
    /// Number of asperities.
    pub jags: f64,
}

/// `[setup.roles]`: half-planes of fixed and driven particles.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Roles {
    /// Particles with a smaller y, in m, are fixed.
    pub fixed_below: Option<f64>,
    /// Particles with a smaller x, in m, are fixed.
    pub fixed_left_of: Option<f64>,
    /// Particles with a greater y, in m, are driven.
    pub driven_above: Option<f64>,
}

const KEYS: [&str; 12] = [
    "seed",
    "sizes",
    "lattice",
    "settle",
    "clip",
    "cut",
    "bonding",
    "correct_density",
    "fault",
    "relax",
    "roles",
    "press",
];

/// Largest number of particles that a lattice may have.
const MOST: f64 = 1e7;

/// `[setup]`.
pub fn setup(
    root: &Table,
    domain: &Domain,
    reading: Reading,
    material: Material,
    folder: &Path,
) -> Result<Option<Setup>> {
    let Some(table) = root.optional_table("setup")? else {
        return Ok(None);
    };
    table.allow(&KEYS)?;
    let sizes = sizes(&table.table("sizes")?, material)?;
    let phases = |key: &str, presses: bool| phases(&table, key, presses, domain, reading);
    let needs_box = domain.width.zip(domain.height);
    let (clip, correct_density) = (
        table.optional_truth("clip")?.unwrap_or(false),
        table.optional_truth("correct_density")?.unwrap_or(false),
    );
    for (key, asked) in [("clip", clip), ("correct_density", correct_density)] {
        if asked && needs_box.is_none() {
            return Err(table.error(key, "needs box.width and box.height"));
        }
    }
    check_dependencies(root, &table)?;
    let cut = cut(&table)?;
    if let (true, Some(shape), Some((width, height))) = (correct_density, &cut, needs_box) {
        check_within_box(&table, shape, [width, height])?;
    }
    Ok(Some(Setup {
        seed: table
            .optional_whole("seed")?
            .ok_or_else(|| table.error("seed", "missing; must be an integer, zero or greater"))?,
        lattice: lattice(&table.table("lattice")?, sizes, domain)?,
        sizes,
        settle: phases("settle", false)?,
        clip,
        cut,
        bonding: bonding(root, &table, folder)?,
        correct_density,
        fault: fault(&table, domain)?,
        relax: phases("relax", false)?,
        roles: roles(&table)?,
        press: phases("press", true)?,
    }))
}

/// Check that no part is given without the part on which it acts.
fn check_dependencies(root: &Table, setup: &Table) -> Result<()> {
    if setup.has("fault") && !setup.has("bonding") {
        return Err(setup.error("fault", "needs [setup.bonding], whose bonds it cuts"));
    }
    if setup.has("press") && !root.has("driving") {
        return Err(setup.error("press", "needs [driving], whose pressure it builds up"));
    }
    let driving = laws::driving(root)?;
    let is_steady = driving.is_some_and(|one| matches!(one.controller, Controller::Steady { .. }));
    if setup.has("press") && is_steady {
        let accepted = "cannot be combined with the controller steady, which has no pressure";
        return Err(setup.error("press", accepted));
    }
    Ok(())
}

fn sizes(table: &Table, material: Material) -> Result<SizeRange> {
    let sizes = size_range(table)?;
    for (key, radius) in [("minimum", sizes.minimum), ("maximum", sizes.maximum)] {
        if let Some(problem) = mass_problem(material, radius) {
            let key = if table.has("mean") { "mean" } else { key };
            return Err(table.error(key, &problem));
        }
    }
    Ok(sizes)
}

fn size_range(table: &Table) -> Result<SizeRange> {
    if table.has("mean") {
        table.allow(&["mean"])?;
        let mean = table.number("mean", Range::Positive)?;
        return Ok(SizeRange::around(mean));
    }
    table.allow(&["mean", "minimum", "maximum"])?;
    let minimum = table.number("minimum", Range::Positive)?;
    let maximum = table.number("maximum", Range::Positive)?;
    if maximum < minimum {
        return Err(table.error("maximum", "must not be below the minimum"));
    }
    Ok(SizeRange { minimum, maximum })
}

fn lattice(table: &Table, sizes: SizeRange, domain: &Domain) -> Result<LatticeTable> {
    let known = [
        "arrangement",
        "pitch",
        "perturbation",
        "columns",
        "rows",
        "filling",
        "origin",
    ];
    table.allow(&known)?;
    let arrangements = [
        ("square", Arrangement::Square),
        ("hexagonal", Arrangement::Hexagonal),
    ];
    let arrangement = table
        .optional_choice("arrangement", &arrangements)?
        .unwrap_or(Arrangement::Square);
    let perturbation = table
        .optional_number("perturbation", Range::NonNegative)?
        .unwrap_or(0.0);
    let pitch = table
        .optional_number("pitch", Range::Positive)?
        .unwrap_or(2.0 * (sizes.maximum + perturbation));
    let columns = columns(table, domain, pitch)?;
    let amount = amount(table, sizes, domain, columns)?;
    let margin = domain
        .width
        .map_or(0.0, |width| 0.5 * (width - pitch * columns as f64));
    let origin = table
        .optional_pair("origin")?
        .unwrap_or([margin.max(0.0) + 0.5 * pitch, 0.5 * pitch]);
    Ok(LatticeTable {
        arrangement,
        pitch,
        perturbation,
        columns,
        amount,
        origin,
    })
}

/// Most rows or columns of a lattice.
const MOST_ROWS: u64 = 1_000_000;

fn columns(table: &Table, domain: &Domain, pitch: f64) -> Result<usize> {
    let columns = match (
        table.optional_whole_within("columns", 1, MOST_ROWS)?,
        domain.width,
    ) {
        (Some(columns), _) => columns as usize,
        (None, Some(width)) if table.has("pitch") && width < pitch => {
            return Err(table.error("pitch", "must not be above box.width"));
        }
        (None, Some(width)) => (width / pitch) as usize,
        (None, None) => {
            return Err(table.error("columns", "missing; required if box.width is absent"));
        }
    };
    match (1..=MOST_ROWS).contains(&(columns as u64)) {
        true => Ok(columns),
        false => {
            let accepted = format!(
                "missing; must be an integer from 1 to {MOST_ROWS}, but box.width is {columns} times the pitch"
            );
            Err(table.error("columns", &accepted))
        }
    }
}

fn amount(table: &Table, sizes: SizeRange, domain: &Domain, columns: usize) -> Result<Amount> {
    let (rows, area) = (
        table.optional_whole_within("rows", 1, MOST_ROWS)?,
        domain.width.zip(domain.height),
    );
    let (key, amount, number) = match (rows, table.has("filling"), area) {
        (Some(rows), false, _) => {
            let number = rows as f64 * columns as f64;
            ("rows", Amount::Rows(rows as usize), number)
        }
        (None, true, Some((width, height))) => {
            let filling = table.number("filling", Range::Between(0.0, 4.0))?;
            let smallest = core::f64::consts::PI * sizes.minimum * sizes.minimum;
            let number = filling * (width / smallest) * height;
            ("filling", Amount::Filling(filling), number)
        }
        (None, true, None) => {
            return Err(table.error("filling", "needs box.width and box.height"));
        }
        _ => return Err(table.error("rows", "exactly one of rows and filling must be given")),
    };
    if number > MOST {
        let accepted = format!("must give at most {MOST} particles, but gives {number:.0}");
        return Err(table.error(key, &accepted));
    }
    Ok(amount)
}

fn phases(
    setup: &Table,
    key: &str,
    presses: bool,
    domain: &Domain,
    reading: Reading,
) -> Result<Vec<PhaseTable>> {
    let read = |table: &Table| {
        let mut known = vec!["duration", "step", "ambient", "external"];
        if presses {
            known.push("speed");
        }
        table.allow(&known)?;
        let (duration, step) = table.duration_and_step("duration")?;
        Ok(PhaseTable {
            duration,
            step,
            ambient: laws::ambient(table, reading)?,
            external: laws::external(table, domain)?,
            speed: table
                .optional_number("speed", Range::Finite)?
                .unwrap_or(0.0),
        })
    };
    setup.tables(key)?.iter().map(read).collect()
}

fn bonding(root: &Table, setup: &Table, folder: &Path) -> Result<Option<Bonding>> {
    let Some(table) = setup.optional_table("bonding")? else {
        return Ok(None);
    };
    table.allow(&["reach", "strength_spread", "strength"])?;
    let reach = table.optional_number("reach", Range::Positive)?;
    Ok(Some(Bonding {
        reach: reach.unwrap_or(REACH),
        strength: bond_strength(root, &table, folder)?,
    }))
}

fn fault(setup: &Table, domain: &Domain) -> Result<Option<FaultTable>> {
    let Some(table) = setup.optional_table("fault")? else {
        return Ok(None);
    };
    table.allow(&["level", "height", "jags"])?;
    if domain.width.is_none() {
        return Err(setup.error("fault", "needs box.width"));
    }
    let level = match (
        table.optional_number("level", Range::Finite)?,
        domain.height,
    ) {
        (Some(level), _) => level,
        (None, Some(height)) => 0.5 * height,
        (None, None) => {
            return Err(table.error("level", "missing; required if box.height is absent"));
        }
    };
    Ok(Some(FaultTable {
        level,
        height: table
            .optional_number("height", Range::NonNegative)?
            .unwrap_or(0.0),
        jags: table
            .optional_number("jags", Range::NonNegative)?
            .unwrap_or(0.0),
    }))
}

fn roles(setup: &Table) -> Result<Option<Roles>> {
    let Some(table) = setup.optional_table("roles")? else {
        return Ok(None);
    };
    table.allow(&["fixed_below", "fixed_left_of", "driven_above"])?;
    Ok(Some(Roles {
        fixed_below: table.optional_number("fixed_below", Range::Finite)?,
        fixed_left_of: table.optional_number("fixed_left_of", Range::Finite)?,
        driven_above: table.optional_number("driven_above", Range::Finite)?,
    }))
}
