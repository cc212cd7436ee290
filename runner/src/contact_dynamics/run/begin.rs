//! The worlds at the beginning of the phases of a scene.

use super::super::Scene;
use super::super::scene::{Body, Outline, PackingTable, Role, Wall};
use crate::error::Error;
use crate::machine::chosen_threads_for;
use crate::random::random;
use crate::run::NamedPhase;
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::assembly::{self, Assembly, Configuration};
use gouge_contact_dynamics::cell::{Cell, LOWER, UPPER};
use gouge_contact_dynamics::detection::HalfPlane;
use gouge_contact_dynamics::error::SetupError;
use gouge_contact_dynamics::law::ContactLaw;
use gouge_contact_dynamics::preparation::{Filling, deposit, draw_diameters, glue, inscribe};
use gouge_contact_dynamics::shape::{ShapeId, Shapes};
use gouge_contact_dynamics::step::{State, StepSettings};
use gouge_contact_dynamics::sweep::{StopCriterion, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Velocity};
use gouge_contact_dynamics::world::World;

/// Smallest mean impulse of the stop criterion of a compaction in impulses of the load on a mean diameter.
const FLOOR: f64 = 1e-12;

/// The phases of a scene: the compaction, if there is one, and the scene proper.
pub fn phases(scene: &Scene) -> Vec<NamedPhase> {
    let named = |name: &str, steps| NamedPhase {
        name: name.to_owned(),
        steps,
    };
    let compaction = scene.packing.as_ref();
    let compaction = compaction.map(|table| named("compact", table.compaction.max_steps));
    compaction
        .into_iter()
        .chain([named("run", scene.steps())])
        .collect()
}

/// The world at the beginning of the run; of the compaction, if there is one.
///
/// # Errors
/// What the kernel refuses.
pub fn first(scene: &Scene) -> Result<World, Error> {
    Ok(match &scene.packing {
        Some(table) => loose(scene, table)?,
        None => listed(scene)?,
    })
}

fn loose(scene: &Scene, table: &PackingTable) -> Result<World, SetupError> {
    let width = scene.domain.width.unwrap_or(0.0);
    let range = table.sizes.range();
    let diameters = draw_diameters(range, table.bodies, random(table.seed, 1));
    let deposited = deposit(&diameters, width)?;
    let compaction = &table.compaction;
    let filling = Filling {
        sides: table.sides,
        density: scene.density,
        roof_mass: compaction.roof_mass,
    };
    let angles = random(table.seed, 2);
    let cell = inscribe(&deposited, &diameters, width, &filling, angles)?;
    let settings = StepSettings {
        time_step: compaction.step,
        law: ContactLaw {
            friction: compaction.friction,
            gap: scene.settings.law.gap,
            ..ContactLaw::inelastic(0.0)
        },
        sweeps: SweepSettings {
            stop: StopCriterion::Increment {
                tolerance: compaction.tolerance,
                floor: FLOOR * compaction.step * range.mean(),
            },
            max_sweeps: compaction.max_sweeps,
            ..SweepSettings::default()
        },
        ..scene.settings
    };
    World::of_cell(cell, settings, compaction.drive)
}

/// The world of the scene proper after its compaction.
///
/// # Errors
/// What the kernel refuses.
pub fn after_compaction(
    scene: &Scene,
    table: &PackingTable,
    compacted: World,
) -> Result<World, Error> {
    let cell = glue(&compacted.into_cell(), table.glue.distance, scene.density)?;
    Ok(of_cell(scene, cell)?)
}

fn of_cell(scene: &Scene, cell: Cell) -> Result<World, SetupError> {
    let world = match &scene.shear {
        Some(shear) => World::of_cell(cell, scene.settings, shear.drive())?,
        None => World::new(cell.assembly, cell.state, scene.settings)?,
    };
    Ok(with_output(scene, world))
}

/// The world with the threads of the environment, and with the work that the scene asks for.
fn with_output(scene: &Scene, world: World) -> World {
    let threads = chosen_threads_for(world.assembly().unit.len());
    world.with_threads(threads).with_work(scene.output.energy)
}

/// The world of the bodies and walls that the scene lists.
fn listed(scene: &Scene) -> Result<World, SetupError> {
    let mut shapes = Shapes::new();
    let mut made: Vec<(Outline, ShapeId)> = Vec::new();
    let mut ids = Vec::new();
    for body in &scene.bodies.bodies {
        let family = family(&body.outline);
        let known = made.iter().find(|(outline, _)| *outline == family);
        let id = match known {
            Some((_, id)) => *id,
            None => {
                let id = add_shape(&mut shapes, &family)?;
                made.push((family, id));
                id
            }
        };
        ids.push(id);
    }
    if let Some(table) = &scene.cell {
        let roof = InverseMass {
            y: 1.0 / table.roof_mass,
            ..InverseMass::IMPOSED
        };
        let width = scene.domain.width.unwrap_or(0.0);
        let mut cell = Cell::new(width, table.height, roof, shapes)?;
        let parts = (&mut cell.assembly, &mut cell.state.configuration);
        add_bodies(scene, &ids, parts)?;
        return of_cell(scene, cell);
    }
    let (mut assembly, mut state) = (Assembly::new(scene.domain, shapes), State::default());
    let configuration = &mut state.configuration;
    for wall in &scene.bodies.walls {
        add_wall(&mut assembly, configuration, wall)?;
    }
    add_bodies(scene, &ids, (&mut assembly, configuration))?;
    let world = World::new(assembly, state, scene.settings)?;
    Ok(with_output(scene, world))
}

/// The outline of unit size, which bodies of all sizes share.
fn family(outline: &Outline) -> Outline {
    match outline {
        Outline::Regular { sides, .. } => Outline::Regular {
            sides: *sides,
            radius: 1.0,
        },
        Outline::Polygon(_) => outline.clone(),
    }
}

fn add_shape(shapes: &mut Shapes, family: &Outline) -> Result<ShapeId, SetupError> {
    match family {
        Outline::Regular { sides: None, .. } => Ok(shapes.add_disc()),
        Outline::Regular {
            sides: Some(sides), ..
        } => shapes.add_regular(*sides),
        Outline::Polygon(vertices) => shapes.add_polygon(vertices),
    }
}

fn add_wall(
    assembly: &mut Assembly,
    configuration: &mut Configuration,
    wall: &Wall,
) -> Result<(), SetupError> {
    let velocity = Velocity {
        linear: wall.velocity,
        angular: 0.0,
    };
    let unit = assembly.add_unit(configuration, InverseMass::IMPOSED, velocity)?;
    let plane = HalfPlane {
        position: wall.position,
        normal: wall.normal,
    };
    assembly.add_wall(configuration, plane, unit)
}

fn add_bodies(
    scene: &Scene,
    shapes: &[ShapeId],
    (assembly, configuration): (&mut Assembly, &mut Configuration),
) -> Result<(), SetupError> {
    for (body, &shape) in scene.bodies.bodies.iter().zip(shapes) {
        let placed = assembly::Body {
            shape,
            scale: scale(body),
            position: body.position,
            angle: body.angle,
        };
        let unit = match body.role {
            Role::Floor => LOWER,
            Role::Roof => UPPER,
            Role::Fixed => {
                assembly.add_unit(configuration, InverseMass::IMPOSED, Velocity::default())?
            }
            Role::Free => {
                assembly.add_free(configuration, placed, body.density, body.velocity)?;
                continue;
            }
        };
        assembly.add_body(configuration, placed, unit)?;
    }
    apply_gravity(assembly, scene.gravity);
    Ok(())
}

fn scale(body: &Body) -> f64 {
    match body.outline {
        Outline::Regular { radius, .. } => radius,
        Outline::Polygon(_) => 1.0,
    }
}

fn apply_gravity(assembly: &mut Assembly, gravity: Vec2) {
    let units = assembly.inverse_mass.iter().zip(&mut assembly.load);
    for (inverse, load) in units.filter(|(inverse, _)| inverse.rotation > 0.0) {
        load.force = gravity * (1.0 / inverse.x);
    }
}
