//! Runs the checks; started by `gouge verify`.

use clap::Parser;
use gouge_runner::error::Error;
use gouge_runner::machine::{CallingThread, start_pool};
use gouge_validation::report::Figures;
use gouge_validation::verify::verify;
use mimalloc::MiMalloc;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Aligns the columns of large worlds to cache lines and puts them into huge pages.
#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

/// Run the checks and write report.html and report.json
#[derive(Parser)]
#[command(name = "gouge-verify", version = gouge_runner::build::VERSION)]
struct Arguments {
    /// Only checks whose identifier contains this
    #[arg(long)]
    only: Option<String>,
    /// Folder for the reports
    #[arg(long, default_value = "out/verify")]
    out: PathBuf,
    /// Write big figures to a folder beside the page: for the copy in docs/report
    #[arg(long)]
    figures_apart: bool,
}

fn execute(arguments: &Arguments) -> Result<(), Error> {
    start_pool(CallingThread::StaysOutside)?;
    let figures = if arguments.figures_apart {
        Figures::Apart
    } else {
        Figures::Inside
    };
    verify(arguments.only.as_deref(), &arguments.out, figures)
}

fn main() -> ExitCode {
    match execute(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // If nobody reads it any more, it is left out.
            let _ = writeln!(std::io::stderr(), "gouge: {error}");
            ExitCode::from(error.status())
        }
    }
}
