//! An open question of the thesis: do other brittle materials shear like its granite?

use super::change::Change;
use super::claim::{Finding, Rule, Verdict, within_or_beyond};
use super::curves::Curves;
use super::friction_curves::FRICTION;
use super::illustration::each;
use super::results::Results;
use super::sample::Sample;
use super::{Part, Scale, Study};
use crate::statistics::Mean;
use gouge_page::{Axis, Figure, table};
use maud::{Markup, html};

/// The study.
pub static STUDY: Study = Study {
    name: "rocks",
    title: "Do other brittle materials shear like the granite of the thesis?",
    introduction,
    parts,
    order: &[
        "granite-fault",
        "basalt-fault",
        "limestone-fault",
        "tonalite-fault",
        "model-granite-fault",
        "granite-tension",
        "basalt-tension",
        "limestone-tension",
        "tonalite-tension",
    ],
    rules: || RULES.iter().collect(),
    curves: FRICTION,
    illustrations: |results, curves| each(figures(results, curves)),
    tables: |results| vec![calibrated(), tension_of_all(results)],
    pictures: &[],
};

/// What was measured of a rock.
struct Measured {
    /// Young's modulus in Pa.
    youngs_modulus: f64,
    /// Poisson's ratio.
    poissons_ratio: f64,
    /// Unconfined compressive strength in Pa.
    compressive: f64,
    /// Strength in direct tension in Pa.
    tensile: f64,
}

/// A material and its bonds.
struct Material {
    /// Its name, with which its parts begin.
    name: &'static str,
    /// What was measured; nothing of the material of the thesis.
    measured: Option<Measured>,
    /// Stiffnesses of bonds in N/m, normal and tangential.
    stiffness: [f64; 2],
    /// Strengths of bonds in Pa, normal and tangential.
    strength: [f64; 2],
}

/// The material with which the others are compared.
const BASE: &str = "model-granite";

/// Rocks with the bonds that the calibration `rock` finds for them, and the material of the thesis.
static MATERIALS: [Material; 5] = [
    Material {
        name: "granite",
        measured: Some(Measured {
            youngs_modulus: 69e9,
            poissons_ratio: 0.26,
            compressive: 200e6,
            tensile: 6.9e6,
        }),
        stiffness: [1.383e8, 6.603e7],
        strength: [1.716e8; 2],
    },
    Material {
        name: "basalt",
        measured: Some(Measured {
            youngs_modulus: 34.9e9,
            poissons_ratio: 0.32,
            compressive: 148e6,
            tensile: 13.1e6,
        }),
        stiffness: [7.480e7, 1.849e7],
        strength: [1.363e8; 2],
    },
    Material {
        name: "limestone",
        measured: Some(Measured {
            youngs_modulus: 28.5e9,
            poissons_ratio: 0.29,
            compressive: 51.0e6,
            tensile: 1.6e6,
        }),
        stiffness: [5.818e7, 2.054e7],
        strength: [4.757e7; 2],
    },
    Material {
        name: "tonalite",
        measured: Some(Measured {
            youngs_modulus: 19.2e9,
            poissons_ratio: 0.17,
            compressive: 101.5e6,
            tensile: 6.4e6,
        }),
        stiffness: [3.323e7, 3.102e7],
        strength: [8.050e7; 2],
    },
    Material {
        name: BASE,
        measured: None,
        stiffness: [1e7; 2],
        strength: [280e6, 168e6],
    },
];

/// Damping of the thesis in kg/s, and the stiffness in N/m that it belongs to.
const DAMPING: [f64; 2] = [10.0, 1e7];
/// Time step in s at that stiffness.
const STEP: f64 = 20e-9;
/// Difference of friction below which curves count as one.
const COLLAPSED: f64 = 0.05;
/// Part of the measured tensile strength by which a prediction may be off.
const PREDICTED: f64 = 0.25;

static RULES: [Rule; 2] = [
    Rule {
        statement: "Over pressure in units of the strength, the rock has the friction of the material of the thesis.",
        rule: "The 90 % interval of the difference, averaged over the pressures of each seed, lies within 0.05 of zero; refuted if it lies beyond.",
        test: friction,
    },
    Rule {
        statement: "Elastic constants and compressive strength give the strength in direct tension.",
        rule: "The 90 % interval of the mean over packings lies within 25 % of the measured strength; refuted if it lies beyond.",
        test: tension,
    },
];

fn introduction() -> Markup {
    html! {
        p {
            "The thesis asks whether other brittle materials would behave like its granite. "
            "Here the bonds of four rocks are calibrated on Young's modulus, Poisson's ratio and unconfined compressive strength alone, as "
            code { "gouge calibrate rock" } " does for the first of them, with bonds that are as strong in tension as in compression and in shear. "
            "Direct tension is then predicted, and the small fault is sheared under pressures in units of the strength of the bonds. "
            "The last material is that of the thesis, with contacts as stiff as its bonds. "
            "All grains have a friction of 0.7, the law of Cundall and Strack with truncation, and the density of granite."
        }
    }
}

impl Material {
    fn of(part: &str) -> Option<&'static Self> {
        MATERIALS
            .iter()
            .find(|material| part.starts_with(material.name))
    }

    /// A sweep of this material, from a file in which names stand for its numbers.
    fn sweep(&self, text: &str) -> String {
        let factor = (self.stiffness[0] / DAMPING[1]).sqrt();
        let numbers = [
            ("NORMAL_STIFFNESS", self.stiffness[0]),
            ("TANGENTIAL_STIFFNESS", self.stiffness[1]),
            ("NORMAL_STRENGTH", self.strength[0]),
            ("TANGENTIAL_STRENGTH", self.strength[1]),
            ("DAMPING", DAMPING[0] * factor),
            ("STEP", STEP / factor),
        ];
        let replaced = |text: String, (name, number): &(&str, f64)| {
            text.replace(name, &format!("{number:.3e}"))
        };
        numbers.iter().fold(text.to_owned(), replaced)
    }
}

fn parts(scale: Scale) -> Vec<Part> {
    let seeds = match scale {
        Scale::Small => "0..6",
        Scale::Full => "0..16",
    };
    let part = |&name: &&'static str| {
        let text = match name.ends_with("-fault") {
            true => include_str!("fault.toml"),
            false => include_str!("tension.toml"),
        };
        Some(Part::new(name, &Material::of(name)?.sweep(text), seeds))
    };
    STUDY.order.iter().filter_map(part).collect()
}

/// Friction of a material less that of the thesis, averaged over the pressures of each seed that has them all.
fn friction(sample: &Sample) -> Option<Finding> {
    let material = Material::of(sample.part.strip_suffix("-fault")?)?;
    let base_part = format!("{BASE}-fault");
    let base = Sample {
        part: &base_part,
        ..*sample
    };
    let pressures = sample.pressures();
    let of_seed = |seed: &&str| -> Option<f64> {
        let at = |sample: Sample, p: f64| sample.by_seed("", p, "friction").get(seed).copied();
        let less = |&p: &f64| Some(at(*sample, p)? - at(base, p)?);
        let changes: Option<Vec<f64>> = pressures.iter().map(less).collect();
        Mean::of(&changes?).map(|mean| mean.mean)
    };
    let changes: Vec<f64> = sample.seeds().iter().filter_map(of_seed).collect();
    let change = Change::of_seeds(material.name, &changes).filter(|one| one.value != BASE)?;
    Some(Change::judged(&[change], COLLAPSED, |_| String::new()))
}

/// Predicted strength in direct tension of a rock, over packings.
fn predicted(sample: Sample) -> Option<(&'static Material, &'static Measured, Mean)> {
    let material = Material::of(sample.part.strip_suffix("-tension")?)?;
    let strengths = sample.runs().filter_map(|run| run.number("strength"));
    let strengths: Vec<f64> = strengths.collect();
    let mean = Mean::of(&strengths).filter(|mean| mean.number > 1)?;
    Some((material, material.measured.as_ref()?, mean))
}

fn tension(sample: &Sample) -> Option<Finding> {
    let (material, measured, mean) = predicted(*sample)?;
    let relative = mean.interval(0.9).map(|end| end / measured.tensile - 1.0);
    let [is_met, is_opposed] = within_or_beyond(relative, PREDICTED);
    let [low, high] = mean.interval(0.9).map(|end| 1e-6 * end);
    let numbers = format!(
        "{}: {:.1} MPa, 90 % [{low:.1}, {high:.1}], of {} packings; measured {:.1} MPa.",
        material.name,
        1e-6 * mean.mean,
        mean.number,
        1e-6 * measured.tensile
    );
    Some(Finding::new(Verdict::of(is_met, is_opposed), numbers))
}

fn figures(results: &Results, _: &Curves) -> Vec<Figure> {
    let curve = |material: &Material| {
        let part = format!("{}-fault", material.name);
        let sample = Sample {
            results,
            part: &part,
        };
        sample.over_pressure(material.name, "friction", |_| true)
    };
    let curves = MATERIALS.iter().map(curve);
    let curves = curves.filter(|curve| !curve.points.is_empty());
    let figure = Figure::new(
        "Friction over pressure in units of the strength of the bonds, 95 % intervals over seeds.",
        Axis::logarithmic("pressure over strength of the bonds", ""),
        Axis::linear("coefficient of friction", ""),
        curves.collect(),
    );
    match figure.curves.is_empty() {
        true => Vec::new(),
        false => vec![figure],
    }
}

/// What was measured of the rocks, and the bonds that give it.
fn calibrated() -> Markup {
    let row = |material: &Material| {
        let measured = material.measured.as_ref();
        let cell = |of: fn(&Measured) -> String| measured.map_or(String::new(), of);
        vec![
            material.name.to_owned(),
            cell(|rock| format!("{:.1}", 1e-9 * rock.youngs_modulus)),
            cell(|rock| format!("{:.2}", rock.poissons_ratio)),
            cell(|rock| format!("{:.1}", 1e-6 * rock.compressive)),
            format!("{:.3e}", material.stiffness[0]),
            format!("{:.3e}", material.stiffness[1]),
            format!("{:.1}", 1e-6 * material.strength[0]),
        ]
    };
    let columns = [
        "material",
        "Young's modulus (GPa)",
        "Poisson's ratio",
        "compressive strength (MPa)",
        "normal stiffness (N/m)",
        "tangential stiffness (N/m)",
        "strength of bonds (MPa)",
    ];
    let rows: Vec<Vec<String>> = MATERIALS.iter().map(row).collect();
    table(
        "Measured constants (tables of Goodman, Introduction to Rock Mechanics, 1989; not checked against the source), and the bonds calibrated on them",
        &columns.map(str::to_owned),
        &rows,
    )
}

/// Predicted and measured strengths in direct tension.
fn tension_of_all(results: &Results) -> Markup {
    let row = |part: &&str| {
        let (material, measured, mean) = predicted(Sample { results, part })?;
        let [low, high] = mean.interval(0.9).map(|end| 1e-6 * end);
        let cells = [
            material.name.to_owned(),
            format!("{:.1} ({low:.1} to {high:.1})", 1e-6 * mean.mean),
            format!("{:.1}", 1e-6 * measured.tensile),
            format!("{:.1}", measured.compressive / mean.mean),
            format!("{:.1}", measured.compressive / measured.tensile),
        ];
        Some(cells.into())
    };
    let rows: Vec<Vec<String>> = STUDY.order.iter().filter_map(row).collect();
    let columns = [
        "rock",
        "predicted, 90 % (MPa)",
        "measured (MPa)",
        "compressive over predicted",
        "compressive over measured",
    ];
    table(
        "Strength in direct tension",
        &columns.map(str::to_owned),
        &rows,
    )
}
