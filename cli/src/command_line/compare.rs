//! `gouge compare`: a run against data of another program.

use super::print;
use super::terminal::Terminal;
use clap::Args;
use gouge_runner::compare::{Options, compare, read};
use gouge_runner::error::Error;
use gouge_runner::scene::Scene;
use std::path::PathBuf;

/// The data, and how they are compared.
#[derive(Args)]
pub struct CompareArguments {
    /// A LAMMPS dump in text form, or a CSV file with the columns time or step, and id for particles
    file: PathBuf,
    /// Largest difference that is accepted, in units of the range of a column; for one column as COLUMN=NUMBER
    #[arg(long, value_name = "[COLUMN=]NUMBER", value_parser = tolerance)]
    tolerance: Vec<(Option<String>, f64)>,
    /// Largest difference of a column in SI units that is accepted whatever its range
    #[arg(long, value_name = "COLUMN=NUMBER", value_parser = absolute)]
    absolute: Vec<(String, f64)>,
    /// Columns to compare, separated by commas; all that both sides have if absent
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    columns: Vec<String>,
    /// Time step of the other program in seconds, if it differs from time.step and the data count steps
    #[arg(long, value_name = "SECONDS", value_parser = step)]
    data_step: Option<f64>,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
}

/// Tolerance without an option.
const TOLERANCE: f64 = 1e-6;

/// Run a scene, compare it, and print the differences.
///
/// # Errors
/// Data that cannot be compared, or that differ.
pub fn launch(scene: &Scene, arguments: CompareArguments) -> Result<(), Error> {
    let data = read(&arguments.file)?;
    let all = arguments.tolerance.into_iter();
    let (common, single): (Vec<_>, Vec<_>) = all.partition(|(name, _)| name.is_none());
    let options = Options {
        step: arguments.data_step,
        tolerance: common.last().map_or(TOLERANCE, |one| one.1),
        tolerances: single
            .into_iter()
            .filter_map(|(name, number)| Some((name?, number)))
            .collect(),
        absolute: arguments.absolute,
        columns: arguments.columns,
    };
    let comparison = compare(
        scene,
        &data,
        &options,
        &mut Terminal::without_signals(arguments.quiet),
    )?;
    print(&comparison.text())?;
    match comparison.is_within() {
        true => Ok(()),
        false => Err(Error::Differs(data.file)),
    }
}

fn tolerance(text: &str) -> Result<(Option<String>, f64), String> {
    let (name, number) = match text.split_once('=') {
        Some((name, number)) => (Some(name.to_owned()), number),
        None => (None, text),
    };
    let number = number.parse().ok().filter(|number: &f64| *number >= 0.0);
    let number = number.ok_or("must be a number, zero or greater, or COLUMN=NUMBER")?;
    Ok((name, number))
}

fn absolute(text: &str) -> Result<(String, f64), String> {
    match tolerance(text)? {
        (Some(name), number) => Ok((name, number)),
        (None, _) => Err("must be COLUMN=NUMBER".to_owned()),
    }
}

fn step(text: &str) -> Result<f64, String> {
    let number = text.parse().ok();
    let number = number.filter(|number: &f64| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "must be a finite number of seconds, greater than zero".to_owned())
}
