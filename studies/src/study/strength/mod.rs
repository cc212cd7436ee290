//! An open question of the thesis: which strength factors give a wanted distribution of strengths, and does it matter?

pub mod densities;

use super::change::Change;
use super::claim::{Finding, Rule};
use super::curves::Curves;
use super::friction_curves::FRICTION;
use super::illustration::each;
use super::results::{Results, Run};
use super::sample::Sample;
use super::{Part, Scale, Study};
use gouge_page::{Axis, Curve, Figure};
use maud::{Markup, html};

/// The study.
pub static STUDY: Study = Study {
    name: "strength",
    title: "Which distribution of bond strengths, and does it matter?",
    introduction,
    parts,
    order: &[PART],
    rules: || RULES.iter().collect(),
    curves: FRICTION,
    illustrations: |results, curves| each(figures(results, curves)),
    tables: |_| Vec::new(),
    pictures: &[],
};

const PART: &str = "strength";
/// The axis of distributions.
const AXIS: &str = "distribution";
/// The distribution with which the others are compared, and the others.
const BASE: &str = "factors of the thesis";
const OTHERS: [&str; 3] = ["one strength", "Weibull 5", "Weibull 2"];
/// Change of friction below which a distribution counts as immaterial.
const IMMATERIAL: f64 = 0.05;
/// Change of the number of broken bonds, as a part of it, that counts as large.
const LARGE: f64 = 0.1;

static RULES: [Rule; 2] = [
    Rule {
        statement: "The distribution of strengths does not change the coefficient of friction.",
        rule: "For each distribution of the same mean, the 90 % interval of the change, averaged over laws and pressures of each seed, lies within 0.05 of zero.",
        test: friction,
    },
    Rule {
        statement: "It does not change the number of broken bonds.",
        rule: "The 90 % interval of the change of the logarithm of that number lies within 0.1 of zero.",
        test: broken,
    },
];

fn parts(scale: Scale) -> Vec<Part> {
    let seeds = match scale {
        Scale::Small => "0..6",
        Scale::Full => "0..16",
    };
    vec![Part::new(PART, include_str!("strength.toml"), seeds)]
}

fn introduction() -> Markup {
    html! {
        p {
            "The thesis asks which distribution of the strength factor s reproduces any given distribution of strengths exactly. "
            "A bond that is pulled breaks at Q = π σ (s min{r_i, r_j})². "
            "Factors that do not depend on the radii can only widen the distribution of the radii, so that most distributions are out of reach. "
            "With s = √(F⁻¹(U) / (π σ)) / min{r_i, r_j}, U uniform, every bond has the distribution F exactly, independently of all others, in any packing: "
            "the radii cancel. "
            "The key strength of the bonding of a set-up does this, and docs/bond-strength.md has the proof. "
            "This study asks what the distribution does to a sheared fault: four of the same mean, on the same packings."
        }
    }
}

fn changes(sample: Sample, of: fn(&Run) -> Option<f64>) -> Option<Vec<Change<'static>>> {
    let change = |other| Change::of(sample, AXIS, [BASE, other], of);
    OTHERS.into_iter().map(change).collect()
}

fn friction(sample: &Sample) -> Option<Finding> {
    let changes = changes(*sample, |run| run.number("friction"))?;
    Some(Change::judged(&changes, IMMATERIAL, |_| String::new()))
}

fn broken(sample: &Sample) -> Option<Finding> {
    let changes = changes(*sample, |run| {
        let number = run.number("bonds-broken")?;
        (number > 0.0).then(|| number.ln())
    })?;
    Some(Change::judged(&changes, LARGE, |_| String::new()))
}

fn figures(results: &Results, _: &Curves) -> Vec<Figure> {
    let sample = Sample {
        results,
        part: PART,
    };
    let curve = |distribution: &&str| {
        sample.over_pressure(distribution, "friction", |run| {
            run.law() == "CS" && run.text(AXIS) == *distribution
        })
    };
    let curves: Vec<Curve> = [BASE].iter().chain(&OTHERS).map(curve).collect();
    let is_empty = curves.iter().all(|curve| curve.points.is_empty());
    let figure = Figure::new(
        "Friction over pressure for four distributions of bond strengths, law CS, 95 % intervals over seeds.",
        Axis::logarithmic("pressure over normal strength", ""),
        Axis::linear("coefficient of friction", ""),
        curves,
    );
    let densities = [densities::figure()].into_iter();
    densities.chain((!is_empty).then_some(figure)).collect()
}
