//! Sweeps by strips against alternating ones, with one thread and with two.

use crate::packing::Packing;
use crate::problem::Problem;
use crate::sheared;
use gouge_contact_dynamics::sweep::{SweepOrder, SweepSettings};
use rayon::ThreadPool;
use std::error::Error;

const COPIES: usize = 25;
const SWEEPS: usize = 100;
/// Few sweeps, so that other programs seldom interrupt them.
const TIMED: usize = 20;
const TURNS: usize = 60;

struct Variant<'a> {
    name: &'static str,
    settings: SweepSettings,
    /// Several threads, or the calling one.
    pool: Option<&'a ThreadPool>,
}

fn variants(pool: &ThreadPool, momentum: f64) -> [Variant<'_>; 3] {
    let plain = SweepSettings {
        momentum,
        ..SweepSettings::default()
    };
    let strips = SweepSettings {
        order: SweepOrder::Strips,
        ..plain
    };
    let variant = |name, settings, pool| Variant {
        name,
        settings,
        pool,
    };
    [
        variant("alternating", plain, None),
        variant("strips, 1 thread", strips, None),
        variant("strips, 2 threads", strips, Some(pool)),
    ]
}

/// Times are those of a clock on the wall, and the smallest of several turns.
pub fn compare(shapes: &[usize]) -> Result<(), Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
    println!("| | ms before and after | ms per sweep | residual after {SWEEPS} sweeps | error |");
    for &sides in shapes {
        let packing = Packing::dense(sides, 400, 20.0)?.repeated(COPIES);
        let (mut system, mut workspace) = sheared(&packing)?;
        let problem = Problem::of_step(&mut system, &mut workspace);
        let (bodies, points) = (packing.bodies.len(), problem.points());
        println!("|---|---|---|---|---|\n{sides} sides, {bodies} bodies, {points} points");
        let best = SweepSettings {
            momentum: 0.9,
            ..SweepSettings::default()
        };
        let reference = problem.solve(&best, 10_000);
        for momentum in [0.0, 0.9] {
            let variants = variants(&pool, momentum);
            let mut times = [f64::INFINITY; 3];
            let mut fixed = [f64::INFINITY; 3];
            for _ in 0..TURNS {
                for (time, variant) in fixed.iter_mut().zip(&variants) {
                    *time = time.min(problem.wall_time(&variant.settings, 0, variant.pool));
                }
                for (time, variant) in times.iter_mut().zip(&variants) {
                    *time = time.min(problem.wall_time(&variant.settings, TIMED, variant.pool));
                }
            }
            for ((time, fixed), variant) in times.into_iter().zip(fixed).zip(&variants) {
                let outcome = problem.solve(&variant.settings, SWEEPS);
                let error = problem.distance(&outcome.velocities, &reference.velocities);
                println!(
                    "| {}, momentum {momentum} | {:.3} | {:.3} | {:.2} | {:.2} |",
                    variant.name,
                    1e3 * fixed,
                    1e3 * (time - fixed) / TIMED as f64,
                    outcome.residual / system.rate,
                    error / system.rate
                );
            }
        }
    }
    Ok(())
}
