//! Tests faults one at a time with the gate.

use crate::gate::{Gate, Tests};
use crate::results::{Fault, Results};
use crate::{Options, Outcome};
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Test all faults that have no result yet, and return all results.
///
/// # Errors
/// A test that fails without a fault, or a file that cannot be read or written.
pub fn run<F: Fault>(
    gate: &Gate,
    folder: &Path,
    faults: &[F],
    switches: usize,
    options: &Options,
) -> Outcome<Results> {
    let mut results = Results::open(folder, gate, switches)?;
    if options.again {
        results.forget_survivors();
    }
    let tests = gate.learn(folder, options.jobs, switches, &mut results)?;
    let open: Vec<&F> = faults.iter().filter(|fault| !results.has(*fault)).collect();
    try_all(gate, &tests, &open, options.jobs, &mut results)?;
    Ok(results)
}

/// Switch on each fault in turn, several at a time.
fn try_all<F: Fault>(
    gate: &Gate,
    tests: &Tests,
    open: &[&F],
    jobs: usize,
    results: &mut Results,
) -> Outcome<()> {
    let next = AtomicUsize::new(0);
    let shared = Mutex::new(results);
    let work = || -> Outcome<()> {
        while let Some(fault) = open.get(next.fetch_add(1, Ordering::Relaxed)) {
            let fate = gate.try_fault(fault.switch(), tests)?;
            println!("{fault}: {fate}");
            let mut results = shared.lock().map_err(|_| "another job has failed")?;
            results.add(*fault, fate)?;
        }
        Ok(())
    };
    std::thread::scope(|scope| {
        let running: Vec<_> = (0..jobs).map(|_| scope.spawn(work)).collect();
        for job in running {
            job.join().map_err(|_| "a job has failed")??;
        }
        Ok(())
    })
}

/// Print the faults that survived and return their number.
pub fn print_survivors<F: Fault>(faults: &[F], results: &Results) -> usize {
    println!("\nSurvived:");
    let mut survivors = 0;
    for fault in faults {
        if let Some(fate) = results.fate(fault)
            && !fate.is_detected()
        {
            survivors += 1;
            println!("{fault}: {fate}");
        }
    }
    survivors
}
