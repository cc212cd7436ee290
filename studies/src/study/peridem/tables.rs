//! Tables of the paper, and of the runs.

use super::claims::from_notch;
use super::{
    CROSSES, CROSSES_FINE, KALTHOFF, NOTCH, NOTCH_CONTACT, NOTCH_FINE, PRINTED_NOTCH, printed,
};
use crate::study::results::{Results, Run};
use crate::study::sample::Sample;
use gouge_page::table;
use gouge_peridem::material::{Material, Plane, Weight};
use maud::Markup;

pub(super) fn tables(results: &Results) -> Vec<Markup> {
    let runs = [
        (KALTHOFF, "The plate", PLATE),
        (CROSSES, "Crosses over horizons", AREAS),
        (CROSSES_FINE, "Crosses over spacings", AREAS),
        (
            NOTCH,
            "The notched square, sizes of the public script",
            PIECES,
        ),
        (
            NOTCH_CONTACT,
            "The notched square with stiffer contacts",
            CONTACTS,
        ),
        (NOTCH_FINE, "The notched square on finer meshes", PIECES),
        (PRINTED_NOTCH, "The notched square, printed sizes", PIECES),
    ];
    let of_runs = runs
        .iter()
        .filter_map(|(part, caption, columns)| table_of_runs(results, part, caption, columns));
    [printed::table(results)]
        .into_iter()
        .chain(constants())
        .chain([materials()])
        .chain(of_runs)
        .collect()
}

/// Columns of a table of runs: heading, column, and factor and decimals of numbers; texts stand as they are.
type Columns = &'static [(&'static str, &'static str, Option<(f64, usize)>)];

const PLATE: Columns = &[
    ("grid", "grid", None),
    ("breaking", "breaking", None),
    ("self contact", "self contact", None),
    ("length in mm", "crack_length_0_last", Some((1e3, 1))),
    ("broken bonds", "broken_bonds_last", Some((1.0, 0))),
];
const AREAS: Columns = &[
    ("horizon", "horizon", None),
    ("spacing", "spacing", None),
    ("area after 400 ns in mm²", "area_at_400_ns", Some((1.0, 4))),
    ("after 1 us", "area_at_1_us", Some((1.0, 4))),
    ("broken bonds", "broken_bonds_last", Some((1.0, 0))),
];
const PIECES: Columns = &[
    ("Gc", "Gc", None),
    ("spacing", "spacing", None),
    ("pieces with two planks", "pieces_last", Some((1.0, 0))),
    ("two pieces at us", "two_pieces", Some((1.0, 1))),
    ("three pieces at us", "three_pieces", Some((1.0, 1))),
    ("broken bonds", "broken_bonds_last", Some((1.0, 0))),
];

const CONTACTS: Columns = &[
    ("Gc", "Gc", None),
    ("spacing", "spacing", None),
    ("stiffness over c/R_c", "contact", None),
    ("pieces with two planks", "pieces_last", Some((1.0, 0))),
    ("two pieces at us", "two_pieces", Some((1.0, 1))),
    ("three pieces at us", "three_pieces", Some((1.0, 1))),
    ("broken bonds", "broken_bonds_last", Some((1.0, 0))),
];

fn table_of_runs(
    results: &Results,
    part: &'static str,
    caption: &str,
    columns: Columns,
) -> Option<Markup> {
    let sample = Sample { results, part };
    let cell = |run: &Run, (_, column, form): &(&str, &str, Option<(f64, usize)>)| match form
        .zip(run.number(column))
    {
        Some(((factor, digits), number)) => format!("{:.*}", digits, number * factor),
        None => run.text(column).to_owned(),
    };
    let angle = |run: &Run| {
        let angles = [0, 1].map(|crack| from_notch(run, crack));
        let said = angles.map(|angle| angle.map_or_else(|| "-".to_owned(), |a| format!("{a:.1}")));
        said.join(" and ")
    };
    let has_cracks = part == KALTHOFF;
    let row = |run: &Run| {
        let cells = columns.iter().map(|column| cell(run, column));
        cells
            .chain(has_cracks.then(|| angle(run)))
            .collect::<Vec<String>>()
    };
    let rows: Vec<Vec<String>> = sample.runs().map(row).collect();
    let names = columns.iter().map(|column| column.0);
    let names: Vec<String> = names
        .chain(has_cracks.then_some("angles from the notches in degrees, positive outwards"))
        .map(str::to_owned)
        .collect();
    (!rows.is_empty()).then(|| table(caption, &names, &rows))
}

/// Table 1 for the second material.
fn constants() -> Option<Markup> {
    let material = Material {
        young_modulus: 1.23e9,
        poisson_ratio: 1.0 / 3.0,
        fracture_energy: 135.0,
        density: 1200.0,
        plane: Plane::Stress,
    };
    let row = |(name, weight)| {
        let constants = material.bond_constants(weight, 5e-4).ok()?;
        Some(vec![
            String::from(name),
            format!("{:.6e}", constants.stiffness),
            format!("{:.6}", constants.critical_stretch),
        ])
    };
    let weights = [("constant", Weight::Constant), ("conic", Weight::Conic)];
    let rows: Option<Vec<Vec<String>>> = weights.map(row).into_iter().collect();
    let columns = ["weight", "c in N/m⁶", "critical stretch"].map(str::to_owned);
    Some(table(
        "Table 1 for E = 1.23 GPa, Gc = 135 J/m², horizon 0.5 mm",
        &columns,
        &rows?,
    ))
}

/// Table 2 with Poisson's ratios of the printed moduli, which bonds cannot have.
fn materials() -> Markup {
    let row = |(name, young, bulk, density): (&str, f64, f64, f64)| {
        let ratio = 0.5 - young / (6.0 * bulk);
        vec![
            name.to_owned(),
            format!("{:.2}", 1e-9 * young),
            format!("{:.1}", 1e-9 * bulk),
            format!("{density}"),
            format!("{ratio:.2}"),
        ]
    };
    let rows = [("M1", 191e9, 159.2e9, 8000.0), ("M2", 1.23e9, 2e9, 1200.0)].map(row);
    let columns = [
        "material",
        "E in GPa",
        "k in GPa",
        "density in kg/m³",
        "Poisson's ratio of E and k",
    ];
    table(
        "Table 2, with the Poisson's ratio that follows; that of bonds is 1/3",
        &columns.map(str::to_owned),
        &rows,
    )
}
