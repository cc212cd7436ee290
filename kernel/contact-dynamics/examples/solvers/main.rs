//! Compares methods for the impulses of a step by accuracy and processor time, and measures what a step costs.
//!
//! `cargo run --release --example solvers -p gouge-contact-dynamics [-- SIDES...]`
//!
//! For discs, hexagons and triangles (or polygons with the given numbers of sides; 0 for discs), packings of 400 bodies
//! are compacted, sheared, and repeated five times for 2000 bodies. The problem of one step is then solved by all
//! methods, with and without first guesses of the impulses. Residuals and errors are in units of the rate of shear
//! times the mean diameter; an error is the root mean square difference to the velocities after many sweeps.
//!
//! With `strips` before the numbers of sides, sweeps by strips are compared with alternating ones for 10 000 bodies.

mod clock;
mod packing;
mod problem;
mod strips;

use gouge_contact_dynamics::step::Workspace;
use gouge_contact_dynamics::sweep::{StopCriterion, SweepOrder, SweepSettings};
use packing::{Packing, System};
use problem::Problem;
use std::error::Error;

const SWEEPS: [usize; 5] = [30, 100, 300, 1000, 3000];
const MANY: usize = 100_000;

fn methods() -> Vec<(&'static str, SweepSettings)> {
    let plain = SweepSettings::default();
    let with = |momentum| SweepSettings { momentum, ..plain };
    let forward = SweepSettings {
        order: SweepOrder::Forward,
        ..plain
    };
    vec![
        ("forward sweeps", forward),
        ("alternating sweeps", plain),
        ("momentum 0.8", with(0.8)),
        ("momentum 0.9", with(0.9)),
        ("momentum 0.95", with(0.95)),
        (
            "forward, momentum 0.9",
            SweepSettings {
                momentum: 0.9,
                ..forward
            },
        ),
    ]
}

/// A packing after some shear.
fn sheared(packing: &Packing) -> Result<(System, Workspace), Box<dyn Error>> {
    let mut system = packing.system(0.4, 0.05)?;
    let mut workspace = Workspace::new(&system.assembly, &system.state, &system.settings);
    system.settings.sweeps.stop = StopCriterion::Increment {
        tolerance: 1e-2,
        floor: 0.0,
    };
    system.settings.sweeps.max_sweeps = 200;
    system.shear(400, &mut workspace);
    Ok((system, workspace))
}

/// Cost of a step without sweeps, and of a visit of a point.
fn print_costs(system: &System, workspace: &mut Workspace, problem: &Problem) {
    let mut still = system.clone();
    still.settings.sweeps.max_sweeps = 0;
    let measure = |_| clock::time(|| still.clone().shear(10, workspace)).0;
    let best = (0..20).map(measure).fold(f64::INFINITY, f64::min);
    println!("step without sweeps: {:.2} ms", 100.0 * best);
    for friction in [0.4, 0.0] {
        let problem = problem.with_friction(friction);
        for (name, settings) in methods() {
            let outcome = problem.solve(&settings, 100);
            let visits = 100.0 * problem.points() as f64;
            println!(
                "friction {friction}, {name}: {:.1} ns per visit",
                1e9 * outcome.time / visits
            );
        }
    }
}

fn print_comparison(title: &str, problem: &Problem, rate: f64) {
    let best = SweepSettings {
        momentum: 0.9,
        ..SweepSettings::default()
    };
    let reference = problem.solve(&best, MANY);
    println!(
        "\n{title}, {} points; reference residual {:.0e}\n",
        problem.points(),
        reference.residual / rate
    );
    let columns = SWEEPS.map(|sweeps| format!(" {sweeps} |"));
    println!(
        "| method | ms per 100 sweeps |{}{}",
        columns.concat(),
        columns.concat()
    );
    println!("|---|---|{}", "---|".repeat(2 * SWEEPS.len()));
    for (name, settings) in methods() {
        let outcomes = SWEEPS.map(|sweeps| problem.solve(&settings, sweeps));
        let residual = outcomes
            .each_ref()
            .map(|outcome| format!(" {:.2} |", outcome.residual / rate));
        let error = outcomes.each_ref().map(|outcome| {
            let error = problem.distance(&outcome.velocities, &reference.velocities);
            format!(" {:.2} |", error / rate)
        });
        let time = 1e3 * outcomes[2].time / 3.0;
        println!(
            "| {name} | {time:.2} |{}{}",
            residual.concat(),
            error.concat()
        );
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut words = std::env::args().skip(1).peekable();
    let is_about_strips = words.next_if_eq("strips").is_some();
    let mut shapes = words
        .map(|word| word.parse())
        .collect::<Result<Vec<usize>, _>>()?;
    if shapes.is_empty() {
        shapes = vec![0, 6, 3];
    }
    if is_about_strips {
        return strips::compare(&shapes);
    }
    for sides in shapes {
        let packing = Packing::dense(sides, 400, 20.0)?;
        for copies in [1, 5] {
            let (mut system, mut workspace) = sheared(&packing.repeated(copies))?;
            let problem = Problem::of_step(&mut system, &mut workspace);
            let title = format!("{sides} sides, {} bodies", 400 * copies);
            println!("\n{title}, height {:.1}", packing.height);
            print_costs(&system, &mut workspace, &problem);
            print_comparison(&format!("{title}, warm"), &problem, system.rate);
            print_comparison(&format!("{title}, cold"), &problem.cold(), system.rate);
        }
    }
    Ok(())
}
