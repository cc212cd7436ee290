//! Particles, bonds and contacts of a scene, from the scene file or from CSV files.

use super::StartFile;
use super::history::{
    FORCES, History, INERTIA, INITIAL_ANGLES, MEMORY, REST, inertia, is_exact, memory, rest,
};
use super::rows::{Row, Rows, read_regular, side_file};
use super::table::{Range, Table};
use super::text::hex;
use crate::error::SceneError;
use gouge_common::geometry::Vec2;
use gouge_dem::bonds::BondStart;
use gouge_dem::contacts::ContactStart;
use gouge_dem::model::Reading;
use gouge_dem::particles::{Particle, Role, moment_of_inertia, sphere_mass};
use sha2::{Digest, Sha256};
use std::path::Path;

type Result<T> = std::result::Result<T, SceneError>;

/// Names of roles.
pub const ROLES: [(&str, Role); 3] = [
    ("free", Role::Free),
    ("driven", Role::Driven),
    ("fixed", Role::Fixed),
];

/// Name of a role.
pub fn role_name(role: Role) -> &'static str {
    ROLES
        .iter()
        .find(|(_, r)| *r == role)
        .map_or("free", |(name, _)| name)
}

/// Where a particle, bond or contact is listed, for errors found later.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The file, or the override.
    pub file: String,
    /// The line; zero for an override.
    pub line: usize,
    /// The key; empty for an override, whose text names it already.
    pub key: String,
}

impl Place {
    /// An error at this place.
    pub fn error(&self, value: String, accepted: String) -> SceneError {
        SceneError {
            file: self.file.clone(),
            line: self.line,
            key: self.key.clone(),
            value: match self.key.is_empty() {
                true => String::new(),
                false => value,
            },
            accepted,
        }
    }
}

/// Items, each with the place where it is listed.
pub type Placed<T> = Vec<(T, Place)>;

const FIXED_MOVES: &str = "a fixed particle never moves, so this must be zero or absent";

/// `[material]`: density and moment of inertia of particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Density in kg/m^3 of particles that do not give their own.
    pub density: f64,
    /// Moment of inertia of all particles in units of mass times radius squared.
    pub inertia_factor: f64,
}

/// `[material]`.
pub fn material(root: &Table, reading: Reading) -> Result<Material> {
    let table = root.table("material")?;
    table.allow(&["density", "inertia_factor"])?;
    Ok(Material {
        density: table.number("density", Range::Positive)?,
        inertia_factor: table
            .optional_number("inertia_factor", Range::Positive)?
            .unwrap_or(reading.inertia_factor()),
    })
}

/// The problem with a sphere whose mass or moment of inertia overflows or underflows, if so.
pub fn mass_problem(material: Material, radius: f64) -> Option<String> {
    let Material {
        density,
        inertia_factor,
    } = material;
    let mass = sphere_mass(density, radius);
    let inertia = moment_of_inertia(inertia_factor, mass, radius);
    let is_usable = |number: f64| number.is_normal() && number.recip().is_normal();
    (!is_usable(mass) || !is_usable(inertia)).then(|| {
        format!(
            "must give a mass and a moment of inertia within the range of floating-point numbers, but \
             with the density {density:?} they are {mass:?} kg and {inertia:?} kg m^2"
        )
    })
}

/// `start`: the folder of a run, or its checkpoint.
pub fn start(root: &Table, folder: &Path) -> Result<Option<StartFile>> {
    let Some(name) = root.optional_text("start")? else {
        return Ok(None);
    };
    let mut path = folder.join(name);
    if path.is_dir() {
        path.push("checkpoint");
    }
    match read_regular(&path) {
        Ok(bytes) => Ok(Some(StartFile {
            path,
            sha256: hex(&Sha256::digest(&bytes)),
            refusal: root.error("start", ""),
        })),
        Err(error) => {
            let accepted = format!("must be the output folder of a finished run: {error}");
            Err(root.error("start", &accepted))
        }
    }
}

/// `[[particles]]` or `particles_file`.
pub fn particles(
    root: &Table,
    folder: &Path,
    material: Material,
    history: &mut History,
) -> Result<Vec<Particle>> {
    const REQUIRED: [&str; 3] = ["x", "y", "radius"];
    const MOTION: [&str; 6] = ["vx", "vy", "angle", "angular_velocity", "role", "id"];
    let Some(rows) = side_file(root, "particles", folder)? else {
        let tables = root.tables("particles")?;
        let particles = tables.iter().map(|table| particle(table, material));
        return particles.collect();
    };
    let optional = [&MOTION[..4], &["density"], &MOTION[4..]].concat();
    if !is_exact(&rows)? {
        return rows.read(&REQUIRED, &optional, |row| particle_row(row, material));
    }
    let required = [&REQUIRED[..], &INERTIA].concat();
    let read = rows.read(&required, &MOTION, |row| {
        let inertia = inertia(row)?;
        let radius = row.number("radius", Range::Positive)?;
        let density = inertia[0] / sphere_mass(1.0, radius);
        let own = Material {
            density,
            ..material
        };
        Ok((particle_row(row, own)?, inertia))
    })?;
    let (particles, inertia) = read.into_iter().unzip();
    history.inertia = inertia;
    Ok(particles)
}

fn particle(table: &Table, material: Material) -> Result<Particle> {
    table.allow(&[
        "position",
        "velocity",
        "angle",
        "angular_velocity",
        "radius",
        "density",
        "role",
    ])?;
    let role = table.optional_choice("role", &ROLES)?.unwrap_or(Role::Free);
    let velocity = table.optional_pair("velocity")?.unwrap_or([0.0; 2]);
    let angular_velocity = table
        .optional_number("angular_velocity", Range::Finite)?
        .unwrap_or(0.0);
    if role == Role::Fixed && velocity != [0.0; 2] {
        return Err(table.error("velocity", FIXED_MOVES));
    }
    if role == Role::Fixed && angular_velocity != 0.0 {
        return Err(table.error("angular_velocity", FIXED_MOVES));
    }
    let [x, y] = table.pair("position")?;
    let particle = Particle {
        position: Vec2::new(x, y),
        velocity: Vec2::new(velocity[0], velocity[1]),
        angle: table
            .optional_number("angle", Range::Finite)?
            .unwrap_or(0.0),
        angular_velocity,
        radius: table.number("radius", Range::Positive)?,
        density: table
            .optional_number("density", Range::Positive)?
            .unwrap_or(material.density),
        inertia_factor: material.inertia_factor,
        role,
    };
    match mass_problem(material_of(&particle), particle.radius) {
        Some(problem) => Err(table.error("radius", &problem)),
        None => Ok(particle),
    }
}

fn material_of(particle: &Particle) -> Material {
    Material {
        density: particle.density,
        inertia_factor: particle.inertia_factor,
    }
}

fn particle_row(row: &Row, material: Material) -> Result<Particle> {
    if row.cell("id").is_some() && row.index("id")? != row.ordinal {
        let accepted =
            "must count the rows from 0, because bonds and contacts name particles by it";
        return Err(row.error("id", accepted));
    }
    let number = |key: &str, range, default| row.optional_number(key, range, default);
    let role = row.role()?;
    let velocity = Vec2::new(
        number("vx", Range::Finite, 0.0)?,
        number("vy", Range::Finite, 0.0)?,
    );
    let angular_velocity = number("angular_velocity", Range::Finite, 0.0)?;
    let moving = [
        ("vx", velocity.x),
        ("vy", velocity.y),
        ("angular_velocity", angular_velocity),
    ];
    if role == Role::Fixed
        && let Some((key, _)) = moving.iter().find(|(_, value)| *value != 0.0)
    {
        return Err(row.error(key, FIXED_MOVES));
    }
    let particle = Particle {
        position: Vec2::new(
            row.number("x", Range::Finite)?,
            row.number("y", Range::Finite)?,
        ),
        velocity,
        angle: number("angle", Range::Finite, 0.0)?,
        angular_velocity,
        radius: row.number("radius", Range::Positive)?,
        density: number("density", Range::Positive, material.density)?,
        inertia_factor: material.inertia_factor,
        role,
    };
    match mass_problem(material_of(&particle), particle.radius) {
        Some(problem) => Err(row.error("radius", &problem)),
        None => Ok(particle),
    }
}

/// `[[bonds]]` or `bonds_file`.
pub fn bonds(root: &Table, folder: &Path, history: &mut History) -> Result<Placed<BondStart>> {
    if let Some(rows) = side_file(root, "bonds", folder)? {
        if is_exact(&rows)? {
            return exact_bonds(&rows, history);
        }
        let optional = [
            "strength_factor",
            "initial_distance",
            "initial_angle_i",
            "initial_angle_j",
        ];
        return rows.read(&["i", "j"], &optional, |row| {
            Ok((bond_row(row)?, row.place()))
        });
    }
    let read = |table: &Table| {
        table.allow(&[
            "between",
            "strength_factor",
            "initial_distance",
            "initial_angles",
        ])?;
        let start = BondStart {
            between: table.index_pair("between")?,
            strength_factor: table
                .optional_number("strength_factor", Range::Positive)?
                .unwrap_or(1.0),
            initial_distance: table.optional_number("initial_distance", Range::Positive)?,
            initial_angles: table.optional_pair("initial_angles")?,
        };
        Ok((start, place(table)))
    };
    root.tables("bonds")?.iter().map(read).collect()
}

/// Bonds whose unstrained states are known to the bit.
fn exact_bonds(rows: &Rows, history: &mut History) -> Result<Placed<BondStart>> {
    let required = [&["i", "j", "initial_distance"][..], &REST].concat();
    let optional = [&["strength_factor"][..], &INITIAL_ANGLES, &FORCES].concat();
    let read = rows.read(&required, &optional, |row| {
        let start = BondStart {
            initial_angles: None,
            ..bond_row(row)?
        };
        Ok(((start, row.place()), rest(row)?))
    })?;
    let (bonds, rests) = read.into_iter().unzip();
    history.rests = rests;
    Ok(bonds)
}

/// A strength factor; infinite for a bond that never breaks.
fn strength_factor(row: &Row) -> Result<f64> {
    match row.cell("strength_factor") {
        Some("inf") => Ok(f64::INFINITY),
        _ => row.optional_number("strength_factor", Range::Positive, 1.0),
    }
}

fn bond_row(row: &Row) -> Result<BondStart> {
    let angles = [row.cell("initial_angle_i"), row.cell("initial_angle_j")];
    let initial_angles = match angles {
        [None, None] => None,
        _ => Some([
            row.number("initial_angle_i", Range::Finite)?,
            row.number("initial_angle_j", Range::Finite)?,
        ]),
    };
    let initial_distance = match row.cell("initial_distance") {
        None => None,
        Some(_) => Some(row.number("initial_distance", Range::Positive)?),
    };
    Ok(BondStart {
        between: row.pair()?,
        strength_factor: strength_factor(row)?,
        initial_distance,
        initial_angles,
    })
}

/// `[[contacts]]` or `contacts_file`.
pub fn contacts(
    root: &Table,
    folder: &Path,
    history: &mut History,
) -> Result<Placed<ContactStart>> {
    if let Some(rows) = side_file(root, "contacts", folder)? {
        if is_exact(&rows)? {
            return exact_contacts(&rows, history);
        }
        return rows.read(
            &["i", "j", "initial_angle_i", "initial_angle_j"],
            &[],
            |row| {
                let initial_angles = [
                    row.number("initial_angle_i", Range::Finite)?,
                    row.number("initial_angle_j", Range::Finite)?,
                ];
                Ok((
                    ContactStart {
                        between: row.pair()?,
                        initial_angles,
                    },
                    row.place(),
                ))
            },
        );
    }
    let read = |table: &Table| {
        table.allow(&["between", "initial_angles"])?;
        let start = ContactStart {
            between: table.index_pair("between")?,
            initial_angles: table.pair("initial_angles")?,
        };
        Ok((start, place(table)))
    };
    root.tables("contacts")?.iter().map(read).collect()
}

/// Contacts whose memories are known to the bit.
fn exact_contacts(rows: &Rows, history: &mut History) -> Result<Placed<ContactStart>> {
    let required = [&["i", "j"][..], &MEMORY].concat();
    let read = rows.read(&required, &INITIAL_ANGLES, |row| {
        let start = ContactStart {
            between: row.pair()?,
            initial_angles: [0.0; 2],
        };
        Ok(((start, row.place()), memory(row)?))
    })?;
    let (contacts, memories) = read.into_iter().unzip();
    history.memories = Some(memories);
    Ok(contacts)
}

fn place(table: &Table) -> Place {
    let error = table.error("between", "");
    Place {
        file: error.file,
        line: error.line,
        key: error.key,
    }
}
