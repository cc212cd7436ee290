//! The stability limit, bracketed by runs.

use super::modes::{Linearised, Mode, integrator_name};
use super::running::grows;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, Table, thesis};
use crate::oracles::amplification::{Method, boundary};
use rayon::prelude::*;

/// The checks of this file.
pub fn checks() -> Vec<Check> {
    let check = |id, effort, measure| Check {
        id,
        claim: "Half a per cent below the theoretical critical step no run of the kernel grows, and half a per cent above it every run grows: for axial, shearing and bending modes of bonds, squeezed, sticking and viscous contacts and drag, with every integrator. Methods without a stable step grow.",
        equations: thesis("(17)-(19), (36), (41)-(45), (55)-(58)"),
        scene: "Seven modes of two or three grains in linear motion; damping ratio 0.5, or from 0.1 to 4",
        oracle: "Step at which the largest eigenvalue of the one-step matrix reaches one",
        norm: "Number of runs on the wrong side",
        origin: Origin::Exact,
        reason: "Half a per cent from the limit, amplitudes change by at least 1e-4 per step; blocks of 512 or more steps distinguish that from rounding",
        effort,
        measure,
    };
    vec![
        check("time-step.bracket.few", Effort::Quick, few),
        check("time-step.bracket.all", Effort::Thorough, all),
    ]
}

/// A mode, a method, a damping ratio and the critical step.
type Case = (Mode, Method, f64, f64);

/// Cases with a critical step to bracket, grouped by mode and damping ratio. Methods that are never
/// stable have none; they run at one step, at which they must grow.
fn cases(ratios: &[f64]) -> Vec<Case> {
    let mut cases = Vec::new();
    for mode in Mode::ALL {
        for zeta in mode.ratios(ratios) {
            for method in Method::ALL {
                let rates = mode.rates(mode.constants(zeta));
                cases.push((mode, method, zeta, boundary(method, rates, 1e-12)));
            }
        }
    }
    cases
}

/// Whether the linearised run of a mode grows.
fn runs_away(mode: Mode, method: Method, step: f64, constants: [f64; 2]) -> Result<bool, Failure> {
    let mut run = Linearised::new(mode, method, step, constants)?;
    let mut scale = None;
    grows(|| {
        run.advance()?;
        let [amplitude, change] = run.state();
        // A mode without stiffness has a speed but no restored amplitude.
        let size = if mode == Mode::Viscous {
            change
        } else {
            amplitude
        };
        let scale = *scale.get_or_insert(size.abs());
        Ok(size / scale)
    })
}

/// Number of runs, of two, on the wrong side of the limit.
fn wrong((mode, method, zeta, critical): Case) -> Result<usize, Failure> {
    let constants = mode.constants(zeta);
    if critical < 1e-8 {
        // Never stable: it must grow at half the unit of time.
        let grows = runs_away(mode, method, 0.5e-6, constants)?;
        return Ok(usize::from(!grows));
    }
    let below = runs_away(mode, method, 0.995 * critical, constants)?;
    let above = runs_away(mode, method, 1.005 * critical, constants)?;
    Ok(usize::from(below) + usize::from(!above))
}

fn bracket(ratios: &[f64]) -> Outcome {
    let cases = cases(ratios);
    let wrong = cases
        .par_iter()
        .map(|&case| wrong(case))
        .collect::<Result<Vec<usize>, Failure>>()?;
    let methods = Method::ALL.map(integrator_name);
    let mut columns = vec!["mode", "damping ratio"];
    columns.extend(methods);
    columns.push("runs on the wrong side");
    let mut table = Table::new(
        "Critical steps in units of 1/w (of 1/rate without stiffness), each bracketed by two runs half a per cent below and above",
        &columns,
    );
    let rows = cases.chunks(methods.len()).zip(wrong.chunks(methods.len()));
    for (row, wrong) in rows {
        let (mode, _, zeta, _) = row[0];
        let steps = row.iter().map(|&(_, _, _, critical)| {
            if critical < 1e-8 {
                "none".to_owned()
            } else {
                format!("{:.5}", critical * 1e6)
            }
        });
        let names = [mode.name().to_owned(), format!("{zeta}")];
        let wrong = wrong.iter().sum::<usize>().to_string();
        table.push(names.into_iter().chain(steps).chain([wrong]));
    }
    let count = wrong.into_iter().sum();
    Ok(Measurement::count(count).showing([crate::checks::Exhibit::Table(table)]))
}

fn few() -> Outcome {
    bracket(&[0.5])
}

fn all() -> Outcome {
    bracket(&[0.1, 0.3, 0.7, 1.0, 2.0, 4.0])
}
