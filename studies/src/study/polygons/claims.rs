//! The claims of the paper, with rules that were fixed before the runs.

use super::SHAPES;
use super::printed::{ALL, FIT_TOLERANCE, FITTED, Printed, fitted_stress_ratio};
use super::shapes::name;
use crate::statistics::Mean;
use crate::study::claim::{Finding, Rule, Verdict};
use crate::study::results::Run;
use crate::study::sample::Sample;

pub(super) static RULES: [Rule; 12] = [
    Rule {
        statement: "The printed values are reproduced.",
        rule: "At least 80 % of the rows with a tolerance are met; refuted if fewer than 60 % are.",
        test: printed_values,
    },
    Rule {
        statement: "Angular shapes are stronger than discs.",
        rule: "q/p, mean of 3 to 6 sides, exceeds that of discs by 0.10 to 0.22; refuted if it does not exceed it by two standard errors.",
        test: stronger,
    },
    Rule {
        statement: "Angular shapes are less dense than discs.",
        rule: "The solid fraction of discs exceeds the mean of 3 to 6 sides by 0.015 to 0.045; refuted if it does not exceed it by two standard errors.",
        test: looser,
    },
    Rule {
        statement: "There is no jump between discs and 60 sides.",
        rule: "q/p differs by less than 0.05 and the solid fraction by less than 0.012.",
        test: no_jump,
    },
    Rule {
        statement: "The share of connected bodies is least near angularity 1 and grows again.",
        rule: "The least share is that of 4 to 8 sides, it lies within 0.70 +- 0.06, and triangles are above squares.",
        test: least_connected,
    },
    Rule {
        statement: "The coordination number is least at intermediate angularity.",
        rule: "The least number is that of neither discs nor triangles and lies in 2.85 to 3.35, and triangles are above discs.",
        test: least_coordination,
    },
    Rule {
        statement: "Branch vectors are isotropic.",
        rule: "abs(a_ln) and abs(a_lt) are below 0.05 for all shapes; refuted if one exceeds 0.1.",
        test: isotropic_branches,
    },
    Rule {
        statement: "Half the sum of the anisotropies is the stress ratio (azema 8).",
        rule: "The difference is below 0.04 for all shapes; refuted if one exceeds 0.08.",
        test: half_sums,
    },
    Rule {
        statement: "Samples shear homogeneously (figure 3).",
        rule: "Away from the walls the mean velocity differs from a linear profile by less than 0.1 of the velocity of the wall for all shapes; refuted if one exceeds 0.2.",
        test: homogeneous,
    },
    Rule {
        statement: "The stresses of side-vertex and side-side contacts add up.",
        rule: "q_sv + q_ss = q within 1e-12 p in every run.",
        test: parts_add_up,
    },
    Rule {
        statement: "Contacts of two vertices are rare (figure 2).",
        rule: "For all shapes their share is below 0.01; refuted if one exceeds 0.03.",
        test: vertices,
    },
    Rule {
        statement: "Overlaps never exceed one hundredth of the diameter.",
        rule: "In at most 0.1 % of the steps of every shape the largest overlap exceeds 0.010 mean diameters; refuted if it does in more than 1 %.",
        test: overlaps,
    },
];

/// A number of the runs of a shape, by sample.
pub(super) fn values(sample: &Sample, sides: u32, column: &str) -> Vec<f64> {
    let name = name(sides);
    let runs = sample.runs().filter(|run| run.text("shape") == name);
    runs.filter_map(|run: &Run| run.number(column)).collect()
}

/// The mean of a number over the samples of a shape.
pub(super) fn mean(sample: &Sample, sides: u32, column: &str) -> Option<Mean> {
    Mean::of(&values(sample, sides, column))
}

/// The mean over some shapes, with the standard error of their mean.
pub(super) fn over(sample: &Sample, sides: &[u32], column: &str) -> Option<[f64; 2]> {
    let means: Option<Vec<Mean>> = sides.iter().map(|&one| mean(sample, one, column)).collect();
    let means = means?;
    let number = means.len() as f64;
    let sum: f64 = means.iter().map(|one| one.mean).sum();
    let variance: f64 = means.iter().map(|one| one.error().powi(2)).sum();
    Some([sum / number, variance.sqrt() / number])
}

fn is_shapes(sample: &Sample) -> Option<()> {
    (sample.part == SHAPES).then_some(())
}

/// A printed value with the measured mean and its standard error.
pub(super) struct Compared {
    pub item: String,
    pub printed: [f64; 2],
    pub measured: [f64; 2],
}

impl Compared {
    /// Whether the mean is within the tolerance.
    pub fn is_met(&self) -> bool {
        (self.measured[0] - self.printed[0]).abs() <= self.printed[1]
    }
}

/// All printed values with what was measured; none if a shape was not run.
pub(super) fn compared(sample: &Sample) -> Option<Vec<Compared>> {
    is_shapes(sample)?;
    let of = |printed: &Printed| {
        let shapes: Vec<String> = printed.sides.iter().map(|&sides| name(sides)).collect();
        let item = match printed.sides {
            [sides] if *sides > 0 => format!("{}, {}", printed.item, shapes.join(", ")),
            _ => printed.item.to_owned(),
        };
        Some(Compared {
            item,
            printed: printed.value,
            measured: over(sample, printed.sides, printed.column)?,
        })
    };
    let fitted = |&sides: &u32| {
        Some(Compared {
            item: format!("figure 5: q/p, fit of (6), {}", name(sides)),
            printed: [fitted_stress_ratio(sides), FIT_TOLERANCE],
            measured: over(sample, &[sides], "stress_ratio")?,
        })
    };
    ALL.iter()
        .map(of)
        .chain(FITTED.iter().map(fitted))
        .collect()
}

fn printed_values(sample: &Sample) -> Option<Finding> {
    let all = compared(sample)?;
    let missed: Vec<&Compared> = all.iter().filter(|one| !one.is_met()).collect();
    let met = all.len() - missed.len();
    let share = met as f64 / all.len() as f64;
    let list = missed.iter().map(|one| {
        let ([value, tolerance], [mean, error]) = (one.printed, one.measured);
        format!(
            "{}: {mean:.3} +- {error:.3} for {value:.3} +- {tolerance}",
            one.item
        )
    });
    let list: Vec<String> = list.collect();
    let numbers = format!(
        "{met} of {} rows are met. Missed: {}.",
        all.len(),
        list.join("; ")
    );
    Some(Finding::new(
        Verdict::of(share >= 0.8, share < 0.6),
        numbers,
    ))
}

/// The shapes that the paper calls angular.
const ANGULAR: [u32; 4] = [3, 4, 5, 6];

/// Whether a difference lies in a range, or is not even positive.
fn judged([one, other]: [[f64; 2]; 2], range: [f64; 2], what: &str) -> Finding {
    let difference = one[0] - other[0];
    let error = one[1].hypot(other[1]);
    let verdict = Verdict::of(
        (range[0]..=range[1]).contains(&difference),
        difference < 2.0 * error,
    );
    Finding::new(verdict, format!("{what}: {difference:.4} +- {error:.4}."))
}

fn stronger(sample: &Sample) -> Option<Finding> {
    is_shapes(sample)?;
    let both = [
        over(sample, &ANGULAR, "stress_ratio")?,
        over(sample, &[0], "stress_ratio")?,
    ];
    Some(judged(both, [0.10, 0.22], "Difference of q/p"))
}

fn looser(sample: &Sample) -> Option<Finding> {
    is_shapes(sample)?;
    let both = [
        over(sample, &[0], "solid_fraction")?,
        over(sample, &ANGULAR, "solid_fraction")?,
    ];
    Some(judged(
        both,
        [0.015, 0.045],
        "Difference of solid fractions",
    ))
}

fn no_jump(sample: &Sample) -> Option<Finding> {
    is_shapes(sample)?;
    let difference = |column| {
        let [disc, many] = [over(sample, &[0], column)?, over(sample, &[60], column)?];
        Some([many[0] - disc[0], many[1].hypot(disc[1])])
    };
    let [q, nu] = [difference("stress_ratio")?, difference("solid_fraction")?];
    let is_met = q[0].abs() < 0.05 && nu[0].abs() < 0.012;
    let is_opposed = q[0].abs() - 2.0 * q[1] > 0.05 || nu[0].abs() - 2.0 * nu[1] > 0.012;
    let numbers = format!(
        "q/p changes by {:.4} +- {:.4}, the solid fraction by {:.4} +- {:.4}.",
        q[0], q[1], nu[0], nu[1]
    );
    Some(Finding::new(Verdict::of(is_met, is_opposed), numbers))
}

/// A number of every shape that was run.
fn all_shapes(sample: &Sample, column: &str) -> Option<Vec<(u32, f64)>> {
    is_shapes(sample)?;
    let of = |&sides: &u32| Some((sides, mean(sample, sides, column)?.mean));
    super::shapes::SIDES.iter().map(of).collect()
}

fn number_of(all: &[(u32, f64)], sides: u32) -> f64 {
    let found = all.iter().find(|(one, _)| *one == sides);
    found.map_or(f64::NAN, |(_, number)| *number)
}

fn least(all: &[(u32, f64)]) -> Option<(u32, f64)> {
    all.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1))
}

fn least_connected(sample: &Sample) -> Option<Finding> {
    let all = all_shapes(sample, "connected")?;
    let (sides, share) = least(&all)?;
    let [three, four] = [3, 4].map(|sides| number_of(&all, sides));
    let is_met = (4..=8).contains(&sides) && (0.64..=0.76).contains(&share) && three > four;
    let numbers = format!(
        "Least for {}: {share:.3}; triangles {three:.3}, squares {four:.3}.",
        name(sides)
    );
    Some(Finding::new(Verdict::of(is_met, three < four), numbers))
}

fn least_coordination(sample: &Sample) -> Option<Finding> {
    let all = all_shapes(sample, "coordination")?;
    let (sides, number) = least(&all)?;
    let [disc, three] = [0, 3].map(|sides| number_of(&all, sides));
    let is_met = ![0, 3].contains(&sides) && (2.85..=3.35).contains(&number) && three > disc;
    let numbers = format!(
        "Least for {}: {number:.3}; discs {disc:.3}, triangles {three:.3}.",
        name(sides)
    );
    Some(Finding::new(Verdict::of(is_met, three < disc), numbers))
}

/// The largest magnitude over all shapes, and whose it is.
fn largest(all: &[(u32, f64)]) -> Option<(u32, f64)> {
    let magnitudes = all.iter().map(|&(sides, number)| (sides, number.abs()));
    magnitudes.max_by(|a, b| a.1.total_cmp(&b.1))
}

fn isotropic_branches(sample: &Sample) -> Option<Finding> {
    let normal = largest(&all_shapes(sample, "a_ln")?)?;
    let tangential = largest(&all_shapes(sample, "a_lt")?)?;
    let most = normal.1.max(tangential.1);
    let numbers = format!(
        "Largest a_ln {:.3} ({}), a_lt {:.3} ({}).",
        normal.1,
        name(normal.0),
        tangential.1,
        name(tangential.0)
    );
    Some(Finding::new(Verdict::of(most < 0.05, most > 0.1), numbers))
}

fn half_sums(sample: &Sample) -> Option<Finding> {
    let sums = all_shapes(sample, "half_sum")?;
    let ratios = all_shapes(sample, "stress_ratio")?;
    let differences = sums.iter().zip(&ratios);
    let differences: Vec<(u32, f64)> = differences.map(|(a, b)| (a.0, a.1 - b.1)).collect();
    let (sides, most) = largest(&differences)?;
    let numbers = format!("Largest difference {most:.3}, for {}.", name(sides));
    Some(Finding::new(Verdict::of(most < 0.04, most > 0.08), numbers))
}

fn homogeneous(sample: &Sample) -> Option<Finding> {
    let (sides, most) = largest(&all_shapes(sample, "profile_deviation")?)?;
    let numbers = format!("Largest difference {most:.3}, for {}.", name(sides));
    Some(Finding::new(Verdict::of(most < 0.1, most > 0.2), numbers))
}

fn parts_add_up(sample: &Sample) -> Option<Finding> {
    is_shapes(sample)?;
    let error = |run: &Run| {
        let [all, sv, ss] =
            ["stress_ratio", "stress_ratio_sv", "stress_ratio_ss"].map(|column| run.number(column));
        Some((all? - sv? - ss?).abs())
    };
    let errors: Option<Vec<f64>> = sample.runs().map(error).collect();
    let most = errors?.into_iter().fold(0.0, f64::max);
    let numbers = format!("Largest difference {most:.1e}.");
    Some(Finding::new(
        Verdict::of(most < 1e-12, most > 1e-9),
        numbers,
    ))
}

fn vertices(sample: &Sample) -> Option<Finding> {
    let (sides, most) = largest(&all_shapes(sample, "vertex_vertex")?)?;
    let numbers = format!("Largest share {most:.4}, for {}.", name(sides));
    Some(Finding::new(Verdict::of(most < 0.01, most > 0.03), numbers))
}

fn overlaps(sample: &Sample) -> Option<Finding> {
    let shares = all_shapes(sample, "large_overlaps_mean")?;
    let (sides, share) = largest(&shares)?;
    let (deepest, overlap) = largest(&all_shapes(sample, "largest_overlap_maximum")?)?;
    let numbers = format!(
        "Largest share of steps {:.3} % ({}); largest overlap {overlap:.4} mean diameters ({}).",
        100.0 * share,
        name(sides),
        name(deepest)
    );
    Some(Finding::new(
        Verdict::of(share <= 1e-3, share > 1e-2),
        numbers,
    ))
}
