//! The bond of LAMMPS, integrated independently.

use super::motion::recorded_motion;
use super::stored;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use crate::oracles::beams::stretched::{Pair, Stretched};
use crate::references::Table;
use gouge_dem::World;

/// The check of this file.
pub fn check() -> Check {
    Check {
        id: "references.differences.beam",
        claim: "While the line of a bond rotates, the remaining difference between the kernel and the bond of LAMMPS is the growth of the shearing moment with the squared distance: an independent integration with this moment follows LAMMPS.",
        equations: thesis("(29)-(34), (43)-(45)"),
        scene: "The runs of lammps/bond-frame",
        oracle: "Recorded motion; the beam with that moment, integrated with LAMMPS's time stepping",
        norm: "Largest error of a position, velocity or spin at any recorded step, in units of the largest displacement, speed and spin",
        origin: Origin::Exact,
        reason: "LAMMPS computes angles by an arccosine, which is zero below 2.1e-8 rad: in symmetric bending this error of the impulse stays below 1e-9 of the amplitude; for oscillations of a fifth of the angle it is 5e-9",
        effort: Effort::Quick,
        measure: follow,
    }
}

fn follow() -> Outcome {
    let case = stored("lammps/bond-frame")?;
    let mut measured = Vec::new();
    for (run, recorded) in case.runs.iter().zip(&case.result.runs) {
        let world = case.draft(run).map_err(Failure::Oracle)?.world()?;
        let motion = recorded_motion(recorded)?;
        measured.push(Measurement::absolute(0.0, largest(&world, motion)?, 5e-9));
    }
    Ok(Measurement::worst(measured).into())
}

/// The largest difference of a run.
fn largest(world: &World, motion: &Table) -> Result<f64, Failure> {
    let (beam, pair) = begin(world)?;
    let mut states = beam.steps(pair, world.model().time_step);
    let p = world.particles();
    let centre = (p.position[0] + p.position[1]) * 0.5;
    let names = ["x", "y", "vx", "vy", "omegaz"];
    let [x, y, vx, vy, w] = motion.places(names).map_err(Failure::Oracle)?;
    let mut errors = [0.0_f64; 3];
    let mut scales = [0.0_f64; 3];
    let mut done = 0;
    for (step, rows) in motion.steps().map_err(Failure::Oracle)? {
        let Some(pair) = states.nth((step - done) as usize) else {
            break;
        };
        done = step + 1;
        for (i, (row, side)) in rows.iter().zip([-0.5, 0.5]).enumerate() {
            let place = [centre.x + side * pair.way[0], centre.y + side * pair.way[1]];
            let began = [p.position[i].x, p.position[i].y];
            let found = [[row[x], row[y]], [row[vx], row[vy]], [row[w], 0.0]];
            let expected = [place, pair.rate.map(|v| side * v), [pair.spins[i], 0.0]];
            let origins = [began, [0.0; 2], [0.0; 2]];
            for kind in 0..3 {
                for axis in 0..2 {
                    let value = found[kind][axis];
                    errors[kind] = errors[kind].max((value - expected[kind][axis]).abs());
                    scales[kind] = scales[kind].max((value - origins[kind][axis]).abs());
                }
            }
        }
    }
    Ok((0..3)
        .map(|kind| errors[kind] / scales[kind])
        .fold(0.0, f64::max))
}

/// The beam of a scene with two equal spheres, and its state.
fn begin(world: &World) -> Result<(Stretched, Pair), Failure> {
    let p = world.particles();
    let bond = world.model().bond;
    let (Some(bond), Some(beam)) = (bond, bond.and_then(|bond| bond.tangential)) else {
        return Err(Failure::Oracle(
            "the scene has no bond with bending".to_owned(),
        ));
    };
    let radius = p.radius[0];
    let half = |constant: f64| 0.5 * constant;
    let way = p.position[1] - p.position[0];
    let rate = p.velocity[1] - p.velocity[0];
    Ok((
        Stretched {
            inertia: [p.mass[0], p.moment_of_inertia[0]],
            rest: way.norm(),
            normal: [bond.normal.stiffness, bond.normal.damping],
            shearing: [beam.stiffness, beam.damping].map(half),
            bending: [
                half(beam.stiffness) * radius * radius,
                half(beam.damping) * radius,
            ],
        },
        Pair {
            way: [way.x, way.y],
            rate: [rate.x, rate.y],
            angles: [0.0; 2],
            spins: [p.angular_velocity[0], p.angular_velocity[1]],
        },
    ))
}
