//! Compares one thread with several, measured in turns.

use crate::peers::{Case, Timer};
use crate::sample::Sample;
use crate::worlds::{Friction, pressed, rubbing};
use gouge_dem::World;
use gouge_runner::error::Error;
use gouge_runner::machine::default_threads;
use rayon::iter::{IntoParallelRefMutIterator, ParallelIterator};

/// Particle-steps per measurement: few, so that all measurements of a round see the same load of the machine.
const WORK: u64 = 4_000_000;
/// Number of warm-up steps before each measurement, which fill the caches as in a long run.
const WARM_UP: u64 = 10;

/// Time few and many pressed grains with one thread and with the default number of threads for their number. Several
/// threads are also compared with as many smaller worlds of one thread each.
///
/// # Errors
/// A scene that cannot be set up.
pub fn measure(rounds: usize) -> Result<Vec<Case>, Error> {
    let packing = pressed(0.1)?;
    let mut cases = Vec::new();
    for times in [1, 37] {
        cases.extend(compare(&packing, times, rounds)?);
    }
    for case in &cases {
        println!("{}", case.words());
    }
    Ok(cases)
}

/// Time the packing repeated `times` times.
///
/// The same world is advanced by one thread and by several in turns. A copy would be at another place in memory, which
/// alone changes the time by some per cent.
fn compare(packing: &World, times: usize, rounds: usize) -> Result<Vec<Case>, Error> {
    let world = rubbing(packing, Friction::CundallStrack, times)?;
    let number = world.particles().len();
    let threads = default_threads(number);
    let steps = WORK / number as u64;
    let mut whole = Timer::new(world, WARM_UP)?;
    let mut shares = shares(packing, times, threads)?;
    let [mut alone, mut together, mut apart] = [(); 3].map(|()| Sample::default());
    for _ in 0..rounds {
        for (count, sample) in [(1, &mut alone), (threads, &mut together)] {
            whole = whole.with_threads(count);
            whole.time(WARM_UP)?;
            sample.0.push(whole.time(steps)?);
        }
        if !shares.is_empty() {
            time_side_by_side(&mut shares, WARM_UP)?;
            apart.0.push(time_side_by_side(&mut shares, steps)?);
        }
    }
    let plural = if threads == 1 { "" } else { "s" };
    let name = format!("{number} particles, {threads} thread{plural}");
    let one = Some(("one thread".to_owned(), alone));
    let mut cases = vec![whole.case(&name, together.clone(), one)];
    if let Some(share) = shares.first() {
        let name = format!("{name}, beside smaller worlds");
        let number = share.world().particles().len();
        let peer = format!("{threads} worlds of {number} side by side");
        cases.push(whole.case(&name, together, Some((peer, apart))));
    }
    Ok(cases)
}

/// Worlds of one thread each, which together have about as many particles as the packing repeated `times` times. None
/// for a single thread.
fn shares(packing: &World, times: usize, threads: usize) -> Result<Vec<Timer>, Error> {
    let number = if threads > 1 { threads } else { 0 };
    let share = || rubbing(packing, Friction::CundallStrack, times / threads);
    (0..number).map(|_| Timer::new(share()?, WARM_UP)).collect()
}

/// Time per particle-step in ns of independent worlds, over a number of further steps. It is a lower bound for several
/// threads on one world.
fn time_side_by_side(timers: &mut [Timer], steps: u64) -> Result<f64, Error> {
    let number = timers.len() as f64;
    let times: Vec<f64> = timers
        .par_iter_mut()
        .map(|timer| timer.time(steps))
        .collect::<Result<_, _>>()?;
    Ok(times.iter().sum::<f64>() / (number * number))
}
