//! How worlds use the machine: nothing here changes a bit of a result.

use crate::error::Error;
use gouge_common::instructions::Instructions;
use gouge_dem::{Number, World};
use rayon::ThreadPoolBuilder;
use std::sync::LazyLock;

/// The environment variable that names the instructions to use instead of the widest ones.
pub const INSTRUCTIONS: &str = "GOUGE_INSTRUCTIONS";
/// The environment variable that says how many threads compute, instead of [`default_threads`].
pub const THREADS: &str = "GOUGE_THREADS";

/// Particles below which a second thread costs more than it gives.
const PARTICLES_PER_THREAD: usize = 10_000;
/// Most threads that one may ask for.
const MAX_THREADS: usize = 1024;

/// What the environment asks for.
#[derive(Clone, Copy, Debug)]
pub struct Machine {
    /// The instructions that worlds use.
    pub instructions: Instructions,
    /// The number of threads, where it does not follow from the size of the world.
    pub threads: Option<usize>,
}

static CHOSEN: LazyLock<Result<Machine, String>> = LazyLock::new(|| {
    Ok(Machine {
        instructions: chosen_instructions()?,
        threads: chosen_threads()?,
    })
});

fn chosen_instructions() -> Result<Instructions, String> {
    let Some(name) = std::env::var_os(INSTRUCTIONS) else {
        return Ok(Instructions::widest());
    };
    let available = Instructions::available();
    let found = available
        .iter()
        .find(|set| name.to_str() == Some(set.name()));
    found.copied().ok_or_else(|| {
        let names: Vec<&str> = available.iter().map(|set| set.name()).collect();
        format!(
            "{INSTRUCTIONS} = {}: this machine has {}",
            name.to_string_lossy(),
            names.join(", ")
        )
    })
}

fn chosen_threads() -> Result<Option<usize>, String> {
    let Some(text) = std::env::var_os(THREADS) else {
        return Ok(None);
    };
    let number = text.to_str().and_then(|text| text.parse().ok());
    match number.filter(|number| (1..=MAX_THREADS).contains(number)) {
        Some(number) => Ok(Some(number)),
        None => Err(format!(
            "{THREADS} = {}: must be an integer from 1 to {MAX_THREADS}",
            text.to_string_lossy()
        )),
    }
}

/// Whether the thread that starts the pool belongs to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CallingThread {
    /// It steps worlds itself, and is one of the threads: outside the pool it would be woken several times per
    /// step.
    JoinsPool,
    /// It waits for threads that it starts, so that the pool cannot count on it.
    StaysOutside,
}

/// Start a pool of as many threads as the environment asks for, and return what it asks for; for main functions.
///
/// # Errors
/// Instructions that this machine has not, numbers of threads that are none.
pub fn start_pool(caller: CallingThread) -> Result<Machine, Error> {
    let machine = CHOSEN.clone().map_err(Error::Argument)?;
    let mut pool = ThreadPoolBuilder::new().num_threads(machine.threads.unwrap_or_default());
    if caller == CallingThread::JoinsPool {
        pool = pool.use_current_thread();
    }
    // A pool that is at work already keeps its threads.
    let _ = pool.build_global();
    Ok(machine)
}

/// Threads for a world of so many particles: one, or all of the machine where each has enough to do.
pub fn default_threads(particles: usize) -> usize {
    let available = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    (particles / PARTICLES_PER_THREAD).clamp(1, available)
}

/// The world with the instructions and threads that the environment asks for; the default ones if what it asks for
/// is an error.
pub fn with_chosen_execution<S: Number>(world: World<S>) -> World<S> {
    let default = Machine {
        instructions: Instructions::widest(),
        threads: None,
    };
    let machine = CHOSEN.as_ref().copied().unwrap_or(default);
    let particles = world.particles().len();
    let threads = machine
        .threads
        .unwrap_or_else(|| default_threads(particles));
    world
        .with_instructions(machine.instructions)
        .with_threads(threads)
}
