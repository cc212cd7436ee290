//! Stiffness and critical stretch of materials.

use super::{Found, Sheet};
use crate::error::Fault;
use crate::fields::Fields;
use crate::peridem::refusals::{MATERIAL, of_parameter};
use gouge_peridem::contact_law::{ContactMaterial, ContactStiffness};
use gouge_peridem::material::{Material, Plane, Weight};
use serde_json::{Value, json};

const INPUTS: [&str; 8] = ["name", "weight", "plane", "E", "nu", "eps", "Gc", "rho"];

/// Weights by name.
pub(super) const WEIGHTS: [(&str, Weight); 3] = [
    ("constant", Weight::Constant),
    ("conic", Weight::Conic),
    ("parabolic", Weight::Parabolic),
];

/// Bulk and shear modulus in Pa of material M2, from which the authors' scripts take Young's modulus.
const MODULI_M2: [f64; 2] = [2e9, 1.33e9];
/// Horizon in m of the constants of material M2; the contact radius is a fifth of it.
const HORIZON_M2: f64 = 0.0005;
/// Material M2 as printed, with the Poisson's ratio of the bonds.
const M2: Material = Material {
    young_modulus: 1.23e9,
    poisson_ratio: 1.0 / 3.0,
    fracture_energy: 135.0,
    density: 1200.0,
    plane: Plane::Stress,
};

pub(super) fn solve(sheet: &mut Sheet) -> Result<(), Fault> {
    sheet.solve("cases", &INPUTS, case)?;
    for (key, values) in [("authors_M2", authors()), ("K_n_M2", stiffnesses()?)] {
        if let Some(given) = sheet.file.optional(key) {
            let mut found = given.texts();
            found.extend(values);
            sheet.found.insert(key.to_owned(), found.into());
        }
    }
    Ok(())
}

pub(super) fn weight(case: &Fields) -> Result<Weight, Fault> {
    let name = case.word("weight", &WEIGHTS.map(|(name, _)| name))?;
    let found = WEIGHTS.iter().find(|(known, _)| *known == name);
    Ok(found.map_or(Weight::Constant, |&(_, weight)| weight))
}

fn case(case: &Fields) -> Result<Found, Fault> {
    let plane = match case.word("plane", &["stress", "strain"])? {
        "strain" => Plane::Strain,
        _ => Plane::Stress,
    };
    let material = Material {
        young_modulus: case.positive("E")?,
        poisson_ratio: case.number("nu")?,
        fracture_energy: case.positive("Gc")?,
        density: case.number_or("rho", 1.0)?,
        plane,
    };
    let horizon = case.positive("eps")?;
    let constants = material.bond_constants(weight(case)?, horizon);
    let constants = constants.map_err(|error| of_parameter(case, &MATERIAL, error))?;
    let (c, s0) = (constants.stiffness, constants.critical_stretch);
    let ratio = material.fracture_energy / (c * s0 * s0 * horizon.powi(4));
    Ok(object([
        ("c", c.into()),
        ("s0", s0.into()),
        ("G_over_c_s0sq_eps4", ratio.into()),
    ]))
}

/// An object with some keys.
pub(super) fn object<const N: usize>(items: [(&str, Value); N]) -> Found {
    items
        .map(|(key, value)| (key.to_owned(), value))
        .into_iter()
        .collect()
}

/// Young's modulus with the slip of the authors' scripts, the right one, and Poisson's ratio of the two moduli.
fn authors() -> Found {
    let [k, g] = MODULI_M2;
    object([
        ("E_slip", json!(9.0 * k * g / (9.0 * k + g))),
        ("E_right", json!(9.0 * k * g / (3.0 * k + g))),
        (
            "nu_of_k_G",
            json!((3.0 * k - 2.0 * g) / (2.0 * (3.0 * k + g))),
        ),
    ])
}

fn stiffnesses() -> Result<Found, Fault> {
    let material = ContactMaterial {
        material: M2,
        bulk_modulus: MODULI_M2[0],
        horizon: HORIZON_M2,
    };
    let radius = HORIZON_M2 / 5.0;
    let of = |kind: ContactStiffness| kind.between(&material, &material, radius);
    Ok(object([
        ("printed_eps5", of(ContactStiffness::Printed)?.into()),
        ("scripts_eps4", of(ContactStiffness::Published)?.into()),
        (
            "c_over_Rc_Rc_eps_5",
            of(ContactStiffness::FromBonds)?.into(),
        ),
    ]))
}
