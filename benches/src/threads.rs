//! One thread beside two, in turns.

use crate::peers::{Case, Timer};
use crate::sample::Sample;
use crate::worlds::{Friction, pressed, rubbing};
use gouge_validation::error::Error;
use gouge_validation::machine::{default_threads, divided};

/// Particle-steps of a measurement: few, so that both of a turn see the same moods of the machine.
const WORK: u64 = 4_000_000;

/// Time pressed grains with one thread and with as many as are chosen by default for their number.
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
        let mut one = Timer::new(divided(world.clone(), 1), 10)?;
        let mut several = Timer::new(divided(world, threads), 10)?;
        let (mut alone, mut together) = (Sample::default(), Sample::default());
        for _ in 0..rounds {
            let steps = WORK / number as u64;
            alone.0.push(one.time(steps)?);
            together.0.push(several.time(steps)?);
        }
        let plural = if threads == 1 { "" } else { "s" };
        let name = format!("{number} particles, {threads} thread{plural}");
        let case = several.case(&name, together, Some(("one thread".to_owned(), alone)));
        println!("{}", case.words());
        cases.push(case);
    }
    Ok(cases)
}
