//! The `gouge` command: parses arguments and prints results.

mod account;
mod calibrate;
mod compare;
mod progress;
mod study;
mod sweep;
mod terminal;
mod verify;

use account::account;
use calibrate::CalibrateArguments;
use clap::{Args, Parser, Subcommand};
use compare::CompareArguments;
use gouge_runner::error::Error;
use gouge_runner::machine::{CallingThread, instruction_names, start_pool};
use gouge_runner::scene::{Overrides, Scene, builtin};
use gouge_runner::{commands, run};
use mimalloc::MiMalloc;
use std::ffi::OsString;
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::LazyLock;
use study::StudyArguments;
use sweep::SweepArguments;
use terminal::{Terminal, say};

/// Aligns the columns of large worlds to cache lines and puts them into huge pages.
#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

/// Version, commit and the instructions of this machine that worlds can use, the widest last.
static VERSION: LazyLock<String> = LazyLock::new(|| {
    let instructions = instruction_names().join(", ");
    format!(
        "{}\ninstructions: {instructions}",
        gouge_runner::build::VERSION
    )
});

/// A verified discrete element model of shearing brittle surfaces.
#[derive(Parser)]
#[command(version = VERSION.as_str())]
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
        /// Continue an interrupted run, or extend a finished one to a later time.end
        #[arg(long)]
        resume: bool,
        /// Replace the results of another run in this folder
        #[arg(long, conflicts_with = "resume")]
        overwrite: bool,
        /// End with status 0 even if the energy balance shows that the results cannot be trusted
        #[arg(long)]
        accept_untrusted: bool,
        /// Show no progress and no account at the end; warnings are still shown
        #[arg(long, short)]
        quiet: bool,
        /// Write data only: neither run.html nor restart.toml
        #[arg(long)]
        data_only: bool,
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
    /// Run a scene and compare it with data of another program
    Compare {
        #[command(flatten)]
        scene: SceneArguments,
        #[command(flatten)]
        data: CompareArguments,
    },
    /// Run a scene with every combination of some values of its keys
    Sweep(SweepArguments),
    /// Repeat a published study with many seeds and test its claims
    Study(StudyArguments),
    /// Find the parameters of scenes that agree with what was measured
    Calibrate(CalibrateArguments),
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
    /// A scene file, the name of a built-in scene, or - for standard input
    scene: OsString,
    /// Override a key of the scene with a TOML value, such as time.step=1e-9; repeatable
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
}

impl SceneArguments {
    fn load(&self) -> Result<Scene, Error> {
        let overrides = Overrides::parse(&self.set)?;
        if self.scene != "-" {
            self.tell_of_ambiguity();
            return Scene::load_with(&self.scene, &overrides);
        }
        let mut bytes = Vec::new();
        let read = std::io::stdin().read_to_end(&mut bytes);
        read.map_err(|error| Error::file("read", Path::new("standard input"), error))?;
        let folder = Path::new(".");
        Ok(Scene::parse_with(
            "standard input",
            &bytes,
            folder,
            &overrides,
        )?)
    }

    /// Say so if both a file and a built-in scene have the name.
    fn tell_of_ambiguity(&self) {
        let path = Path::new(&self.scene);
        if path.is_file() && builtin::of_path(path).is_some() {
            let name = path.display();
            say(&format!(
                "reading the file {name}; for the built-in scene of this name: \
                 gouge scenes {name} | gouge ... -"
            ));
        }
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
        Command::Run { .. } | Command::Compare { .. } => CallingThread::JoinsPool,
        _ => CallingThread::StaysOutside,
    })?;
    let text = match command {
        Command::Run {
            scene,
            out,
            resume,
            overwrite,
            accept_untrusted,
            quiet,
            data_only,
            checkpoint_interval,
        } => {
            let options = run::RunOptions {
                resume,
                overwrite,
                data_only,
                checkpoint_interval,
            };
            let scene = scene.load()?;
            let summary = run::run(&scene, &out, options, &mut Terminal::new(quiet)?)?;
            if !quiet {
                print(&account(&scene, &summary, &out))?;
            }
            return match summary.status == run::UNTRUSTED && !accept_untrusted {
                true => Err(Error::Untrusted(out)),
                false => Ok(()),
            };
        }
        Command::Compare { scene, data } => return compare::launch(&scene.load()?, data),
        Command::Sweep(arguments) => return sweep::launch(&arguments),
        Command::Study(arguments) => return study::launch(&arguments),
        Command::Calibrate(arguments) => return calibrate::launch(&arguments),
        Command::Verify { only, out } => return verify::launch(only.as_deref(), &out),
        Command::Links { scene } => commands::links(&scene.load()?)?,
        Command::Stability { scene } => commands::stability(&scene.load()?)?,
        Command::Scenes { name } => commands::scenes(name.as_deref())?,
    };
    print(&text)
}

/// Write to standard output. If the reader closes the pipe, as `head` does, the rest is left out.
fn print(text: &str) -> Result<(), Error> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Error::file("write", Path::new("standard output"), error))
        }
        _ => Ok(()),
    }
}

fn main() -> ExitCode {
    match execute(Arguments::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            say(&error.to_string());
            ExitCode::from(error.status())
        }
    }
}
