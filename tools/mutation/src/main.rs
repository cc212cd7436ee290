//! Whether the gate notices every number of the kernel.
//!
//! Every literal and every coefficient of a formula of the kernel is a site. The workspace is copied, each
//! site is wrapped in a question whether it is the one to be scaled by 1 + 1e-6, and the gate is built
//! once. Each test is run once to learn which sites it uses. Then each site is scaled in turn, and the
//! tests that use it are run, fast ones first, until one fails. A site whose tests all pass has survived:
//! the gate would not notice a wrong number there.

mod declared;
mod exempt;
mod gate;
mod names;
mod results;
mod site;
mod sites;
mod workspace;

use clap::Parser;
use results::{Fate, Results};
use site::Site;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A result, or why there is none.
pub type Outcome<T> = Result<T, Box<dyn std::error::Error + Send + Sync>>;

/// Scale every number of the kernel's formulas by 1 + 1e-6, one at a time, and list those that the gate
/// does not notice.
#[derive(Parser)]
struct Arguments {
    /// List the sites and stop.
    #[arg(long)]
    list: bool,
    /// Only sites whose line of the list contains this text.
    #[arg(long)]
    only: Option<String>,
    /// Try again what survived before, and keep the other results.
    #[arg(long)]
    again: bool,
    /// How many sites are tried at a time.
    #[arg(long, default_value_t = 2)]
    jobs: usize,
    /// Folder for the copy and the results.
    #[arg(long)]
    folder: Option<PathBuf>,
}

fn main() -> Outcome<ExitCode> {
    let arguments = Arguments::parse();
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .canonicalize()?;
    let sources = workspace::survey(&root)?;
    let all = workspace::sites(&sources);
    if let Some(unused) = exempt::stale(&all).first() {
        return Err(format!("an exemption fits no site: {unused}").into());
    }
    let wanted = |site: &&Site| {
        let only = arguments.only.as_ref();
        only.is_none_or(|text| site.to_string().contains(text))
    };
    let (exempted, tried): (Vec<Site>, Vec<Site>) = all
        .iter()
        .filter(wanted)
        .cloned()
        .partition(|site| exempt::reason(site).is_some());
    if arguments.list {
        all.iter()
            .filter(wanted)
            .for_each(|site| println!("{site}"));
        println!("{} sites and {} exempted", tried.len(), exempted.len());
        return Ok(ExitCode::SUCCESS);
    }
    let folder = arguments
        .folder
        .unwrap_or_else(|| std::env::temp_dir().join("gouge-mutation"));
    let copy = folder.join("copy");
    workspace::plant(&root, &copy, &sources)?;
    let gate = gate::Gate::build(&copy)?;
    let mut results = Results::open(&folder, &gate, &all)?;
    if arguments.again {
        results.forget_survivors();
    }
    let tests = gate.learn(&folder, arguments.jobs, all.len(), &mut results)?;
    let open: Vec<&Site> = tried.iter().filter(|site| !results.has(site)).collect();
    try_all(&gate, &tests, &open, arguments.jobs, &mut results)?;
    Ok(report(&tried, &exempted, &results))
}

/// Scale each site in turn, several at a time.
fn try_all(
    gate: &gate::Gate,
    tests: &gate::Tests,
    open: &[&Site],
    jobs: usize,
    results: &mut Results,
) -> Outcome<()> {
    let next = AtomicUsize::new(0);
    let shared = Mutex::new(results);
    let work = || -> Outcome<()> {
        while let Some(site) = open.get(next.fetch_add(1, Ordering::Relaxed)) {
            let fate = gate.try_site(site.id, tests)?;
            println!("{site}: {fate}");
            let mut results = shared.lock().map_err(|_| "another job has failed")?;
            results.add(site, fate)?;
        }
        Ok(())
    };
    std::thread::scope(|scope| {
        let running: Vec<_> = (0..jobs).map(|_| scope.spawn(work)).collect();
        for job in running {
            job.join().map_err(|_| "a job has failed")??;
        }
        Ok(())
    })
}

/// Print what was left out, what survived and how many were caught.
fn report(tried: &[Site], exempted: &[Site], results: &Results) -> ExitCode {
    println!("\nLeft out:");
    for site in exempted {
        println!("{site}: {}", exempt::reason(site).unwrap_or_default());
    }
    println!("\nSurvived:");
    let mut survivors = 0;
    for site in tried {
        if let Some(fate @ (Fate::Survived | Fate::Unused)) = results.fate(site) {
            survivors += 1;
            println!("{site}: {fate}");
        }
    }
    println!(
        "\n{} of {} sites caught, {survivors} survived, {} left out",
        tried.len() - survivors,
        tried.len(),
        exempted.len()
    );
    if survivors == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
