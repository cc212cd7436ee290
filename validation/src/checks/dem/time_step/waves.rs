//! Bounds from waves and cracks, compared with the stability limits of modes.

use super::modes::{Mode, mass};
use crate::checks::{Check, Effort, Exhibit, Measurement, Origin, Outcome, Table, thesis};
use crate::oracles::amplification::{Method, boundary};
use gouge_dem::integrators::{crack_bound, wave_bound};
use gouge_dem::material::{Elastic, GRANITE};
use gouge_dem::setup::SizeRange;

/// The checks of this file.
pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "time-step.waves",
        claim: "Waves cross a grain of 1 mm of the thesis's granite in 435 ns, and cracks at Mach 15 in 29.0 ns, in 24.0 ns for the smallest grain, and in 16.6 ns for the smallest grain with the naive upper wave speed of 6.7 km/s. None of these is the printed 18 ns.",
        equations: thesis("(59)-(62), (66)"),
        scene: "Young's moduli of 30, 50 and 70 GPa, Poisson's ratios from 0.1 to 0.34, densities of 2.6 to 2.8 Mg/m^3, radii of 1 mm and of the smallest grain",
        oracle: "Speeds from Lame's constants: c_P^2 = (lambda + 2 mu)/rho, c_S^2 = mu/rho; the table also shows the printed value",
        norm: "Largest relative error of a speed or a bound; the four quoted values to the digits quoted",
        origin: Origin::Exact,
        reason: "About ten roundings each, amplified by 1 - 2 nu and halved by the square root: 32 roundings",
        effort: Effort::Quick,
        measure: waves,
    }]
}

/// Mach number of cracks in thesis section 4.2.
const MACH: f64 = 15.0;

/// Speeds of primary and secondary waves in m/s.
fn speeds(young: f64, poisson: f64, density: f64) -> [f64; 2] {
    let mu = young / (2.0 + 2.0 * poisson);
    let lambda = 2.0 * mu * poisson / (1.0 - 2.0 * poisson);
    [
        ((lambda + 2.0 * mu) / density).sqrt(),
        (mu / density).sqrt(),
    ]
}

fn waves() -> Outcome {
    let smallest = 1e-3 * 2.0 / (1.0 + 2.0_f64.sqrt());
    let mut all = vec![Measurement::relative(
        smallest,
        SizeRange::around(1e-3).minimum,
        4.0 * f64::EPSILON,
    )];
    let tolerance = 32.0 * f64::EPSILON;
    for youngs_modulus in [30e9, 50e9, 70e9] {
        for poissons_ratio in [0.1, 0.22, 0.34] {
            let elastic = Elastic {
                youngs_modulus,
                poissons_ratio,
            };
            for density in [2.6e3, 2.7e3, 2.8e3] {
                let [p, s] = speeds(youngs_modulus, poissons_ratio, density);
                let mut compare = |expected, found| {
                    all.push(Measurement::relative(expected, found, tolerance));
                };
                compare(p, elastic.primary_wave_speed(density));
                compare(s, elastic.secondary_wave_speed(density));
                for r in [1e-3, smallest] {
                    compare(2.0 * r / p, wave_bound(elastic, density, r));
                    let crack = 2.0 * r / (MACH * p);
                    compare(crack, crack_bound(elastic, density, r, MACH));
                }
            }
        }
    }
    let elastic = GRANITE.elastic();
    let density = GRANITE.density.value;
    let naive = largest_moduli();
    let quoted = [
        (435.0, wave_bound(elastic, density, 1e-3), 0.5),
        (29.0, crack_bound(elastic, density, 1e-3, MACH), 0.05),
        (24.0, crack_bound(elastic, density, smallest, MACH), 0.05),
        (16.6, crack_bound(naive, 2.6e3, smallest, MACH), 0.05),
    ];
    all.extend(quoted.map(|(ns, bound, digit)| Measurement::absolute(ns, 1e9 * bound, digit)));
    Ok(Measurement::worst(all)
        .showing([Exhibit::Table(meaning(quoted.map(|(_, bound, _)| bound)))]))
}

/// The solid with the largest bulk modulus and the largest shear modulus allowed by the intervals 50 +-
/// 20 GPa and 0.22 +- 0.12, although no solid within them has both.
fn largest_moduli() -> Elastic {
    let (bulk, shear) = (70e9 / (3.0 * (1.0 - 0.68)), 70e9 / 2.2);
    Elastic {
        youngs_modulus: 9.0 * bulk * shear / (3.0 * bulk + shear),
        poissons_ratio: (3.0 * bulk - 2.0 * shear) / (6.0 * bulk + 2.0 * shear),
    }
}

/// The bounds, and the stability limits of the modes that the thesis integrates with explicit Euler.
fn meaning([wave, mean, small, smallest]: [f64; 4]) -> Table {
    let mut table = Table::new(
        "Bounds of the time step: waves and cracks in the solid, and modes of grains of 1 mm with the thesis's integrator",
        &["bound", "step in ns"],
    );
    let ns = |seconds: f64| format!("{:.1}", 1e9 * seconds);
    table.push(["primary wave across a grain (61)".to_owned(), ns(wave)]);
    table.push(["crack at Mach 15 (62)".to_owned(), ns(mean)]);
    table.push(["the same, smallest grain".to_owned(), ns(small)]);
    table.push([
        "the same, with the largest wave speed".to_owned(),
        ns(smallest),
    ]);
    table.push(["printed".to_owned(), "18".to_owned()]);
    table.push(["step of the thesis".to_owned(), "10".to_owned()]);
    let euler = |mode: Mode, constants| boundary(Method::Euler, mode.rates(constants), 1e-13);
    let granite = [1e7, 10.0];
    for mode in [Mode::Squeezed, Mode::Axial, Mode::Shearing] {
        table.push([format!("Euler: {}", mode.name()), ns(euler(mode, granite))]);
    }
    table.push([
        format!("Euler: {}", Mode::Sticking.name()),
        "none".to_owned(),
    ]);
    let viscous = euler(Mode::Viscous, [0.0, 100.0]);
    table.push([format!("Euler: {}", Mode::Viscous.name()), ns(viscous)]);
    for contacts in [4.0, 6.0] {
        // All grains rotate alike: a slip velocity of 2 r w at each of z contacts, and a moment of
        // inertia of 2/5 m r^2.
        let rate = 5.0 * contacts * 100.0 / mass();
        let name = format!("Euler: all grains rotate alike, {contacts} viscous contacts each");
        table.push([name, ns(2.0 / rate)]);
    }
    table
}
