//! Nodes and bonds of the grains of a scene.

use super::super::Scene;
use super::super::scene::{Constants, Form, GrainTable, Mesh, MeshKind};
use crate::error::{Error, SceneError};
use crate::scene::Rectangle;
use gouge_common::geometry::Vec2;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::error::SetupError;
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::interior::Interior;
use gouge_peridem::mesh;
use gouge_peridem::shape::Outline;

/// What is known of the nodes of a grain besides what the kernel keeps.
#[derive(Clone, Debug, Default)]
pub struct Cells {
    /// Triangles of nodes, counted over all grains.
    pub triangles: Vec<[u32; 3]>,
    /// Whether the nodes are the centres of squares.
    pub are_squares: bool,
}

/// Grains at rest, with their bonds.
pub struct Meshed {
    /// The grains.
    pub grains: Grains,
    /// Their bonds.
    pub bonds: Bonds,
    /// What their meshes say besides.
    pub cells: Vec<Cells>,
}

/// The error of a scene for a reason that the kernel gives.
pub fn refused(refusal: Option<&SceneError>, reason: &SetupError) -> Error {
    match refusal {
        Some(refusal) => Error::Scene(SceneError {
            accepted: reason.to_string(),
            ..refusal.clone()
        }),
        None => Error::PeridemSetup(reason.clone()),
    }
}

/// The grains of a scene. Bonds are found in the frames of the grains, where their shapes are exact.
///
/// # Errors
/// Grains that cannot be meshed or that the kernel refuses.
pub fn meshed(scene: &Scene) -> Result<Meshed, Error> {
    let mut local = Vec::new();
    let mut cells = Vec::new();
    let mut first = 0;
    for (k, table) in scene.grains.iter().enumerate() {
        let refusals = scene.refusals.grains.get(k);
        let of_shape = |error| match error {
            SetupError::NodeOnCut { .. } => refused(refusals.map(|all| &all.cuts), &error),
            _ => refused(refusals.map(|all| &all.shape), &error),
        };
        let refuse = |error| refused(refusals.map(|all| &all.whole), &error);
        let mesh = nodes(table).map_err(of_shape)?;
        let shifted = |triangle: &[u32; 3]| triangle.map(|node| node + first);
        cells.push(Cells {
            triangles: mesh.triangles.iter().map(shifted).collect(),
            are_squares: is_square(table),
        });
        first += mesh.position.len() as u32;
        local.push(grain(scene, table, mesh).map_err(refuse)?);
    }
    let grains = Grains::new(&local)?;
    let bonds = bonds(scene, &grains)?;
    for (k, (grain, table)) in local.iter_mut().zip(&scene.grains).enumerate() {
        let placed = |point: Vec2| table.position + rotated(point, table.angle);
        let positions = grain.position.iter().map(|&point| placed(point));
        grain.position = positions.collect();
        let refusals = scene.refusals.grains.get(k);
        let (clamped, loads) = (
            refusals.map(|all| &all.clamped),
            refusals.map(|all| &all.loads),
        );
        hold(table, grain).map_err(|reason| refused_by_runner(clamped, k, reason))?;
        load(table, grain).map_err(|reason| refused_by_runner(loads, k, reason))?;
        let checked = require_free(table, grain);
        checked.map_err(|reason| refused_by_runner(clamped, k, reason))?;
    }
    Ok(Meshed {
        grains: Grains::new(&local)?,
        bonds,
        cells,
    })
}

/// An error about a key of a grain, or about the grain if it is not of a file, for a reason that is not the kernel's.
pub fn refused_by_runner(refusal: Option<&SceneError>, grain: usize, reason: &str) -> Error {
    let argument = || Error::Argument(format!("grains[{grain}]: {reason}"));
    refusal.map_or_else(argument, |refusal| {
        Error::Scene(SceneError {
            accepted: reason.to_owned(),
            ..refusal.clone()
        })
    })
}

fn is_square(table: &GrainTable) -> bool {
    match &table.form {
        Form::Outline(_, mesh) => mesh.kind != MeshKind::Triangulated && table.angle == 0.0,
        Form::Nodes(_) => false,
    }
}

/// A point turned anticlockwise about the origin by an angle in rad.
fn rotated(point: Vec2, angle: f64) -> Vec2 {
    if angle == 0.0 {
        return point;
    }
    let (sin, cos) = libm::sincos(angle);
    Vec2::new(cos * point.x - sin * point.y, sin * point.x + cos * point.y)
}

fn nodes(table: &GrainTable) -> Result<mesh::Mesh, SetupError> {
    match &table.form {
        Form::Outline(outline, mesh) => mesh_of(outline, mesh),
        Form::Nodes(list) => Ok(mesh::Mesh {
            position: list.position.clone(),
            area: list.area.clone(),
            ..mesh::Mesh::default()
        }),
    }
}

fn mesh_of(outline: &Outline, how: &Mesh) -> Result<mesh::Mesh, SetupError> {
    let corner = outline.bounds().lower;
    let cells = how.cells(outline);
    let mesh = match (how.kind, cells) {
        (MeshKind::Triangulated, _) => mesh::Mesh::triangulated(outline, how.size)?,
        (MeshKind::Cells, Some([columns, rows])) => {
            mesh::Mesh::rectangle(columns, rows, how.size, corner)?
        }
        // The scene has refused cells that do not fit.
        (MeshKind::Lattice | MeshKind::Cells, _) => {
            mesh::Mesh::lattice(outline, how.size, Vec2::zero())?
        }
    };
    Interior::new(outline).require_off_cuts(&mesh.position)?;
    Ok(mesh)
}

/// A grain in its own frame, without what depends on its place.
fn grain(scene: &Scene, table: &GrainTable, mesh: mesh::Mesh) -> Result<Grain, SetupError> {
    let material = &scene.materials[table.material];
    let constants = material.constants(&scene.bonds)?;
    let breaking = scene.bonds.breaking.filter(|_| table.is_breakable);
    let touches_itself = scene.contact.is_some_and(|contact| contact.touches_itself);
    let contact_stiffness = match scene.bonds.constants {
        Constants::Authors => constants.stiffness,
        Constants::Consistent => material.contact(&scene.bonds).bond_stiffness()?,
    };
    Ok(Grain {
        position: mesh.position,
        area: mesh.area,
        density: material.density,
        constants,
        breaking,
        // The program of the authors knows self contact only of grains that break.
        touches_itself: touches_itself && (breaking.is_some() || !scene.mode.is_of_authors()),
        contact_stiffness,
        material: table.material,
        clamped: Vec::new(),
        load: Vec::new(),
    })
}

fn bonds(scene: &Scene, local: &Grains) -> Result<Bonds, Error> {
    let interior = |table: &GrainTable| match &table.form {
        Form::Outline(outline, _) => Some(Interior::new(outline)),
        Form::Nodes(_) => None,
    };
    let interiors: Vec<Option<Interior>> = scene.grains.iter().map(interior).collect();
    let admits = |grain: usize, from: Vec2, to: Vec2| {
        let interior = interiors[grain].as_ref();
        interior.is_none_or(|interior| interior.admits_from_inside(from, to))
    };
    let listed = |table: &GrainTable| match &table.form {
        Form::Nodes(list) => list.bonds.clone(),
        Form::Outline(..) => None,
    };
    let lists: Vec<_> = scene.grains.iter().map(listed).collect();
    let found = Bonds::within_horizon(local, admits);
    let all = found.map_err(|error| of_bonds(scene, &error))?;
    if lists.iter().all(Option::is_none) {
        return Ok(all);
    }
    let own = |grain: usize| {
        let nodes = local.rows[grain].nodes.clone();
        let rows = nodes.clone().flat_map(|later| {
            let row = all.with_earlier(later);
            row.map(move |(earlier, _)| [earlier, later])
        });
        rows.map(|pair| pair.map(|node| node - nodes.start))
            .collect()
    };
    let lists = lists.into_iter().enumerate();
    let lists: Vec<Vec<[usize; 2]>> = lists
        .map(|(grain, list)| list.unwrap_or_else(|| own(grain)))
        .collect();
    Bonds::from_pairs(local, &lists).map_err(|error| of_bonds(scene, &error))
}

/// The error of a scene whose bonds the kernel refuses.
fn of_bonds(scene: &Scene, error: &SetupError) -> Error {
    let refusal = match error {
        SetupError::Bond { grain, .. } => scene.refusals.grains.get(*grain),
        _ => None,
    };
    refused(refusal.map(|all| &all.whole), error)
}

/// Clamp nodes of a placed grain.
fn hold(table: &GrainTable, grain: &mut Grain) -> Result<(), &'static str> {
    for region in &table.clamped {
        let inside = inside(grain, region);
        if inside.is_empty() {
            return Err("no node of the grain is in one of the boxes");
        }
        grain.clamped.extend(inside);
    }
    Ok(())
}

/// Load nodes of a placed grain.
fn load(table: &GrainTable, grain: &mut Grain) -> Result<(), &'static str> {
    let number = grain.position.len();
    for load in &table.loads {
        let inside = inside(grain, &load.region);
        let area: f64 = inside.iter().map(|&node| grain.area[node]).sum();
        if inside.is_empty() {
            return Err("no node of the grain is in the box of one of the loads");
        }
        grain.load.resize(number, Vec2::zero());
        for node in inside {
            grain.load[node] += load.force * (1.0 / area);
        }
    }
    Ok(())
}

/// The nodes of a placed grain in a box.
fn inside(grain: &Grain, region: &Rectangle) -> Vec<usize> {
    let number = grain.position.len();
    (0..number)
        .filter(|&node| region.contains(grain.position[node]))
        .collect()
}

/// Refuse a motion or a load of a grain all of whose nodes are clamped.
fn require_free(table: &GrainTable, grain: &Grain) -> Result<(), &'static str> {
    let mut clamped = grain.clamped.clone();
    clamped.sort_unstable();
    clamped.dedup();
    let moves = table.velocity != Vec2::zero() || table.angular_velocity != 0.0;
    let is_moved = moves || !table.loads.is_empty();
    match is_moved && clamped.len() == grain.position.len() {
        true => Err(
            "holds all nodes of the grain, so that its velocity, angular_velocity and loads have no effect; leave them out, \
             or some nodes outside the boxes",
        ),
        false => Ok(()),
    }
}
