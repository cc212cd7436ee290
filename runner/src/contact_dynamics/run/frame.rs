//! Bodies as frames, rows and grains of the page.

use super::super::Scene;
use super::super::scene::{Body, Outline, Role};
use super::statistics::{diameter, is_free};
use crate::run::page::{DRIVEN, FIXED, Grain, SINGLE};
use crate::run::table::{Kinds, Table, Values};
use crate::run::trajectory::{Frame, Shapes};
use gouge_common::estimators::Tensor;
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::assembly::Assembly;
use gouge_contact_dynamics::cell::{LOWER, UPPER};
use gouge_contact_dynamics::detection::Placed;
use gouge_contact_dynamics::observables::{add_body_moments, point_forces};
use gouge_contact_dynamics::world::World;

/// Corners of a disc in a frame of polygons.
const CORNERS: usize = 48;

/// What a body moves with.
pub fn role(scene: &Scene, assembly: &Assembly, body: usize) -> Role {
    let is_cell = scene.packing.is_some() || scene.cell.is_some();
    match assembly.unit[body] {
        _ if is_free(assembly, body) => Role::Free,
        LOWER if is_cell => Role::Floor,
        UPPER if is_cell => Role::Roof,
        _ => Role::Fixed,
    }
}

fn roles(scene: &Scene, assembly: &Assembly) -> Kinds {
    let code = |body: usize| match role(scene, assembly, body) {
        Role::Free => 0,
        Role::Fixed => 1,
        Role::Floor => 2,
        Role::Roof => 3,
    };
    Kinds {
        names: vec!["free", "fixed", "floor", "roof"],
        codes: (0..assembly.shape.len()).map(code).collect(),
    }
}

fn sides(assembly: &Assembly) -> impl Iterator<Item = usize> + '_ {
    let sides = |&shape| assembly.shapes.outline(shape).sides.len();
    assembly.shape.iter().map(sides)
}

fn radii(assembly: &Assembly) -> Vec<f64> {
    let bodies = 0..assembly.shape.len();
    bodies.map(|body| 0.5 * diameter(assembly, body)).collect()
}

/// The final bodies, with the columns of `particles.csv` and the number of sides.
fn particles(scene: &Scene, world: &World) -> Table {
    let (assembly, configuration) = (world.assembly(), &world.state().configuration);
    let number = assembly.shape.len();
    let velocity = |body: usize| configuration.velocity[assembly.unit[body] as usize];
    let numbers = |of: &dyn Fn(usize) -> f64| Values::Numbers((0..number).map(of).collect());
    let columns = vec![
        ("id", Values::Integers((0..number).collect())),
        ("x", numbers(&|body| configuration.position[body].x)),
        ("y", numbers(&|body| configuration.position[body].y)),
        ("vx", numbers(&|body| velocity(body).linear.x)),
        ("vy", numbers(&|body| velocity(body).linear.y)),
        ("angle", Values::Numbers(configuration.angle.clone())),
        ("angular_velocity", numbers(&|body| velocity(body).angular)),
        ("radius", Values::Numbers(radii(assembly))),
        ("role", Values::Kinds(roles(scene, assembly))),
        ("sides", Values::Integers(sides(assembly).collect())),
    ];
    Table { columns }
}

/// The final bodies as CSV. Bodies that the scene describes by their corners keep them, in a further column.
pub fn particles_csv(scene: &Scene, world: &World) -> String {
    let text = particles(scene, world).to_csv();
    let listed = &scene.bodies.bodies;
    let corners = |body: &Body| match &body.outline {
        Outline::Polygon(vertices) => {
            let corners = vertices.iter().map(|v| format!("{:?} {:?}", v.x, v.y));
            corners.collect::<Vec<String>>().join(";")
        }
        Outline::Regular { .. } => String::new(),
    };
    if listed.iter().all(|body| corners(body).is_empty()) {
        return text;
    }
    let cells = ["vertices".to_owned()]
        .into_iter()
        .chain(listed.iter().map(corners));
    let lines = text.lines().zip(cells);
    lines
        .map(|(line, cell)| format!("{line},{cell}\n"))
        .collect()
}

/// The corners of a body around its centroid in m; many for a disc.
pub fn outline(world: &World, body: usize) -> Vec<Vec2> {
    let (assembly, configuration) = (world.assembly(), &world.state().configuration);
    let shape = assembly.shapes.outline(assembly.shape[body]);
    let placed = Placed::new(shape, assembly.scale[body], configuration.angle[body]);
    if let Some(radius) = placed.disc_radius() {
        let angle = |k: usize| std::f64::consts::TAU * k as f64 / CORNERS as f64;
        let corner = |k| placed.to_space(Vec2::new(angle(k).cos(), angle(k).sin()) * radius);
        return (0..CORNERS).map(corner).collect();
    }
    let corner = |k| placed.to_space(placed.vertex(k));
    (0..shape.vertices.len()).map(corner).collect()
}

/// A frame of a world.
pub fn frame(scene: &Scene, world: &World) -> Frame {
    let (assembly, configuration) = (world.assembly(), &world.state().configuration);
    let positions = configuration.position.clone();
    let velocity = |&unit: &u32| configuration.velocity[unit as usize];
    let corners = |body: usize| {
        let outline = outline(world, body).into_iter();
        outline.map(|corner| positions[body] + corner).collect()
    };
    let angular = assembly.unit.iter().map(|unit| velocity(unit).angular);
    let columns = vec![
        ("angle", Values::Numbers(configuration.angle.clone())),
        ("angular_velocity", Values::Numbers(angular.collect())),
        ("pressure", Values::Numbers(pressures(scene, world))),
        ("role", Values::Kinds(roles(scene, assembly))),
        ("sides", Values::Integers(sides(assembly).collect())),
    ];
    let linear = assembly.unit.iter().map(|unit| velocity(unit).linear);
    Frame {
        time: world.time(),
        note: String::new(),
        domain: scene.domain,
        shapes: Shapes::Polygons(radii(assembly), (0..positions.len()).map(corners).collect()),
        vectors: vec![("velocity", linear.collect())],
        positions,
        scalars: Table { columns },
        lines: Vec::new(),
    }
}

/// Mean pressure in Pa in every body, from the contact forces of the latest step.
fn pressures(scene: &Scene, world: &World) -> Vec<f64> {
    let (assembly, configuration) = (world.assembly(), &world.state().configuration);
    let mut moments = vec![Tensor::default(); assembly.shape.len()];
    let step = scene.settings.time_step;
    let points = point_forces(assembly, configuration, world.workspace(), step);
    add_body_moments(points, &mut moments);
    let pressure = |(body, moment): (usize, Tensor)| -moment.mean() / assembly.area(body);
    moments.into_iter().enumerate().map(pressure).collect()
}

/// What the motion on the page shows of every body.
pub fn grains(scene: &Scene, world: &World) -> Vec<Grain> {
    let (assembly, configuration) = (world.assembly(), &world.state().configuration);
    let pressures = pressures(scene, world);
    let grain = |body: usize| {
        let speed = configuration.velocity[assembly.unit[body] as usize]
            .linear
            .norm();
        Grain {
            numbers: [
                configuration.position[body].x as f32,
                configuration.position[body].y as f32,
                configuration.angle[body] as f32,
                speed as f32,
                pressures[body] as f32,
            ],
            colour: match role(scene, assembly, body) {
                Role::Free => SINGLE,
                Role::Roof => DRIVEN,
                Role::Fixed | Role::Floor => FIXED,
            },
        }
    };
    (0..assembly.shape.len()).map(grain).collect()
}

/// Number of sides of every body for the motion, 0 for discs and for shapes that are not of a regular family.
pub fn drawn_sides(scene: &Scene, world: &World) -> Vec<u16> {
    let listed = &scene.bodies.bodies;
    let is_regular = |body: usize| {
        let listed = listed.get(body);
        listed.is_none_or(|one| matches!(one.outline, Outline::Regular { .. }))
    };
    let sides = sides(world.assembly()).enumerate();
    sides
        .map(|(body, sides)| if is_regular(body) { sides as u16 } else { 0 })
        .collect()
}
