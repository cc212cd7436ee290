//! What a step costs, and how fast sweeps converge.
mod clock;
mod packing;

use gouge_contact_dynamics::law::ContactLaw;
use gouge_contact_dynamics::step::{Workspace, step};
use gouge_contact_dynamics::sweep::{ContactInput, Solver, StopCriterion, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Velocity};
use packing::Packing;
use std::error::Error;

/// The problem of one step.
pub struct Problem {
    pub points: Vec<ContactInput>,
    pub before: Vec<Velocity>,
    pub free: Vec<Velocity>,
    pub masses: Vec<InverseMass>,
    pub law: ContactLaw,
    pub time_step: f64,
}

fn problem(system: &mut packing::System, workspace: &mut Workspace) -> Problem {
    system.drive();
    let before = system.state.configuration.velocity.clone();
    let memory = system.state.memory.clone();
    let mut free = system.state.configuration.clone();
    free.accelerate(&system.assembly, system.settings.time_step);
    step(
        &system.assembly,
        &system.settings,
        &mut system.state,
        workspace,
    );
    let mut memory = memory;
    let mut guesses = Vec::new();
    memory.guess(
        workspace.keys(),
        system.settings.warm_start_distance,
        &mut guesses,
    );
    let mut points = workspace.points().to_vec();
    for (point, guess) in points.iter_mut().zip(guesses) {
        point.impulse = guess;
    }
    Problem {
        points,
        before,
        free: free.velocity,
        masses: system.assembly.inverse_mass.clone(),
        law: system.settings.law,
        time_step: system.settings.time_step,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let shapes: Vec<usize> = std::env::args()
        .skip(1)
        .filter_map(|word| word.parse().ok())
        .collect();
    for sides in shapes {
        let packing = Packing::dense(sides, 400, 20.0)?;
        let mut system = packing.repeated(5).system(0.4, 0.05)?;
        let mut workspace = Workspace::new(&system.assembly, &system.state, &system.settings);
        system.settings.sweeps.stop = StopCriterion::Increment {
            tolerance: 1e-2,
            floor: 0.0,
        };
        system.settings.sweeps.max_sweeps = 200;
        system.shear(400, &mut workspace);
        let p = problem(&mut system, &mut workspace);
        println!(
            "sides {sides}: height {:.3}, points {}",
            packing.height,
            p.points.len()
        );
        let mut best = f64::MAX;
        for _ in 0..20 {
            let sweeps = system.settings.sweeps;
            system.settings.sweeps.max_sweeps = 0;
            let mut copy = system.clone();
            best = best.min(clock::time(|| copy.shear(10, &mut workspace)).0);
            system.settings.sweeps = sweeps;
        }
        println!("  step without sweeps {:.3} ms", 1e3 * best / 10.0);
        for friction in [0.4, 0.0] {
            for streams in [1, 4] {
                let all = &p.points;
                let chunk = all.len().div_ceil(streams);
                let points: Vec<_> = (0..chunk)
                    .flat_map(|k| (0..streams).filter_map(move |s| all.get(s * chunk + k)))
                    .copied()
                    .collect();
                let law = ContactLaw { friction, ..p.law };
                for count in [30, 300] {
                    let sweeps = SweepSettings {
                        stop: StopCriterion::Increment {
                            tolerance: 0.0,
                            floor: 0.0,
                        },
                        max_sweeps: count,
                        ..SweepSettings::default()
                    };
                    let mut solver = Solver::new();
                    let mut best = f64::MAX;
                    let mut residual = 0.0;
                    for _ in 0..600 / count {
                        solver.prepare(&points, &law, p.time_step, &p.before, &p.masses);
                        let mut v = p.free.clone();
                        let (time, _) = clock::time(|| solver.solve(&sweeps, &p.masses, &mut v));
                        best = best.min(time);
                        residual = solver.residual(&v);
                    }
                    println!(
                        "  mu {friction} streams {streams} sweeps {count}: {:.2} ns per visit, residual {residual:e}",
                        1e9 * best / count as f64 / points.len() as f64
                    );
                }
            }
        }
    }
    Ok(())
}
