//! Reads cases in this process and watches each.

use crate::kinds::{Files, Kind};
use crate::{ALLOCATOR, Arguments, Outcome, report};
use std::fs::File;
use std::io::Write;
use std::os::unix::fs::FileExt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// Longest time for a case.
const PATIENCE: Duration = Duration::from_secs(1);
/// Time after which a case is given up.
const HANG: Duration = Duration::from_secs(10);
/// Most memory in bytes.
const MEMORY: usize = 1 << 30;
/// Number of cases between reports of progress.
const PROGRESS: u64 = 1000;
/// Status of a process that gives up.
const GIVEN_UP: i32 = 9;

/// Read all cases of a kind; the file keeps the number of the present one.
///
/// # Errors
/// Failures of the file system.
pub fn read_all(arguments: &Arguments, kind: Kind, present: &Path) -> Outcome<u64> {
    let files = Files::of(kind)?;
    let present = File::create(present)?;
    let watched = watch();
    std::panic::set_hook(Box::new(|_| {}));
    for number in arguments.from..arguments.from + arguments.cases {
        present.write_all_at(&number.to_le_bytes(), 0)?;
        if number % PROGRESS == 0 {
            println!("{number}");
            std::io::stdout().flush()?;
        }
        let bytes = files.case(arguments.seed, number);
        watched.fetch_add(1, Ordering::Relaxed);
        let began = Instant::now();
        let outcome = catch_unwind(AssertUnwindSafe(|| files.read(&bytes)));
        if outcome.is_err() {
            report(kind, arguments.seed, number, "panicked");
        }
        if began.elapsed() > PATIENCE {
            report(
                kind,
                arguments.seed,
                number,
                &format!("took {:?}", began.elapsed()),
            );
        }
    }
    Ok(0)
}

/// Start a thread that ends the process if a case takes too long or too much memory. It takes a case for a new one
/// whenever the number changes.
fn watch() -> Arc<AtomicU64> {
    let number = Arc::new(AtomicU64::new(0));
    let watched = Arc::clone(&number);
    std::thread::spawn(move || {
        let (mut last, mut since) = (0, Instant::now());
        loop {
            std::thread::sleep(Duration::from_millis(5));
            let now = watched.load(Ordering::Relaxed);
            if now != last {
                (last, since) = (now, Instant::now());
            }
            if since.elapsed() > HANG || ALLOCATOR.allocated() > MEMORY {
                std::process::exit(GIVEN_UP);
            }
        }
    });
    number
}
