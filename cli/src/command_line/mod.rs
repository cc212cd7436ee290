//! The command line: parses arguments and prints results.

mod account;
mod calibrate;
mod compare;
mod help;
mod progress;
mod replay;
mod study;
mod sweep;
mod terminal;
mod verify;

pub use account::account;
use calibrate::CalibrateArguments;
use clap::{Args, CommandFactory, Parser, Subcommand};
use clap_complete::{Shell, generate};
use clap_mangen::Man;
use compare::CompareArguments;
use gouge_runner::any_scene::AnyScene;
use gouge_runner::error::Error;
use gouge_runner::machine::{COMPILED_FOR, CallingThread, instruction_names, start_pool};
use gouge_runner::scene::{Overrides, builtin};
use gouge_runner::{commands, run};
use gouge_studies::sweep::Program;
use replay::ReplayArguments;
use std::ffi::OsString;
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use study::StudyArguments;
use sweep::SweepArguments;
use terminal::{Terminal, say};

/// Version and commit, and the instructions for which worlds are compiled and which this machine has, the widest last.
static VERSION: LazyLock<String> = LazyLock::new(|| {
    format!(
        "{}\ncompiled for: {}\ninstructions: {}",
        gouge_runner::build::VERSION,
        COMPILED_FOR.join(", "),
        instruction_names().join(", ")
    )
});

/// A verified discrete element model of shearing brittle surfaces.
#[derive(Parser)]
#[command(name = "gouge", version = VERSION.as_str(), after_help = help::ALL)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run a scene and write its outputs
    #[command(after_help = help::RUN)]
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
    #[command(after_help = help::LINKS)]
    Links {
        #[command(flatten)]
        scene: SceneArguments,
    },
    /// Print the time-step bounds of a scene, as JSON
    #[command(after_help = help::STABILITY)]
    Stability {
        #[command(flatten)]
        scene: SceneArguments,
    },
    /// Run a scene and compare it with data of another program
    #[command(after_help = help::COMPARE)]
    Compare {
        #[command(flatten)]
        scene: SceneArguments,
        #[command(flatten)]
        data: CompareArguments,
    },
    /// Run a scene with every combination of some values of its keys
    #[command(after_help = help::SWEEP)]
    Sweep(SweepArguments),
    /// Repeat a published study with many seeds and test its claims
    #[command(after_help = help::STUDY)]
    Study(StudyArguments),
    /// Find the parameters of scenes that agree with what was measured
    #[command(after_help = help::CALIBRATE)]
    Calibrate(CalibrateArguments),
    /// Repeat worked examples of other programs and write what is found, as JSON
    #[command(after_help = help::REPLAY)]
    Replay(ReplayArguments),
    /// Run the checks and write report.html and report.json
    #[command(after_help = help::VERIFY)]
    Verify {
        /// Run only checks whose identifier contains this text
        #[arg(long, value_name = "PATTERN")]
        only: Option<String>,
        /// Folder for the reports
        #[arg(long, value_name = "DIR", default_value = "out/verify")]
        out: PathBuf,
    },
    /// List the built-in scenes, or print one
    #[command(after_help = help::SCENES)]
    Scenes {
        /// Name of a built-in scene
        name: Option<String>,
    },
    /// Print the completions of this command line for a shell
    #[command(after_help = help::COMPLETIONS)]
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Print the manual page, of this program or of a command
    #[command(after_help = help::MAN)]
    Man {
        /// A command
        command: Option<String>,
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
    fn load(&self) -> Result<AnyScene, Error> {
        let overrides = Overrides::parse(&self.set)?;
        if self.scene != "-" {
            self.tell_of_ambiguity();
            return AnyScene::load_with(&self.scene, &overrides);
        }
        let mut bytes = Vec::new();
        let read = std::io::stdin().read_to_end(&mut bytes);
        read.map_err(|error| Error::file("read", Path::new("standard input"), error))?;
        let folder = Path::new(".");
        AnyScene::parse_with("standard input", &bytes, folder, &overrides)
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

fn execute(command: Command, program: &Program) -> Result<(), Error> {
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
            let summary = scene.run(&out, options, &mut Terminal::new(quiet)?)?;
            if !quiet {
                print(&account(&scene, &summary, &out))?;
            }
            return match summary.status == run::UNTRUSTED && !accept_untrusted {
                true => Err(Error::Untrusted(out)),
                false => Ok(()),
            };
        }
        Command::Compare { scene, data } => {
            return compare::launch(&scene.load()?.dem("compare")?, data);
        }
        Command::Sweep(arguments) => return sweep::launch(&arguments, program),
        Command::Study(arguments) => return study::launch(&arguments, program),
        Command::Calibrate(arguments) => return calibrate::launch(&arguments, program),
        Command::Replay(arguments) => return replay::launch(&arguments),
        Command::Verify { only, out } => return verify::launch(program, only.as_deref(), &out),
        Command::Links { scene } => scene.load()?.links()?.to_csv(),
        Command::Stability { scene } => scene.load()?.stability()?,
        Command::Scenes { name } => commands::scenes(name.as_deref())?,
        Command::Completions { shell } => completions(shell),
        Command::Man { command } => manual(command.as_deref())?,
    };
    print(&text)
}

/// The completions of the command line for a shell.
fn completions(shell: Shell) -> String {
    let mut text = Vec::new();
    generate(shell, &mut Arguments::command(), "gouge", &mut text);
    String::from_utf8_lossy(&text).into_owned()
}

/// The manual page of the program or of a command.
fn manual(name: Option<&str>) -> Result<String, Error> {
    let mut program = Arguments::command().version(env!("CARGO_PKG_VERSION"));
    program.build();
    let page = match name {
        None => program,
        Some(name) => {
            let found = program.find_subcommand(name).cloned();
            let found = found.map(|page| page.version(env!("CARGO_PKG_VERSION")));
            found.ok_or_else(|| {
                let names = program.get_subcommands().map(clap::Command::get_name);
                let names: Vec<&str> = names.collect();
                Error::Argument(format!("{name}: must be one of: {}", names.join(", ")))
            })?
        }
    };
    let mut text = Vec::new();
    let written = Man::new(page).render(&mut text);
    written.map_err(|error| Error::file("write", Path::new("standard output"), error))?;
    Ok(String::from_utf8_lossy(&text).into_owned())
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

/// Do what the arguments of the command `gouge` say, the first of which is its name, and return its exit status; `program`
/// starts it for the runs of sweeps.
pub fn command_line(program: &Program, arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let outcome = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => execute(arguments.command, program),
        Err(refusal) => {
            // If nobody reads what is said, there is nobody to tell.
            let _ = refusal.print();
            return u8::try_from(refusal.exit_code()).unwrap_or(2);
        }
    };
    match outcome {
        Ok(()) => 0,
        Err(error) => {
            say(&error.to_string());
            error.status()
        }
    }
}
