//! `gouge verify`: runs the register of checks, prints one line per check, and writes the reports.

use crate::checks::{Check, Effort, Topic, register};
use crate::lines::Lines;
use crate::report::{self, Entry, Figures, Record};
use gouge_runner::error::Error;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::time::Instant;

/// Runs the checks whose identifier contains a pattern, prints one line per check and writes the
/// reports. The reports are written even if the lines cannot be printed.
///
/// # Errors
/// A pattern that matches no check, failures of the file system, failed checks, and lines that cannot
/// be printed, unless standard output is a pipe that was closed.
pub fn verify(only: Option<&str>, folder: &Path, figures: Figures) -> Result<(), Error> {
    let topics = register();
    let checks = chosen(&topics, only)?;
    std::fs::create_dir_all(folder).map_err(|error| Error::file("create", folder, error))?;
    let progress = bar(checks.len());
    let mut lines = Lines::new(std::io::stdout());
    let entries = run_all(&checks, &progress, &mut lines);
    progress.set_message("pictures");
    let pictures = match only {
        None => report::pictures()?,
        Some(_) => Vec::new(),
    };
    progress.finish_and_clear();
    report::write(folder, &topics, &entries, &pictures, figures)?;
    let failed = entries.iter().filter(|entry| !entry.record.passed());
    match failed.count() {
        0 => lines
            .finish()
            .map_err(|error| Error::file("write", Path::new("standard output"), error)),
        failed => Err(Error::Checks(failed, entries.len())),
    }
}

/// The checks selected by a pattern, in the order of the report.
fn chosen<'a>(topics: &'a [Topic], only: Option<&str>) -> Result<Vec<&'a Check>, Error> {
    let all = || topics.iter().flat_map(|topic| &topic.checks);
    let matches = |check: &&Check| only.is_none_or(|pattern| check.id.contains(pattern));
    let checks: Vec<&Check> = all().filter(matches).collect();
    if checks.is_empty() {
        let names: Vec<&str> = all().map(|check| check.id).collect();
        return Err(Error::Argument(format!(
            "no check matches --only {:?}; the checks are: {}",
            only.unwrap_or_default(),
            names.join(", ")
        )));
    }
    Ok(checks)
}

/// A progress bar on standard error, if it is a terminal.
fn bar(checks: usize) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(checks as u64), ProgressDrawTarget::stderr());
    let style = "{msg:32} {wide_bar} {pos}/{len}  {elapsed} elapsed";
    if let Ok(style) = ProgressStyle::with_template(style) {
        bar.set_style(style);
    }
    bar
}

/// Runs short checks on all cores, then long ones, which may measure time, one after the other.
fn run_all(checks: &[&Check], progress: &ProgressBar, lines: &mut Lines<impl Write>) -> Vec<Entry> {
    let (long, short): (Vec<usize>, Vec<usize>) =
        (0..checks.len()).partition(|&place| checks[place].effort == Effort::Report);
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let mut entries = BTreeMap::new();
    for (places, threads) in [(short, threads), (long, 1)] {
        run_on(threads, checks, &places, progress, |place, entry| {
            progress.suspend(|| lines.add(place, entry.record.line()));
            entries.insert(place, entry);
        });
    }
    entries.into_values().collect()
}

/// Runs some checks on the given number of threads and passes on each result as soon as it is ready.
fn run_on(
    threads: usize,
    checks: &[&Check],
    places: &[usize],
    progress: &ProgressBar,
    mut done: impl FnMut(usize, Entry),
) {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::channel();
    std::thread::scope(|scope| {
        for _ in 0..threads {
            let (sender, next) = (sender.clone(), &next);
            let places = std::iter::from_fn(move || {
                let place = places.get(next.fetch_add(1, Ordering::Relaxed));
                place.copied()
            });
            scope.spawn(move || work(checks, places, progress, &sender));
        }
        drop(sender);
        for (place, entry) in receiver {
            progress.inc(1);
            done(place, entry);
        }
    });
}

/// Runs checks one after the other until the receiver of the results is gone.
fn work(
    checks: &[&Check],
    places: impl Iterator<Item = usize>,
    progress: &ProgressBar,
    sender: &mpsc::Sender<(usize, Entry)>,
) {
    for place in places {
        progress.set_message(checks[place].id);
        if sender.send((place, run(checks[place]))).is_err() {
            return;
        }
    }
}

fn run(check: &Check) -> Entry {
    let began = Instant::now();
    let outcome = (check.measure)();
    Entry {
        record: Record::new(check, &outcome, began.elapsed().as_secs_f64()),
        exhibits: outcome.map_or_else(|_| Vec::new(), |finding| finding.exhibits),
    }
}
