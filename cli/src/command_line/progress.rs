//! Progress over many runs, and over the steps of one.

use super::terminal::say;
use gouge_studies::sweep::{Planned, Progress, Status};
use gouge_studies::words::{counted, duration};
use indicatif::{ProgressBar, ProgressStyle};
use std::cell::Cell;
use std::collections::HashMap;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Least time between lines of progress.
const BETWEEN_LINES: Duration = Duration::from_secs(60);

/// Shows how many runs have ended and how long the others will take; it assumes that all steps cost the same.
pub struct RunProgress {
    /// Steps by the name of a run; empty if nothing is shown.
    steps: HashMap<String, u64>,
    runs: usize,
    bar: ProgressBar,
    began: Instant,
    ended: Mutex<Ended>,
}

/// What has ended.
struct Ended {
    runs: usize,
    steps: u64,
    latest_line: Instant,
}

impl RunProgress {
    /// Nothing of some runs has ended yet.
    pub fn new(runs: &[Planned], quiet: bool) -> Self {
        let steps = |run: &Planned| (run.name.clone(), run.steps());
        let steps: HashMap<String, u64> = match quiet {
            true => HashMap::new(),
            false => runs.iter().map(steps).collect(),
        };
        Self {
            bar: match quiet {
                true => ProgressBar::hidden(),
                false => bar(steps.values().sum()),
            },
            steps,
            runs: runs.len(),
            began: Instant::now(),
            ended: Mutex::new(Ended {
                runs: 0,
                steps: 0,
                latest_line: Instant::now(),
            }),
        }
    }

    /// Show that a run has ended, as a line at most once a minute where a bar cannot be drawn.
    pub fn report(&self, progress: Progress) {
        let Ok(mut ended) = self.ended.lock() else {
            return;
        };
        ended.runs += 1;
        ended.steps += self.steps.get(&progress.name).unwrap_or(&0);
        let message = format!(
            "{} of {} done{}",
            ended.runs,
            counted(self.runs, "run"),
            self.left(ended.steps)
        );
        self.bar.set_position(ended.steps);
        self.bar.set_message(message.clone());
        self.bar.suspend(|| tell(progress));
        let is_due = ended.latest_line.elapsed() >= BETWEEN_LINES;
        if !self.steps.is_empty() && self.bar.is_hidden() && is_due {
            ended.latest_line = Instant::now();
            say(&message);
        }
    }

    /// How long the other steps will take, if some have ended.
    fn left(&self, ended: u64) -> String {
        if ended == 0 {
            return String::new();
        }
        let all: u64 = self.steps.values().sum();
        let share = all.saturating_sub(ended) as f64 / ended as f64;
        let left = duration(self.began.elapsed().as_secs_f64() * share);
        format!(", about {left} remaining")
    }

    /// Show no progress any more.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// A bar over a number of steps.
fn bar(steps: u64) -> ProgressBar {
    let bar = ProgressBar::new(steps);
    let style = "{wide_bar} {percent} % of all steps, {elapsed} elapsed, {msg}";
    if let Ok(style) = ProgressStyle::with_template(style) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_secs(1));
    bar
}

/// Shows how many steps of a motion are done and how long the others will take.
pub struct StepProgress {
    is_quiet: bool,
    bar: ProgressBar,
    began: Instant,
    latest_line: Cell<Instant>,
}

impl StepProgress {
    /// No step is done yet.
    pub fn new(is_quiet: bool) -> Self {
        Self {
            is_quiet,
            bar: match is_quiet {
                true => ProgressBar::hidden(),
                false => bar(0),
            },
            began: Instant::now(),
            latest_line: Cell::new(Instant::now()),
        }
    }

    /// Show how many steps are done, as a line at most once a minute where a bar cannot be drawn.
    pub fn report(&self, done: u64, all: u64) {
        let share = all.saturating_sub(done) as f64 / done.max(1) as f64;
        let left = duration(self.began.elapsed().as_secs_f64() * share);
        self.bar.set_length(all);
        self.bar.set_position(done);
        self.bar.set_message(format!("about {left} remaining"));
        let is_due = self.latest_line.get().elapsed() >= BETWEEN_LINES;
        if !self.is_quiet && self.bar.is_hidden() && is_due {
            self.latest_line.set(Instant::now());
            say(&format!(
                "{done} of {all} steps done, about {left} remaining"
            ));
        }
    }

    /// Show no progress any more.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// Tell of a run that is not done.
pub fn tell(progress: Progress) {
    let Progress { name, state } = progress;
    if !matches!(state.status, Status::Done | Status::Begun) {
        say(&format!("{name}: {}: {}", state.status.name(), state.cause));
    }
}
