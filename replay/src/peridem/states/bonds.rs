//! Which pairs of nodes of a shape are bonds: by the exact rule, and by the method of section 5 of peridem.

use super::constants::object;
use super::{Found, Sheet};
use crate::error::Fault;
use crate::fields::Fields;
use crate::peridem::refusals::{of_bond, of_shape};
use core::fmt::Write;
use gouge_common::geometry::Vec2;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::interior::{Interceptors, Interior, SectionFive};
use gouge_peridem::material::{BondConstants, Weight};
use gouge_peridem::shape::Outline;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

const INPUTS: [&str; 9] = [
    "name",
    "outer",
    "holes",
    "cuts",
    "eps",
    "h",
    "x",
    "y",
    "on_boundary",
];

/// Ratio of the distance by which section 5 moves the boundary outwards to the mesh size.
const BOUNDARY_SHIFT: f64 = 0.05;

/// Pairs of nodes, the smaller first, in ascending order.
type Pairs = Vec<[usize; 2]>;

pub(super) fn solve(sheet: &mut Sheet) -> Result<(), Fault> {
    sheet.solve("cases", &INPUTS, case)
}

fn case(case: &Fields) -> Result<Found, Fault> {
    let nodes = case.filled_list("x", "number")?.len();
    let position = case.vectors("x", "y", nodes)?;
    let outline = outline(case)?;
    let interior = Interior::new(&outline);
    let checked = interior.require_off_cuts(&position);
    checked.map_err(|error| of_shape(case, error))?;
    let pairs = within(case, &position)?;
    let admits = |&[i, j]: &[usize; 2]| interior.admits(position[i], position[j]);
    let (bonds, removed): (Pairs, Pairs) = pairs.iter().partition(|pair| admits(pair));
    let mut found = object([
        ("pairs_within_eps", pairs.len().into()),
        ("bonds", bonds.len().into()),
        ("sha256_of_bonds", hash(&bonds).into()),
        ("removed_pairs", json!(removed)),
    ]);
    let methods = [
        ("paper_method_bisectors_only", Interceptors::Bisectors),
        (
            "paper_method_bisectors_and_extended_boundary",
            Interceptors::BisectorsAndBoundary,
        ),
    ];
    let is_treated = outline.holes().is_empty() && outline.cuts().is_empty();
    for (key, interceptors) in methods {
        if is_treated || case.optional(key).is_some() {
            let shift = BOUNDARY_SHIFT * case.positive("h")?;
            let method = SectionFive::new(&outline, shift, interceptors);
            let method = method.map_err(|error| of_shape(case, error))?;
            let keeps = |&&[i, j]: &&[usize; 2]| method.admits(position[i], position[j]);
            found.insert(key.to_owned(), differences(&bonds, &removed, keeps));
        }
    }
    Ok(found)
}

/// Pairs on which a method and the exact rule differ.
fn differences(bonds: &Pairs, removed: &Pairs, keeps: impl Fn(&&[usize; 2]) -> bool) -> Value {
    let kept: Vec<_> = removed.iter().filter(&keeps).collect();
    let lost: Vec<_> = bonds.iter().filter(|pair| !keeps(pair)).collect();
    json!({"kept_but_leaves_domain": kept, "removed_but_inside": lost})
}

fn outline(case: &Fields) -> Result<Outline, Fault> {
    let ring = |ring: &Fields| {
        ring.as_list()?
            .iter()
            .map(Fields::as_vector)
            .collect::<Result<Vec<_>, _>>()
    };
    let listed = |key: &str| {
        case.optional(key)
            .map_or(Ok(Vec::new()), |list| list.as_list())
    };
    let cut = |cut: &Fields| match ring(cut)?.as_slice() {
        &[a, b] => Ok([a, b]),
        _ => Err(cut.refuse("two points")),
    };
    let outline = Outline::new(
        ring(&case.required("outer", "a list of points")?)?,
        listed("holes")?
            .iter()
            .map(ring)
            .collect::<Result<_, _>>()?,
        listed("cuts")?.iter().map(cut).collect::<Result<_, _>>()?,
    );
    outline.map_err(|error| of_shape(case, error))
}

/// All pairs of nodes within the horizon.
fn within(case: &Fields, position: &[Vec2]) -> Result<Pairs, Fault> {
    let grains = Grains::new(&[Grain {
        position: position.to_vec(),
        area: vec![1.0; position.len()],
        density: 1.0,
        constants: BondConstants {
            weight: Weight::Constant,
            horizon: case.usable("eps")?,
            stiffness: 1.0,
            critical_stretch: 1.0,
        },
        breaking: None,
        touches_itself: false,
        contact_stiffness: 1.0,
        material: 0,
        clamped: Vec::new(),
        load: Vec::new(),
    }])?;
    let bonds = Bonds::within_horizon(&grains, |_, _, _| true);
    let bonds = bonds.map_err(|error| of_bond(case, error))?;
    let mut pairs: Pairs = bonds.all().map(|(i, j, _)| [i, j]).collect();
    pairs.sort_unstable();
    Ok(pairs)
}

/// SHA-256 of the bonds as lines `i j`, joined by line feeds without one at the end.
fn hash(bonds: &Pairs) -> String {
    let lines: Vec<_> = bonds.iter().map(|[i, j]| format!("{i} {j}")).collect();
    let digest = Sha256::digest(lines.join("\n"));
    digest.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
