//! Studies: sweeps, claims with rules that are fixed before the runs, and a page of verdicts.

mod change;
mod claim;
mod curves;
mod friction_curves;
mod illustration;
mod media;
mod page;
mod peridem;
mod pictures;
mod polygons;
mod results;
mod rocks;
mod sample;
mod strength;
mod thesis;

use crate::sweep::Sweep;
use claim::{Claim, Rule};
use curves::{CurvePlan, Curves};
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use illustration::Illustration;
use maud::Markup;
use pictures::{Kept, Shown};
use results::{Columns, Results};
use std::collections::HashSet;
use std::path::Path;

/// A study.
pub struct Study {
    /// Its name on the command line.
    pub name: &'static str,
    /// Title of its page.
    title: &'static str,
    /// What it asks and how, in words.
    introduction: fn() -> Markup,
    /// Its parts, in the order in which they are run.
    parts: fn(Scale) -> Vec<Part>,
    /// All its parts, the most telling first.
    order: &'static [&'static str],
    /// Its claims.
    rules: fn() -> Vec<&'static Rule>,
    /// The curves over time that it keeps.
    curves: CurvePlan,
    /// What it shows below its tables.
    illustrations: fn(&Results, &Curves) -> Vec<Illustration>,
    /// Its tables.
    tables: fn(&Results) -> Vec<Markup>,
    /// Final states that it shows.
    pictures: &'static [Shown],
}

/// All studies.
pub static STUDIES: [&Study; 6] = [
    &thesis::STUDY,
    &strength::STUDY,
    &media::STUDY,
    &rocks::STUDY,
    &polygons::STUDY,
    &peridem::STUDY,
];

/// How much is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// What two cores do in two hours.
    Small,
    /// All of it.
    Full,
}

/// A sweep of a study.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its name, also of its folder.
    pub name: &'static str,
    /// Its sweep file.
    sweep: String,
}

impl Part {
    /// A part, from a sweep file in which `SEEDS` stands for the seeds.
    fn new(name: &'static str, sweep: &str, seeds: &str) -> Self {
        Self {
            name,
            sweep: sweep.replace("SEEDS", seeds),
        }
    }
}

/// A part of a study with its sweep, ready to be executed.
pub struct Prepared {
    /// The part.
    pub part: Part,
    /// Its sweep.
    pub sweep: Sweep,
}

impl Study {
    /// The study of a name.
    pub fn named(name: &str) -> Option<&'static Self> {
        STUDIES.into_iter().find(|study| study.name == name)
    }

    /// Write the sweep files of all parts into folders below `out` and read them.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn prepare(&self, scale: Scale, out: &Path) -> Result<Vec<Prepared>, Error> {
        let prepare = |part: Part| {
            let folder = out.join(part.name);
            std::fs::create_dir_all(&folder)
                .map_err(|error| Error::file("create", &folder, error))?;
            let file = folder.join("sweep.toml");
            write_whole(&file, part.sweep.as_bytes())?;
            let sweep = Sweep::load(&file)?;
            Ok(Prepared { part, sweep })
        };
        (self.parts)(scale).into_iter().map(prepare).collect()
    }

    /// Join the tables of all parts into `runs.csv` and `curves.csv`, test every claim, and write `claims.csv` and
    /// `study.html`.
    ///
    /// `earlier` are folders with `runs.csv`, `curves.csv` and pictures of earlier studies, whose results count, too.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn conclude(
        &self,
        prepared: &[Prepared],
        earlier: &[&Path],
        out: &Path,
    ) -> Result<(), Error> {
        let columns = Columns::of(prepared.iter().map(|one| &one.sweep));
        let mut results = Results::default();
        let mut curves = Curves::new(self.curves);
        for folder in earlier {
            results.add_joint(&folder.join("runs.csv"), &columns)?;
            curves.add(&folder.join("curves.csv"))?;
        }
        for one in prepared {
            let folder = out.join(one.part.name);
            results.add(one.part.name, &folder.join("runs.csv"), &columns)?;
        }
        curves.observe(&results, out);
        results.write(&out.join("runs.csv"))?;
        curves.write(&out.join("curves.csv"))?;
        let rules = (self.rules)().into_iter();
        let claims: Vec<Claim> = rules
            .map(|rule| Claim::judged(rule, self.order, &results))
            .collect();
        claim::write(&claims, &out.join("claims.csv"))?;
        let kept = Kept {
            results: &results,
            earlier,
            out,
        };
        let illustrations = (self.illustrations)(&results, &curves).into_iter();
        let illustrations: Result<Vec<Markup>, Error> = illustrations
            .chain(
                self.pictures
                    .iter()
                    .map(|&shown| Illustration::Picture(shown)),
            )
            .map(|illustration| illustration.html(&kept))
            .collect();
        let page = page::page(self, &results, &claims, &illustrations?);
        write_whole(&out.join("study.html"), page.into_string().as_bytes())
    }
}

/// Names of the runs that earlier parts of a study finished; `prepared` are its present parts.
///
/// # Errors
/// Tables that cannot be read or are not those of a study.
pub fn known(
    study: &Study,
    earlier: &[&Path],
    prepared: &[Prepared],
) -> Result<HashSet<String>, Error> {
    let columns = Columns::of(prepared.iter().map(|one| &one.sweep));
    let mut results = Results::default();
    for folder in earlier {
        results.add_joint(&folder.join("runs.csv"), &columns)?;
        Curves::new(study.curves).add(&folder.join("curves.csv"))?;
    }
    let finished = results.runs().iter().filter(|run| run.is_finished());
    Ok(finished.map(|run| run.name.clone()).collect())
}
