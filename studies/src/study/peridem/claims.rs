//! The claims of the paper, with rules; those on the edge that is hit and on times were written after first runs.

use super::square::{pieces, printed_pieces, times};
use super::{CROSSES, CROSSES_FINE, KALTHOFF};
use crate::study::claim::{Finding, Rule, Verdict};
use crate::study::results::Run;
use crate::study::sample::Sample;

pub(super) static RULES: [Rule; 11] = [
    Rule {
        statement: "The cracks of the notched plate run at about 68 degrees from the notches (figure 4b).",
        rule: "Every angle on grids of at most 1 mm lies within 56 to 70 degrees.",
        test: angle,
    },
    Rule {
        statement: "Both cracks run at the same angle.",
        rule: "The two angles differ by less than 1 degree on every grid.",
        test: symmetry,
    },
    Rule {
        statement: "The cracks cross the plate.",
        rule: "They are longer than 40 mm after 80 us on every grid.",
        test: length,
    },
    Rule {
        statement: "The cracks start at the notches, not where the impactor hits (figure 4b).",
        rule: "No node within 24.5 mm of the middle of the edge that is hit loses more than 35 % of its bonds, on every grid.",
        test: impact,
    },
    Rule {
        statement: "Bonds break at abs(s) > s0, also when they are compressed (section 3.1).",
        rule: "With this rule, the cracks are longer than 40 mm after 80 us, too.",
        test: two_sided,
    },
    Rule {
        statement: "Nodes without a bond repel each other, also across the notches (section 4.4).",
        rule: "With self contact, the angles lie within 56 to 70 degrees, too.",
        test: self_contact,
    },
    Rule {
        statement: "The damaged zone vanishes with the horizon (figure 8a).",
        rule: "With one contact stiffness for all horizons, the area for 15 h exceeds three times that for 4 h, after 400 ns and after 1 us.",
        test: horizon,
    },
    Rule {
        statement: "The damaged zone converges with the spacing of nodes (figure 8b).",
        rule: "From R/40 to R/50 the area after 1 us changes by less than 15 %.",
        test: spacing,
    },
    Rule {
        statement: "The notched square breaks into two pieces for 135 J/m^2 and into three for 13.5 J/m^2 (figure 9).",
        rule: "With the sizes of the public script it does so within 70 us on most meshes.",
        test: pieces,
    },
    Rule {
        statement: "It does so by 50 us for 135 J/m^2 and by 40 us for 13.5 J/m^2 (figure 9).",
        rule: "On every mesh the last piece separates within 1.5 times these times.",
        test: times,
    },
    Rule {
        statement: "It does so with the printed sizes, a square of 1 mm.",
        rule: "Two pieces for 135 J/m^2, and three for 13.5 J/m^2, within 50 us.",
        test: printed_pieces,
    },
];

/// Angle in degrees of the left or the right crack from the direction of the vertical notches, positive away from the other
/// one.
pub(super) fn from_notch(run: &Run, crack: usize) -> Option<f64> {
    let angle = run.number(&format!("crack_angle_{crack}_last"))?;
    let turned = angle.to_degrees() - 90.0;
    let outward = if crack == 0 { turned } else { -turned };
    Some((outward + 180.0).rem_euclid(360.0) - 180.0)
}

/// Runs of the plate with a rule of breaking and with or without self contact.
pub(super) fn plates<'a>(
    sample: &Sample<'a>,
    breaking: &'static str,
    self_contact: &'static str,
) -> Vec<&'a Run> {
    if sample.part != KALTHOFF {
        return Vec::new();
    }
    let is_meant =
        |run: &&Run| run.text("breaking") == breaking && run.text("self contact") == self_contact;
    sample.runs().filter(is_meant).collect()
}

/// A finding about the numbers of some runs, with their labels; none without runs.
fn judged(
    runs: &[&Run],
    label: &str,
    number: impl Fn(&Run) -> Option<f64>,
    unit: &str,
    is_met: impl Fn(f64) -> bool,
    otherwise: Verdict,
) -> Option<Finding> {
    let numbers: Option<Vec<(String, f64)>> = runs
        .iter()
        .map(|run| Some((run.text(label).to_owned(), number(run)?)))
        .collect();
    let numbers = numbers.filter(|numbers| !numbers.is_empty())?;
    let holds = numbers.iter().all(|(_, number)| is_met(*number));
    let said: Vec<String> = numbers
        .iter()
        .map(|(name, number)| format!("{name}: {number:.1}{unit}"))
        .collect();
    let verdict = if holds { Verdict::Holds } else { otherwise };
    Some(Finding::new(verdict, said.join("; ") + "."))
}

fn angle(sample: &Sample) -> Option<Finding> {
    let runs = plates(sample, "tension only", "off");
    let mean = |run: &Run| Some(0.5 * (from_notch(run, 0)? + from_notch(run, 1)?));
    let is_met = |angle| (56.0..=70.0).contains(&angle);
    judged(&runs, "grid", mean, " degrees", is_met, Verdict::Refuted)
}

fn symmetry(sample: &Sample) -> Option<Finding> {
    let runs = plates(sample, "tension only", "off");
    let apart = |run: &Run| Some((from_notch(run, 0)? - from_notch(run, 1)?).abs());
    judged(
        &runs,
        "grid",
        apart,
        " degrees",
        |d| d < 1.0,
        Verdict::Refuted,
    )
}

fn length_of(run: &Run) -> Option<f64> {
    Some(1e3 * run.number("length_at_80_us")?)
}

fn length(sample: &Sample) -> Option<Finding> {
    let runs = plates(sample, "tension only", "off");
    judged(
        &runs,
        "grid",
        length_of,
        " mm",
        |d| d > 40.0,
        Verdict::Refuted,
    )
}

fn impact(sample: &Sample) -> Option<Finding> {
    let runs = plates(sample, "tension only", "off");
    // Without a damaged node there is no distance.
    let reach = |run: &Run| Some(run.number("broken_at_impact").unwrap_or(0.0));
    let unit = " mm of the edge damaged";
    judged(&runs, "grid", reach, unit, |d| d == 0.0, Verdict::Refuted)
}

fn two_sided(sample: &Sample) -> Option<Finding> {
    let runs = plates(sample, "two-sided", "off");
    // Without a damaged node there is no crack.
    let length = |run: &Run| Some(length_of(run).unwrap_or(0.0));
    judged(
        &runs,
        "grid",
        length,
        " mm",
        |d| d > 40.0,
        Verdict::NotAsPrinted,
    )
}

fn self_contact(sample: &Sample) -> Option<Finding> {
    let runs = plates(sample, "tension only", "on");
    let mean = |run: &Run| Some(0.5 * (from_notch(run, 0)? + from_notch(run, 1)?));
    let is_met = |angle| (56.0..=70.0).contains(&angle);
    judged(
        &runs,
        "grid",
        mean,
        " degrees",
        is_met,
        Verdict::NotAsPrinted,
    )
}

/// A number of the run with a label on an axis.
fn labelled(sample: &Sample, axis: &str, label: &str, column: &str) -> Option<f64> {
    sample
        .runs()
        .find(|run| run.text(axis) == label)?
        .number(column)
}

fn horizon(sample: &Sample) -> Option<Finding> {
    if sample.part != CROSSES {
        return None;
    }
    let area = |label, column| labelled(sample, "horizon", label, column);
    let ratio = |column| Some(area("15 h", column)? / area("4 h", column)?);
    let [early, late] = [ratio("area_at_400_ns")?, ratio("area_at_1_us")?];
    let numbers = format!("15 h over 4 h: {early:.1} after 400 ns, {late:.1} after 1 us.");
    let holds = early > 3.0 && late > 3.0;
    Some(Finding::new(Verdict::of(holds, early < 1.0), numbers))
}

fn spacing(sample: &Sample) -> Option<Finding> {
    if sample.part != CROSSES_FINE {
        return None;
    }
    let area = |label| labelled(sample, "spacing", label, "area_at_1_us");
    let [coarse, middle, fine] = [area("R/30")?, area("R/40")?, area("R/50")?];
    let change = fine / middle - 1.0;
    let numbers = format!(
        "{coarse:.4}, {middle:.4}, {fine:.4} mm² for R/30, R/40, R/50: the last changes by {:.0} %.",
        100.0 * change
    );
    let is_met = change.abs() < 0.15;
    Some(Finding::new(Verdict::of(is_met, !is_met), numbers))
}
