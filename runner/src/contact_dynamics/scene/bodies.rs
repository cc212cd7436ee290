//! `[[particles]]`, `particles_file` and `[[walls]]`.

use super::Result;
use super::setup::{MOST_SIDES, sides};
use crate::scene::rows::{Row, side_file};
use crate::scene::table::{Range, Table};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::units::Velocity;
use std::path::Path;

/// Bodies and walls that a scene lists.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bodies {
    /// The bodies.
    pub bodies: Vec<Body>,
    /// The walls.
    pub walls: Vec<Wall>,
}

/// A body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Its outline.
    pub outline: Outline,
    /// Position of its centroid in m.
    pub position: Vec2,
    /// Its angle in rad.
    pub angle: f64,
    /// Its velocity.
    pub velocity: Velocity,
    /// Its density in kg/m².
    pub density: f64,
    /// Whether it moves freely.
    pub role: Role,
}

/// The outline of a body around its centroid.
#[derive(Clone, Debug, PartialEq)]
pub enum Outline {
    /// A disc, or a regular polygon with this circumscribed radius in m.
    Regular {
        /// Number of sides; none for a disc.
        sides: Option<usize>,
        /// Radius of the circumscribed circle in m.
        radius: f64,
    },
    /// A convex polygon, vertices in m, anticlockwise.
    Polygon(Vec<Vec2>),
}

/// What a body moves with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// It moves freely.
    Free,
    /// It does not move.
    Fixed,
    /// It is glued to the floor of the cell.
    Floor,
    /// It is glued to the roof of the cell.
    Roof,
}

/// Names of the roles.
pub const ROLES: [(&str, Role); 4] = [
    ("free", Role::Free),
    ("fixed", Role::Fixed),
    ("floor", Role::Floor),
    ("roof", Role::Roof),
];

/// A flat wall with an imposed velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// A point of its surface in m.
    pub position: Vec2,
    /// Unit normal, out of the wall.
    pub normal: Vec2,
    /// Its velocity in m/s.
    pub velocity: Vec2,
}

impl Bodies {
    /// Whether the scene lists nothing.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty() && self.walls.is_empty()
    }

    /// Mean diameter in m of the circumscribed circles; 1 without bodies.
    pub(super) fn mean_diameter(&self) -> f64 {
        let sum: f64 = self.bodies.iter().map(|body| 2.0 * body.radius()).sum();
        match self.bodies.len() {
            0 => 1.0,
            number => sum / number as f64,
        }
    }

    /// Check that only cells have bodies glued to their walls.
    pub(super) fn check_roles(&self, root: &Table, has_cell: bool) -> Result<()> {
        let glued = |body: &&Body| matches!(body.role, Role::Floor | Role::Roof);
        match self.bodies.iter().find(glued) {
            Some(_) if !has_cell => {
                let key = ["particles", "particles_file"]
                    .into_iter()
                    .find(|key| root.has(key));
                let accepted = "the roles floor and roof need [cell]";
                Err(root.error(key.unwrap_or("particles"), accepted))
            }
            _ => Ok(()),
        }
    }
}

impl Body {
    /// Radius in m of the circle around its centroid.
    pub fn radius(&self) -> f64 {
        match &self.outline {
            Outline::Regular { radius, .. } => *radius,
            Outline::Polygon(vertices) => {
                let farthest = |far: f64, v: &Vec2| far.max(v.norm());
                vertices.iter().fold(0.0, farthest)
            }
        }
    }
}

pub(super) fn bodies(root: &Table, folder: &Path, density: f64) -> Result<Bodies> {
    let bodies = match side_file(root, "particles", folder)? {
        Some(rows) => rows.read(
            &["x", "y", "radius"],
            &[
                "sides",
                "vertices",
                "vx",
                "vy",
                "angle",
                "angular_velocity",
                "role",
                "density",
                "id",
            ],
            |row| body_of_row(row, density),
        )?,
        None => {
            let tables = root.tables("particles")?;
            let bodies = tables.iter().map(|table| body(table, density));
            bodies.collect::<Result<_>>()?
        }
    };
    let walls = root.tables("walls")?;
    let walls = walls.iter().map(wall).collect::<Result<_>>()?;
    Ok(Bodies { bodies, walls })
}

fn wall(table: &Table) -> Result<Wall> {
    table.allow(&["position", "normal", "velocity"])?;
    let pair = |key| Ok(vector(table.pair(key)?));
    let normal = pair("normal")?;
    if normal.norm() == 0.0 {
        return Err(table.error("normal", "must not be [0, 0]"));
    }
    Ok(Wall {
        position: pair("position")?,
        normal: normal * (1.0 / normal.norm()),
        velocity: vector(table.optional_pair("velocity")?.unwrap_or_default()),
    })
}

fn vector([x, y]: [f64; 2]) -> Vec2 {
    Vec2::new(x, y)
}

fn body(table: &Table, density: f64) -> Result<Body> {
    table.allow(&[
        "sides",
        "radius",
        "vertices",
        "position",
        "angle",
        "velocity",
        "angular_velocity",
        "density",
        "role",
    ])?;
    let number = |key, default| {
        let given = table.optional_number(key, Range::Finite)?;
        Ok(given.unwrap_or(default))
    };
    let own = table.optional_number("density", Range::Positive)?;
    let role = table.optional_choice("role", &ROLES)?.unwrap_or(Role::Free);
    for key in ["velocity", "angular_velocity"] {
        if role != Role::Free && table.has(key) {
            return Err(table.error(
                key,
                "must be left out: only free bodies have a velocity of their own",
            ));
        }
    }
    Ok(Body {
        outline: outline(table)?,
        position: vector(table.pair("position")?),
        angle: number("angle", 0.0)?,
        velocity: Velocity {
            linear: vector(table.optional_pair("velocity")?.unwrap_or_default()),
            angular: number("angular_velocity", 0.0)?,
        },
        density: own.unwrap_or(density),
        role,
    })
}

fn outline(table: &Table) -> Result<Outline> {
    if !table.has("vertices") {
        return Ok(Outline::Regular {
            sides: sides(table)?,
            radius: table.number("radius", Range::Positive)?,
        });
    }
    for key in ["sides", "radius"] {
        if table.has(key) {
            return Err(table.error(key, "cannot be combined with vertices"));
        }
    }
    let vertices: Vec<Vec2> = table.pairs("vertices")?.into_iter().map(vector).collect();
    let mut shapes = gouge_contact_dynamics::shape::Shapes::new();
    let checked = shapes.add_polygon(&vertices);
    checked.map_err(|error| table.error("vertices", &error.to_string()))?;
    Ok(Outline::Polygon(vertices))
}

fn body_of_row(row: &Row, density: f64) -> Result<Body> {
    let number = |key, default| row.optional_number(key, Range::Finite, default);
    let sides = match row.cell("sides") {
        None | Some("0") => None,
        Some(cell) => {
            let sides = cell.parse().ok().filter(|n| (3..=MOST_SIDES).contains(n));
            let accepted = "must be a whole number of at least 3, or 0 for a disc";
            Some(sides.ok_or_else(|| row.error("sides", accepted))? as usize)
        }
    };
    let role = match row.cell("role") {
        None => Role::Free,
        Some(cell) => {
            let found = ROLES.iter().find(|(name, _)| *name == cell);
            let accepted = "must be one of: free, fixed, floor, roof";
            found.ok_or_else(|| row.error("role", accepted))?.1
        }
    };
    let radius = row.number("radius", Range::Positive)?;
    let outline = match row.cell("vertices") {
        None => Outline::Regular { sides, radius },
        Some(cell) => {
            let polygon = vertices_of(cell).filter(|vertices| is_polygon(vertices));
            let accepted = "must be the corners of a convex polygon, anticlockwise: x y;x y;x y";
            Outline::Polygon(polygon.ok_or_else(|| row.error("vertices", accepted))?)
        }
    };
    Ok(Body {
        outline,
        position: vector([
            row.number("x", Range::Finite)?,
            row.number("y", Range::Finite)?,
        ]),
        angle: number("angle", 0.0)?,
        velocity: Velocity {
            linear: vector([number("vx", 0.0)?, number("vy", 0.0)?]),
            angular: number("angular_velocity", 0.0)?,
        },
        density: row.optional_number("density", Range::Positive, density)?,
        role,
    })
}

/// Corners written as `x y;x y;x y`.
fn vertices_of(cell: &str) -> Option<Vec<Vec2>> {
    let corner = |text: &str| {
        let (x, y) = text.trim().split_once(' ')?;
        let [x, y]: [f64; 2] = [x.parse().ok()?, y.trim().parse().ok()?];
        (x.is_finite() && y.is_finite()).then(|| Vec2::new(x, y))
    };
    cell.split(';').map(corner).collect()
}

fn is_polygon(vertices: &[Vec2]) -> bool {
    let mut shapes = gouge_contact_dynamics::shape::Shapes::new();
    shapes.add_polygon(vertices).is_ok()
}
