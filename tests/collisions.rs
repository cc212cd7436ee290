//! Collisions of two particles against closed forms of the outcome.

use crate::worlds::{advance, head, particle, world};
use approx::abs_diff_eq;
use gouge_dem::World;
use proptest::prelude::*;

const MASS: f64 = 1.130973355292325e-5; // 4/3 pi 2700 kg/m^3 (1 mm)^3

fn contact(stiffness: f64, damping: f64, more: &str) -> String {
    format!(
        "[contact]\n{more}\n[contact.normal]\nlaw = \"kelvin-voigt\"\n\
         stiffness = {stiffness:e}\ndamping = {damping:e}\n"
    )
}

/// Restitution of a truncated Kelvin-Voigt collision of equal spheres at 1 mm, by the kernel.
fn restitution(damping_ratio: f64) -> f64 {
    let stiffness = 1e7;
    let rate = (2.0 * stiffness / MASS).sqrt();
    let damping = damping_ratio * (2.0 * stiffness * MASS).sqrt();
    let step = 1e-5 / rate;
    let gap = 1e-3 - 1e-14;
    let text = head("velocity-verlet", step)
        + &contact(stiffness, damping, "")
        + &particle([-gap, 0.0], [0.5, 0.0], 0.0, 1e-3)
        + &particle([gap, 0.0], [-0.5, 0.0], 0.0, 1e-3);
    let mut world = world(&text);
    advance(&mut world, 800_000);
    let v = &world.particles().velocity;
    v[1].x - v[0].x
}

#[test]
fn restitution_of_truncated_kelvin_voigt_matches_the_closed_form() {
    // exp(-beta t), where t is the first zero of the force; evaluated to twelve digits independently.
    let table = [
        (0.05, 0.858758101775),
        (0.1, 0.744079397722),
        (0.3, 0.450975452893),
        (0.664903801, 0.222769627052),
        (0.9, 0.155282747502),
        (0.99, 0.137157344298),
    ];
    for (ratio, expected) in table {
        let found = restitution(ratio);
        // The beginning of the contact is detected up to one step late: the relative error is below the step in units
        // of 1/w, 1e-5, times the damping ratio. The integrator itself contributes 1e-10.
        assert!(
            abs_diff_eq!(found / expected, 1.0, epsilon = 3e-5),
            "{ratio}: {found}, {expected}"
        );
    }
}

#[test]
fn separate_particles_do_not_feel_each_other_while_they_approach() {
    // Taken literally, (36) would push this pair apart: damping times approach speed exceeds the negative spring force.
    let text = head("euler", 1e-9)
        + &contact(1e7, 10.0, "")
        + &particle([-1.1e-3, 0.0], [1.0, 0.0], 0.0, 1e-3)
        + &particle([1.1e-3, 0.0], [-1.0, 0.0], 0.0, 1e-3);
    let mut world = world(&text);
    advance(&mut world, 1000);
    assert_eq!(world.particles().velocity[0].x, 1.0);
}

fn momenta(world: &World) -> (f64, f64, f64) {
    let p = world.particles();
    let mut sums = (0.0, 0.0, 0.0);
    for i in 0..p.len() {
        let (m, x, v) = (p.mass[i], p.position[i], p.velocity[i]);
        sums.0 += m * v.x;
        sums.1 += m * v.y;
        sums.2 += m * x.cross(v) + p.moment_of_inertia[i] * p.angular_velocity[i];
    }
    sums
}

const LAWS: [&str; 3] = [
    "law = \"haff-werner\"\nfriction = 0.6\ndamping = 3.0\n",
    "law = \"cundall-strack\"\nfriction = 0.6\nstiffness = 3e6\n",
    "law = \"cundall-strack-truncated\"\nfriction = 0.6\nstiffness = 3e6\n",
];

/// Two spheres of different sizes that overlap, slide and spin.
fn sliding_pair(reading: &str, distance: &str, law: &str, x: f64, y: f64, spin: f64) -> String {
    format!("reading = \"{reading}\"\n")
        + &head("symplectic-euler", 1e-9)
        + &contact(1e7, 1.0, &format!("distance = \"{distance}\""))
        + &format!("[contact.tangential]\n{law}")
        + &particle([0.0, 0.0], [3.0, -1.0], spin, 1e-3)
        + &particle([x, y], [-2.0, 1.5], -0.3 * spin, 1.7e-3)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn contacts_conserve_momentum_and_angular_momentum(
        law in 0_usize..3,
        distance in prop::sample::select(vec!["radius", "focal", "mean"]),
        angle in 0.0..std::f64::consts::TAU,
        depth in 0.02..0.3,
        spin in -2000.0..2000.0,
    ) {
        let reach = (1.0 - depth) * 2.7e-3;
        let (x, y) = (reach * angle.cos(), reach * angle.sin());
        let mut world = world(&sliding_pair("corrected", distance, LAWS[law], x, y, spin));
        let before = momenta(&world);
        advance(&mut world, 300);
        let after = momenta(&world);
        // Scales: total |m v| is about 2e-4 kg m/s, times 3 mm; 300 steps with a few rounding errors each.
        prop_assert!(abs_diff_eq!(after.0, before.0, epsilon = 1e-17));
        prop_assert!(abs_diff_eq!(after.1, before.1, epsilon = 1e-17));
        let (old, new) = (before.2, after.2);
        prop_assert!(abs_diff_eq!(new, old, epsilon = 1e-19), "{old} {new}");
    }
}

#[test]
fn the_thesis_reading_loses_angular_momentum_as_stated() {
    // dL/dt = (d_ij + d_ji - D) F_t: the defect of the printed torque (thesis E10).
    let mut world = world(&sliding_pair(
        "thesis", "radius", LAWS[0], 2.5e-3, 0.0, 500.0,
    ));
    let mut expected = 0.0;
    let before = momenta(&world).2;
    for _ in 0..200 {
        let links = world.interactions();
        if let Some(link) = links.first() {
            expected += link.normal_displacement * link.tangential_force * 1e-9;
        }
        advance(&mut world, 1);
    }
    let lost = momenta(&world).2 - before;
    assert!(expected.abs() > 1e-12);
    assert!(
        abs_diff_eq!(lost / expected, 1.0, epsilon = 1e-6),
        "{lost}, {expected}"
    );
}

#[test]
fn opposite_spins_of_equal_spheres_change_neither_spins_nor_directions() {
    // Test 7 of Chung and Ooi: the contact does not slip, so spins and directions do not change at all.
    for law in LAWS {
        for k in 1..=17 {
            let spin = 2.0 * (f64::from(k) * std::f64::consts::PI / 36.0).tan();
            let text = head("velocity-verlet", 1e-7)
                + &contact(1e6, 100.0, "")
                + &format!("[contact.tangential]\n{law}")
                + &particle([-0.1, 0.0], [0.2, 0.0], spin, 0.1)
                + &particle([0.1, 0.0], [-0.2, 0.0], -spin, 0.1);
            let mut world = world(&text);
            advance(&mut world, 2000);
            let p = world.particles();
            assert_eq!(
                [p.angular_velocity[0], p.angular_velocity[1]],
                [spin, -spin],
                "{law}"
            );
            assert_eq!([p.velocity[0].y, p.velocity[1].y], [0.0, 0.0], "{law}");
        }
    }
}

#[test]
fn rolling_without_slip_builds_up_no_tangential_displacement() {
    // A sphere rolls without slip around a fixed one, several times: a wrapped angle would jump.
    let radii = [3e-3, 1e-3];
    let reach = 0.999 * (radii[0] + radii[1]);
    let orbit = 40.0;
    let (speed, spin) = (orbit * reach, orbit * (radii[0] + radii[1]) / radii[1]);
    let text = head("velocity-verlet", 1e-6)
        + &contact(1e-6, 0.0, "")
        + "[contact.tangential]\nlaw = \"cundall-strack-truncated\"\nfriction = 1e9\nstiffness = 1e-9\n"
        + &format!(
            "[[particles]]\nposition = [0.0, 0.0]\nradius = {:e}\nrole = \"fixed\"\n",
            radii[0]
        )
        + &particle([reach, 0.0], [0.0, speed], spin, radii[1]);
    let mut world = world(&text);
    // The contact is far too weak to bend the path, so only a few steps along chords of the circle are taken.
    advance(&mut world, 20);
    let link = world.interactions()[0];
    let slip: f64 = link.tangential_displacement.iter().sum();
    let path = orbit * radii[0] * 20e-6;
    assert!(
        (slip / path).abs() < 1e-3,
        "{slip} against a path of {path}"
    );
}
