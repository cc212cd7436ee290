//! Shows the warnings of a run and, if standard error is a terminal, a progress bar.

use gouge_runner::run::{Event, Observer, Phase};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;

/// An observer that writes to standard error.
pub struct Terminal {
    is_quiet: bool,
    bar: Option<PhaseBar>,
}

impl Terminal {
    /// An observer that shows nothing if `is_quiet`.
    pub fn new(is_quiet: bool) -> Self {
        Self {
            is_quiet,
            bar: None,
        }
    }
}

impl Observer for Terminal {
    fn event(&mut self, event: Event<'_>) {
        if self.is_quiet {
            return;
        }
        match event {
            Event::PhaseBegan { phases, .. } => {
                if self.bar.is_none() && std::io::stderr().is_terminal() {
                    self.bar = Some(PhaseBar::new(phases));
                }
            }
            Event::Progress { phase, steps } => {
                if let Some(bar) = &self.bar {
                    bar.show(phase, steps);
                }
            }
            Event::Warning(warning) => eprintln!("gouge: warning: {warning}"),
            Event::Ended => {
                if let Some(bar) = &self.bar {
                    bar.bar.finish_and_clear();
                }
            }
            Event::SampleWritten { .. } | Event::CheckpointWritten { .. } => {}
        }
    }
}

/// A progress bar over all phases of a run.
struct PhaseBar {
    bar: ProgressBar,
    names: Vec<String>,
    /// For each phase, the number of steps of all earlier phases.
    starts: Vec<u64>,
}

impl PhaseBar {
    fn new(phases: &[Phase]) -> Self {
        let mut starts = vec![0_u64];
        for phase in phases {
            starts.push(starts[starts.len() - 1].saturating_add(phase.steps));
        }
        let bar = ProgressBar::new(starts[starts.len() - 1]);
        let style = "{msg:12} {wide_bar} {percent:>3} %  {elapsed} elapsed, {eta} remaining";
        if let Ok(style) = ProgressStyle::with_template(style) {
            bar.set_style(style);
        }
        Self {
            bar,
            names: phases.iter().map(|phase| phase.name.clone()).collect(),
            starts,
        }
    }

    fn show(&self, phase: usize, steps: u64) {
        self.bar.set_message(self.names[phase].clone());
        self.bar.set_position(self.starts[phase] + steps);
    }
}
