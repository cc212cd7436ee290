//! Growth of the time per particle-step with the number of particles, from cache to memory.

use crate::peers::{Case, Timer};
use crate::sample::Sample;
use crate::worlds::{Friction, pressed, rubbing};
use gouge_runner::error::Error;

/// Particle-steps per measurement.
const WORK: u64 = 4_000_000;

/// Time growing numbers of pressed grains in the given number of rounds over all sizes. Each time is compared with that
/// of the smallest size in the same round.
///
/// # Errors
/// A scene that cannot be set up.
pub fn measure(rounds: usize, largest: usize) -> Result<Vec<Case>, Error> {
    let (small, whole) = (pressed(0.0375)?, pressed(0.1)?);
    let mut timers = Vec::new();
    for (packing, times) in [
        (&small, 1),
        (&whole, 1),
        (&whole, 4),
        (&whole, 12),
        (&whole, 37),
        (&whole, 120),
        (&whole, 374),
    ] {
        let number = packing.particles().len() * times;
        if number <= largest {
            let world = rubbing(packing, Friction::CundallStrack, times)?;
            timers.push((number, Timer::new(world, 10)?, Sample::default()));
        }
    }
    for _ in 0..rounds {
        for (number, timer, sample) in &mut timers {
            let steps = (WORK / *number as u64).max(4);
            sample.0.push(timer.time(steps)?);
        }
    }
    let name = |number: usize| format!("{number} particles");
    let fewest = timers.first();
    let fewest = fewest.map(|(number, _, sample)| (name(*number), sample.clone()));
    let cases = timers.into_iter().enumerate();
    let cases = cases.map(|(position, (number, timer, sample))| {
        let beside = fewest.clone().filter(|_| position > 0);
        let case = timer.case(&name(number), sample, beside);
        println!("{}", case.words());
        case
    });
    Ok(cases.collect())
}
