//! Forces of a bond compared with an engine whose beam becomes stiffer when stretched.

use super::motion::recorded_motion;
use crate::checks::{Exhibit, Failure, Measurement, Outcome, Table};
use crate::references::{Case, RecordedRun, Run};
use gouge_common::geometry::Vec2;
use gouge_dem::World;

/// Compares the forces on the first particle and both torques after adding the difference of the laws.
pub(super) fn compare(case: &Case) -> Outcome {
    let mut table = Table::new(
        "Torque on the first particle in N m",
        &[
            "run",
            "strain",
            "kernel",
            &case.result.engine,
            "difference",
            "difference of the laws",
        ],
    );
    let mut measured = Vec::new();
    for (run, recorded) in case.runs.iter().zip(&case.result.runs) {
        measured.extend(compare_run(case, run, recorded, &mut table)?);
    }
    let agreement = Exhibit::Text(case.agreement.clone());
    Ok(Measurement::worst(measured).showing([agreement, Exhibit::Table(table)]))
}

fn compare_run(
    case: &Case,
    run: &Run,
    recorded: &RecordedRun,
    table: &mut Table,
) -> Result<[Measurement; 4], Failure> {
    let mut world = case.draft(run).map_err(Failure::Oracle)?.world()?;
    world.evaluate_if_pending()?;
    let motion = recorded_motion(recorded)?;
    let names = ["fx", "fy", "tqz"];
    let [fx, fy, tqz] = motion.places(names).map_err(Failure::Oracle)?;
    let [first, second] = &motion.rows[..] else {
        return Err(Failure::Oracle("a bond has two ends".to_owned()));
    };
    let more = stiffening(&world)?;
    let forces = world.forces();
    let force = forces.force[0] + more.force;
    let scale = force.norm();
    let radius = world.particles().radius[0];
    let strain = more.strain;
    table.push([
        run.name.clone(),
        format!("{strain:.3e}"),
        format!("{:.9e}", forces.torque[0]),
        format!("{:.9e}", first[tqz]),
        format!("{:.6e}", first[tqz] - forces.torque[0]),
        format!("{:.6e}", more.torque),
    ]);
    let torque = |end: usize, row: &[f64]| {
        let found = forces.torque[end] + more.torque;
        Measurement::scaled(row[tqz], found, scale * radius, case.tolerance)
    };
    Ok([
        Measurement::scaled(first[fx], force.x, scale, case.tolerance),
        Measurement::scaled(first[fy], force.y, scale, case.tolerance),
        torque(0, first),
        torque(1, second),
    ])
}

/// The difference between the engine's beam and the thesis's.
struct Stiffening {
    strain: f64,
    force: Vec2,
    torque: f64,
}

/// The difference of the laws for equal radii: the engine's shearing moment is the thesis's, times the
/// squared ratio of the distance to the rest length.
fn stiffening(world: &World) -> Result<Stiffening, Failure> {
    let links = world.interactions();
    let bond = world.model().bond.and_then(|bond| bond.tangential);
    let (Some(link), Some(beam)) = (links.first(), bond) else {
        return Err(Failure::Oracle(
            "the scene has no bond with bending".to_owned(),
        ));
    };
    let [first, second] = link.tangential_displacement;
    let radius = world.particles().radius[0];
    let strain = -link.adjusted_normal_displacement / (2.0 * radius);
    let growth = strain * (2.0 + strain);
    let torque = -0.5 * beam.stiffness * radius * growth * (first + second);
    Ok(Stiffening {
        strain,
        force: link.normal.perpendicular() * (2.0 * torque / link.distance),
        torque,
    })
}
