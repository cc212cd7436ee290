//! Equations without errata, tested with identities, derivatives and limits.

mod fields;

use crate::worlds::{advance, world};
use approx::{abs_diff_eq, assert_abs_diff_eq, assert_relative_eq, relative_eq};
use gouge_common::geometry::Vec2;
use gouge_dem::geometry::{
    Arm, FocalArm, MeanArm, PairFrame, PairMotion, angle_of, contact_area, contact_half_length,
    cylinder_contact_area, cylinder_displaced_volume, displaced_volume, focal_distance,
    overlap_factor, reversed,
};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, Controller, CundallStrackTruncated, EulerBernoulli, HaffWerner,
    KelvinVoigt, ZhangEckert,
};
use gouge_dem::material::GRANITE;
use gouge_dem::setup::{Fault, is_above};
use gouge_runner::scene::DrivingTable;
use gouge_validation::scenes::{Bond, Draft, Grain};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

proptest! {
    #[test]
    fn pair_frames_are_antisymmetric_and_right_handed(x in -2.0..2.0_f64, y in -2.0..2.0_f64) {
        let displacement = Vec2::<f64>::new(x, y);
        prop_assume!(displacement.norm() > 1e-3);
        let (there, back) = (PairFrame::new(displacement), PairFrame::new(-displacement));
        prop_assert_eq!(there.normal, -back.normal);
        prop_assert_eq!(there.tangent(), -back.tangent());
        prop_assert_eq!(there.normal.dot(there.tangent()), 0.0);
        prop_assert!(abs_diff_eq!(there.normal.cross(there.tangent()), 1.0, epsilon = 1e-15));
    }

    #[test]
    fn the_gradient_of_the_angle_is_the_perpendicular_over_the_square(
        x in -2.0..2.0_f64, y in -2.0..2.0_f64, u in -1.0..1.0_f64, v in -1.0..1.0_f64,
    ) {
        let (at, along) = (Vec2::<f64>::new(x, y), Vec2::<f64>::new(u, v));
        prop_assume!(at.norm() > 0.1 && (x > 0.1 || y.abs() > 0.1));
        let h = 1e-6;
        let slope = (angle_of(at + along * h) - angle_of(at - along * h)) / (2.0 * h);
        let motion = PairMotion::new(&PairFrame::new(at), along);
        // Third derivatives are below 2 / 0.1^3, so the error is below h^2 / 6 times that.
        let found = motion.frame_rate;
        prop_assert!(abs_diff_eq!(found, slope, epsilon = 1e-8), "{found} {slope}");
    }
}

#[test]
fn angles_on_the_axes_have_their_values() {
    let at = |x: f64, y: f64| angle_of(Vec2::new(x, y));
    assert_eq!(
        [at(1.0, 0.0), at(0.0, 1.0), at(0.0, -1.0)],
        [0.0, FRAC_PI_2, -FRAC_PI_2]
    );
    // The positive sign where the thesis allows both, zero where it defines no angle.
    assert_eq!([at(-1.0, 0.0), at(0.0, 0.0)], [PI, 0.0]);
    assert_eq!([reversed(0.0), reversed(PI)], [PI, 0.0]);
}

#[test]
fn the_displaced_volume_loses_the_contact_area_per_distance() {
    // Separating the bodies by dD reduces the overlap volume by its cross-section: dV/dD = -A for spheres and
    // cylinders.
    let (h, depth) = (1e-6, 0.7);
    for radii in [[1.0_f64, 1.0], [1.0, 1.7], [2.5, 0.4]] {
        let (near, far) = ((radii[0] - radii[1]).abs(), radii[0] + radii[1]);
        for k in 1..20 {
            let distance: f64 = near + (far - near) * f64::from(k) / 20.0;
            let z = contact_half_length(radii[0], focal_distance(radii, distance));
            let slope = |volume: &dyn Fn(f64) -> f64| {
                (volume(distance + h) - volume(distance - h)) / (2.0 * h)
            };
            let sphere = slope(&|d| displaced_volume(radii, d));
            let cylinder = slope(&|d| cylinder_displaced_volume(depth, radii, d));
            // Rounding: a few times 2e-16 in the volumes, divided by 2e-6.
            assert!(
                abs_diff_eq!(sphere, -contact_area(z), epsilon = 5e-8),
                "{radii:?} {distance}"
            );
            assert_abs_diff_eq!(cylinder, -cylinder_contact_area(depth, z), epsilon = 5e-7);
        }
        // The caps are continuous at their limits: zero for touching bodies, the smaller body for a contained one.
        let gap = 1e-9;
        assert!(displaced_volume(radii, far - gap) < 1e-9 && displaced_volume(radii, far) == 0.0);
        for (outside, inside) in [
            (
                displaced_volume(radii, near + gap),
                displaced_volume(radii, near),
            ),
            (
                cylinder_displaced_volume(depth, radii, near + gap),
                cylinder_displaced_volume(depth, radii, near),
            ),
        ] {
            assert!(
                abs_diff_eq!(outside, inside, epsilon = 1e-6),
                "{radii:?} {outside} {inside}"
            );
        }
    }
}

/// A pair that overlaps and moves almost freely, remembering an earlier turn of both ends.
fn gliding(distance: &str, step: f64) -> Draft {
    Draft::open_box(Integrator::Euler, step)
        .with("contact.distance", distance)
        .law(KelvinVoigt {
            stiffness: 1e-9,
            damping: 0.0,
        })
        .law(CundallStrackTruncated {
            friction: 1e9,
            stiffness: 1e-9,
        })
        .grain(
            Grain::at([0.0, 0.0], 1e-3)
                .moving([1.0, -2.0])
                .spinning(700.0),
        )
        .grain(
            Grain::at([2.0e-3, 1.0e-3], 1.5e-3)
                .moving([-1.5, 1.0])
                .spinning(-400.0),
        )
        .touching_since(0, 1, [-0.6, -3.3])
}

#[test]
fn rates_are_the_derivatives_of_displacements() {
    let step = 1e-9;
    for distance in ["radius", "focal", "mean"] {
        let mut world = world(&gliding(distance, step));
        let before = world.interactions()[0];
        advance(&mut world, 2);
        let after = world.interactions()[0];
        advance(&mut world, 2);
        let last = world.interactions()[0];
        let slope = |from: f64, to: f64| (to - from) / (4.0 * step);
        let normal = slope(before.normal_displacement, last.normal_displacement);
        // Rounding: 1e-16 times 3 mm, divided by 4 ns.
        assert_abs_diff_eq!(
            normal,
            after.normal_velocity,
            epsilon = 1e-9 * 3.0 / 4.0 + 1e-6
        );
        let r = [1e-3, 1.5e-3];
        let d = (r[0] + r[1]) - after.normal_displacement;
        for end in 0..2 {
            let found = slope(
                before.tangential_displacement[end],
                last.tangential_displacement[end],
            );
            // thesis E11: if the lever arm depends on the distance, its rate d' times the angle adds a term that (34)
            // omits.
            let arm = |d: f64| match distance {
                "radius" => r[end],
                "focal" => FocalArm.distances(r, d)[end],
                _ => MeanArm.distances(r, d)[end],
            };
            let h = 1e-8;
            let arm_slope = (arm(d + h) - arm(d - h)) / (2.0 * h);
            let turn = after.tangential_displacement[end] / arm(d);
            let dropped = arm_slope * -after.normal_velocity * turn;
            let expected = after.tangential_velocity[end] + dropped;
            assert!(
                abs_diff_eq!(found, expected, epsilon = 2e-6),
                "{distance} {end}: {found} {expected}"
            );
            if distance == "focal" {
                let other = overlap_factor([r[1 - end], r[end]], d);
                assert!(
                    relative_eq!(arm_slope, other, epsilon = 0.0, max_relative = 1e-6),
                    "dy/dD = b of the other end"
                );
            }
            assert_eq!(distance == "radius", dropped.abs() < 1e-6);
        }
    }
}

/// Grains that touch or nearly do; the last one is driven.
fn three_grains() -> [Grain; 3] {
    [
        Grain::at([0.0, 0.0], 1e-3)
            .moving([1.0, 0.0])
            .spinning(100.0),
        Grain::at([2.1e-3, 0.0], 1.2e-3)
            .moving([0.0, 0.5])
            .spinning(-300.0),
        Grain::at([2.5e-3, 1.8e-3], 0.8e-3)
            .moving([-1.0, 0.0])
            .spinning(50.0)
            .driven(),
    ]
}

/// The tables of all kinds of forces.
fn tables() -> [(&'static str, Draft); 5] {
    [
        (
            "contact",
            Draft::empty()
                .law(KelvinVoigt {
                    stiffness: 1e7,
                    damping: 3.0,
                })
                .law(HaffWerner {
                    friction: 0.5,
                    damping: 2.0,
                }),
        ),
        (
            "bond",
            Draft::empty()
                .law(AdjustedKelvinVoigt {
                    stiffness: 2e7,
                    damping: 3.0,
                })
                .law(EulerBernoulli {
                    stiffness: 1e7,
                    damping: 4.0,
                }),
        ),
        ("ambient", Draft::empty().creeping_drag(3.0)),
        ("external", Draft::empty().gravity(9.81e3)),
        (
            "driving",
            Draft::empty().driving(DrivingTable {
                controller: Controller::RateLimited { force_rate: 0.0 },
                speed: 1.0,
                pressure: 1.0,
                area: None,
                initial_force: [3.0, -2.0],
            }),
        ),
    ]
}

/// Three particles with the given kinds of forces.
fn parts(kinds: &[&str]) -> gouge_dem::World {
    let mut draft = Draft::open_box(Integrator::Euler, 1e-9).with("box.width", 0.02);
    for (kind, table) in tables() {
        if kinds.contains(&kind) {
            draft = draft.and(&table);
        }
    }
    draft = draft.grains(three_grains());
    if kinds.contains(&"bond") {
        draft = draft.bond(Bond::between(0, 1).of_length(2.2e-3).since([0.1, 3.0]));
    }
    let mut world = world(&draft);
    world.evaluate_if_pending().expect("finite");
    world
}

#[test]
fn the_force_on_a_particle_is_the_sum_of_its_parts() {
    let kinds = ["contact", "bond", "ambient", "external", "driving"];
    let all = parts(&kinds);
    for i in 0..3 {
        let (mut force, mut torque) = (Vec2::zero(), 0.0);
        for kind in kinds {
            // A bonded pair has no contact, so the contact force of this pair is not counted.
            let part = parts(&[kind]);
            let skip = if kind == "contact" {
                pair_of_bond(&part)
            } else {
                ([Vec2::zero(); 3], [0.0; 3])
            };
            force += part.forces().force[i] - skip.0[i];
            torque += part.forces().torque[i] - skip.1[i];
        }
        let total = (all.forces().force[i], all.forces().torque[i]);
        assert!(
            (force - total.0).norm() < 1e-10 * total.0.norm(),
            "{force:?} {total:?}"
        );
        assert_abs_diff_eq!(torque, total.1, epsilon = 1e-10 * total.1.abs());
        // The accelerations are x'' = F / m and phi'' = tau / J, tested with one explicit step.
        let mut moved = all.clone();
        moved.step().expect("finite");
        let p = moved.particles();
        let gained = p.velocity[i] - all.particles().velocity[i];
        let spun = p.angular_velocity[i] - all.particles().angular_velocity[i];
        assert!((gained * p.mass[i] - total.0 * 1e-9).norm() < 1e-6 * total.0.norm() * 1e-9);
        assert_abs_diff_eq!(
            spun * p.moment_of_inertia[i],
            total.1 * 1e-9,
            epsilon = 1e-6 * total.1.abs() * 1e-9
        );
    }
}

/// Forces and torques of the contact between particles 0 and 1, which their bond replaces.
fn pair_of_bond(world: &gouge_dem::World) -> ([Vec2; 3], [f64; 3]) {
    let (mut force, mut torque) = ([Vec2::zero(); 3], [0.0; 3]);
    for link in world.interactions() {
        if link.pair.indices() == (0, 1) {
            let f = link.normal * link.normal_force
                + link.normal.perpendicular() * link.tangential_force;
            (force[0], force[1]) = (f, -f);
            (torque[0], torque[1]) = (link.torque[0], link.torque[1]);
        }
    }
    (force, torque)
}

#[test]
fn moduli_and_wave_speeds_are_consistent() {
    for nu in [-0.5, 0.0, 0.1, 0.22, 0.4, 0.49] {
        let solid = gouge_dem::material::Elastic {
            youngs_modulus: 50e9,
            poissons_ratio: nu,
        };
        let (g, k, m) = (
            solid.shear_modulus(),
            solid.bulk_modulus(),
            solid.p_wave_modulus(),
        );
        assert_relative_eq!(k + 4.0 / 3.0 * g, m, epsilon = 0.0, max_relative = 1e-13);
        assert_relative_eq!(
            9.0 * k * g / (3.0 * k + g),
            50e9,
            epsilon = 0.0,
            max_relative = 1e-13
        );
        assert_relative_eq!(
            (3.0 * k - 2.0 * g) / (6.0 * k + 2.0 * g) + 1.0,
            nu + 1.0,
            epsilon = 0.0,
            max_relative = 1e-13
        );
        assert_relative_eq!(
            solid.primary_wave_speed(2700.0).powi(2) * 2700.0,
            m,
            epsilon = 0.0,
            max_relative = 1e-13
        );
        assert_relative_eq!(
            solid.secondary_wave_speed(2700.0).powi(2) * 2700.0,
            g,
            epsilon = 0.0,
            max_relative = 1e-13
        );
    }
    let granite = GRANITE.elastic();
    assert_relative_eq!(
        granite.primary_wave_speed(2700.0),
        4598.08,
        epsilon = 0.0,
        max_relative = 1e-6
    );
    assert_relative_eq!(
        granite.secondary_wave_speed(2700.0),
        2754.915,
        epsilon = 0.0,
        max_relative = 1e-6
    );
}

#[test]
fn the_axial_ratio_matches_the_breaking_forces() {
    let law = ZhangEckert {
        normal_strength: 280e6,
        tangential_strength: 168e6,
    };
    // The smallest purely normal and purely tangential forces that break the bond, by bisection.
    let limit = |along: &dyn Fn(f64) -> (f64, f64), s: f64| {
        let (mut low, mut high) = (0.0, 1e5);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            let (n, t) = along(middle);
            if law.breaks(n, t, [1e-3, 1.5e-3], s) {
                high = middle;
            } else {
                low = middle;
            }
        }
        low
    };
    let (normal, tangential) = (limit(&|f| (f, 0.0), 1.0), limit(&|f| (0.0, -f), 1.0));
    assert_relative_eq!(
        tangential / normal,
        law.axial_ratio(),
        epsilon = 0.0,
        max_relative = 1e-12
    );
    assert!(
        relative_eq!(
            limit(&|f| (f, 0.0), 1.1),
            1.21 * normal,
            epsilon = 0.0,
            max_relative = 1e-12
        ),
        "square of the factor"
    );
    // Between the axes the limit is an ellipse.
    let diagonal = limit(&|f| (-0.6 * f, 0.8 * f), 1.0);
    let sum = (0.6 * diagonal / normal).powi(2) + (0.8 * diagonal / tangential).powi(2);
    assert_relative_eq!(sum, 1.0, epsilon = 0.0, max_relative = 1e-12);
}

#[test]
fn a_fault_separates_the_points_above_and_below_it() {
    let straight = Fault {
        level: 0.05,
        height: 0.0,
        jags: 4.0,
        width: 0.1,
    };
    let jagged = Fault {
        height: 4e-3,
        ..straight
    };
    for k in 0..100 {
        let x = 0.1 * f64::from(k) / 100.0;
        let above = |fault: &Fault, y: f64| is_above(fault, Vec2::new(x, y));
        assert!(above(&straight, 0.05) && !above(&straight, 0.05 - 1e-12));
        assert!(above(&jagged, 0.052 + 1e-12) && !above(&jagged, 0.048 - 1e-12));
        // Four jags across the width, with the same shape across the periodic boundary.
        for y in [0.0485, 0.0495, 0.0505, 0.0515] {
            let shifted = |by: f64| is_above(&jagged, Vec2::new(x + by, y));
            assert_eq!(shifted(0.0), shifted(0.1 / 4.0 + 1e-15));
        }
    }
    let crest = |x: f64, y: f64| is_above(&jagged, Vec2::new(x, y));
    assert!(
        !crest(0.1 / 16.0, 0.0519) && crest(0.3 / 16.0, 0.0481),
        "crest first, then trough"
    );
}
