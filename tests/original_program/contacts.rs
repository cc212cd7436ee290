//! Contacts.

use super::{BOX, EACH_RUBBING, RULES, STABLE, Twins, check, grain, replay};
use gouge_validation::oracles::original::{Grain, Original, Rubbing, Rules, Spring};
use std::f64::consts::TAU;

/// Two unequal grains with a gap between them at an angle, on a line through `x`, with velocities along the line of
/// centres and across, and spins.
fn approaching(x: f64, gap: f64, [closing, across]: [f64; 2], spins: [f64; 2]) -> Vec<Grain> {
    let (normal, [r, s]) = ([0.4_f64.cos(), 0.4_f64.sin()], [1.1e-3, 0.85e-3]);
    let reach = r + s + gap;
    let along = |a: f64, b: f64| [a * normal[0] - b * normal[1], a * normal[1] + b * normal[0]];
    let mut first = grain([x, 5e-3], r);
    let offset = along(reach, 0.0);
    let mut second = grain([(x + offset[0]).rem_euclid(BOX), 5e-3 + offset[1]], s);
    first.v = along(0.5 * closing, 0.5 * across);
    second.v = along(-0.5 * closing, -0.5 * across);
    (first.omega, second.omega) = (spins[0], spins[1]);
    // Large angles from earlier rotation, which must cancel.
    (first.phi, second.phi) = (7.5, -11.0);
    vec![first, second]
}

#[test]
fn collisions_follow_the_original_program() {
    // In the last motion the grains are initially too far apart to be in the neighbour list.
    let motions = [
        ("head on", 2e-8, [2.0, 0.0], [0.0; 2]),
        ("oblique, sticking", 2e-8, [2.0, 0.2], [150.0, -60.0]),
        ("oblique, sliding", 2e-8, [1.5, -3.0], [4e3, 2.5e3]),
        ("from afar", 1.2e-3, [200.0, 1.0], [4e3, 0.0]),
    ];
    for rubbing in EACH_RUBBING {
        for (place, x) in [
            ("inside", 10e-3),
            ("at the periodic boundary", BOX - 0.4e-3),
        ] {
            for (motion, gap, velocity, spins) in motions {
                let grains = approaching(x, gap, velocity, spins);
                let rules = Rules {
                    rubbing,
                    period: Some(BOX),
                    ..RULES
                };
                let run = replay(Twins::new(Original::new(rules, grains), false), 1000);
                assert!(
                    (20..900).contains(&run.touching),
                    "the grains collide and separate"
                );
                let turns = (run.twins.oracle.grains[0].omega - spins[0]).abs() > 1e-6;
                assert!(
                    turns == (rubbing != Rubbing::Zero && motion != "head on"),
                    "{motion}"
                );
                check(&format!("{rubbing:?}, {place}, {motion}"), &run, STABLE);
            }
        }
    }
}

/// A ring of soft unequal grains, compressed by the periodic box and held at one height, that turn like gears.
fn gears(rubbing: Rubbing) -> Original {
    let radii = [1e-3, 0.7e-3, 1.1e-3, 0.8e-3];
    let soft = Spring {
        k: 1e4,
        gamma: 0.02,
    };
    let (mut x, mut grains) = (0.0, Vec::new());
    for (r, turn) in radii.into_iter().zip([1.0, -1.0, 1.01, -0.98]) {
        let mut gear = grain([x + r, 1e-3 * r], r);
        gear.omega = 20.0 * turn / r;
        x += 2.0 * r;
        grains.push(gear);
    }
    let well = Some([1e4, 0.0]);
    let period = Some(0.97 * x);
    grains.iter_mut().for_each(|gear| gear.x[0] *= 0.97);
    Original::new(
        Rules {
            dt: 2e-7,
            period,
            touch: soft,
            rubbing,
            well,
            ..RULES
        },
        grains,
    )
}

#[test]
fn rolling_contacts_follow_the_original_program() {
    let soft = [
        Rubbing::HaffWerner {
            mu: 0.7,
            gamma: 0.05,
        },
        Rubbing::CundallStrack { mu: 0.7, k: 1e4 },
    ];
    for rubbing in soft {
        let steps = 5_000;
        let run = replay(Twins::new(gears(rubbing), true), steps);
        assert_eq!(run.touching, steps, "the contacts never end");
        for gear in &run.twins.oracle.grains {
            assert!(
                gear.phi.abs() > 2.0 * TAU,
                "each turns more than twice: {}",
                gear.phi
            );
        }
        check(&format!("gears, {rubbing:?}"), &run, STABLE);
    }
}

#[test]
fn contacts_begun_earlier_follow_the_original_program() {
    // Since then both ends have rotated by an angle, or by an angle and whole turns. In the last case the grains are at
    // rest, so that the direction of sliding is undefined.
    let cases = [
        ("sticks", [1.0, 0.5], [30.0, -20.0], [1e-4, -3e-4]),
        ("slid", [1.0, 0.5], [3e3, -1e3], [0.1, 0.2]),
        ("at rest", [0.0; 2], [0.0; 2], [0.1, -0.02]),
    ];
    for rubbing in EACH_RUBBING {
        for (name, velocity, spins, turned) in cases {
            let grains = approaching(BOX - 0.4e-3, -1e-4, velocity, spins);
            let rules = Rules {
                rubbing,
                period: Some(BOX),
                ..RULES
            };
            let mut oracle = Original::new(rules, grains);
            oracle.bond((0, 1), 1.0);
            let psi = oracle.bonds.remove(&(0, 1)).expect("just bonded").psi;
            let psi = [psi[0] - turned[0] - TAU, psi[1] - turned[1] + 2.0 * TAU];
            oracle.contacts.insert((0, 1), psi);
            let run = replay(Twins::new(oracle, false), 1000);
            check(
                &format!("contact begun earlier, {name}, {rubbing:?}"),
                &run,
                STABLE,
            );
        }
    }
}

/// Three grains that rotate as a whole: two are bonded to the third and have a frictional contact with each other.
#[test]
fn whirling_contacts_follow_the_original_program() {
    let soft = [
        Rubbing::HaffWerner {
            mu: 0.7,
            gamma: 1.0,
        },
        Rubbing::CundallStrack { mu: 0.7, k: 1e6 },
    ];
    for rubbing in soft {
        let spin = 1e5;
        let mut grains = vec![
            grain([-0.8e-3, 0.0], 1e-3),
            grain([0.8e-3, 0.1e-3], 0.85e-3),
            grain([0.0, 1.6e-3], 0.9e-3),
        ];
        for grain in &mut grains {
            grain.v = [-spin * (grain.x[1] - 0.5e-3), spin * grain.x[0]];
            grain.omega = spin;
        }
        grains[0].omega *= 0.99;
        let mut oracle = Original::new(Rules { rubbing, ..RULES }, grains);
        oracle.bond((0, 2), 1.0);
        oracle.bond((1, 2), 1.0);
        let run = replay(Twins::new(oracle, true), 20_000);
        assert_eq!(run.touching, 20_000, "the contacts never end");
        assert!(
            run.twins.oracle.grains[0].phi > 2.5 * TAU,
            "the group turns more than twice"
        );
        check(&format!("whirl, {rubbing:?}"), &run, STABLE);
    }
}
