//! What a calibration found, as lines for the terminal.

use super::calibration::Calibration;
use super::identify::{DROPS, Marginal, profile_interval};
use super::outcome::{Answer, Outcome};
use super::parameter::Parameter;
use super::truths::Trial;
use crate::words::{counted, duration};
use std::fmt::Write;

/// The outcome on a few lines: the answer, the parameters, the targets, and how far to trust it all.
pub fn account(calibration: &Calibration, outcome: &Outcome) -> String {
    let mut text = format!(
        "{}\n\nanswer          {}\n",
        calibration.title,
        answer(calibration, outcome)
    );
    if !matches!(outcome.answer, Answer::Refuted(_) | Answer::Unresolved) {
        text += &parameters(calibration, outcome);
    }
    text += &targets(calibration, outcome);
    text + &trust(outcome)
}

/// The answer in words.
pub fn answer(calibration: &Calibration, outcome: &Outcome) -> String {
    let determined = outcome
        .combinations
        .iter()
        .filter(|one| one.is_determined());
    let combinations: Vec<String> = determined
        .map(|one| one.text(&calibration.parameters))
        .collect();
    let answer = match &outcome.answer {
        Answer::Determined => "determined".to_owned(),
        Answer::Combinations => format!("only this is determined: {}", combinations.join(", ")),
        Answer::Undetermined => "the measurements determine nothing".to_owned(),
        Answer::Unresolved => format!(
            "unresolved: only {:.0} points of the posterior count",
            outcome.posterior.effective_number()
        ),
        Answer::Refuted(reasons) => format!("refuted: {}", reasons.join("; ")),
    };
    match outcome.failed_range() {
        0.0 => answer,
        share => format!(
            "{answer}; about {:.0} % of the ranges could not be run",
            (100.0 * share).max(1.0)
        ),
    }
}

fn parameters(calibration: &Calibration, outcome: &Outcome) -> String {
    let mut text = format!(
        "\n{:24}{:>12}{:>26}{:>26}{:>14}\n",
        "parameter", "best", "68 %", "90 %", "contraction"
    );
    for (parameter, one) in calibration.parameters.iter().zip(&outcome.marginals) {
        let value = |place: f64| parameter.value(place);
        let [_, low, high, lowest, highest] = one.quantiles.map(value);
        let _ = writeln!(
            text,
            "{:24}{:>12}{:>26}{:>26}{:>14.2}{}",
            parameter.name,
            shown(value(one.best)),
            range(low, high),
            range(lowest, highest),
            one.contraction,
            bounds(parameter, one)
        );
        if let [Some(low), Some(high)] = profile_interval(&one.profile, DROPS[0]) {
            let range = range(value(low), value(high));
            let _ = writeln!(
                text,
                "{:36}{range:>26}  by the profile of the likelihood",
                ""
            );
        }
    }
    text
}

/// A number with four digits.
pub fn shown(number: f64) -> String {
    let size = number.abs();
    match size {
        0.0 => "0".to_owned(),
        _ if !(1e-3..1e5).contains(&size) => format!("{number:.3e}"),
        _ => {
            let decimals = (3.0 - size.log10().floor()).max(0.0) as usize;
            format!("{number:.decimals$}")
        }
    }
}

/// A number with as many digits as it has.
pub fn exact(number: f64) -> String {
    match number.abs() {
        0.0 | 1e-3..1e5 => format!("{number}"),
        _ => format!("{number:e}"),
    }
}

/// A range of values.
pub fn range(low: f64, high: f64) -> String {
    format!("{} - {}", shown(low), shown(high))
}

/// What the profile says about the ends of the range, where it does not bound the parameter on both sides: the one-sided
/// interval of the posterior that holds 95 % of it.
pub fn bounds(parameter: &Parameter, one: &Marginal) -> String {
    let [.., lowest, highest] = one.quantiles.map(|place| shown(parameter.value(place)));
    match one.is_bounded {
        [true, true] => String::new(),
        [true, false] => format!("  bounded only from below: above {lowest} with 95 %"),
        [false, true] => format!("  bounded only from above: below {highest} with 95 %"),
        [false, false] => "  not bounded in its range".to_owned(),
    }
}

fn targets(calibration: &Calibration, outcome: &Outcome) -> String {
    let mut text = format!(
        "\n{:24}{:>24}{:>12}{:>14}{:>16}\n",
        "target", "measured", "best", "residual/sd", "left out, 90 %"
    );
    let best: Vec<f64> = outcome.marginals.iter().map(|one| one.best).collect();
    let predictions = outcome.emulators.at(&best);
    let rows = calibration
        .targets
        .iter()
        .zip(&outcome.measured)
        .zip(&predictions);
    for (((target, one), &prediction), emulator) in rows.zip(&outcome.emulators.0) {
        let left_out = emulator.leave_one_out();
        let covered = left_out
            .iter()
            .filter(|one| one.standardised.abs() < NINETY)
            .count();
        let _ = writeln!(
            text,
            "{:24}{:>24}{:>12}{:>14.2}{:>16}",
            calibration.target_name(target),
            format!("{} +- {}", exact(one.value), exact(one.deviation)),
            shown(prediction.mean),
            one.residual(prediction),
            format!("{covered} of {}", left_out.len()),
        );
    }
    text
}

/// Half the width of a 90 % interval of a normal distribution, in standard deviations.
pub const NINETY: f64 = 1.645;

fn trust(outcome: &Outcome) -> String {
    let runs = outcome.results.runs.len();
    let failed = outcome.results.failed().count();
    let mut text = String::new();
    for (place, wave) in outcome.waves.iter().enumerate() {
        let _ = writeln!(
            text,
            "{}wave {}          {} points; then {:.2} % of the ranges is plausible",
            if place == 0 { "\n" } else { "" },
            place + 1,
            wave.points,
            100.0 * wave.share
        );
    }
    let _ = writeln!(
        text,
        "posterior       {} points, effective number {:.0}",
        outcome.posterior.points.len(),
        outcome.posterior.effective_number()
    );
    let _ = writeln!(
        text,
        "runs            {}, of which {failed} failed; {} on one core",
        runs + outcome.predictive.runs.len(),
        duration(outcome.results.seconds() + outcome.predictive.seconds())
    );
    if failed > 0 {
        let [range, share] =
            [outcome.failed_range(), outcome.failed_share()].map(|one| 100.0 * one);
        let _ = writeln!(
            text,
            "                {range:.1} % of the ranges and {share:.1} % of the posterior are nearest to points where \
             runs failed;\n                there nothing was measured, and all values are about as likely as before"
        );
    }
    text
}

/// How known truths were recovered, one line a parameter.
pub fn account_of_trial(calibration: &Calibration, trial: &Trial) -> String {
    let mut text = format!(
        "{}\n{:24}{:>8}{:>14}{:>14}{:>14}{:>14}\n",
        calibration.title, "", "", "50 % hold", "90 % hold", "ranks even, p", "contraction"
    );
    for (parameter, one) in calibration
        .parameters
        .iter()
        .zip(&trial.recovery.parameters)
    {
        let _ = writeln!(
            text,
            "{:24}{:>8}{:>13.1}%{:>13.1}%{:>14.3}{:>14.2}",
            parameter.name,
            if one.passes() { "pass" } else { "FAIL" },
            100.0 * one.coverage(0.5),
            100.0 * one.coverage(0.9),
            one.evenness(),
            one.contraction
        );
    }
    let Trial {
        recovery,
        failed,
        runs,
        seconds,
    } = trial;
    let repetitions = recovery.parameters.first().map_or(0, |one| one.ranks.len());
    let _ = writeln!(
        text,
        "{} ({failed} more failed), {}, {} on one core; \
         smallest effective number {:.0}; {:.1} % would be refuted",
        counted(repetitions, "repetition"),
        counted(*runs, "run"),
        duration(*seconds),
        recovery.effective_number,
        100.0 * recovery.refuted
    );
    text
}
