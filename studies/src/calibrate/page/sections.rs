//! Tables of the page and what they mean.

use crate::calibrate::account::{NINETY, bounds, exact, range, shown};
use crate::calibrate::calibration::Calibration;
use crate::calibrate::identify::{DROPS, profile_interval};
use crate::calibrate::likelihood::RULED_OUT;
use crate::calibrate::outcome::{Answer, Outcome};
use crate::words::{counted, duration};
use gouge_page::table;
use maud::{Markup, html};

/// Most failed runs that are listed.
const LISTED: usize = 50;

fn columns(names: &[&str]) -> Vec<String> {
    names.iter().map(|&name| name.to_owned()).collect()
}

/// What was measured, by whom, and how the best parameters agree.
pub fn targets(calibration: &Calibration, outcome: &Outcome) -> Markup {
    let best: Vec<f64> = outcome.marginals.iter().map(|one| one.best).collect();
    let predictions = outcome.emulators.at(&best);
    let places = 0..calibration.targets.len();
    let row = |place: usize| {
        let (target, one) = (&calibration.targets[place], outcome.measured[place]);
        let [low, high] = outcome.attained[place];
        let prediction = predictions[place];
        vec![
            format!("{}", place + 1),
            calibration.target_name(target),
            format!("{} ± {}", exact(one.value), exact(one.deviation)),
            shown(prediction.mean),
            format!("{:.2}", one.residual(prediction)),
            range(low, high),
            shown(prediction.scatter.sqrt()),
            shown(prediction.variance.sqrt()),
            target.source.clone(),
            (if target.is_verified { "yes" } else { "no" }).to_owned(),
        ]
    };
    let rows: Vec<Vec<String>> = places.map(row).collect();
    let names = [
        "",
        "quantity",
        "measured",
        "best",
        "residual",
        "attained in the ranges",
        "scatter of packings",
        "error of the emulator",
        "source",
        "checked against its source",
    ];
    html! {
        (table("Measurements with their standard deviations, and the model where it agrees best. The residual is in standard deviations of the measurement, the scatter of packings and the error of the emulator together.", &columns(&names), &rows))
    }
}

/// Runs at points of the posterior.
pub fn predictive(calibration: &Calibration, outcome: &Outcome) -> Markup {
    let results = &outcome.predictive;
    let mut rows = Vec::new();
    for run in &results.runs {
        let test = &calibration.tests[run.test];
        let point = &results.points[run.point];
        for (k, observed) in test.observed.iter().enumerate() {
            let is_meant = |target: &&_| {
                let target: &super::super::calibration::Target = target;
                (target.test, target.quantity) == (run.test, k)
            };
            let target = calibration
                .targets
                .iter()
                .position(|target| is_meant(&target));
            let expected = target.map(|place| outcome.emulators.0[place].at(point));
            let value = run.outcome.as_ref().map(|values| values[k]);
            let residual = match (&value, expected) {
                (Ok(value), Some(one)) => {
                    let deviation = (one.variance + one.scatter).sqrt();
                    format!("{:.2}", (value - one.mean) / deviation)
                }
                _ => String::new(),
            };
            rows.push(vec![
                test.name.clone(),
                format!("{}", run.point + 1),
                run.seed.map_or_else(String::new, |seed| seed.to_string()),
                observed.observation.name(),
                value.map_or_else(|cause| cause.clone(), shown),
                expected.map_or_else(|| "no target".to_owned(), |one| shown(one.mean)),
                residual,
            ]);
        }
    }
    let names = [
        "test",
        "point",
        "seed",
        "quantity",
        "run",
        "emulator",
        "difference",
    ];
    html! {
        p { "The scenes were run at points of the posterior, to see whether the emulators are right where it matters. The difference is in standard deviations of a single run." }
        (table("Runs at points of the posterior.", &columns(&names), &rows))
    }
}

/// What is known of each parameter.
pub fn parameters(calibration: &Calibration, outcome: &Outcome) -> Markup {
    if matches!(outcome.answer, Answer::Refuted(_) | Answer::Unresolved) {
        return html! { p { "There are no parameters to report. The figures show where the model comes closest." } };
    }
    let pairs = calibration.parameters.iter().zip(&outcome.marginals);
    let rows: Vec<Vec<String>> = pairs
        .map(|(parameter, one)| {
            let value = |place: f64| parameter.value(place);
            let [middle, low, high, lowest, highest] = one.quantiles.map(value);
            let profile = match profile_interval(&one.profile, DROPS[0]) {
                [Some(low), Some(high)] => range(value(low), value(high)),
                [Some(low), None] => format!("above {}", shown(value(low))),
                [None, Some(high)] => format!("below {}", shown(value(high))),
                [None, None] => "none".to_owned(),
            };
            let [first, last] = parameter.range;
            vec![
                parameter.name_with_unit(),
                range(first, last),
                shown(value(one.best)),
                shown(middle),
                range(low, high),
                range(lowest, highest),
                profile,
                format!("{:.2}{}", one.contraction, bounds(parameter, one)),
            ]
        })
        .collect();
    let names = [
        "parameter",
        "range",
        "most likely",
        "median",
        "68 %",
        "90 %",
        "68 % by the profile",
        "contraction",
    ];
    html! {
        (table("Intervals are central ones of the posterior. Contraction is its standard deviation over that of the range. A parameter is bounded on a side if the profile of the log-likelihood falls by 1.92 towards that end of the range.", &columns(&names), &rows))
    }
}

/// The principal combinations.
pub fn combinations(calibration: &Calibration, outcome: &Outcome) -> Markup {
    let row = |one: &crate::calibrate::identify::Combination| {
        vec![
            one.text(&calibration.parameters),
            format!("{:.2}", one.contraction),
            (if one.is_determined() { "yes" } else { "no" }).to_owned(),
        ]
    };
    let rows: Vec<Vec<String>> = outcome.combinations.iter().map(row).collect();
    html! {
        (table("Principal directions of the Fisher matrix in the logarithms of the parameters (in the parameters themselves where their scale is linear), averaged over the posterior. One is determined if less than half of the standard deviation of its range remains.", &columns(&["combination", "contraction", "determined"]), &rows))
    }
}

/// How good the emulators are.
pub fn emulators(calibration: &Calibration, outcome: &Outcome) -> Markup {
    let pairs = calibration.targets.iter().zip(&outcome.emulators.0);
    let rows: Vec<Vec<String>> = pairs
        .map(|(target, emulator)| {
            let left_out = emulator.leave_one_out();
            let inside = left_out
                .iter()
                .filter(|one| one.standardised.abs() < NINETY);
            let squares = left_out.iter().map(|one| one.standardised.powi(2));
            let mean = squares.sum::<f64>() / left_out.len() as f64;
            let lengths = emulator.lengths().iter().map(|&length| shown(length));
            vec![
                calibration.target_name(target),
                format!("{} of {}", inside.count(), left_out.len()),
                format!("{:.2}", mean.sqrt()),
                lengths.collect::<Vec<_>>().join(", "),
            ]
        })
        .collect();
    let names = [
        "quantity",
        "points inside their 90 % intervals",
        "root mean square of the residuals",
        "correlation lengths, in ranges",
    ];
    html! {
        p { "Each point was left out in turn, and expected from all others. If the emulator is right, nine in ten points are inside their 90 % intervals, the root mean square is near 1, and the residuals show no pattern." }
        (table("Points left out.", &columns(&names), &rows))
    }
}

/// Waves, failures and cost.
pub fn runs(calibration: &Calibration, outcome: &Outcome) -> Markup {
    let results = &outcome.results;
    let failed: Vec<usize> = (0..results.points.len())
        .filter(|&point| results.has_failed_at(point))
        .collect();
    let waves: Vec<Vec<String>> = outcome
        .waves
        .iter()
        .enumerate()
        .map(|(place, wave)| {
            vec![
                format!("{}", place + 1),
                wave.points.to_string(),
                format!("{:.3} %", 100.0 * wave.share),
                format!("{:.2}", wave.smallest),
            ]
        })
        .collect();
    let names = [
        "wave",
        "points",
        "plausible after it",
        "smallest implausibility",
    ];
    let seconds = results.seconds() + outcome.predictive.seconds();
    html! {
        p { (counted(results.runs.len(), "run")) " for the emulators and " (outcome.predictive.runs.len()) " at points of the posterior took " (duration(seconds)) " on one core." }
        (table(&format!("A point is plausible if no target is more than {RULED_OUT} standard deviations away."), &columns(&names), &waves))
        @if failed.is_empty() {
            p { "No run failed." }
        } @else {
            p {
                "At " (failed.len()) " of " (results.points.len()) " points ("
                (format!("{:.0} %", 100.0 * failed.len() as f64 / results.points.len() as f64))
                ") a run failed. The emulators know nothing of these runs. "
                (format!("{:.1} %", 100.0 * outcome.failed_range()))
                " of the ranges and "
                (format!("{:.1} %", 100.0 * outcome.failed_share()))
                " of the posterior are closer to such a point than to any other: there nothing was measured, and all values are about as likely as before."
            }
            (failures(calibration, outcome))
        }
    }
}

fn failures(calibration: &Calibration, outcome: &Outcome) -> Markup {
    let mut names = columns(&["test"]);
    names.extend(calibration.parameters.iter().map(|one| one.name.clone()));
    names.extend(columns(&["seed", "cause"]));
    let row = |run: &crate::calibrate::results::Finished| {
        let point = &outcome.results.points[run.point];
        let values = calibration.parameters.iter().zip(point);
        let values = values.map(|(parameter, &place)| shown(parameter.value(place)));
        let mut row = vec![calibration.tests[run.test].name.clone()];
        row.extend(values);
        row.push(run.seed.map_or_else(String::new, |seed| seed.to_string()));
        row.push(run.outcome.clone().err().unwrap_or_default());
        row
    };
    let all = outcome.results.failed().count();
    let rows: Vec<Vec<String>> = outcome.results.failed().take(LISTED).map(row).collect();
    let caption = match all > rows.len() {
        true => format!("The first {LISTED} of {all} failed runs; runs.csv has all."),
        false => "Failed runs.".to_owned(),
    };
    table(&caption, &names, &rows)
}

/// What the numbers are.
pub fn method() -> Markup {
    html! {
        p { "Before the measurements, all values in the ranges are equally likely, in the logarithm of a parameter with a logarithmic scale. Measurements are independent and normal. The variance of the difference between a measurement and the model is that of the measurement, plus the scatter of packings over the number of specimens, plus the error of the emulator." }
        p { "Emulators are Gaussian processes with a Matérn covariance; the scatter between seeds is a term of its own. The posterior is sampled on fixed points, of which " code { "posterior.csv" } " has all with their weights. An error of the model itself is not among the terms: where it exists, intervals are too narrow, and residuals and the predictive check are the place to see it." }
    }
}
