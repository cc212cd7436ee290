//! The study of the thesis, repeated with many seeds.

mod claims;
mod figures;
mod printed;
mod table;

use super::friction_curves::FRICTION;
use super::illustration::each;
use super::pictures::Shown;
use super::results::Results;
use super::sample::Sample;
use super::{Part, Scale, Study};
use maud::{Markup, html};

/// The study.
pub static STUDY: Study = Study {
    name: "thesis",
    title: "Friction between shearing brittle surfaces: the study of the thesis, repeated",
    introduction,
    parts,
    order: &[
        "corrected-full",
        "corrected-small",
        "thesis-full",
        "thesis-small",
        "variants-small",
    ],
    rules: || claims::rules().chain(&table::RULES).collect(),
    curves: FRICTION,
    illustrations: |results, curves| each(figures::all(results, curves)),
    tables,
    pictures: &PICTURES,
};

/// Pictures as in thesis figure 11.
static PICTURES: [Shown; 8] = [
    shown("thesis-full", &[("law", "HW"), ("pressure", "0.0125")]),
    shown("thesis-full", &[("law", "HW"), ("pressure", "0.15")]),
    shown("thesis-full", &[("law", "HW"), ("pressure", "0.5")]),
    shown("thesis-full", &[("law", "HW"), ("pressure", "0.7")]),
    shown("corrected-full", &[("law", "HW"), ("pressure", "0.0125")]),
    shown("corrected-full", &[("law", "HW"), ("pressure", "0.15")]),
    shown("corrected-full", &[("law", "HW"), ("pressure", "0.4")]),
    shown("corrected-full", &[("law", "HW"), ("pressure", "0.8")]),
];

const fn shown(part: &'static str, axes: &'static [(&'static str, &'static str)]) -> Shown {
    Shown::final_state(part, axes)
}

/// The sweep files.
const SWEEPS: [(&str, &str); 5] = [
    (
        "corrected-small",
        include_str!("sweeps/corrected-small.toml"),
    ),
    ("thesis-small", include_str!("sweeps/thesis-small.toml")),
    ("variants-small", include_str!("sweeps/variants-small.toml")),
    ("corrected-full", include_str!("sweeps/corrected-full.toml")),
    ("thesis-full", include_str!("sweeps/thesis-full.toml")),
];

fn parts(scale: Scale) -> Vec<Part> {
    // Over packings, changes of friction deviate by 0.05 to 0.1: equivalence within 0.05 needs the most.
    let seeds = |name: &str| match (scale, name) {
        // The 75 runs of the thesis, once.
        (_, "thesis-full") => "0..1",
        (_, "corrected-full") => "0..4",
        (Scale::Full, "variants-small") => "0..32",
        (Scale::Full, "corrected-small") => "0..16",
        (Scale::Small, "thesis-small") => "0..3",
        _ => "0..6",
    };
    let is_run = |name: &str| scale == Scale::Full || name.ends_with("-small");
    let all = SWEEPS.into_iter().filter(|(name, _)| is_run(name));
    all.map(|(name, text)| Part::new(name, text, seeds(name)))
        .collect()
}

/// Table 1 for the parts of full size.
fn tables(results: &Results) -> Vec<Markup> {
    let parts = ["corrected-full", "thesis-full"].into_iter();
    parts
        .filter_map(|part| table::table(Sample { results, part }))
        .collect()
}

fn introduction() -> Markup {
    html! {
        p {
            "Kiiskinen's thesis ran 75 simulations, 3 laws of friction times 25 pressures, of one packing. "
            "Here every run is repeated with several packings. "
            "The corrected arm uses the equations as corrected in the errata, velocity Verlet, and a stable step for each law. "
            "The other arm computes as the author's program did: explicit Euler at 10 ns, friction as printed, moment of inertia 3/5 m r². "
            "Runs of the corrected arm whose energy balance is off do not count; those of the other arm all do."
        }
    }
}
