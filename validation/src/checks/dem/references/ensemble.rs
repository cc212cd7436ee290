//! Averages over many runs of chaotic motion, compared by equivalence tests.
//!
//! Both programs start from the same states. For each observable the differences d between the runs
//! have a mean and a standard error s. Two one-sided t tests at level a reject a difference of the
//! means beyond the margin M if |mean| + t(1 - a) s < M.

use super::observables::{Course, value};
use crate::checks::{Axis, Curve, Exhibit, Failure, Figure, Measurement, Outcome, Table};
use crate::references::{Case, Control, Observable, RecordedRun, Run};
use crate::scenes::Draft;
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// Values of an observable in all runs, from the engine and from the kernel.
type Pairs = Vec<[f64; 2]>;

/// Tests every observable of a case.
pub(super) fn compare(case: &Case) -> Outcome {
    let courses = courses(case, None)?;
    let mut table =
        table("Differences of the means, kernel minus engine, in units of the engine's mean");
    let mut measured = Vec::new();
    for observable in &case.observables {
        let test = Test::of(
            observable,
            &pairs(case, observable, &courses)?,
            case.tolerance,
        )?;
        measured.push(Measurement::absolute(0.0, test.bound, observable.margin));
        table.push(test.row(observable));
    }
    let mut exhibits = vec![
        Exhibit::Text(case.agreement.clone()),
        Exhibit::Table(table),
        Exhibit::Table(reasons(case)),
    ];
    exhibits.extend(plot(case, &courses)?);
    Ok(Measurement::worst(measured).showing(exhibits))
}

/// Tests that a wrong kernel fails for the stated observables.
pub(super) fn compare_wrong(case: &Case) -> Outcome {
    let control = case.control.as_ref();
    let control = control.ok_or_else(|| Failure::Oracle("the case has no control".to_owned()))?;
    let courses = courses(case, Some(control))?;
    let mut table = table("The same tests with a wrong kernel");
    let mut rejected = Vec::new();
    for observable in &case.observables {
        let test = Test::of(
            observable,
            &pairs(case, observable, &courses)?,
            case.tolerance,
        )?;
        table.push(test.row(observable));
        if test.bound >= observable.margin {
            rejected.push(observable.label());
        }
    }
    if control.rejects.is_empty() {
        return Err(Failure::Oracle("the control rejects nothing".to_owned()));
    }
    let missed = control
        .rejects
        .iter()
        .filter(|label| !rejected.contains(label));
    Ok(Measurement::count(missed.count()).showing([Exhibit::Table(table)]))
}

/// Repeats all runs with the kernel.
fn courses(case: &Case, control: Option<&Control>) -> Result<Vec<Course>, Failure> {
    let runs = case.runs.par_iter().zip(&case.result.runs);
    let course = |(run, recorded): (&Run, &RecordedRun)| {
        let mut text = case.scene(run).map_err(Failure::Oracle)?;
        if let Some(control) = control {
            if !text.contains(&control.replace) {
                return Err(Failure::Oracle("the control replaces nothing".to_owned()));
            }
            text = text.replacen(&control.replace, &control.with, 1);
        }
        let series = recorded.series.as_ref();
        let series =
            series.ok_or_else(|| Failure::Oracle("the result has no series".to_owned()))?;
        Course::beside(&mut Draft::parse(&text).world()?, series)
    };
    runs.map(course).collect()
}

fn pairs(case: &Case, observable: &Observable, courses: &[Course]) -> Result<Pairs, Failure> {
    let runs = case.result.runs.iter().zip(courses);
    let pair = |(recorded, course): (&RecordedRun, &Course)| {
        let engine = recorded
            .series
            .as_ref()
            .map(|series| value(series, observable));
        let engine = engine.unwrap_or_else(|| Err("the result has no series".to_owned()));
        Ok([
            engine.map_err(Failure::Oracle)?,
            value(&course.0, observable).map_err(Failure::Oracle)?,
        ])
    };
    runs.map(pair).collect()
}

/// Result of the tests of one observable; differences are in units of the engine's mean.
struct Test {
    means: [f64; 2],
    difference: f64,
    deviation: f64,
    /// Smallest margin at which both tests would establish equivalence.
    bound: f64,
    /// Probability of establishing equivalence if the means are equal.
    power: f64,
}

impl Test {
    fn of(observable: &Observable, pairs: &Pairs, level: f64) -> Result<Self, Failure> {
        let number = pairs.len() as f64;
        let mean = |value: &dyn Fn(&[f64; 2]) -> f64| pairs.iter().map(value).sum::<f64>() / number;
        let means = [mean(&|pair| pair[0]), mean(&|pair| pair[1])];
        let difference = means[1] - means[0];
        let variance =
            mean(&|pair| (pair[1] - pair[0] - difference).powi(2)) * number / (number - 1.0);
        let student = StudentsT::new(0.0, 1.0, number - 1.0)
            .map_err(|error| Failure::Oracle(error.to_string()))?;
        let scale = means[0].abs();
        let deviation = variance.sqrt() / scale;
        let error = deviation / number.sqrt();
        let quantile = student.inverse_cdf(1.0 - level);
        let slack = observable.margin / error - quantile;
        Ok(Self {
            means,
            difference: difference / scale,
            deviation,
            bound: (difference / scale).abs() + quantile * error,
            power: (2.0 * student.cdf(slack) - 1.0).max(0.0),
        })
    }

    fn row(&self, observable: &Observable) -> Vec<String> {
        vec![
            observable.label(),
            format!("{:.5e}", self.means[0]),
            format!("{:.5e}", self.means[1]),
            format!("{:+.2e}", self.difference),
            format!("{:.2e}", self.deviation),
            format!("{:.2e}", self.bound),
            format!("{:.1e}", observable.margin),
            format!("{:.4}", self.power),
        ]
    }
}

fn table(title: &str) -> Table {
    let columns = [
        "observable",
        "engine",
        "kernel",
        "difference",
        "standard deviation of the differences",
        "bound from both tests",
        "margin",
        "power",
    ];
    Table::new(title, &columns)
}

fn reasons(case: &Case) -> Table {
    let mut table = Table::new(
        "The averages, and the reason for each margin",
        &["observable", "steps", "reason"],
    );
    for observable in &case.observables {
        let [first, last] = observable.steps;
        table.push([
            observable.label(),
            format!("{first} to {last}"),
            observable.reason.clone(),
        ]);
    }
    table
}

/// The first observable over time in the first run.
fn plot(case: &Case, courses: &[Course]) -> Result<Option<Exhibit>, Failure> {
    let first = case.result.runs.first().and_then(|run| run.series.as_ref());
    let (Some(recorded), Some(course), Some(observable)) =
        (first, courses.first(), case.observables.first())
    else {
        return Ok(None);
    };
    let points = |table: &crate::references::Table| {
        let names = ["step", observable.name.as_str()];
        let [step, place] = table.places(names).map_err(Failure::Oracle)?;
        let rows = table.rows.iter();
        Ok::<_, Failure>(rows.map(|row| [row[step], row[place]]).collect::<Vec<_>>())
    };
    Ok(Some(Exhibit::Figure(Figure::new(
        format!("{} in the first run", observable.label()),
        Axis::linear("step", ""),
        Axis::linear(&observable.label(), ""),
        vec![
            Curve::line(&case.result.engine, points(recorded)?),
            Curve::marks("kernel", points(&course.0)?),
        ],
    ))))
}
