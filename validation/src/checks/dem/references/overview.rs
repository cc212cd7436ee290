//! The table of all stored cases.

use super::motion;
use crate::checks::{
    Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, largest, thesis,
};
use crate::references::{Case, Compared, case, paths};

/// The check of this file.
pub fn check() -> Check {
    Check {
        id: "references.overview",
        claim: "Every stored case names its engine, version, inputs and runs, and the kernel reproduces every stored motion within its tolerance.",
        equations: thesis("(28)-(58)"),
        scene: "All cases of the folder references",
        oracle: "LAMMPS and YADE",
        norm: "Number of cases that lack a version or a run, whose inputs differ from those given to the engine (by SHA-256), or whose motion differs by more than their tolerance",
        origin: Origin::Exact,
        reason: "No case may be incomplete",
        effort: Effort::Quick,
        measure: overview,
    }
}

fn overview() -> Outcome {
    let mut table = Table::new(
        "Stored cases",
        &[
            "case", "engine", "version", "date", "runs", "laws", "digits",
        ],
    );
    let mut wrong = 0;
    for path in paths() {
        let case = case(&path).map_err(Failure::Oracle)?;
        let result = &case.result;
        let is_complete = !result.version.is_empty()
            && !result.inputs.is_empty()
            && case.changed_inputs().is_empty()
            && !case.runs.is_empty()
            && result.runs.iter().all(|run| !run.command.is_empty());
        let digits = digits(case)?;
        wrong += usize::from(!is_complete || digits.as_ref().is_none_or(|(_, passes)| !passes));
        table.push([
            path.to_owned(),
            result.engine.clone(),
            result.version.clone(),
            result.date.clone(),
            case.runs.len().to_string(),
            case.laws.clone(),
            digits.map_or_else(String::new, |(digits, _)| digits),
        ]);
    }
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table)]))
}

/// Digits of agreement of a motion, and whether they suffice; other cases are judged by their own
/// checks.
fn digits(case: &Case) -> Result<Option<(String, bool)>, Failure> {
    let said = |words: &str| Ok(Some((words.to_owned(), true)));
    match case.compares {
        Compared::Ensemble => return said("equivalent within margins"),
        Compared::Beam | Compared::Inertia => {
            return said("after adding the difference of the laws");
        }
        Compared::Motion => {}
    }
    let differences = motion::differences(case)?;
    let size = largest(
        differences
            .iter()
            .map(|(_, difference)| difference.largest()),
    );
    let digits = format!("{:.1}", -size.max(1e-17).log10());
    Ok(Some((digits, size <= case.tolerance)))
}
