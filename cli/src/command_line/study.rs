//! `gouge study`: a published study, repeated with many seeds.

use super::print;
use super::sweep::{cores, run};
use super::terminal::stopped_by_signals;
use clap::{Args, ValueEnum};
use gouge_runner::error::Error;
use gouge_studies::study::{Prepared, STUDIES, Scale, Study, known};
use gouge_studies::sweep::{Execution, Planned, Program, collect, estimate, open, plan};
use gouge_studies::words::{counted, duration};
use std::path::{Path, PathBuf};

/// A study and where it goes.
#[derive(Args)]
pub struct StudyArguments {
    /// thesis: friction between shearing brittle surfaces; strength: distributions of bond strengths; media: water and
    /// other liquids
    #[arg(value_parser = study)]
    study: &'static Study,
    /// Folder of the study
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// How much is run
    #[arg(long, value_enum, default_value = "small")]
    scale: Size,
    /// Number of runs at a time; as many as there are cores if absent
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Folder with runs.csv and curves.csv of an earlier study, whose runs are not run again; repeatable
    #[arg(long, value_name = "DIR")]
    earlier: Vec<PathBuf>,
    /// Print what would be run and what it would cost, and stop
    #[arg(long)]
    plan: bool,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
}

/// How much is run.
#[derive(Clone, Copy, ValueEnum)]
enum Size {
    /// What two cores do in two hours
    Small,
    /// All of it
    Full,
}

/// The study of a name.
fn study(name: &str) -> Result<&'static Study, String> {
    Study::named(name).ok_or_else(|| {
        let names: Vec<&str> = STUDIES.iter().map(|study| study.name).collect();
        format!("must be one of: {}", names.join(", "))
    })
}

/// Run what is missing, then conclude from what is there.
///
/// # Errors
/// Failures of the file system, an interruption.
pub fn launch(arguments: &StudyArguments, program: &Program) -> Result<(), Error> {
    let scale = match arguments.scale {
        Size::Small => Scale::Small,
        Size::Full => Scale::Full,
    };
    let out = &arguments.out;
    let earlier: Vec<&Path> = arguments.earlier.iter().map(PathBuf::as_path).collect();
    let jobs = usize::from(arguments.jobs.unwrap_or_else(cores));
    let prepared = arguments.study.prepare(scale, out)?;
    let known = known(arguments.study, &earlier, &prepared)?;
    let stop = stopped_by_signals()?;
    let mut outcome = Ok(());
    for one in &prepared {
        let folder = out.join(one.part.name);
        let all = plan(&one.sweep, &folder)?;
        let is_new = |run: &&Planned| !known.contains(&run.name);
        let open = open(&all, &folder).into_iter().filter(is_new);
        let open: Vec<Planned> = open.cloned().collect();
        if arguments.plan {
            print(&planned(one, all.len(), &open))?;
            continue;
        }
        if outcome.is_ok() {
            let execution = Execution {
                program,
                out: &folder,
                jobs,
                stop: &stop,
            };
            outcome = run(&open, execution, arguments.quiet);
        }
        collect(&one.sweep, &all, &folder)?;
    }
    if arguments.plan {
        return Ok(());
    }
    arguments.study.conclude(&prepared, &earlier, out)?;
    if !arguments.quiet {
        print(&format!("{}\n", out.join("study.html").display()))?;
    }
    outcome
}

fn planned(one: &Prepared, all: usize, open: &[Planned]) -> String {
    let runs: Vec<&Planned> = open.iter().collect();
    let cost = estimate(&runs);
    format!(
        "{:16}{:>10}, of which {:5} not done yet: {} on one core, {:.0} MB\n",
        one.part.name,
        counted(all, "run"),
        open.len(),
        duration(cost.seconds()),
        cost.bytes / 1e6
    )
}
