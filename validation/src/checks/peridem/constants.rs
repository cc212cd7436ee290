//! Constants of bonds, and the energies of lattices.

use super::grains::{MATERIAL, WEIGHTS, block, bonds_only, cloud, world};
use crate::checks::{Check, Effort, Exhibit, Measurement, Origin, Outcome, Table, peridem};
use crate::oracles::peridem::{WEIGHTS as FUNCTIONS, constants};
use gouge_common::geometry::Vec2;
use gouge_peridem::grain::Grains;
use gouge_peridem::material::{Material, Plane};
use gouge_peridem::state::State;

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "peridem.constants.quadrature",
            claim: "Stiffness and critical stretch belong to the same weight: an isotropic stretch has the energy of an elastic plate, and it costs the fracture energy to cut all bonds across a line.",
            equations: peridem("(3.2), section 3.1"),
            scene: "Three weights, plane stress and plane strain, horizons from 0.1 mm to 1 m",
            oracle: "Quadrature of the two definitions over the horizon",
            norm: "Largest relative error",
            origin: Origin::Exact,
            reason: "The quadrature has an error of 1e-13",
            effort: Effort::Quick,
            measure: quadrature,
        },
        Check {
            id: "peridem.constants.lattice",
            claim: "The energy of a stretched block of nodes is the sum over all pairs within the horizon; inside a lattice it differs from that of the continuum by several per cent.",
            equations: peridem("(3.2), section 3.1"),
            scene: "Blocks of 17 x 17 to 33 x 33 square cells under an isotropic stretch of 1e-3, horizons of 3.015, 4.015 and 8.015 cells, three weights",
            oracle: "Sums over all pairs by lengths before and after",
            norm: "Largest relative error of the energy of the block",
            origin: Origin::Exact,
            reason: "The oracle subtracts lengths, 2e-16, for a stretch of 1e-3: 2e-13, squared 4e-13 per bond, with random signs over thousands of bonds",
            effort: Effort::Quick,
            measure: lattice,
        },
    ]
}

fn quadrature() -> Outcome {
    let mut all = Vec::new();
    let strain = Material {
        poisson_ratio: 0.25,
        plane: Plane::Strain,
        ..MATERIAL
    };
    for material in [MATERIAL, strain] {
        let nu = material.poisson_ratio;
        let modulus = match material.plane {
            Plane::Stress => material.young_modulus / (1.0 - nu),
            Plane::Strain => material.young_modulus / ((1.0 + nu) * (1.0 - 2.0 * nu)),
        };
        for (weight, (_, function)) in WEIGHTS.into_iter().zip(FUNCTIONS) {
            for horizon in [1e-4, 5e-4, 0.03, 1.0] {
                let found = material.bond_constants(weight, horizon)?;
                let stiffness = constants::stiffness(modulus, horizon, function);
                let release = material.fracture_energy;
                let critical = constants::critical_stretch(release, stiffness, horizon, function);
                all.push(Measurement::relative(stiffness, found.stiffness, 1e-12));
                all.push(Measurement::relative(
                    critical,
                    found.critical_stretch,
                    1e-12,
                ));
            }
        }
    }
    Ok(Measurement::worst(all).into())
}

fn lattice() -> Outcome {
    const STRETCH: f64 = 1e-3;
    const SIDE: f64 = 1e-3;
    let mut table = Table::new(
        "Energy of an isotropic stretch at a node inside a square lattice, over that of the continuum",
        &["horizon over spacing", "constant", "conic", "parabolic"],
    );
    let mut all = Vec::new();
    for ratio in [3.015, 4.015, 8.015] {
        let cells = 2 * (ratio as usize) + 11;
        let mut row = vec![format!("{ratio}")];
        for (weight, (_, function)) in WEIGHTS.into_iter().zip(FUNCTIONS) {
            let grain = block([cells; 2], SIDE, ratio, weight)?;
            let stretched = |[x, y]: [f64; 2]| [STRETCH * x, STRETCH * y];
            let expected = cloud(&grain, function).energy(stretched);
            let mut state = world(std::slice::from_ref(&grain), bonds_only(1e-9), |_, _| {
                Vec2::zero()
            })?
            .state()
            .clone();
            for place in &mut state.places {
                place.displacement = place.reference * STRETCH;
            }
            let grains = Grains::new(&[grain])?;
            let found = energy_of(&grains, &state);
            all.push(Measurement::relative(expected, found, 1e-12));
            let modulus = MATERIAL.young_modulus / (1.0 - MATERIAL.poisson_ratio);
            let middle = (cells / 2) * (cells + 1);
            let inside = node_energy(&grains, &state, middle);
            row.push(format!("{:.4}", inside / (modulus * STRETCH * STRETCH)));
        }
        table.push(row);
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn energy_of(grains: &Grains, state: &State) -> f64 {
    gouge_peridem::energy::Energies::of(grains, state, Vec2::zero()).bonds
}

/// Half of the energy of the bonds of a node over its area, in J/m^3.
fn node_energy(grains: &Grains, state: &State, node: usize) -> f64 {
    let constants = &grains.of(node).constants;
    let of_bond = |(earlier, later, length): (usize, usize, f64)| {
        let other = match node {
            _ if earlier == node => later,
            _ if later == node => earlier,
            _ => return 0.0,
        };
        let elongation = state.places[earlier].elongation_to(state.places[later], length);
        0.5 * elongation.energy(constants) * grains.area[other]
    };
    state.bonds.all().map(of_bond).sum()
}
