//! Collisions of two particles against closed forms of the outcome.

use crate::worlds::{advance, world};
use approx::abs_diff_eq;
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{CundallStrackTruncated, KelvinVoigt};
use gouge_validation::scenes::{Draft, Grain};
use proptest::prelude::*;

const MASS: f64 = 1.130973355292325e-5; // 4/3 pi 2700 kg/m^3 (1 mm)^3

fn contact(stiffness: f64, damping: f64) -> Draft {
    Draft::empty().law(KelvinVoigt { stiffness, damping })
}

/// Restitution of a truncated Kelvin-Voigt collision of equal spheres at 1 mm, by the kernel.
fn restitution(damping_ratio: f64) -> f64 {
    let stiffness = 1e7;
    let rate = (2.0 * stiffness / MASS).sqrt();
    let damping = damping_ratio * (2.0 * stiffness * MASS).sqrt();
    let step = 1e-5 / rate;
    let gap = 1e-3 - 1e-14;
    let draft = Draft::open_box(Integrator::VelocityVerlet, step)
        .and(&contact(stiffness, damping))
        .grain(Grain::at([-gap, 0.0], 1e-3).moving([0.5, 0.0]))
        .grain(Grain::at([gap, 0.0], 1e-3).moving([-0.5, 0.0]));
    let mut world = world(&draft);
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
    // Literally (36) would push this pair apart: damping times approach exceeds the negative spring.
    let draft = Draft::open_box(Integrator::Euler, 1e-9)
        .and(&contact(1e7, 10.0))
        .grain(Grain::at([-1.1e-3, 0.0], 1e-3).moving([1.0, 0.0]))
        .grain(Grain::at([1.1e-3, 0.0], 1e-3).moving([-1.0, 0.0]));
    let mut world = world(&draft);
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

/// Laws of friction with their damping or stiffness.
const LAWS: [(&str, f64); 3] = [
    ("haff-werner", 3.0),
    ("cundall-strack", 3e6),
    ("cundall-strack-truncated", 3e6),
];

/// Two spheres of different size that overlap, slide and spin.
fn sliding_pair(
    reading: &str,
    distance: &str,
    law: (&str, f64),
    x: f64,
    y: f64,
    spin: f64,
) -> Draft {
    Draft::open_box(Integrator::SymplecticEuler, 1e-9)
        .reading(reading)
        .with("contact.distance", distance)
        .and(&contact(1e7, 1.0))
        .friction(law.0, 0.6, law.1)
        .grain(
            Grain::at([0.0, 0.0], 1e-3)
                .moving([3.0, -1.0])
                .spinning(spin),
        )
        .grain(
            Grain::at([x, y], 1.7e-3)
                .moving([-2.0, 1.5])
                .spinning(-0.3 * spin),
        )
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
            let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-7)
                .and(&contact(1e6, 100.0))
                .friction(law.0, 0.6, law.1)
                .grain(
                    Grain::at([-0.1, 0.0], 0.1)
                        .moving([0.2, 0.0])
                        .spinning(spin),
                )
                .grain(
                    Grain::at([0.1, 0.0], 0.1)
                        .moving([-0.2, 0.0])
                        .spinning(-spin),
                );
            let mut world = world(&draft);
            advance(&mut world, 2000);
            let p = world.particles();
            assert_eq!(
                [p.angular_velocity[0], p.angular_velocity[1]],
                [spin, -spin],
                "{law:?}"
            );
            assert_eq!([p.velocity[0].y, p.velocity[1].y], [0.0, 0.0], "{law:?}");
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
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-6)
        .and(&contact(1e-6, 0.0))
        .law(CundallStrackTruncated {
            friction: 1e9,
            stiffness: 1e-9,
        })
        .grain(Grain::at([0.0, 0.0], radii[0]).fixed())
        .grain(
            Grain::at([reach, 0.0], radii[1])
                .moving([0.0, speed])
                .spinning(spin),
        );
    let mut world = world(&draft);
    // The link is far too weak to bend the path, so follow the circle by stepping along chords of it.
    advance(&mut world, 20);
    let link = world.interactions()[0];
    let slip: f64 = link.tangential_displacement.iter().sum();
    let path = orbit * radii[0] * 20e-6;
    assert!(
        (slip / path).abs() < 1e-3,
        "{slip} against a path of {path}"
    );
}
