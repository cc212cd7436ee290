//! The `gouge` command: parses arguments and prints results.

mod terminal;
mod verify;

use clap::{Args, Parser, Subcommand};
use gouge_runner::error::Error;
use gouge_runner::machine::{CallingThread, start_pool};
use gouge_runner::scene::{Overrides, Scene};
use gouge_runner::{commands, run};
use mimalloc::MiMalloc;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use terminal::Terminal;

/// Aligns the columns of large worlds to cache lines and puts them into huge pages.
#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

/// A verified discrete element model of shearing brittle surfaces.
#[derive(Parser)]
#[command(version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run a scene and write its outputs
    Run {
        #[command(flatten)]
        scene: SceneArguments,
        /// Folder for the outputs
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// Continue an interrupted run
        #[arg(long)]
        resume: bool,
        /// Show no progress and no warnings
        #[arg(long, short)]
        quiet: bool,
        /// Wall time between checkpoints, in seconds
        #[arg(long, value_name = "SECONDS", default_value = "5", value_parser = seconds)]
        checkpoint_interval: f64,
    },
    /// Print every pair that interacts at t = 0, as CSV
    Links {
        #[command(flatten)]
        scene: SceneArguments,
    },
    /// Print the time-step bounds of a scene, as JSON
    Stability {
        #[command(flatten)]
        scene: SceneArguments,
    },
    /// Run the checks and write report.html and report.json
    Verify {
        /// Run only checks whose identifier contains this text
        #[arg(long, value_name = "PATTERN")]
        only: Option<String>,
        /// Folder for the reports
        #[arg(long, value_name = "DIR", default_value = "out/verify")]
        out: PathBuf,
    },
    /// List the built-in scenes, or print one
    Scenes {
        /// Name of a built-in scene
        name: Option<String>,
    },
}

/// A scene and the overrides of its keys.
#[derive(Args)]
struct SceneArguments {
    /// A scene file, or the name of a built-in scene
    scene: String,
    /// Override a key of the scene with a TOML value, such as time.step=1e-9; repeatable
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
}

impl SceneArguments {
    fn load(&self) -> Result<Scene, Error> {
        Scene::load_with(&self.scene, &Overrides::parse(&self.set)?)
    }
}

/// Parse a number of seconds.
fn seconds(text: &str) -> Result<f64, String> {
    let number = text.parse().ok();
    let number = number.filter(|number: &f64| number.is_finite() && *number >= 0.0);
    number.ok_or_else(|| "must be a finite number of seconds, zero or greater".to_owned())
}

fn execute(command: Command) -> Result<(), Error> {
    start_pool(match command {
        Command::Run { .. } => CallingThread::JoinsPool,
        _ => CallingThread::StaysOutside,
    })?;
    let text = match command {
        Command::Run {
            scene,
            out,
            resume,
            quiet,
            checkpoint_interval,
        } => {
            let options = run::RunOptions {
                resume,
                checkpoint_interval,
            };
            let mut terminal = Terminal::new(quiet);
            return run::run(&scene.load()?, &out, options, &mut terminal);
        }
        Command::Verify { only, out } => return verify::launch(only.as_deref(), &out),
        Command::Links { scene } => commands::links(&scene.load()?)?,
        Command::Stability { scene } => commands::stability(&scene.load()?)?,
        Command::Scenes { name } => commands::scenes(name.as_deref())?,
    };
    // Writing fails if the reader closes the pipe, as `head` does; this is not an error.
    let _ = std::io::stdout().write_all(text.as_bytes());
    Ok(())
}

fn main() -> ExitCode {
    match execute(Arguments::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("gouge: {error}");
            ExitCode::from(error.status())
        }
    }
}
