//! Constants of bonds against the integrals that define them.

use crate::quadrature::integrate;
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
