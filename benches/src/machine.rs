//! The machine and two reference times, so that runs on different machines can be compared.

use gouge_validation::report::machine_words;
use serde::Serialize;
use std::hint::black_box;
use std::time::Instant;

/// The machine on which a run was measured.
#[derive(Serialize)]
pub struct Machine {
    /// Processor, operating system and number of threads.
    pub words: String,
    /// The instructions that worlds used.
    pub instructions: &'static str,
    /// Time per dependent addition in ns, which measures the clock rate.
    pub addition_ns: f64,
    /// Time per dependent square root and division in ns.
    pub root_and_division_ns: f64,
}

impl Machine {
    /// Measure this machine.
    pub fn measured(instructions: &'static str) -> Self {
        Self {
            words: machine_words(),
            instructions,
            addition_ns: chain(|x| x + 1e-9),
            root_and_division_ns: chain(|x| 1.0 / x.sqrt() + 0.5),
        }
    }
}

/// Time per operation in a chain of dependent operations in ns; the minimum of several tries.
fn chain(operation: impl Fn(f64) -> f64) -> f64 {
    const LINKS: u32 = 2_000_000;
    let time = || {
        let began = Instant::now();
        let mut x = black_box(1.0);
        for _ in 0..LINKS {
            x = operation(x);
        }
        black_box(x);
        began.elapsed().as_secs_f64() * 1e9 / f64::from(LINKS)
    };
    (0..9).map(|_| time()).fold(f64::INFINITY, f64::min)
}
