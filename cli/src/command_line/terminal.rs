//! Shows the warnings of a run and, if standard error is a terminal, a progress bar.

use gouge_runner::error::Error;
use gouge_runner::run::{Event, NamedPhase, Observer};
use indicatif::{ProgressBar, ProgressStyle};
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::io::{IsTerminal, Write};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A switch that the signals set that ask the program to end. The first signal stops a run at its next step; the second
/// one ends the program at once.
///
/// # Errors
/// Signals that cannot be received.
pub fn stopped_by_signals() -> Result<Arc<AtomicBool>, Error> {
    let is_stopped = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        flag::register_conditional_shutdown(signal, 130, Arc::clone(&is_stopped))
            .and_then(|_| flag::register(signal, Arc::clone(&is_stopped)))
            .map_err(|error| Error::file("receive", Path::new("signals"), error))?;
    }
    Ok(is_stopped)
}

/// Say something on standard error. If nobody reads it any more, it is left out.
pub fn say(text: &str) {
    let _ = writeln!(std::io::stderr(), "gouge: {text}");
}

/// An observer that writes to standard error.
pub struct Terminal {
    is_quiet: bool,
    /// Set by the signals that ask the program to end.
    is_stopped: Arc<AtomicBool>,
    bar: Option<PhaseBar>,
}

impl Terminal {
    /// An observer that shows no progress if `is_quiet`.
    ///
    /// # Errors
    /// Signals that cannot be received.
    pub fn new(is_quiet: bool) -> Result<Self, Error> {
        let is_stopped = stopped_by_signals()?;
        Ok(Self {
            is_stopped,
            ..Self::without_signals(is_quiet)
        })
    }

    /// Like [`Terminal::new`], but signals end the program at once.
    pub fn without_signals(is_quiet: bool) -> Self {
        Self {
            is_quiet,
            is_stopped: Arc::default(),
            bar: None,
        }
    }
}

impl Observer for Terminal {
    fn event(&mut self, event: Event<'_>) {
        match event {
            Event::PhaseBegan { phases, .. } => {
                if self.bar.is_none() && !self.is_quiet && std::io::stderr().is_terminal() {
                    self.bar = Some(PhaseBar::new(phases));
                }
            }
            Event::Progress { phase, steps } => {
                if let Some(bar) = &self.bar {
                    bar.show(phase, steps);
                }
            }
            Event::Warning(warning) => say(&format!("warning: {warning}")),
            Event::Ended => {
                if let Some(bar) = &self.bar {
                    bar.bar.finish_and_clear();
                }
            }
            Event::NothingToResume { folder } => {
                let folder = folder.display();
                say(&format!("{folder} holds nothing to resume; the run begins"));
            }
            Event::AlreadyDone { folder } => {
                let folder = folder.display();
                say(&format!(
                    "{folder} already holds the finished run of this scene; nothing to do"
                ));
            }
            Event::SampleWritten { .. } | Event::CheckpointWritten { .. } => {}
        }
    }

    fn wants_stop(&self) -> bool {
        self.is_stopped.load(Ordering::Relaxed)
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
    fn new(phases: &[NamedPhase]) -> Self {
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
