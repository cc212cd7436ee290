//! Mutants that replace operators, conditions and results of functions.

mod find;
mod mutant;
mod replacements;
mod report;
mod switches;
mod viable;

use crate::gate::Gate;
use crate::kernel::Kernel;
use crate::workspace::{Source, parse_all};
use crate::{Options, Outcome, campaign};
use clap::Args;
use mutant::{Mutant, Place};
use rand::seq::IteratorRandom;
use rand_pcg::Pcg64;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

/// The cargo profile with which the gate is built.
const PROFILE: &str = "mutants";

/// Selection of mutants.
#[derive(Args)]
pub struct Choice {
    /// Number of mutants drawn; default: all.
    #[arg(long)]
    sample: Option<usize>,
    /// Seed of the random draw.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// A source file with its places.
struct Searched {
    source: Source,
    places: Vec<Place>,
}

/// Draw mutants, and test or list them.
///
/// # Errors
/// A source that cannot be read, a copy that does not compile without mutants, or a test that fails without one.
pub fn run(root: &Path, folder: &Path, choice: &Choice, options: &Options) -> Outcome<ExitCode> {
    let searched = survey(root, options.kernel)?;
    let mut all = mutants(&searched);
    all.retain(|mutant| options.wants(mutant));
    let number = all.len();
    let sample = draw(all, choice);
    if options.list {
        sample.iter().for_each(|mutant| println!("{mutant}"));
        println!("{} of {number} mutants", sample.len());
        return Ok(ExitCode::SUCCESS);
    }
    fs::create_dir_all(folder)?;
    let left_out = viable::settle(root, folder, &searched, &sample, options.kernel)?;
    let gate = Gate::build(&folder.join("copy"), PROFILE, options.kernel)?;
    let viable: Vec<Mutant> = sample
        .iter()
        .filter(|mutant| !left_out.contains(&mutant.switch))
        .cloned()
        .collect();
    let results = campaign::run(&gate, folder, &viable, sample.len(), options)?;
    report::print(number, &sample, &viable, &results)
}

/// The sources of the kernel with their places.
fn survey(root: &Path, kernel: Kernel) -> Outcome<Vec<Searched>> {
    let sources = parse_all(root, kernel.folders())?;
    let search = |source: Source| Searched {
        places: find::find(&source.text, &source.file),
        source,
    };
    Ok(sources.into_iter().map(search).collect())
}

/// All mutants, in order of files and places.
fn mutants(searched: &[Searched]) -> Vec<Mutant> {
    let mut all = Vec::new();
    for (file, one) in searched.iter().enumerate() {
        let name = one.source.name();
        for (number, place) in one.places.iter().enumerate() {
            all.extend(Mutant::of(&name, (file, number), place));
        }
    }
    all
}

/// Draw mutants and number their switches in source order.
fn draw(all: Vec<Mutant>, choice: &Choice) -> Vec<Mutant> {
    let mut numbers: Vec<usize> = (0..all.len()).collect();
    if let Some(size) = choice.sample {
        let mut random = Pcg64::new(u128::from(choice.seed), 0);
        let mut drawn = vec![0; size.min(all.len())];
        numbers.iter().copied().sample_fill(&mut random, &mut drawn);
        drawn.sort_unstable();
        numbers = drawn;
    }
    let numbered = |(switch, number): (usize, usize)| {
        let mut mutant = all[number].clone();
        mutant.switch = switch;
        mutant
    };
    numbers.into_iter().enumerate().map(numbered).collect()
}
