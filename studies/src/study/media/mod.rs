//! An open question of the thesis: does water or another medium change friction?

use super::change::Change;
use super::claim::{Finding, Rule};
use super::curves::Curves;
use super::friction_curves::FRICTION;
use super::illustration::each;
use super::results::{Results, Run};
use super::sample::Sample;
use super::{Part, Scale, Study};
use crate::statistics::Mean;
use gouge_page::{Axis, Curve, Figure, Guide};
use maud::{Markup, html};

/// The study.
pub static STUDY: Study = Study {
    name: "media",
    title: "Does water or another medium change the friction of a fault?",
    introduction,
    parts,
    order: &[PART],
    rules: || RULES.iter().collect(),
    curves: FRICTION,
    illustrations: |results, curves| each(figures(results, curves)),
    tables: |_| Vec::new(),
    pictures: &[],
};

const PART: &str = "media";
/// The medium with which the others are compared.
const NOTHING: &str = "nothing";
/// The others with their viscosities in Pa s, as in the sweep file.
const MEDIA: [(&str, f64); 5] = [
    ("air", 18e-6),
    ("water", 1e-3),
    ("0.1 Pa s", 0.1),
    ("1.4 Pa s", 1.4),
    ("10 Pa s", 10.0),
];
/// Change of friction below which water counts as immaterial.
const IMMATERIAL: f64 = 0.03;
/// Change of friction that counts as marked.
const MARKED: f64 = 0.05;

static RULES: [Rule; 2] = [
    Rule {
        statement: "Water does not change the coefficient of friction.",
        rule: "The 90 % interval of the change, averaged over laws and pressures of each seed, lies within 0.03 of zero.",
        test: water,
    },
    Rule {
        statement: "No liquid of up to 10 Pa s changes it markedly.",
        rule: "The 90 % interval of the change lies within 0.05 of zero in each liquid; refuted if that of one lies beyond.",
        test: liquids,
    },
];

fn parts(scale: Scale) -> Vec<Part> {
    let seeds = match scale {
        Scale::Small => "0..6",
        Scale::Full => "0..16",
    };
    vec![Part::new(PART, include_str!("media.toml"), seeds)]
}

fn introduction() -> Markup {
    html! {
        p {
            "The thesis asks whether water or some other surrounding medium would change the behavior markedly. "
            "Here the small fault is sheared in vacuum, air, water and more viscous liquids, with the same packings. "
            "The medium acts by drag on single spheres with an inertial correction, as if each grain were alone in a liquid at rest. "
            "There is no pressure of pores, no lubrication and no flow, so that this answers only what drag does. "
            "Drag also acts on the moving block itself, whose grains count as single spheres: the share of the work that drag takes is shown."
        }
    }
}

/// Change of friction in a medium.
fn change(sample: Sample, medium: &'static str) -> Option<Change<'static>> {
    Change::of(sample, "medium", [NOTHING, medium], |run| {
        run.number("friction")
    })
}

fn water(sample: &Sample) -> Option<Finding> {
    let change = change(*sample, "water")?;
    Some(Change::judged(&[change], IMMATERIAL, |_| String::new()))
}

fn liquids(sample: &Sample) -> Option<Finding> {
    let changes = MEDIA.iter().map(|(medium, _)| change(*sample, medium));
    let changes: Option<Vec<Change>> = changes.collect();
    Some(Change::judged(&changes?, MARKED, |change| {
        let share = share_of_drag(*sample, change.value).unwrap_or(f64::NAN);
        format!(", of the work {:.1} % to drag", 100.0 * share)
    }))
}

/// Part of the work of the drive that becomes heat of drag, on the moving block, too.
fn share_of_drag(sample: Sample, medium: &str) -> Option<f64> {
    let share = |run: &Run| Some(run.number("heat-of-drag")? / run.number("driving_last")?);
    let runs = sample.runs().filter(|run| run.text("medium") == medium);
    let shares: Vec<f64> = runs.filter_map(share).collect();
    Mean::of(&shares).map(|mean| mean.mean)
}

fn figures(results: &Results, _: &Curves) -> Vec<Figure> {
    let sample = Sample {
        results,
        part: PART,
    };
    let point = |(medium, viscosity)| {
        let change = change(sample, medium)?;
        Some((viscosity, change.mean, change.interval))
    };
    let points: Vec<(f64, Mean, [f64; 2])> = MEDIA.into_iter().filter_map(point).collect();
    let curve = Curve::marks(
        "change of friction",
        points.iter().map(|(x, mean, _)| [*x, mean.mean]),
    )
    .with_intervals(points.iter().map(|(.., interval)| *interval));
    let figure = Figure::new(
        "Change of friction over the viscosity of the medium, 90 % intervals over seeds.",
        Axis::logarithmic("viscosity", "Pa s"),
        Axis::linear("change of the coefficient of friction", ""),
        vec![curve],
    );
    let figure = figure.with_guide(Guide::horizontal("marked", MARKED));
    match points.is_empty() {
        true => Vec::new(),
        false => vec![figure.with_guide(Guide::horizontal("nothing", 0.0))],
    }
}
