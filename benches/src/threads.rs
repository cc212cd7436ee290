//! One thread beside several, in turns.

use crate::peers::{Case, Timer};
use crate::sample::Sample;
use crate::worlds::{Friction, pressed, rubbing};
use gouge_kernel::World;
use gouge_validation::error::Error;
use gouge_validation::machine::default_threads;
use rayon::iter::{IntoParallelRefMutIterator, ParallelIterator};

/// Particle-steps of a measurement: few, so that all of a turn see the same moods of the machine.
const WORK: u64 = 4_000_000;
/// Steps before each measurement, after which caches hold what they hold in a long run.
const WARM_UP: u64 = 10;

/// Time pressed grains with one thread and with as many as are chosen by default for their number; beside the
/// latter also smaller worlds of a thread each.
///
/// One world is advanced by both in turns: a copy lies elsewhere in memory, which alone makes some per cent.
///
/// # Errors
/// Scenes that cannot be set up.
pub fn measure(rounds: usize) -> Result<Vec<Case>, Error> {
    let packing = pressed(0.1)?;
    let mut cases = Vec::new();
    for times in [1, 37] {
        let world = rubbing(&packing, Friction::CundallStrack, times)?;
        let number = world.particles().len();
        let threads = default_threads(number);
        let steps = WORK / number as u64;
        let mut timer = Timer::new(world, WARM_UP)?;
        let mut shares = Vec::new();
        if threads > 1 {
            shares = worlds_of_a_thread(&packing, times, threads)?;
        }
        let mut samples = [(); 3].map(|()| Sample::default());
        let [alone, together, apart] = &mut samples;
        for _ in 0..rounds {
            for (count, sample) in [(1, &mut *alone), (threads, &mut *together)] {
                timer = timer.divided(count);
                timer.time(WARM_UP)?;
                sample.0.push(timer.time(steps)?);
            }
            if threads > 1 {
                time_side_by_side(&mut shares, WARM_UP)?;
                apart.0.push(time_side_by_side(&mut shares, steps)?);
            }
        }
        let plural = if threads == 1 { "" } else { "s" };
        let name = format!("{number} particles, {threads} thread{plural}");
        let [alone, together, apart] = samples;
        cases.push(timer.case(
            &name,
            together.clone(),
            Some(("one thread".to_owned(), alone)),
        ));
        if let Some(share) = shares.pop() {
            let name = format!("{name}, beside smaller worlds");
            let peer = format!(
                "{threads} worlds of {} side by side",
                share.world().particles().len()
            );
            cases.push(share.case(&name, together, Some((peer, apart))));
        }
    }
    for case in &cases {
        println!("{}", case.words());
    }
    Ok(cases)
}

/// Worlds that have about as many particles together as the packing repeated so many times.
fn worlds_of_a_thread(packing: &World, times: usize, threads: usize) -> Result<Vec<Timer>, Error> {
    let share = || rubbing(packing, Friction::CundallStrack, times / threads);
    (0..threads)
        .map(|_| Timer::new(share()?, WARM_UP))
        .collect()
}

/// Time of a particle-step in ns, over so many more steps, of worlds that have nothing to do with each other:
/// what the threads of the machine can do at best.
fn time_side_by_side(timers: &mut [Timer], steps: u64) -> Result<f64, Error> {
    let number = timers.len() as f64;
    let times: Vec<f64> = timers
        .par_iter_mut()
        .map(|timer| timer.time(steps))
        .collect::<Result<_, _>>()?;
    Ok(times.iter().sum::<f64>() / (number * number))
}
