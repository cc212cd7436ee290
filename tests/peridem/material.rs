//! Constants of bonds against the integrals that define them.

use crate::quadrature::integrate;
use gouge_peridem::contact_law::{ContactMaterial, ContactStiffness};
use gouge_peridem::error::SetupError;
use gouge_peridem::material::{Material, Plane, Weight};
use std::f64::consts::PI;

const WEIGHTS: [Weight; 3] = [Weight::Constant, Weight::Conic, Weight::Parabolic];

fn materials() -> [Material; 2] {
    let stress = Material {
        young_modulus: 1.23e9,
        poisson_ratio: 1.0 / 3.0,
        fracture_energy: 135.0,
        density: 1200.0,
        plane: Plane::Stress,
    };
    let strain = Material {
        young_modulus: 72e9,
        poisson_ratio: 0.25,
        plane: Plane::Strain,
        ..stress
    };
    [stress, strain]
}

/// Energy density of a stretch of one in the plane, by Hooke's law in space.
fn energy_of_hooke(material: &Material) -> f64 {
    let (e, nu) = (material.young_modulus, material.poisson_ratio);
    let lambda = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    let shear = e / (2.0 * (1.0 + nu));
    let thickness_strain = match material.plane {
        Plane::Stress => -2.0 * lambda / (lambda + 2.0 * shear),
        Plane::Strain => 0.0,
    };
    lambda * (2.0 + thickness_strain) + 2.0 * shear
}

#[test]
fn an_isotropic_stretch_has_the_energy_of_the_plate() {
    for (material, weight) in materials().iter().flat_map(|m| WEIGHTS.map(|w| (m, w))) {
        let horizon = 5e-4;
        let bonds = material.bond_constants(weight, horizon).unwrap();
        let ring = |r: f64| 2.0 * PI * r * 0.25 * bonds.stiffness * weight.at(r, horizon) * r;
        let ratio = integrate(0.0, horizon, ring) / energy_of_hooke(material);
        assert!((ratio - 1.0).abs() < 1e-12, "{weight:?}: {ratio}");
    }
}

#[test]
fn separation_of_two_half_planes_costs_the_fracture_energy() {
    for (material, weight) in materials().iter().flat_map(|m| WEIGHTS.map(|w| (m, w))) {
        let horizon = 5e-4;
        let bonds = material.bond_constants(weight, horizon).unwrap();
        let bond = |r: f64| {
            let s0 = bonds.critical_stretch;
            0.5 * bonds.stiffness * weight.at(r, horizon) * s0 * s0 * r
        };
        let across =
            |z: f64| integrate(z, horizon, |r| bond(r) * 2.0 * r * (z / r).min(1.0).acos());
        let ratio = integrate(0.0, horizon, across) / material.fracture_energy;
        assert!((ratio - 1.0).abs() < 1e-12, "{weight:?}: {ratio}");
    }
}

#[test]
fn invalid_materials_are_refused() {
    let [good, _] = materials();
    for bad in [
        Material {
            young_modulus: 0.0,
            ..good
        },
        Material {
            density: f64::NAN,
            ..good
        },
        Material {
            fracture_energy: -1.0,
            ..good
        },
        Material {
            poisson_ratio: 0.5,
            ..good
        },
    ] {
        assert!(bad.bond_constants(Weight::Constant, 1e-3).is_err());
    }
    assert!(good.bond_constants(Weight::Constant, 0.0).is_err());
}

/// Name and value of a parameter of which a product is refused.
fn extreme<T: std::fmt::Debug>(result: Result<T, SetupError>) -> (&'static str, f64) {
    match result {
        Err(SetupError::Product { name, value, .. }) => (name, value),
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_parameter_with_which_a_product_overflows_is_named() {
    let of = |change: fn(&mut Material), horizon: f64| {
        let mut material = materials()[0];
        change(&mut material);
        material.bond_constants(Weight::Constant, horizon)
    };
    for (young, name) in [(1e300, "young_modulus"), (1e-300, "young_modulus")] {
        let material = Material {
            young_modulus: young,
            ..materials()[0]
        };
        let found = material.bond_constants(Weight::Constant, 1e-3);
        assert_eq!(extreme(found), (name, young));
    }
    for horizon in [1e-150, 1e100] {
        assert_eq!(extreme(of(|_| (), horizon)), ("horizon", horizon));
    }
    assert_eq!(
        extreme(of(|one| one.density = 1e300, 1e-3)),
        ("density", 1e300)
    );
    assert_eq!(
        extreme(of(|one| one.density = 1e-300, 1e-3)),
        ("density", 1e-300)
    );
    let tough = of(|one| one.fracture_energy = 1e300, 1e-3).unwrap();
    assert!(tough.critical_stretch > 1e100);
    let text = of(|one| one.young_modulus = 1e300, 1e-3)
        .unwrap_err()
        .to_string();
    assert!(
        text.starts_with("young_modulus is 1e300, which makes") && text.len() < 200,
        "{text}"
    );
}

#[test]
fn the_parameter_with_which_a_contact_stiffness_overflows_is_named() {
    let side = |bulk_modulus: f64| ContactMaterial {
        material: materials()[0],
        bulk_modulus,
        horizon: 1e-3,
    };
    let between = |how: ContactStiffness, bulk: f64, radius: f64| {
        extreme(how.between(&side(bulk), &side(bulk), radius))
    };
    for how in [ContactStiffness::Published, ContactStiffness::Printed] {
        assert_eq!(between(how, 1e300, 1e-3), ("bulk_modulus", 1e300));
    }
    let radius = between(ContactStiffness::FromBonds, 1.0, 1e-300);
    assert_eq!(radius, ("contact radius", 1e-300));
}

/// A strip of bonds is as stiff as its material only if Poisson's ratio is that of the bonds.
#[test]
fn young_modulus_of_bonds_is_that_of_the_plate_with_the_same_dilation() {
    for material in materials() {
        let own = material.young_modulus_of_bonds();
        assert!((own / material.young_modulus - 1.0).abs() < 1e-15);
        let other = Material {
            poisson_ratio: 0.1,
            ..material
        };
        let of_bonds = Material {
            young_modulus: other.young_modulus_of_bonds(),
            ..material
        };
        let ratio = energy_of_hooke(&other) / energy_of_hooke(&of_bonds);
        assert!((ratio - 1.0).abs() < 1e-14, "{ratio}");
    }
}
