//! Progress on standard error, where a person watches.

use super::Phase;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;

/// A bar over all phases, or nothing.
pub struct Progress {
    bar: Option<ProgressBar>,
    names: Vec<String>,
    starts: Vec<u64>,
}

impl Progress {
    /// A bar for the given phases; none if quiet or if nobody watches.
    pub fn new(phases: &[Phase], quiet: bool) -> Self {
        let mut starts = vec![0_u64];
        for phase in phases {
            starts.push(starts[starts.len() - 1].saturating_add(phase.steps));
        }
        let watched = !quiet && std::io::stderr().is_terminal();
        let bar = watched.then(|| {
            let bar = ProgressBar::new(starts[starts.len() - 1]);
            let style = "{msg:12} {wide_bar} {percent:>3} %  {elapsed} gone, {eta} left";
            if let Ok(style) = ProgressStyle::with_template(style) {
                bar.set_style(style);
            }
            bar
        });
        Self {
            bar,
            names: phases.iter().map(|phase| phase.name.clone()).collect(),
            starts,
        }
    }

    /// Show how far a phase is.
    pub fn show(&self, phase: usize, steps: u64) {
        if let Some(bar) = &self.bar {
            bar.set_message(self.names[phase].clone());
            bar.set_position(self.starts[phase] + steps);
        }
    }

    /// Clear the bar.
    pub fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
