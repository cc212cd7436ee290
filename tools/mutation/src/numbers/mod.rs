//! Every number of the kernel's formulas, scaled by 1 + 1e-6.

mod declared;
mod exempt;
mod names;
mod site;
mod sites;
mod switches;

use crate::gate::Gate;
use crate::results::Results;
use crate::{Options, Outcome, campaign, workspace};
use site::Site;
use std::path::Path;
use std::process::ExitCode;

/// Test the sites or list them.
///
/// # Errors
/// A source that cannot be read, an exemption that matches no site, a copy that does not compile, or a test that fails
/// without a fault.
pub fn run(root: &Path, folder: &Path, options: &Options) -> Outcome<ExitCode> {
    let sources = switches::survey(root, options.kernel)?;
    let all = switches::sites(&sources);
    if let Some(unused) = exempt::stale(&all, options.kernel).first() {
        return Err(format!("an exemption matches no site: {unused}").into());
    }
    let (exempted, tried): (Vec<Site>, Vec<Site>) = all
        .iter()
        .filter(|site| options.wants(site))
        .cloned()
        .partition(|site| exempt::reason(site).is_some());
    if options.list {
        all.iter()
            .filter(|site| options.wants(site))
            .for_each(|site| println!("{site}"));
        println!("{} sites, and {} exempt ones", tried.len(), exempted.len());
        return Ok(ExitCode::SUCCESS);
    }
    let copy = folder.join("copy");
    workspace::plant(root, &copy, &switches::texts(&sources), all.len())?;
    let gate = Gate::build(&copy, "test", options.kernel)?;
    let results = campaign::run(&gate, folder, &tried, all.len(), options)?;
    Ok(report(&tried, &exempted, &results))
}

/// Print the exempt sites, the survivors and the number of detected faults.
fn report(tried: &[Site], exempted: &[Site], results: &Results) -> ExitCode {
    println!("\nExempt:");
    for site in exempted {
        println!("{site}: {}", exempt::reason(site).unwrap_or_default());
    }
    let survivors = campaign::print_survivors(tried, results);
    println!(
        "\n{} of {} sites detected, {survivors} survived, {} exempt",
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
