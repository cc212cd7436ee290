//! The study of the thesis, repeated with many seeds: its sweeps, its claims, and a page of verdicts.
//!
//! Rules and tests are fixed in `claims` and do not depend on results.

mod claims;
mod curves;
mod figures;
mod page;
mod parts;
mod printed;
mod results;

pub use parts::{Part, Scale, parts};

use crate::sweep::Sweep;
use curves::Curves;
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use results::Results;
use std::collections::HashSet;
use std::path::Path;

/// A part of the study with its sweep, ready to be executed.
pub struct Prepared {
    /// The part.
    pub part: Part,
    /// Its sweep.
    pub sweep: Sweep,
}

/// Write the sweep files of all parts into folders below `out` and read them.
///
/// # Errors
/// Failures of the file system.
pub fn prepare(scale: Scale, out: &Path) -> Result<Vec<Prepared>, Error> {
    let prepare = |part: Part| {
        let folder = out.join(part.name);
        std::fs::create_dir_all(&folder).map_err(|error| Error::file("create", &folder, error))?;
        let file = folder.join("sweep.toml");
        write_whole(&file, part.sweep.as_bytes())?;
        let sweep = Sweep::load(&file)?;
        Ok(Prepared { part, sweep })
    };
    parts(scale).into_iter().map(prepare).collect()
}

/// Names of the runs that earlier studies finished.
///
/// # Errors
/// Tables that cannot be read.
pub fn known(earlier: &[&Path]) -> Result<HashSet<String>, Error> {
    let mut results = Results::default();
    for folder in earlier {
        results.add_joint(&folder.join("runs.csv"))?;
    }
    let finished = results.runs().iter().filter(|run| run.is_finished());
    Ok(finished.map(|run| run.name.clone()).collect())
}

/// Join the tables of all parts into `runs.csv` and `curves.csv`, test every claim, and write `claims.csv` and
/// `study.html`.
///
/// `earlier` are folders with `runs.csv` and `curves.csv` of earlier studies, whose results count, too.
///
/// # Errors
/// Failures of the file system.
pub fn conclude(prepared: &[Prepared], earlier: &[&Path], out: &Path) -> Result<(), Error> {
    let mut results = Results::default();
    let mut curves = Curves::default();
    for folder in earlier {
        results.add_joint(&folder.join("runs.csv"))?;
        curves.add(&folder.join("curves.csv"))?;
    }
    for one in prepared {
        let folder = out.join(one.part.name);
        results.add(one.part.name, &folder.join("runs.csv"))?;
    }
    curves.observe(&results, out);
    results.write(&out.join("runs.csv"))?;
    curves.write(&out.join("curves.csv"))?;
    let claims = claims::all(&results);
    claims::write(&claims, &out.join("claims.csv"))?;
    let figures = figures::all(&results, &curves);
    let page = page::page(&results, &claims, &figures);
    write_whole(&out.join("study.html"), page.into_string().as_bytes())
}
