//! Instructions and threads that worlds use. Results have the same bits for every choice.

use crate::error::Error;
use gouge_common::instructions::Instructions;
use gouge_dem::{Number, World};
use rayon::ThreadPoolBuilder;
use std::sync::LazyLock;

/// The environment variable that names the instructions to use instead of the widest ones.
pub const INSTRUCTIONS: &str = "GOUGE_INSTRUCTIONS";
/// The environment variable that sets the number of threads, instead of [`default_threads`].
pub const THREADS: &str = "GOUGE_THREADS";

/// Number of particles per thread below which another thread costs more than it saves.
const PARTICLES_PER_THREAD: usize = 10_000;
/// Largest number of threads that is accepted.
const MAX_THREADS: usize = 1024;

/// The choices made by the environment variables.
#[derive(Clone, Copy, Debug)]
pub struct Machine {
    /// The instructions that worlds use.
    pub instructions: Instructions,
    /// The number of threads; if absent, it follows from the size of the world.
    pub threads: Option<usize>,
}

static CHOSEN: LazyLock<Result<Machine, String>> = LazyLock::new(|| {
    Ok(Machine {
        instructions: chosen_instructions()?,
        threads: chosen_threads()?,
    })
});

/// Names of the instructions for which worlds are compiled, the widest last.
pub const COMPILED_FOR: &[&str] = Instructions::COMPILED_FOR;

/// Names of the instructions that this machine has, the widest last.
pub fn instruction_names() -> Vec<&'static str> {
    Instructions::available()
        .iter()
        .map(|set| set.name())
        .collect()
}

fn chosen_instructions() -> Result<Instructions, String> {
    let Some(name) = std::env::var_os(INSTRUCTIONS) else {
        return Ok(Instructions::widest());
    };
    let available = Instructions::available();
    let found = available
        .iter()
        .find(|set| name.to_str() == Some(set.name()));
    found.copied().ok_or_else(|| {
        format!(
            "{INSTRUCTIONS} = {}: must be one of the instruction sets of this machine: {}",
            name.to_string_lossy(),
            instruction_names().join(", ")
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

/// The choices of the environment.
///
/// # Errors
/// Instructions that this machine does not have, or an invalid number of threads.
pub fn chosen() -> Result<Machine, Error> {
    CHOSEN.clone().map_err(Error::Argument)
}

/// Whether the thread that starts the pool becomes one of its threads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CallingThread {
    /// The calling thread steps worlds itself and belongs to the pool. Outside the pool it would be woken several
    /// times per step.
    JoinsPool,
    /// The calling thread waits for threads that it starts, so it cannot work for the pool.
    StaysOutside,
}

/// Start the global thread pool with the number of threads that the environment sets, and return all choices of the
/// environment. To be called from main functions.
///
/// # Errors
/// Instructions that this machine does not have, or an invalid number of threads.
pub fn start_pool(caller: CallingThread) -> Result<Machine, Error> {
    let machine = chosen()?;
    let mut pool = ThreadPoolBuilder::new().num_threads(machine.threads.unwrap_or_default());
    if caller == CallingThread::JoinsPool {
        pool = pool.use_current_thread();
    }
    // Fails if a global pool exists already; that pool then keeps its threads.
    let _ = pool.build_global();
    Ok(machine)
}

/// The process in which threads were first asked for.
static FIRST_PROCESS: LazyLock<u32> = LazyLock::new(std::process::id);

/// Whether this process is a copy of the one in which threads were first asked for: it has none of its threads, and
/// would wait for them forever.
pub fn is_forked() -> bool {
    *FIRST_PROCESS != std::process::id()
}

/// Number of threads for a world with the given number of particles: one per 10 000 particles, at least one and at
/// most as many as the machine has.
pub fn default_threads(particles: usize) -> usize {
    let available = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    (particles / PARTICLES_PER_THREAD).clamp(1, available)
}

/// Number of threads that the environment sets for a world, or the default one if the environment is invalid.
pub fn chosen_threads_for(particles: usize) -> usize {
    let chosen = CHOSEN.as_ref().ok().and_then(|machine| machine.threads);
    match is_forked() {
        true => 1,
        false => chosen.unwrap_or_else(|| default_threads(particles)),
    }
}

/// The world with the instructions and threads that the environment sets, or with the default ones if the environment
/// is invalid.
pub fn with_chosen_execution<S: Number>(world: World<S>) -> World<S> {
    let default = Machine {
        instructions: Instructions::widest(),
        threads: None,
    };
    let machine = CHOSEN.as_ref().copied().unwrap_or(default);
    let threads = chosen_threads_for(world.particles().len());
    world
        .with_instructions(machine.instructions)
        .with_threads(threads)
}
