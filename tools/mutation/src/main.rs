//! Tests whether the gate detects deliberate faults in the kernel.
//!
//! There are two kinds of faults: every literal and every coefficient of a formula of the kernel can be
//! scaled by 1 + 1e-6, and operators, conditions and results of functions can be replaced. The workspace
//! is copied, each fault gets a switch, and the gate is built once. Each test is run to learn which
//! switches it meets. Then each fault is switched on in turn, and the tests that meet its switch are run,
//! fast ones first, until one fails. A fault survives if all its tests pass: the gate does not
//! detect it.

mod campaign;
mod gate;
mod kernel;
mod numbers;
mod operators;
mod results;
mod workspace;

use clap::{Args, Parser, Subcommand};
use kernel::Kernel;
use std::path::PathBuf;
use std::process::ExitCode;

/// A result or an error.
pub type Outcome<T> = Result<T, Box<dyn std::error::Error + Send + Sync>>;

/// Switch on faults of the kernel, one at a time, and list those that the gate does not detect.
#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    faults: Option<Faults>,
    #[command(flatten)]
    options: Options,
}

/// Kinds of faults.
#[derive(Subcommand)]
enum Faults {
    /// Scale every number of the kernel's formulas by 1 + 1e-6 (the default).
    Numbers,
    /// Replace operators, conditions and results of functions.
    Operators(operators::Choice),
}

/// Options for all kinds of faults.
#[derive(Args)]
pub struct Options {
    /// List the faults and stop.
    #[arg(long, global = true)]
    list: bool,
    /// Test only faults whose line in the list contains this text.
    #[arg(long, global = true)]
    only: Option<String>,
    /// Test the survivors of an earlier run again; keep the other results.
    #[arg(long, global = true)]
    again: bool,
    /// Number of faults tested at a time.
    #[arg(long, global = true, default_value_t = 2)]
    jobs: usize,
    /// The kernel whose faults are tested.
    #[arg(long, global = true, value_enum, default_value = "dem")]
    kernel: Kernel,
    /// Folder for the copy and the results.
    #[arg(long, global = true)]
    folder: Option<PathBuf>,
}

impl Options {
    /// Whether the options select a fault.
    fn wants(&self, fault: &impl std::fmt::Display) -> bool {
        let only = self.only.as_ref();
        only.is_none_or(|text| fault.to_string().contains(text))
    }

    /// The folder for the copy and the results.
    fn folder(&self, name: &str) -> PathBuf {
        let usual = || std::env::temp_dir().join(self.kernel.folder(name));
        self.folder.clone().unwrap_or_else(usual)
    }
}

fn main() -> Outcome<ExitCode> {
    let Arguments { faults, options } = Arguments::parse();
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .canonicalize()?;
    match faults {
        None | Some(Faults::Numbers) => numbers::run(&root, &options.folder("mutation"), &options),
        Some(Faults::Operators(choice)) => {
            let folder = options.folder("mutation-operators");
            operators::run(&root, &folder, &choice, &options)
        }
    }
}
