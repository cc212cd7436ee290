//! Refuses meshes that are too coarse or too fine, too many bonds, and places where the rounding of coordinates would
//! change the distances of nodes, before anything is meshed.

use super::{Form, GrainTable, Mesh, MeshKind, Result, Scene, outline};
use crate::scene::table::Table;
use gouge_common::geometry::Vec2;
use gouge_peridem::mesh::{MOST_NODES, smallest_distance};
use gouge_peridem::shape::Outline;
use std::f64::consts::PI;

/// Most bonds of all grains, and most pairs of nodes within the contact radius.
const MOST_BONDS: f64 = 134_217_728.0;
/// Bytes that a bond needs in memory.
const BYTES: f64 = 12.0;
/// Most nodes of all grains, in those of one.
const MOST_MESHES: f64 = 2.0;
/// Largest rounding error of a coordinate in parts of the distance of nodes.
const ROUNDING: f64 = 1e-6;
/// Area of a node in a triangular mesh of size 1.
const TRIANGULAR: f64 = 0.866_025_403_784_438_6;

/// Nodes of a grain, estimated before it is meshed.
#[derive(Clone, Copy)]
struct Estimate {
    number: f64,
    /// Area of a node in m².
    area: f64,
    /// Distance of neighbouring nodes in m.
    spacing: f64,
}

impl Estimate {
    fn of(form: &Form) -> Self {
        match form {
            Form::Outline(outline, mesh) => Self::of_mesh(outline, mesh),
            Form::Nodes(list) => {
                let number = list.area.len() as f64;
                let area = list.area.iter().sum::<f64>() / number;
                Self {
                    number,
                    area,
                    spacing: smallest_distance(&list.position).unwrap_or(area.sqrt()),
                }
            }
        }
    }

    fn of_mesh(outline: &Outline, mesh: &Mesh) -> Self {
        let factor = match mesh.kind {
            MeshKind::Triangulated => TRIANGULAR,
            MeshKind::Lattice | MeshKind::Cells => 1.0,
        };
        let area = factor * mesh.size * mesh.size;
        Self {
            number: outline.area() / area,
            area,
            spacing: mesh.size,
        }
    }

    /// Number of pairs of nodes within a distance in m.
    fn pairs(&self, distance: f64) -> f64 {
        let neighbours = (PI * distance * distance / self.area).min(self.number);
        0.5 * self.number * neighbours
    }
}

/// What is accepted instead of a mesh that is coarser than the grain, or that has too many nodes; none for a usable one.
pub(super) fn unusable_mesh(outline: &Outline, mesh: &Mesh) -> Option<String> {
    let bounds = outline.bounds();
    let sides = bounds.upper - bounds.lower;
    let longest = sides.x.max(sides.y);
    if mesh.size > longest * (1.0 + ROUNDING) {
        return Some(format!(
            "must be at most the longer side of the grain, {longest:?} m, and should be a small part of it"
        ));
    }
    let number = Estimate::of_mesh(outline, mesh).number;
    (number > MOST_NODES).then(|| {
        format!("a grain would have about {number:.1e} nodes, but at most {MOST_NODES:.0e} are accepted; give a larger size")
    })
}

/// Refuse more nodes or bonds than can be handled.
pub(super) fn check_bonds(root: &Table, scene: &Scene) -> Result<()> {
    let horizon = scene.bonds.horizon;
    let of_grain = |grain: &GrainTable| {
        let nodes = Estimate::of(&grain.form);
        (nodes, nodes.pairs(horizon))
    };
    let all: Vec<(Estimate, f64)> = scene.grains.iter().map(of_grain).collect();
    let nodes: f64 = all.iter().map(|(nodes, _)| nodes.number).sum();
    let most = MOST_MESHES * MOST_NODES;
    if nodes > most {
        let accepted = format!(
            "would have about {nodes:.1e} nodes in all, but at most {most:.0e} are accepted; give larger mesh sizes"
        );
        return Err(root.error("grains", &accepted));
    }
    check_contacts(root, scene, &all)?;
    let bonds: f64 = all.iter().map(|(_, bonds)| bonds).sum();
    if bonds <= MOST_BONDS {
        return Ok(());
    }
    let numbered = all.iter().enumerate();
    let largest = numbered.max_by(|(_, a), (_, b)| a.1.total_cmp(&b.1));
    let (grain, spacing) = largest.map_or((0, 0.0), |(grain, (nodes, _))| (grain, nodes.spacing));
    let accepted = format!(
        "the {nodes:.1e} nodes would have about {bonds:.1e} bonds, which need {:.1e} bytes, but at most {MOST_BONDS:.2e} bonds \
         are accepted; the horizon is {:.3e} times the distance of nodes in grains[{grain}], {spacing:?} m: give a smaller \
         horizon or a larger mesh.size",
        BYTES * bonds,
        horizon / spacing
    );
    Err(root.table("bonds")?.error("horizon", &accepted))
}

/// Refuse a contact radius within which there are too many pairs of nodes that are not bonded.
fn check_contacts(root: &Table, scene: &Scene, all: &[(Estimate, f64)]) -> Result<()> {
    let radius = scene.contact.map_or(0.0, |contact| contact.law.radius);
    if radius <= scene.bonds.horizon {
        return Ok(());
    }
    let pairs: f64 = all.iter().map(|(nodes, _)| nodes.pairs(radius)).sum();
    if pairs <= MOST_BONDS {
        return Ok(());
    }
    let accepted = format!(
        "about {pairs:.1e} pairs of nodes would be nearer than that, but at most {MOST_BONDS:.2e} are accepted; the radius \
         should be about 1.5 times the distance of nodes"
    );
    Err(root.table("contact")?.error("radius", &accepted))
}

/// Largest coordinate in m of a grain in a frame of its own.
fn reach(form: &Form) -> f64 {
    let of = |points: &mut dyn Iterator<Item = Vec2>| {
        points.fold(0.0, |most: f64, at| most.max(at.x.abs()).max(at.y.abs()))
    };
    match form {
        Form::Outline(outline, _) => of(&mut outline.outer().iter().copied()),
        Form::Nodes(list) => of(&mut list.position.iter().copied()),
    }
}

/// Refuse places so far from the origin that the rounding of coordinates is a part of the distance of nodes.
pub(super) fn check_place(table: &Table, form: &Form, position: Vec2) -> Result<()> {
    let spacing = Estimate::of(form).spacing;
    let farthest = ROUNDING * spacing / f64::EPSILON;
    let local = reach(form);
    let far = local + position.x.abs().max(position.y.abs());
    let key = match () {
        () if local > farthest => outline::shape_key(table),
        () if far > farthest => "position",
        () => return Ok(()),
    };
    let accepted = format!(
        "coordinates up to {:.3e} m would be rounded by up to {:.1e} m, more than a millionth of the distance of nodes, \
         {spacing:?} m: the grain must be within {farthest:.3e} m of the origin",
        far.max(local),
        f64::EPSILON * far.max(local)
    );
    Err(table.error(key, &accepted))
}
