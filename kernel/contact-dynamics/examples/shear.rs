//! Shears a compacted packing between glued walls at constant normal stress, and measures what a step costs.
//!
//! `cargo run --release --example shear -- PACK STRAIN_PER_STEP INERTIA STRAIN TOLERANCE [forward] [BIAS]`
//!
//! The first line of PACK is `width height bodies inverse-wall-mass`; each other line is `sides circumradius x y angle
//! group` with group 0 for the lower wall, 1 for the upper wall and -1 for free bodies. Mean diameter, density and
//! normal stress are 1.

use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::assembly::{Assembly, Body, Configuration};
use gouge_contact_dynamics::detection::{DetectionSettings, HalfPlane};
use gouge_contact_dynamics::error::SetupError;
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::shape::Shapes;
use gouge_contact_dynamics::step::{Scheme, State, StepSettings, Workspace, step};
use gouge_contact_dynamics::sweep::{StopCriterion, SweepOrder, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Velocity};
use gouge_contact_dynamics::warm_start::PointKey;
use std::error::Error;
use std::time::Instant;

const DRIVEN: u32 = 1;

struct Cell {
    assembly: Assembly,
    state: State,
    width: f64,
    height: f64,
}

/// A fixed lower wall, and an upper one that is driven sideways and carries the normal stress.
fn add_walls(
    assembly: &mut Assembly,
    configuration: &mut Configuration,
    [width, height, inverse_wall_mass]: [f64; 3],
) -> Result<(), SetupError> {
    let driven = InverseMass {
        y: inverse_wall_mass,
        ..InverseMass::IMPOSED
    };
    for (mass, y, normal) in [(InverseMass::IMPOSED, 0.0, 1.0), (driven, height, -1.0)] {
        let unit = assembly.add_unit(configuration, mass, Velocity::default())?;
        let wall = HalfPlane {
            position: Vec2::new(0.0, y),
            normal: Vec2::new(0.0, normal),
        };
        assembly.add_wall(configuration, wall, unit)?;
    }
    assembly.load[DRIVEN as usize].force = Vec2::new(0.0, -width);
    Ok(())
}

fn read(path: &str) -> Result<Cell, Box<dyn Error>> {
    let text = std::fs::read_to_string(path)?;
    let parse = |line: &str| {
        line.split_whitespace()
            .map(str::parse)
            .collect::<Result<Vec<f64>, _>>()
    };
    let mut lines = text.lines();
    let head = parse(lines.next().unwrap_or_default())?;
    let [width, height, _, inverse_wall_mass] = head[..] else {
        return Err("the first line needs four numbers".into());
    };
    let domain = Domain {
        width: Some(width),
        height: None,
        periodic: true,
    };
    let (mut assembly, mut state) = (Assembly::new(domain, Shapes::new()), State::default());
    let configuration = &mut state.configuration;
    add_walls(
        &mut assembly,
        configuration,
        [width, height, inverse_wall_mass],
    )?;
    let mut shapes = std::collections::BTreeMap::new();
    for line in lines {
        let [sides, scale, x, y, angle, group] = parse(line)?[..] else {
            return Err("a body needs six numbers".into());
        };
        let shape = match shapes.get(&(sides as usize)) {
            Some(&shape) => shape,
            None if sides == 0.0 => assembly.shapes.add_disc(),
            None => assembly.shapes.add_regular(sides as usize)?,
        };
        shapes.insert(sides as usize, shape);
        let body = Body {
            shape,
            scale,
            position: Vec2::new(x, y),
            angle,
        };
        if group < 0.0 {
            assembly.add_free(configuration, body, 1.0, Velocity::default())?;
        } else {
            assembly.add_body(configuration, body, group as u32)?;
        }
    }
    Ok(Cell {
        assembly,
        state,
        width,
        height,
    })
}

/// Sum of force times branch vector over the contacts of bodies, in units of the normal stress and the cell.
fn stress(workspace: &Workspace, bodies: usize, time_step: f64, volume: f64) -> [f64; 4] {
    let mut sum = [0.0; 4];
    let bodies_only = |key: &PointKey| (key.pair.j as usize) < bodies;
    let rows = workspace.keys().iter().zip(workspace.solver().rows());
    for (_, row) in rows.filter(|(key, _)| bodies_only(key)) {
        let point = row.kinematics();
        let (n, p) = (point.normal, row.impulse());
        let tangent = n.perpendicular();
        let force = n * (p.n / time_step) + tangent * (p.t / time_step);
        let [one, other] = point.arms;
        let branch = n * (one.n - other.n) + tangent * (one.t - other.t);
        let parts = [
            force.x * branch.x,
            force.x * branch.y,
            force.y * branch.x,
            force.y * branch.y,
        ];
        sum.iter_mut()
            .zip(parts)
            .for_each(|(total, part)| *total += part / volume);
    }
    sum
}

/// Deviatoric over mean stress.
fn stress_ratio(s: [f64; 4]) -> f64 {
    let (p, shear) = (0.5 * (s[0] + s[3]), 0.5 * (s[1] + s[2]));
    (0.5 * (s[0] - s[3])).hypot(shear) / p
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [pack, numbers @ ..] = arguments.as_slice() else {
        return Err(
            "usage: shear PACK STRAIN_PER_STEP INERTIA STRAIN TOLERANCE [forward] [BIAS]".into(),
        );
    };
    let is_forward = numbers.iter().any(|word| word == "forward");
    let numbers: Vec<f64> = numbers
        .iter()
        .filter_map(|word| word.parse().ok())
        .collect();
    let [strain_per_step, inertia, strain, tolerance, bias @ ..] = numbers.as_slice() else {
        return Err("four numbers are needed".into());
    };
    let mut cell = read(pack)?;
    let settings = StepSettings {
        time_step: strain_per_step / inertia,
        scheme: Scheme::Midpoint,
        detection: DetectionSettings::for_diameter(1.0),
        law: ContactLaw {
            gap: match bias {
                [fraction] => GapRule::Stabilized {
                    fraction: *fraction,
                    allowed_overlap: 0.002,
                },
                _ => GapRule::Predicted,
            },
            ..ContactLaw::inelastic(0.4)
        },
        sweeps: SweepSettings {
            stop: StopCriterion::Increment {
                tolerance: *tolerance,
                floor: 1e-12 * strain_per_step / inertia,
            },
            order: if is_forward {
                SweepOrder::Forward
            } else {
                SweepOrder::Alternating
            },
            ..SweepSettings::default()
        },
        warm_start_distance: 0.3,
    };
    settings.validate()?;
    run(&mut cell, &settings, *inertia, *strain);
    Ok(())
}

fn run(cell: &mut Cell, settings: &StepSettings, rate: f64, strain: f64) {
    let mut workspace = Workspace::new(&cell.assembly, &cell.state, settings);
    let steps = (strain / (rate * settings.time_step)) as usize;
    let tenth = (steps / 10).max(1);
    let start = Instant::now();
    let mut sum = [0.0; 4];
    let (mut sweeps, mut visits, mut stopped, mut overlap) = (0, 0, 0, 0.0f64);
    for index in 1..=steps {
        let top = cell.state.configuration.wall[1].position.y;
        cell.state.configuration.velocity[DRIVEN as usize].linear.x = rate * top;
        let report = step(&cell.assembly, settings, &mut cell.state, &mut workspace);
        sweeps += report.sweeps.sweeps;
        visits += report.sweeps.sweeps * report.points;
        stopped += usize::from(!report.sweeps.has_converged);
        overlap = overlap.max(report.largest_overlap);
        let part = stress(
            &workspace,
            cell.assembly.shape.len(),
            settings.time_step,
            cell.width * top,
        );
        sum.iter_mut().zip(part).for_each(|(total, x)| *total += x);
        if index % tenth == 0 {
            let residual = workspace
                .solver()
                .residual(&cell.state.configuration.velocity);
            println!(
                "strain {:.3}: height {top:.3} of {:.3}, q/p {:.3}, points {}, sweeps {:.1} per step",
                index as f64 * rate * settings.time_step,
                cell.height,
                stress_ratio(sum),
                report.points,
                sweeps as f64 / tenth as f64,
            );
            println!(
                "    not converged {stopped}, overlap {overlap:.4}, residual {:.1e} diameters times the rate",
                residual / rate
            );
            (sum, sweeps, stopped) = ([0.0; 4], 0, 0);
        }
    }
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "{:.3} ms per step, {:.1} ns per point and sweep",
        1e3 * seconds / steps as f64,
        1e9 * seconds / visits as f64
    );
}
