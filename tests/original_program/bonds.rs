//! Bonds.

use super::{EACH_RUBBING, RULES, STABLE, STRENGTH, Twins, check, grain, replay};
use gouge_validation::oracles::original::{Original, Rules, Spring};

/// A bonded pair of unequal grains with the given spins; the velocity of the second grain has components along and
/// across the line of centres.
fn bonded(rules: Rules, distance: f64, velocity: [f64; 2], spins: [f64; 2]) -> Original {
    let normal = [0.3_f64.cos(), -0.3_f64.sin()];
    let mut grains = vec![grain([4e-3, 6e-3], 1.15e-3), grain([0.0; 2], 0.9e-3)];
    grains[1].x = [4e-3 + distance * normal[0], 6e-3 + distance * normal[1]];
    let [a, b] = velocity;
    grains[1].v = [a * normal[0] - b * normal[1], a * normal[1] + b * normal[0]];
    (grains[0].omega, grains[1].omega) = (spins[0], spins[1]);
    (grains[0].phi, grains[1].phi) = (-2.0, 40.0);
    let mut oracle = Original::new(rules, grains);
    oracle.bond((0, 1), 1.0);
    oracle
}

#[test]
fn bonds_follow_the_original_program() {
    // In the last two motions each end makes many turns, so that angles wrap at different times.
    let motions = [
        ("stretched", [30.0, 0.0], [0.0; 2]),
        ("bent", [0.0; 2], [2e4, -2e4]),
        ("sheared", [0.0, 30.0], [0.0; 2]),
        ("all at once", [20.0, -10.0], [3e4, -1e4]),
        ("whirling", [0.0, 220.0], [1e5, 1e5]),
    ];
    for distance in [2.3e-3, 1.9e-3] {
        for (motion, velocity, spins) in motions {
            let steps = if motion == "whirling" { 40_000 } else { 3_000 };
            let now = replay(
                Twins::bonded_now(bonded(RULES, distance, velocity, spins)),
                steps,
            );
            check(&format!("bond, {motion}, {distance:?}"), &now, STABLE);
            let mut earlier = bonded(RULES, distance, velocity, spins);
            for bond in earlier.bonds.values_mut() {
                bond.length *= 0.998;
                bond.psi = [bond.psi[0] + 5e-3, bond.psi[1] - 8e-3];
            }
            let earlier = replay(Twins::new(earlier, false), steps);
            check(
                &format!("bond begun earlier, {motion}, {distance:?}"),
                &earlier,
                STABLE,
            );
            assert_eq!(earlier.touching, 0, "bonded pairs have no contact");
        }
    }
}

#[test]
fn bonds_turned_inside_out_follow_the_original_program() {
    // A bond so weak that its ends make several turns against it.
    let bend = Spring {
        k: 1e2,
        gamma: 1e-3,
    };
    let spins = [3e5, -2e5];
    let run = replay(
        Twins::new(
            bonded(Rules { bend, ..RULES }, 2.1e-3, [0.0, 10.0], spins),
            true,
        ),
        20_000,
    );
    let turns = run
        .twins
        .oracle
        .grains
        .iter()
        .map(|grain| grain.omega.abs())
        .collect::<Vec<_>>();
    assert!(turns.iter().all(|&omega| omega > 1e5), "{turns:?}");
    check("bond turned inside out", &run, STABLE);
}

#[test]
fn breaking_bonds_follow_the_original_program() {
    let weak_damping = Spring { k: 1e7, gamma: 1.0 };
    let cases = [
        ("tension", 2.05e-3, [150.0, 0.0], [0.0; 2], false),
        (
            "tension while touching",
            1.95e-3,
            [120.0, 5.0],
            [3e4, -1e4],
            true,
        ),
        ("compression", 2.05e-3, [-150.0, 2.0], [2e4, 5e4], true),
        ("shear", 2.2e-3, [0.0, 200.0], [0.0; 2], false),
        ("bending", 2.0e-3, [0.0, 0.0], [2e5, 1.5e5], true),
    ];
    for rubbing in EACH_RUBBING {
        for (name, distance, velocity, spins, touches) in cases {
            let (stretch, bend) = (weak_damping, weak_damping);
            let rules = Rules {
                rubbing,
                stretch,
                bend,
                strength: Some(STRENGTH),
                ..RULES
            };
            let run = replay(
                Twins::new(bonded(rules, distance, velocity, spins), true),
                1000,
            );
            assert_eq!(run.breaks.len(), 1, "{name}");
            assert!(run.breaks[0] > 2, "{name}: the bond must not break at once");
            assert_eq!(run.broken_into_contact == 1, touches, "{name}");
            check(
                &format!("{name} {rubbing:?}, broken at {:?}", run.breaks),
                &run,
                STABLE,
            );
        }
    }
}
