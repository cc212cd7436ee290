//! Errors of the kernel about the values of a case, by the keys that give these values.

use crate::error::Fault;
use crate::fields::Fields;
use gouge_peridem::error::{SetupError, USABLE};

/// A name of a parameter in errors of the kernel, and the key that gives it.
pub(super) type Name = (&'static str, &'static str);

/// Constants of a material.
pub(super) const MATERIAL: [Name; 5] = [
    ("young_modulus", "E"),
    ("poisson_ratio", "nu"),
    ("fracture_energy", "Gc"),
    ("density", "rho"),
    ("horizon", "eps"),
];
/// Coefficients of contacts.
pub(super) const CONTACT: [Name; 4] = [
    ("contact radius", "R_c"),
    ("contact stiffness", "K_n"),
    ("damping ratio", "r_d"),
    ("friction", "mu"),
];

/// The error about the key that gives a parameter; errors about anything else stay as they are.
pub(super) fn of_parameter(fields: &Fields, names: &[Name], error: SetupError) -> Fault {
    let (name, accepted) = match &error {
        SetupError::Parameter { name, accepted, .. } => (*name, (*accepted).to_owned()),
        SetupError::Product {
            name,
            product,
            result,
            ..
        } => {
            let [least, most] = USABLE;
            let range = format!("from {least:?} to {most:?}, not {result:?}");
            (*name, format!("such that {product} is {range}"))
        }
        _ => return error.into(),
    };
    match names.iter().find(|(of_kernel, _)| *of_kernel == name) {
        Some((_, key)) => fields.refuse_key(key, accepted),
        None => error.into(),
    }
}

/// The error about the key that makes a bond of a grain impossible.
pub(super) fn of_bond(grain: &Fields, error: SetupError) -> Fault {
    let SetupError::Bond { i, j, what, .. } = error else {
        return error.into();
    };
    let [first, second] = [i.min(j), i.max(j)];
    let place = grain.list("x").ok();
    let place = place.as_ref().and_then(|list| list.get(second));
    match (what, place) {
        ("no distance", Some(place)) => place.refuse(format!(
            "such that the node has, with y, a place of its own, but node {first} is there"
        )),
        ("too many bonds", _) => {
            let most = u16::MAX;
            let accepted = format!("such that no node has more than {most} bonds, as node {j} has");
            let is_listed = grain.list("bonds").is_ok();
            grain.refuse_key(if is_listed { "bonds" } else { "eps" }, accepted)
        }
        _ => SetupError::Bond {
            grain: 0,
            i,
            j,
            what,
        }
        .into(),
    }
}

/// The error about the polygon or the cut that makes a shape unusable.
pub(super) fn of_shape(case: &Fields, error: SetupError) -> Fault {
    let (key, place) = match error {
        SetupError::TooFewVertices { ring, .. }
        | SetupError::InvalidVertex { ring, .. }
        | SetupError::ZeroArea { ring }
        | SetupError::SelfIntersection { ring, .. } => match ring.checked_sub(1) {
            Some(hole) => ("holes", Some(hole)),
            None => ("outer", None),
        },
        SetupError::HoleOutside { hole } => ("holes", Some(hole)),
        SetupError::HolesMeet { second, .. } => ("holes", Some(second)),
        SetupError::InvalidCut { cut } | SetupError::NodeOnCut { cut, .. } => ("cuts", Some(cut)),
        _ => return error.into(),
    };
    let accepted = match key {
        "outer" => "a polygon that does not touch itself",
        "holes" => "a polygon that does not touch itself, outer or another hole",
        _ => "a segment on which there is no node",
    };
    let accepted = format!("{accepted} ({error})");
    let list = case.list(key).ok();
    match place.and_then(|place| list?.get(place).cloned()) {
        Some(value) => value.refuse(accepted),
        None => case.refuse_key(key, accepted),
    }
}
