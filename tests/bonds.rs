//! Bonds do not depend on how their ends are named, and their energies do not depend on their neighbours.

use crate::worlds::{INTEGRATORS, advance, bits, world};
use approx::assert_abs_diff_eq;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli, KelvinVoigt, ZhangEckert};
use gouge_dem::model::Yielding;
use gouge_validation::scenes::{Bond, Draft, Grain};
use std::f64::consts::PI;

const RADIUS: f64 = 1e-3;
/// Normal strength in Pa.
const STRENGTH: f64 = 28e6;
/// Stiffness of bonds and contacts in kg/s^2.
const STIFFNESS: f64 = 1e7;

#[test]
fn the_ends_of_a_bond_may_be_named_in_either_order() {
    let run = |integrator: &str, bond: Bond| {
        let draft = Draft::open_box(integrator, 1e-9)
            .law(AdjustedKelvinVoigt {
                stiffness: STIFFNESS,
                damping: 1.0,
            })
            .law(EulerBernoulli {
                stiffness: STIFFNESS,
                damping: 1.0,
            })
            .grain(Grain::at([-RADIUS, 0.0], RADIUS))
            .grain(Grain::at([RADIUS, 1e-5], 1.2 * RADIUS))
            .bond(bond.of_length(2.1 * RADIUS));
        let mut world = world(&draft);
        advance(&mut world, 500);
        bits(&world)
    };
    for integrator in INTEGRATORS {
        let forwards = run(integrator, Bond::between(0, 1).since([0.01, 3.0]));
        let backwards = run(integrator, Bond::between(1, 0).since([3.0, 0.01]));
        let exchanged = run(integrator, Bond::between(1, 0).since([0.01, 3.0]));
        assert_eq!(forwards, backwards, "{integrator}");
        assert_ne!(forwards, exchanged, "{integrator}");
    }
}

/// When a bond in tension breaks, its energy leaves the balance up to the work of its force in half a step. A
/// compressed contact beside it holds 2000 times as much.
#[test]
fn a_breaking_bond_leaves_the_energy_of_other_contacts_alone() {
    let (speed, step, overlap) = (16.0, 1e-9, 1e-4);
    let draft = Draft::open_box(Integrator::VelocityVerlet, step)
        .law(AdjustedKelvinVoigt {
            stiffness: STIFFNESS,
            damping: 0.0,
        })
        .law(Yielding {
            law: ZhangEckert {
                normal_strength: STRENGTH,
                tangential_strength: STRENGTH,
            },
            tensile_strength: None,
            unbreakable_edges: false,
        })
        .law(KelvinVoigt {
            stiffness: STIFFNESS,
            damping: 0.0,
        })
        .grain(Grain::at([-2.0 * RADIUS, 0.0], RADIUS).moving([-speed, 0.0]))
        .grain(Grain::at([0.0, 0.0], RADIUS).fixed())
        .grain(Grain::at([2.0 * RADIUS - overlap, 0.0], RADIUS).fixed())
        .bonded(0, 1);
    let mut world = world(&draft);
    let held = 0.5 * STIFFNESS * overlap * overlap;
    advance(&mut world, 1000);
    assert!(world.bonds().is_some_and(|bonds| bonds.is_empty()));
    let work = 0.5 * STRENGTH * PI * RADIUS * RADIUS * speed * step;
    let residual = world.energy().residual.abs();
    assert!(0.0 < residual && residual <= work, "{residual} {work}");
    assert!(held > 2000.0 * work, "{held}");
}

/// The contact that replaces a bond torn in tension does not touch; its lever arms need not exist.
#[test]
fn a_bond_torn_in_tension_leaves_a_contact_without_energy() {
    for distance in ["radius", "focal", "mean"] {
        let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
            .law(AdjustedKelvinVoigt {
                stiffness: STIFFNESS,
                damping: 0.0,
            })
            .law(ZhangEckert {
                normal_strength: STRENGTH,
                tangential_strength: STRENGTH,
            })
            .law(KelvinVoigt {
                stiffness: STIFFNESS,
                damping: 0.0,
            })
            .friction("cundall-strack", 0.5, STIFFNESS)
            .with("contact.distance", distance)
            .grain(
                Grain::at([-RADIUS, 0.0], RADIUS)
                    .moving([-16.0, 0.0])
                    .spinning(1e3),
            )
            .grain(Grain::at([RADIUS, 0.0], RADIUS).moving([16.0, 1.0]))
            .bonded(0, 1);
        let mut world = world(&draft);
        advance(&mut world, 1000);
        assert!(world.bonds().is_some_and(|bonds| bonds.is_empty()));
        assert_eq!(world.energy().bonding, 0.0, "{distance}");
        assert!(world.energy().residual.is_finite(), "{distance}");
    }
}

/// The reading of the thesis wraps angles to [-pi, pi): where a rotation passes pi, the spring changes sides.
#[test]
fn a_spring_changes_sides_where_its_rotation_passes_half_a_turn() {
    let (step, spin, before) = (1e-9, 1e3, 2e-5);
    for turned in [0, 1] {
        let spin_of = |end: usize| if end == turned { spin } else { 0.0 };
        let grain = |end: usize| {
            let side = if end == 0 { -0.99 } else { 0.99 };
            Grain::at([side * RADIUS, 0.0], RADIUS).spinning(spin_of(end))
        };
        // Rotations since the contact began: nearly half a turn, and none.
        let mut since = [0.0, -PI];
        since[turned] = if turned == 0 { before - PI } else { before };
        let draft = Draft::open_box(Integrator::VelocityVerlet, step)
            .reading("thesis")
            .law(KelvinVoigt {
                stiffness: STIFFNESS,
                damping: 0.0,
            })
            .friction("cundall-strack", 1e9, 1.0)
            .grain(grain(0))
            .grain(grain(1))
            .touching_since(0, 1, since);
        let mut world = world(&draft);
        let state = |world: &gouge_dem::World| {
            let p = world.particles();
            (p.angle[turned], p.angular_velocity[turned])
        };
        let mut passed = None;
        for _ in 0..40 {
            let (_, earlier) = state(&world);
            advance(&mut world, 1);
            let (angle, now) = state(&world);
            if now > earlier && passed.is_none() {
                passed = Some(PI - before + angle);
            }
        }
        let rotation = passed.expect("the torque changes its sign");
        assert_abs_diff_eq!(rotation, PI, epsilon = 2.0 * spin * step);
    }
}

/// Thesis (46)-(50): alone, each force breaks the bond at its strength times the section of the smaller radius, scaled
/// by the factor.
#[test]
fn the_strength_factor_scales_the_radius_of_the_weakest_section() {
    let law = ZhangEckert {
        normal_strength: 280e6,
        tangential_strength: 168e6,
    };
    for (radii, smaller) in [([1e-3, 2e-3], 1e-3), ([3e-3, 2e-3], 2e-3_f64)] {
        for factor in [0.4, 1.0, 2.5] {
            let section = PI * smaller * smaller * factor * factor;
            for (share, breaks) in [(1.0 - 1e-8, false), (1.0 + 1e-8, true)] {
                let (normal, tangential) = (280e6 * section * share, 168e6 * section * share);
                for sign in [-1.0, 1.0] {
                    assert_eq!(law.breaks(sign * normal, 0.0, radii, factor), breaks);
                    assert_eq!(law.breaks(0.0, sign * tangential, radii, factor), breaks);
                }
            }
        }
    }
}
