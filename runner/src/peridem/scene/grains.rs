//! `[mesh]` and `[[grains]]`.

use super::Result;
use super::materials::MaterialTable;
use super::outline::Family;
use super::size;
use crate::scene::Rectangle;
use crate::scene::rows::{Row, rows_of};
use crate::scene::table::{Range, Table};
use gouge_common::geometry::Vec2;
use gouge_peridem::shape::Outline;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

/// Keys that name a CSV file of a grain.
pub(super) const FILES: [&str; 2] = ["nodes_file", "bonds_file"];
/// Part of a cell by which the sides of a rectangle may differ from whole cells.
const WHOLE: f64 = 1e-6;
/// Part of the horizon by which a listed bond may be longer: numbers in files are rounded.
const ROUNDING: f64 = 1e-9;
/// What a box must be.
const BOX: &str = "must be a box [x0, y0, x1, y1], with x0 < x1 and y0 < y1";
const BOXES: &str = "must be an array of boxes [x0, y0, x1, y1], with x0 < x1 and y0 < y1";

/// A grain of `[[grains]]`.
#[derive(Clone, Debug, PartialEq)]
pub struct GrainTable {
    /// Its nodes, or what they are made from, in a frame of its own.
    pub form: Form,
    /// Number of its material.
    pub material: usize,
    /// Where the origin of its frame is in m.
    pub position: Vec2,
    /// Angle of its frame in rad.
    pub angle: f64,
    /// Velocity of its centre in m/s.
    pub velocity: Vec2,
    /// Angular velocity in rad/s about its centre.
    pub angular_velocity: f64,
    /// Whether its bonds may break.
    pub is_breakable: bool,
    /// Nodes in these boxes never move.
    pub clamped: Vec<Rectangle>,
    /// Forces on nodes in boxes.
    pub loads: Vec<LoadTable>,
}

/// Where the nodes of a grain come from.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A shape that is meshed.
    Outline(Outline, Mesh),
    /// Nodes that a file lists.
    Nodes(NodeList),
}

/// How a shape is meshed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mesh {
    /// Kind of the mesh.
    pub kind: MeshKind,
    /// Distance of neighbouring nodes in m.
    pub size: f64,
}

/// Kinds of meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshKind {
    /// A triangulation with nodes on the boundary.
    Triangulated,
    /// Points of a square lattice inside the shape.
    Lattice,
    /// Whole square cells of a rectangle, with nodes at their centres.
    Cells,
}

const KINDS: [(&str, MeshKind); 3] = [
    ("triangulated", MeshKind::Triangulated),
    ("lattice", MeshKind::Lattice),
    ("cells", MeshKind::Cells),
];

/// Nodes that a file lists.
#[derive(Clone, Debug, PartialEq)]
pub struct NodeList {
    /// Positions in m.
    pub position: Vec<Vec2>,
    /// Areas in m².
    pub area: Vec<f64>,
    /// Pairs of bonded nodes; none if all nodes within the horizon are bonded.
    pub bonds: Option<Vec<[usize; 2]>>,
    /// The files.
    pub files: Vec<PathBuf>,
}

/// A force on some nodes of a grain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadTable {
    /// Where the nodes are at t = 0.
    pub region: Rectangle,
    /// Total force in N per metre of depth, which is spread over the nodes by their areas.
    pub force: Vec2,
}

impl GrainTable {
    /// The CSV files that it names.
    pub(super) fn files(&self) -> impl Iterator<Item = &PathBuf> {
        let files: &[PathBuf] = match &self.form {
            Form::Outline(..) => &[],
            Form::Nodes(list) => &list.files,
        };
        files.iter()
    }
}

/// What grains need of the rest of a scene.
pub(super) struct Surroundings<'a> {
    pub(super) root: &'a Table<'a>,
    pub(super) folder: &'a Path,
    pub(super) materials: &'a [MaterialTable],
    /// Horizon of the bonds in m.
    pub(super) horizon: f64,
}

/// Read the grains of a scene.
pub(super) fn grains(tables: &[Table], around: &Surroundings) -> Result<Vec<GrainTable>> {
    let root = around.root;
    if tables.is_empty() {
        return Err(root.error("grains", "missing; a scene needs at least one [[grains]]"));
    }
    let mesh = root.optional_table("mesh")?;
    if let Some(mesh) = &mesh {
        mesh.allow(&["kind", "size"])?;
        mesh.optional_choice("kind", &KINDS)?;
        mesh.optional_number("size", Range::Positive)?;
    }
    let read = |table: &Table| grain(table, mesh.as_ref(), around);
    tables.iter().map(read).collect()
}

const KEYS: [&str; 9] = [
    "shape",
    "position",
    "angle",
    "velocity",
    "angular_velocity",
    "material",
    "breakable",
    "clamped",
    "loads",
];

fn grain(table: &Table, mesh: Option<&Table>, around: &Surroundings) -> Result<GrainTable> {
    let pair = |key| {
        let [x, y] = table.optional_pair(key)?.unwrap_or_default();
        Ok(Vec2::new(x, y))
    };
    let number = |key| {
        let given = table.optional_number(key, Range::Finite)?;
        Ok(given.unwrap_or(0.0))
    };
    let form = match table.has("nodes_file") {
        true => {
            table.allow(&[&KEYS[1..], &FILES].concat())?;
            Form::Nodes(nodes(table, around)?)
        }
        false => {
            let family = Family::read(table)?;
            let keys = [&KEYS[..], family.keys(), &["mesh_kind", "mesh_size"]];
            table.allow(&keys.concat())?;
            let outline = family.outline(table)?;
            let mesh = mesh_of(table, mesh, family, &outline)?;
            Form::Outline(outline, mesh)
        }
    };
    let position = pair("position")?;
    size::check_place(table, &form, position)?;
    Ok(GrainTable {
        form,
        material: material(table, around.materials)?,
        position,
        angle: number("angle")?,
        velocity: pair("velocity")?,
        angular_velocity: number("angular_velocity")?,
        is_breakable: table.optional_truth("breakable")?.unwrap_or(true),
        clamped: clamped(table)?,
        loads: table
            .tables("loads")?
            .iter()
            .map(load)
            .collect::<Result<_>>()?,
    })
}

/// The number of the material; a scene with one material need not name it.
fn material(table: &Table, materials: &[MaterialTable]) -> Result<usize> {
    if !table.has("material") && materials.len() == 1 {
        return Ok(0);
    }
    let names = materials.iter().enumerate();
    let names: Vec<(&str, usize)> = names.map(|(k, one)| (one.name.as_str(), k)).collect();
    table.choice("material", &names)
}

fn mesh_of(
    table: &Table,
    shared: Option<&Table>,
    family: Family,
    outline: &Outline,
) -> Result<Mesh> {
    let shared_kind = match shared {
        Some(mesh) => mesh.optional_choice("kind", &KINDS)?,
        None => None,
    };
    let shared_size = match shared {
        Some(mesh) => mesh.optional_number("size", Range::Positive)?,
        None => None,
    };
    let own_kind = table.optional_choice("mesh_kind", &KINDS)?;
    let own_size = table.optional_number("mesh_size", Range::Positive)?;
    let kind = own_kind.or(shared_kind).unwrap_or(MeshKind::Triangulated);
    let Some(size) = own_size.or(shared_size) else {
        let accepted = "missing; give it here, or mesh.size for all grains, in m";
        return Err(table.error("mesh_size", accepted));
    };
    let mesh = Mesh { kind, size };
    if kind == MeshKind::Cells {
        let is_rectangle = matches!(family, Family::Rectangle | Family::Square);
        if !is_rectangle {
            let accepted = "of the kind \"cells\" needs the shape rectangle or square";
            return Err(table.error("shape", &format!("a mesh {accepted}")));
        }
        if mesh.cells(outline).is_none() {
            let accepted = "the sides of the rectangle must be whole multiples of the mesh size";
            return Err(table.own_error(accepted));
        }
    }
    let refused = |accepted: &str| match (own_size, shared) {
        (None, Some(shared)) => shared.error("size", accepted),
        _ => table.error("mesh_size", accepted),
    };
    match size::unusable_mesh(outline, &mesh) {
        Some(accepted) => Err(refused(&accepted)),
        None => Ok(mesh),
    }
}

impl Mesh {
    /// Numbers of whole cells along the sides of a rectangle; none if its sides are not whole multiples of the size.
    pub fn cells(&self, outline: &Outline) -> Option<[usize; 2]> {
        let bounds = outline.bounds();
        let size = bounds.upper - bounds.lower;
        let cells = [size.x, size.y].map(|side| side / self.size);
        let is_whole = |cells: &f64| (cells - cells.round()).abs() < WHOLE * cells.max(1.0);
        let all_fit = cells
            .iter()
            .all(|number| is_whole(number) && *number >= 0.5);
        all_fit.then(|| cells.map(|number| number.round() as usize))
    }
}

fn clamped(table: &Table) -> Result<Vec<Rectangle>> {
    let boxes = table.optional_rows("clamped", BOXES)?.into_iter();
    let boxes: Option<Vec<Rectangle>> = boxes.map(rectangle).collect();
    boxes.ok_or_else(|| table.error("clamped", BOXES))
}

fn rectangle([x0, y0, x1, y1]: [f64; 4]) -> Option<Rectangle> {
    (x0 < x1 && y0 < y1).then(|| Rectangle {
        lower_left: Vec2::new(x0, y0),
        upper_right: Vec2::new(x1, y1),
    })
}

fn load(table: &Table) -> Result<LoadTable> {
    table.allow(&["box", "force"])?;
    let region = rectangle(table.four("box", BOX)?);
    let [x, y] = table.pair("force")?;
    Ok(LoadTable {
        region: region.ok_or_else(|| table.error("box", BOX))?,
        force: Vec2::new(x, y),
    })
}

/// The nodes and bonds that files list.
fn nodes(table: &Table, around: &Surroundings) -> Result<NodeList> {
    let place = |key: &str| {
        Ok(around
            .folder
            .join(table.optional_text(key)?.unwrap_or_default()))
    };
    let path = place("nodes_file")?;
    let rows = rows_of(table, "nodes_file", &path)?;
    let mut places = HashSet::new();
    let nodes = rows.read(&["x", "y", "area"], &[], |row| {
        let (x, y) = (
            row.number("x", Range::Finite)?,
            row.number("y", Range::Finite)?,
        );
        // Zero has two signs.
        if !places.insert([x, y].map(|coordinate| (coordinate + 0.0).to_bits())) {
            return Err(row.error("x", "there is another node at this place"));
        }
        Ok((Vec2::new(x, y), row.number("area", Range::Positive)?))
    })?;
    if nodes.is_empty() {
        return Err(table.error("nodes_file", "must have at least one row"));
    }
    let (position, area): (Vec<Vec2>, Vec<f64>) = nodes.into_iter().unzip();
    let mut list = NodeList {
        position,
        area,
        bonds: None,
        files: vec![path],
    };
    if table.has("bonds_file") {
        let path = place("bonds_file")?;
        let rows = rows_of(table, "bonds_file", &path)?;
        let mut known = HashSet::new();
        list.bonds = Some(rows.read(&["i", "j"], &[], |row| {
            let [i, j] = bond(row, &list, around.horizon)?;
            match known.insert([i.min(j), i.max(j)]) {
                true => Ok([i, j]),
                false => Err(row.error("j", "the same two nodes are listed before")),
            }
        })?);
        list.files.push(path);
    }
    Ok(list)
}

/// The nodes of a bond that a row lists.
fn bond(row: &Row, list: &NodeList, horizon: f64) -> Result<[usize; 2]> {
    let number = list.position.len();
    let [i, j] = [row.node("i", number)?, row.node("j", number)?];
    if i == j {
        return Err(row.error("j", "must be another node than i"));
    }
    let length = (list.position[j] - list.position[i]).norm();
    if length > horizon * (1.0 + ROUNDING) {
        let accepted = format!(
            "is {length:e} m from node {i}, but bonds must not be longer than bonds.horizon = {horizon:?}"
        );
        return Err(row.error("j", &accepted));
    }
    Ok([i, j])
}
