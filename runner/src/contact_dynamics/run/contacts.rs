//! Contact points as a table.

use super::super::Scene;
use super::begin::{after_compaction, first};
use crate::error::Error;
use crate::run::table::{Kinds, Table, Values};
use gouge_contact_dynamics::observables::point_forces;
use gouge_contact_dynamics::world::World;

/// The contact points of the first step from t = 0, after the compaction.
///
/// # Errors
/// Scenes that the kernel refuses, or a step that fails.
pub fn contacts(scene: &Scene) -> Result<Table, Error> {
    let mut world = at_beginning(scene)?;
    let step = |source| Error::ContactDynamicsStep {
        phase: "run".to_owned(),
        source,
    };
    world.step().map_err(step)?;
    Ok(table_of_points(scene, &world))
}

/// The world at t = 0 of the scene proper, without any output.
///
/// # Errors
/// Scenes that the kernel refuses, or a compaction that fails.
pub fn at_beginning(scene: &Scene) -> Result<World, Error> {
    let mut world = first(scene)?;
    let Some(table) = &scene.packing else {
        return Ok(world);
    };
    while !world.has_settled() {
        let steps = table.compaction.max_steps;
        if world.steps() >= steps {
            return Err(Error::Unsettled { steps });
        }
        world.step().map_err(|source| Error::ContactDynamicsStep {
            phase: "compact".to_owned(),
            source,
        })?;
    }
    after_compaction(scene, table, world)
}

/// The contact points of the latest step. Walls are counted after all bodies; the normal points from i to j, and forces
/// and impulses act on j.
pub fn table_of_points(scene: &Scene, world: &World) -> Table {
    let (assembly, configuration) = (world.assembly(), &world.state().configuration);
    let step = scene.settings.time_step;
    let points: Vec<_> = point_forces(assembly, configuration, world.workspace(), step).collect();
    let bodies = assembly.unit.len() as u32;
    let gaps = world.workspace().points().iter().map(|point| point.gap);
    let same = |a: usize, b: usize| {
        points
            .get(a)
            .zip(points.get(b))
            .is_some_and(|(a, b)| (a.first, a.second) == (b.first, b.second))
    };
    let bears = |k: usize| points[k].force.n > 0.0;
    let code = |k: usize| match k {
        k if points[k].first >= bodies => 0,
        k if bears(k)
            && (same(k, k + 1) && bears(k + 1) || k > 0 && same(k, k - 1) && bears(k - 1)) =>
        {
            2
        }
        _ => 1,
    };
    let kinds = Kinds {
        names: vec!["wall", "side-vertex", "side-side"],
        codes: (0..points.len()).map(code).collect(),
    };
    let place = |k: usize| {
        let (point, second) = (&points[k], points[k].second as usize);
        let (n, arm) = (point.normal, point.arms[1]);
        configuration.position[second] + n * arm.n + n.perpendicular() * arm.t
    };
    let places: Vec<_> = (0..points.len()).map(place).collect();
    let numbers = |of: &dyn Fn(usize) -> f64| Values::Numbers((0..points.len()).map(of).collect());
    let columns = vec![
        (
            "i",
            Values::Integers(points.iter().map(|p| p.first as usize).collect()),
        ),
        (
            "j",
            Values::Integers(points.iter().map(|p| p.second as usize).collect()),
        ),
        ("kind", Values::Kinds(kinds)),
        ("x", numbers(&|k| places[k].x)),
        ("y", numbers(&|k| places[k].y)),
        ("normal_x", numbers(&|k| points[k].normal.x)),
        ("normal_y", numbers(&|k| points[k].normal.y)),
        ("gap", Values::Numbers(gaps.collect())),
        ("normal_force", numbers(&|k| points[k].force.n)),
        ("tangential_force", numbers(&|k| points[k].force.t)),
        ("normal_impulse", numbers(&|k| points[k].force.n * step)),
        ("tangential_impulse", numbers(&|k| points[k].force.t * step)),
    ];
    Table { columns }
}
