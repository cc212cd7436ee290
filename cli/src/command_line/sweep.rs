//! `gouge sweep`: runs of a scene with every combination of some values.

use super::print;
use super::progress::{RunProgress, tell};
use super::terminal::stopped_by_signals;
use clap::{Args, Subcommand, ValueEnum};
use gouge_runner::error::Error;
use gouge_studies::sweep::{
    Chunks, Cost, Execution, Planned, Program, Script, Status, Sweep, collect, estimate, execute,
    open, plan, retry, status,
};
use gouge_studies::words::{counted, duration};
use std::path::{Path, PathBuf};

/// A sweep and what is done with it.
#[derive(Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct SweepArguments {
    #[command(subcommand)]
    command: Option<SweepCommand>,
    /// A sweep file
    #[arg(required = true)]
    file: Option<PathBuf>,
    /// Folder of the sweep
    #[arg(long, value_name = "DIR", required = true)]
    out: Option<PathBuf>,
    /// Number of runs at a time; as many as there are cores if absent
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Print what would be run and what it would cost, and stop
    #[arg(long)]
    plan: bool,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
}

#[derive(Subcommand)]
enum SweepCommand {
    /// Print how many runs are in which state
    Status(Place),
    /// Forget runs that failed or were refused, so that the sweep runs them again
    Retry(Place),
    /// Write runs.csv: one row a run
    Collect(Place),
    /// Run a chunk of the runs, as a worker of a cluster does
    Work {
        #[command(flatten)]
        place: Place,
        /// The chunk, counted from 0
        #[arg(long, value_name = "I")]
        chunk: usize,
        /// Number of chunks
        #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
        chunks: u32,
    },
    /// Write a script that runs the sweep on a cluster
    Export {
        /// The program that schedules there
        #[arg(value_enum)]
        cluster: Cluster,
        #[command(flatten)]
        place: Place,
        /// Most workers at a time
        #[arg(long, value_name = "N", default_value_t = 50)]
        workers: u32,
        /// Time limit of a worker in minutes
        #[arg(long, value_name = "MINUTES", default_value_t = 240)]
        minutes: u32,
        /// Most chunks: MaxArraySize of Slurm
        #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..))]
        most_chunks: u32,
    },
}

/// Programs that schedule jobs.
#[derive(Clone, Copy, ValueEnum)]
enum Cluster {
    /// Slurm
    Slurm,
    /// HyperQueue
    Hyperqueue,
}

/// A sweep and its folder.
#[derive(Args)]
struct Place {
    /// A sweep file
    file: PathBuf,
    /// Folder of the sweep
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Do what the arguments say.
///
/// # Errors
/// A sweep that cannot be used, one beyond its budget, failures of the file system, an interruption.
pub fn launch(arguments: &SweepArguments, program: &Program) -> Result<(), Error> {
    let (Some(file), Some(out)) = (&arguments.file, &arguments.out) else {
        return match &arguments.command {
            Some(command) => manage(command, program),
            None => Ok(()),
        };
    };
    let sweep = Sweep::load(file)?;
    let runs = plan(&sweep, out)?;
    let open = open(&runs, out);
    let jobs = usize::from(arguments.jobs.unwrap_or_else(cores));
    if arguments.plan {
        return print(&planned(&runs, &open, estimate(&open), jobs));
    }
    // Without a budget no pilot runs are needed.
    if sweep.core_hours.is_some() {
        sweep.within_budget(estimate(&open))?;
    }
    let open: Vec<Planned> = open.into_iter().cloned().collect();
    let execution = Execution {
        program,
        out,
        jobs,
        stop: &*stopped_by_signals()?,
    };
    let outcome = run(&open, execution, arguments.quiet);
    let path = collect(&sweep, &runs, out)?;
    if !arguments.quiet {
        print(&format!("{}{}\n", states(&runs, out), path.display()))?;
    }
    outcome
}

fn manage(command: &SweepCommand, program: &Program) -> Result<(), Error> {
    let place = match command {
        SweepCommand::Status(place) | SweepCommand::Retry(place) | SweepCommand::Collect(place) => {
            place
        }
        SweepCommand::Work { place, .. } | SweepCommand::Export { place, .. } => place,
    };
    let sweep = Sweep::load(&place.file)?;
    let runs = plan(&sweep, &place.out)?;
    match command {
        SweepCommand::Status(_) => print(&states(&runs, &place.out)),
        SweepCommand::Retry(_) => {
            let number = retry(&runs, &place.out)?.len();
            print(&format!("{} will be run again\n", counted(number, "run")))
        }
        SweepCommand::Collect(_) => {
            let path = collect(&sweep, &runs, &place.out)?;
            print(&format!("{}\n", path.display()))
        }
        SweepCommand::Work { chunk, chunks, .. } => {
            let execution = Execution {
                program,
                out: &place.out,
                jobs: 1,
                stop: &*stopped_by_signals()?,
            };
            work(&runs, execution, *chunk, *chunks as usize)
        }
        SweepCommand::Export {
            cluster,
            workers,
            minutes,
            most_chunks,
            ..
        } => {
            let limits = [*workers, *minutes, *most_chunks];
            print(&script(program, &sweep, &runs, place, *cluster, limits)?)
        }
    }
}

/// Run one chunk.
fn work(runs: &[Planned], execution: Execution, chunk: usize, chunks: usize) -> Result<(), Error> {
    if chunk >= chunks {
        return Err(Error::Argument(format!(
            "--chunk {chunk}: must be from 0 to {}",
            chunks - 1
        )));
    }
    let edge = |chunk: usize| chunk * runs.len() / chunks;
    execute(&runs[edge(chunk)..edge(chunk + 1)], execution, &tell)
}

/// The script for a cluster.
fn script(
    program: &Program,
    sweep: &Sweep,
    runs: &[Planned],
    place: &Place,
    cluster: Cluster,
    [workers, minutes, most]: [u32; 3],
) -> Result<String, Error> {
    let all: Vec<&Planned> = runs.iter().collect();
    let cost = estimate(&all);
    sweep.within_budget(cost)?;
    let absolute =
        |path: &Path| std::path::absolute(path).map_err(|error| Error::file("find", path, error));
    let (file, out) = (absolute(&place.file)?, absolute(&place.out)?);
    let script = Script {
        program,
        file: &file,
        out: &out,
        chunks: Chunks::of(cost, runs.len(), most as usize),
        workers: workers as usize,
        minutes: u64::from(minutes),
    };
    Ok(match cluster {
        Cluster::Slurm => script.slurm(),
        Cluster::Hyperqueue => script.hyperqueue(),
    })
}

/// Number of cores.
pub fn cores() -> u16 {
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    u16::try_from(cores).unwrap_or(u16::MAX)
}

fn planned(runs: &[Planned], open: &[&Planned], cost: Cost, jobs: usize) -> String {
    let seconds = cost.seconds() / jobs.min(open.len()).max(1) as f64;
    format!(
        "runs            {}, of which {} are not done yet\n\
         core-hours      {:.3} ({} on one core), estimated from pilot runs\n\
         time            {} with {jobs} at a time\n\
         disk            {:.1} MB\n",
        runs.len(),
        open.len(),
        cost.core_hours,
        duration(cost.seconds()),
        duration(seconds),
        cost.bytes / 1e6
    )
}

/// Execute runs, and show the progress and the time left unless told to be quiet.
///
/// # Errors
/// Failures of the file system, an interruption.
pub fn run(runs: &[Planned], execution: Execution, quiet: bool) -> Result<(), Error> {
    let progress = RunProgress::new(runs, quiet);
    let outcome = execute(runs, execution, &|ended| progress.report(ended));
    progress.finish();
    outcome
}

/// How many runs are in which state, one line each.
fn states(runs: &[Planned], out: &Path) -> String {
    let line = |(status, number): (&Status, &usize)| format!("{:16}{number}\n", status.name());
    status(runs, out).iter().map(line).collect()
}
