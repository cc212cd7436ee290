//! All scenes in one table.

use super::advice::{cost_of_thesis, fastest, ratio, useless};
use super::scenes::CASES;
use super::show::Curves;
use super::{VERLET, curves};
use crate::checks::{Check, Effort, Exhibit, Measurement, Origin, Outcome, Table, thesis};

/// The check that summarises the scenes.
pub fn check() -> Check {
    Check {
        id: "work-precision.summary",
        claim: "With the thesis's time step, forward Euler is in no scene as accurate as velocity Verlet, which needs the same number of force evaluations.",
        equations: thesis("(55)-(58)"),
        scene: "The seven scenes of the diagrams, with 10 ns or the same fraction of their time scale",
        oracle: "The oracles of the diagrams",
        norm: "Number of scenes in which the error of velocity Verlet is not smaller than that of forward Euler",
        origin: Origin::Exact,
        reason: "A count; the errors differ by far more than the uncertainty of the references",
        effort: Effort::Report,
        measure,
    }
}

fn measure() -> Outcome {
    let all = (0..CASES.len()).map(curves);
    let all = all.collect::<Result<Vec<_>, _>>()?;
    let wins = all.iter().filter(|(_, curves)| euler_wins(curves)).count();
    let columns = [
        "scene",
        "best for 1e-3",
        "best for 1e-6",
        "best for 1e-9",
        "error of the thesis's choice",
        "time over that of the best method for the same error",
        "error over that of the best method in the same time",
        "dominated methods",
    ];
    let title =
        "Recommended integrators, and the cost of forward Euler with the thesis's time step";
    let mut table = Table::new(title, &columns);
    all.iter().for_each(|(_, curves)| table.push(row(curves)));
    Ok(Measurement::count(wins).showing([Exhibit::Table(table), Exhibit::Text(everywhere(&all))]))
}

fn euler_wins(curves: &Curves) -> bool {
    let error = |method: usize| {
        let rung = curves
            .methods
            .get(method)?
            .rungs
            .get(curves.case.doublings as usize)?;
        Some(rung.error)
    };
    // An unstable run has an infinite error; a missing run counts against the claim.
    !matches!((error(0), error(VERLET)), (Some(euler), Some(verlet)) if verlet < euler)
}

fn row(curves: &Curves) -> Vec<String> {
    let best = |error: f64| {
        let found = fastest(&curves.methods, error);
        found
            .map_or("none", |(sweep, _)| sweep.integrator)
            .to_owned()
    };
    let thesis = cost_of_thesis(curves.case, &curves.methods);
    let error = thesis.as_ref().map_or(f64::INFINITY, |thesis| thesis.error);
    let slower = thesis.as_ref().and_then(|thesis| Some(thesis.slower?.0));
    let fraction = thesis
        .as_ref()
        .and_then(|thesis| Some(1.0 / thesis.fraction?.0));
    let useless = useless(&curves.methods);
    vec![
        curves.case.name.to_owned(),
        best(1e-3),
        best(1e-6),
        best(1e-9),
        if error.is_finite() {
            format!("{error:.1e}")
        } else {
            "unstable".to_owned()
        },
        ratio(slower),
        ratio(fraction),
        if useless.is_empty() {
            "none".to_owned()
        } else {
            useless.join(", ")
        },
    ]
}

/// Methods that are dominated in every scene.
fn everywhere(all: &[&super::Taken]) -> String {
    let mut common: Option<Vec<&str>> = None;
    for (_, curves) in all {
        let here = useless(&curves.methods);
        common = Some(match common {
            Some(before) => before
                .into_iter()
                .filter(|name| here.contains(name))
                .collect(),
            None => here,
        });
    }
    match common.unwrap_or_default().as_slice() {
        [] => "No method is dominated in every scene.".to_owned(),
        names => format!("Dominated in every scene: {}.", names.join(" or ")),
    }
}
