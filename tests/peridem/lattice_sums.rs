//! Answers of lattices against sums over their neighbours.

use crate::cloud::{H, at_rest, forces, grain, lattice, material, settings};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::energy::Energies;
use gouge_peridem::grain::Grains;
use gouge_peridem::material::{BondConstants, Weight};
use gouge_peridem::observables::grain_stress;
use gouge_peridem::state::State;

const BOTH: [Weight; 2] = [Weight::Constant, Weight::Conic];

/// Offsets to all neighbours of a node, in lattice distances.
fn offsets(ratio: f64) -> impl Iterator<Item = Vec2> {
    let reach = ratio.floor() as i32;
    let axis = move || (-reach..=reach).map(f64::from);
    let all = axis().flat_map(move |y| axis().map(move |x| Vec2::new(x, y)));
    all.filter(move |arm| arm.norm() > 0.0 && arm.norm() <= ratio)
}

fn constants(weight: Weight, ratio: f64) -> BondConstants {
    material().bond_constants(weight, ratio * H).unwrap()
}

/// Moduli C11, C12 and C66 in Pa of an endless lattice.
fn moduli(weight: Weight, ratio: f64) -> [f64; 3] {
    let bonds = constants(weight, ratio);
    let mut sums = [0.0; 3];
    for arm in offsets(ratio) {
        let r = arm.norm();
        let (x, y) = (arm.x / r, arm.y / r);
        let half = 0.5 * bonds.stiffness * weight.at(r * H, ratio * H) * r * H * H * H;
        for (sum, moment) in sums
            .iter_mut()
            .zip([x * x * x * x, x * x * y * y, x * x * y * y])
        {
            *sum += half * moment;
        }
    }
    sums
}

/// Energy density of a lattice stretched by a map of displacements, without its edges: the mixed second difference of the
/// energies of four rectangles.
fn energy_density(weight: Weight, ratio: f64, map: impl Fn(Vec2) -> Vec2) -> f64 {
    let n = ratio.ceil() as usize + 1;
    let of = |columns, rows| {
        let (grains, mut state) = at_rest(&[grain(lattice(columns, rows), ratio, weight)]);
        for place in &mut state.places {
            place.displacement = map(place.reference);
        }
        Energies::of(&grains, &state, Vec2::zero()).bonds
    };
    (of(n + 1, n + 1) - of(n + 1, n) - of(n, n + 1) + of(n, n)) / (H * H)
}

#[test]
fn dilation_has_the_energy_of_the_lattice_sum() {
    let printed = [
        (
            Weight::Constant,
            [(3.015, 1.025), (4.015, 0.952), (8.0, 0.970)],
        ),
        (
            Weight::Conic,
            [(3.015, 0.958), (4.015, 0.984), (8.0, 0.997)],
        ),
    ];
    for (weight, rows) in printed {
        for (ratio, expected) in rows {
            let ratio = ratio * (1.0 + 1e-12);
            let [c11, c12, _] = moduli(weight, ratio);
            let density = energy_density(weight, ratio, |at| at * 1e-3) / 1e-6;
            let error = density / (c11 + c12) - 1.0;
            assert!(error.abs() < 1e-11, "{weight:?} {ratio}: {error:e}");
            let continuum = material().young_modulus / (1.0 - 1.0 / 3.0);
            let found = density / continuum;
            assert!(
                (found - expected).abs() < 1e-3,
                "{weight:?} {ratio}: {found}"
            );
        }
    }
}

#[test]
fn moduli_are_those_of_the_lattice_sums() {
    let e = 1e-5;
    for (weight, ratio) in BOTH.iter().flat_map(|&w| [3.015, 4.015].map(|m| (w, m))) {
        let mean = |map: fn(Vec2) -> Vec2| {
            let of = |sign: f64| energy_density(weight, ratio, |at| map(at) * (sign * e));
            (of(1.0) + of(-1.0)) / (e * e)
        };
        let [c11, c12, c66] = moduli(weight, ratio);
        let long = mean(|at| Vec2::new(at.x, 0.0));
        let shear = mean(|at| Vec2::new(at.x, -at.y)) / 2.0;
        let angle = mean(|at| Vec2::new(0.5 * at.y, 0.5 * at.x));
        for (found, expected) in [(long, c11), (shear, c11 - c12), (angle, c66)] {
            let error = found / expected - 1.0;
            assert!(error.abs() < 1e-9, "{weight:?} {ratio}: {error:e}");
        }
    }
}

#[test]
fn a_plane_wave_has_the_frequencies_of_the_lattice_sum() {
    let ratio = 3.015;
    for (weight, wave) in BOTH
        .iter()
        .flat_map(|&w| [(0.3, 0.1), (1.1, -2.3), (3.1, 0.7)].map(|k| (w, k)))
    {
        let wave = Vec2::new(wave.0 / H, wave.1 / H);
        let (grains, state) = at_rest(&[grain(lattice(9, 9), ratio, weight)]);
        let centre = grains.position[40];
        for way in [Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)] {
            let size = 1e-6 * H;
            let moved = |sign: f64| {
                let mut state = state.clone();
                for place in &mut state.places {
                    let phase = wave.dot(place.reference - centre);
                    place.displacement = way * (sign * size * phase.cos());
                }
                forces(&grains, &settings(1e-8), &state)[40]
            };
            let found = (moved(-1.0) - moved(1.0)) * (0.5 / size);
            let mut sum = Vec2::zero();
            for arm in offsets(ratio) {
                let (r, n) = (arm.norm() * H, arm * (1.0 / arm.norm()));
                let c = constants(weight, ratio).stiffness * weight.at(r, ratio * H) * H * H / r;
                sum += n * (n.dot(way) * c * (1.0 - (wave.dot(arm) * H).cos()));
            }
            let error = (found - sum).norm() / sum.norm();
            assert!(error < 1e-8, "{weight:?} {wave:?}: {error:e}");
        }
    }
}

/// Energy in J/m^2 of the bonds that cross a line, all stretched by the critical stretch.
fn fracture_energy(weight: Weight, ratio: f64) -> f64 {
    let rows = 2 * ratio.ceil() as usize;
    let line = (rows as f64 / 2.0 - 0.5) * H;
    let of = |columns| {
        let grains = Grains::new(&[grain(lattice(columns, rows), ratio, weight)]).unwrap();
        let crosses = |_, a: Vec2, b: Vec2| (a.y < line) != (b.y < line);
        let bonds = Bonds::within_horizon(&grains, crosses).unwrap();
        let stretch = grains.rows[0].constants.critical_stretch;
        let mut state = State::at_rest(&grains, bonds);
        for place in &mut state.places {
            place.displacement = place.reference * stretch;
        }
        Energies::of(&grains, &state, Vec2::zero()).bonds
    };
    (of(rows + 1) - of(rows)) / H
}

#[test]
fn separation_of_a_lattice_costs_its_own_fracture_energy() {
    let printed = [
        (Weight::Constant, [(3.0, 1.026), (4.0, 0.929), (8.0, 0.959)]),
        (Weight::Conic, [(3.0, 0.933), (4.0, 0.973), (8.0, 0.992)]),
    ];
    for (weight, rows) in printed {
        for (ratio, expected) in rows {
            let ratio = ratio * (1.0 + 1e-12);
            let found = fracture_energy(weight, ratio);
            // Bonds that cross the line: as many per length as their rise has lattice distances.
            let bonds = constants(weight, ratio);
            let s0 = bonds.critical_stretch;
            let upwards = offsets(ratio).filter(|arm| arm.y > 0.0);
            let energy = |arm: Vec2| {
                let r = arm.norm() * H;
                arm.y * 0.5 * bonds.stiffness * weight.at(r, ratio * H) * s0 * s0 * r * H.powi(3)
            };
            let sum: f64 = upwards.map(energy).sum();
            assert!((found / sum - 1.0).abs() < 1e-10, "{weight:?} {ratio}");
            let found = found / material().fracture_energy;
            assert!(
                (found - expected).abs() < 1e-3,
                "{weight:?} {ratio}: {found}"
            );
        }
    }
}

#[test]
fn stress_is_the_derivative_of_the_energy() {
    let (grains, mut state) = at_rest(&[grain(lattice(7, 5), 3.015, Weight::Conic)]);
    let area = grains.area.iter().sum::<f64>();
    let base = |at: Vec2| Vec2::new(0.02 * at.x + 0.01 * at.y, -0.013 * at.y);
    let mut energy = |row: usize, column: usize, strain: f64| {
        for place in &mut state.places {
            // A small strain of the deformed grain.
            let now = place.reference + base(place.reference);
            let extra = if column == 0 { now.x } else { now.y } * strain;
            let extra = if row == 0 {
                Vec2::new(extra, 0.0)
            } else {
                Vec2::new(0.0, extra)
            };
            place.displacement = base(place.reference) + extra;
        }
        Energies::of(&grains, &state, Vec2::zero()).bonds
    };
    let mut slopes = [0.0; 4];
    for (k, slope) in slopes.iter_mut().enumerate() {
        let e = 1e-5;
        *slope = (energy(k / 2, k % 2, e) - energy(k / 2, k % 2, -e)) / (2.0 * e * area);
    }
    energy(0, 0, 0.0);
    let stress = grain_stress(&grains, &state, 0);
    for (found, slope) in [stress.xx, stress.xy, stress.yx, stress.yy]
        .iter()
        .zip(slopes)
    {
        assert!(
            (found - slope).abs() < 1e-7 * slopes[0].abs(),
            "{found} {slope}"
        );
    }
    assert!((stress.xy - stress.yx).abs() < 1e-12 * stress.xx && stress.xx > 0.0);
    assert!(!state.bonds.are_bonded(Pair::new(0, 34)));
}
