//! Limits of the machine: rates of instructions, of square roots with divisions, and of memory traffic.

use crate::sample::Sample;
use pulp::Arch;
use serde::Serialize;
use std::hint::black_box;
use std::time::Instant;

/// The limits of one core.
#[derive(Serialize)]
pub struct Limits {
    /// Instructions per ns in a loop of independent operations without memory access.
    pub instructions_per_ns: f64,
    /// Time in ns per independent square root and division.
    pub root_and_division_ns: f64,
    /// Largest measured memory traffic, from and to memory, in bytes per ns.
    pub bytes_per_ns: f64,
    /// Median of the measured memory traffic in bytes per ns; other users of the host share the bandwidth.
    pub usual_bytes_per_ns: f64,
}

impl Limits {
    /// Measure the limits of this machine, given the number of instructions per iteration of [`busy`].
    pub fn measured(instructions_of_busy: f64) -> Self {
        const TURNS: u64 = 20_000_000;
        let busy_ns = times(TURNS as f64, || {
            black_box(busy(black_box(TURNS)));
        })
        .least();
        let traffic = traffic();
        Self {
            instructions_per_ns: instructions_of_busy / busy_ns,
            root_and_division_ns: root_and_division(),
            bytes_per_ns: 1.0 / traffic.least(),
            usual_bytes_per_ns: 1.0 / traffic.median(),
        }
    }
    /// The limits in words.
    pub fn words(&self) -> String {
        format!(
            "limits: {:.2} instructions per ns, {:.2} ns per square root with a division, {:.1} bytes of memory per ns, median {:.1}",
            self.instructions_per_ns,
            self.root_and_division_ns,
            self.bytes_per_ns,
            self.usual_bytes_per_ns
        )
    }
}

/// Times in ns per operation, for a function that does the given number of operations.
fn times(things: f64, mut act: impl FnMut()) -> Sample {
    let mut time = || {
        let began = Instant::now();
        act();
        began.elapsed().as_secs_f64() * 1e9 / things
    };
    Sample((0..27).map(|_| time()).collect())
}

/// Iterate a loop of independent integer operations that stay in registers.
pub fn busy(turns: u64) -> u64 {
    let mut numbers: [u64; 16] = black_box([1; 16]);
    for turn in 0..turns {
        for number in &mut numbers {
            *number = (*number ^ turn).wrapping_add(turn);
        }
    }
    numbers.iter().fold(0, |all, number| all ^ number)
}

fn root_and_division() -> f64 {
    const LOOPS: usize = 40_000;
    let mut numbers = black_box([2.0_f64; 64]);
    times((LOOPS * numbers.len()) as f64, || {
        Arch::new().dispatch(|| {
            for _ in 0..LOOPS {
                for number in &mut numbers {
                    *number = 2.0 / number.sqrt();
                }
                black_box(&mut numbers);
            }
        });
    })
    .least()
}

/// Times in ns per byte when two columns are read and a third is written. The processor also reads the third column
/// before it is overwritten.
fn traffic() -> Sample {
    const NUMBER: usize = 8_000_000;
    let (a, b) = (
        black_box(vec![1.0_f64; NUMBER]),
        black_box(vec![2.0_f64; NUMBER]),
    );
    let mut sum = vec![0.0_f64; NUMBER];
    times((4 * 8 * NUMBER) as f64, || {
        Arch::new().dispatch(|| {
            for (sum, (a, b)) in sum.iter_mut().zip(a.iter().zip(&b)) {
                *sum = a + 3.0 * b;
            }
        });
        black_box(&mut sum);
    })
}
