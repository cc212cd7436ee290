//! Claims about energy.

use crate::statistics::{Mean, slope};
use crate::study::claim::{Finding, Rule, Verdict};
use crate::study::results::Run;
use crate::study::sample::Sample;
use crate::study::thesis::printed::LAWS;

/// Drift that the thesis calls acceptable, in J/s.
const DRIFT: f64 = 200.0;
/// Residual of a corrected run, as a part of the work of the drive.
const RESIDUAL: f64 = 1e-3;

pub(super) static RULES: [Rule; 2] = [
    Rule {
        statement: "The drift of the energy is at most 200 J/s in most cases.",
        rule: "Computed as in the thesis: in more than half of the runs of full size. Corrected: in every run the residual is below 0.1 % of the work of the drive.",
        test: drift,
    },
    Rule {
        statement: "Heat grows more slowly than in proportion to the pressure.",
        rule: "For each law, the upper end of the 95 % interval over seeds of the exponent of heat over pressure, from 0.05 to 0.6, is below 1.",
        test: exponent,
    },
];

fn drift(sample: &Sample) -> Option<Finding> {
    let numbers = |run: &Run| {
        Some([
            run.number("residual_last")?,
            run.number("driving_last")?,
            run.number("time")?,
        ])
    };
    let rows: Vec<[f64; 3]> = sample.runs().filter_map(numbers).collect();
    if rows.is_empty() || !sample.is_arm() {
        return None;
    }
    let count =
        |is_counted: &dyn Fn(&[f64; 3]) -> bool| rows.iter().filter(|row| is_counted(row)).count();
    if sample.part.starts_with("thesis") {
        let within = count(&|[residual, _, time]| (residual / time).abs() <= DRIFT);
        let mut drifts: Vec<f64> = rows
            .iter()
            .map(|[residual, _, time]| (residual / time).abs())
            .collect();
        drifts.sort_by(f64::total_cmp);
        let said = format!(
            "At most 200 J/s in {within} of {} runs; median {:.0} J/s, largest {:.0} J/s.",
            rows.len(),
            drifts[rows.len() / 2],
            drifts[rows.len() - 1]
        );
        let is_most = 2 * within > rows.len();
        return Some(Finding::new(
            Verdict::of(is_most, !is_most && sample.is_full()),
            said,
        ));
    }
    let within = count(&|[residual, work, _]| residual.abs() < RESIDUAL * work.abs());
    let parts = rows
        .iter()
        .map(|[residual, work, _]| (residual / work).abs());
    let largest = parts.fold(0.0, f64::max);
    let said = format!(
        "Below 0.1 % of the work in {within} of {} runs; largest {:.2} %.",
        rows.len(),
        100.0 * largest
    );
    let is_all = within == rows.len();
    Some(Finding::new(Verdict::of(is_all, !is_all), said))
}

fn exponent(sample: &Sample) -> Option<Finding> {
    let pressures = sample.middle();
    let (mut is_met, mut is_opposed, mut said) = (true, false, Vec::new());
    for law in LAWS {
        let of_seed = |seed: &&str| -> Option<f64> {
            let point = |&p: &f64| {
                let heat = *sample.by_seed(law, p, "heat").get(seed)?;
                (heat > 0.0).then(|| [p.ln(), heat.ln()])
            };
            let points: Option<Vec<[f64; 2]>> = pressures.iter().map(point).collect();
            points.map(|points| slope(&points))
        };
        let exponents: Vec<f64> = sample.seeds().iter().filter_map(of_seed).collect();
        let mean = Mean::of(&exponents).filter(|mean| mean.number > 1 && pressures.len() > 2)?;
        let [low, high] = mean.interval(0.95);
        is_met &= high < 1.0;
        is_opposed |= low > 1.0;
        said.push(format!("{law} {:.2} [{low:.2}, {high:.2}]", mean.mean));
    }
    let said = format!("Exponents: {}.", said.join(", "));
    Some(Finding::new(Verdict::of(is_met, is_opposed), said))
}
