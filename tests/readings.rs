//! Decisions of the errata, tested by their effects.

use crate::worlds::{advance, world};
use approx::abs_diff_eq;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli};
use gouge_validation::scenes::{Draft, Grain};

/// A bonded pair that rolls like gears; each end turns by many half-turns, at different moments.
fn gears(reading: &str) -> Draft {
    Draft::open_box(Integrator::Euler, 1e-7)
        .reading(reading)
        .law(AdjustedKelvinVoigt {
            stiffness: 1e3,
            damping: 0.0,
        })
        .law(EulerBernoulli {
            stiffness: 1e-9,
            damping: 0.0,
        })
        .grain(Grain::at([0.0, 0.0], 1e-3).spinning(2e4))
        .grain(Grain::at([3e-3, 0.0], 2e-3).spinning(-1e4))
        .bonded(0, 1)
}

#[test]
fn corrected_angles_continue_where_thesis_angles_wrap() {
    for (reading, unwrapped) in [("corrected", true), ("thesis", false)] {
        let mut world = world(&gears(reading));
        advance(&mut world, 10_000);
        let zeta = world.interactions()[0].tangential_displacement;
        // 20 rad at 1 mm and -10 rad at 2 mm.
        let expected = if unwrapped {
            [20e-3, -20e-3]
        } else {
            let tau = std::f64::consts::TAU;
            [1e-3 * (20.0 - 3.0 * tau), 2e-3 * (-10.0 + 2.0 * tau)]
        };
        for end in 0..2 {
            assert!(
                abs_diff_eq!(zeta[end], expected[end], epsilon = 1e-9),
                "{reading} {zeta:?} {expected:?}"
            );
        }
    }
}

#[test]
fn a_bond_is_unstrained_after_many_rigid_turns() {
    // Rigid rotation about the common centre: no strain at any angle of rotation.
    let omega = 1e4;
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-8)
        .law(AdjustedKelvinVoigt {
            stiffness: 1e7,
            damping: 0.0,
        })
        .law(EulerBernoulli {
            stiffness: 1e7,
            damping: 0.0,
        })
        .grain(
            Grain::at([-1e-3, 0.0], 1e-3)
                .moving([0.0, -omega * 1e-3])
                .spinning(omega),
        )
        .grain(
            Grain::at([1e-3, 0.0], 1e-3)
                .moving([0.0, omega * 1e-3])
                .spinning(omega),
        )
        .bonded(0, 1);
    let mut world = world(&draft);
    advance(&mut world, 200_000);
    let p = world.particles();
    assert!(
        abs_diff_eq!(p.angle[0], omega * 2e-3, epsilon = 1e-2),
        "more than three turns"
    );
    let zeta = world.interactions()[0].tangential_displacement;
    // The centrifugal stretch of 1e-4 reduces omega by the same fraction; the ends oscillate with an amplitude of about
    // r 1e-4 omega / (2e6 1/s) = 0.5 nm.
    assert!(zeta.iter().all(|z| z.abs() < 2e-9), "{zeta:?}");
}

/// Terminal speed of a 1 mm sphere falling in air, by the drag law of the reading.
fn drag(reading: &str) -> f64 {
    let draft = Draft::open_box(Integrator::Euler, 1e-9)
        .reading(reading)
        .correlation_drag(18e-6, 1.2)
        .grain(Grain::at([0.0, 0.0], 1e-3).moving([2.0, 0.0]));
    let mut world = world(&draft);
    world.evaluate_if_pending().expect("finite");
    world.forces().force[0].x
}

#[test]
fn the_drag_constant_follows_the_reading() {
    // At Re = 266.67 the coefficients are 0.69375 and 1.27371: 24/Re + 3/sqrt(Re) + 0.42 or 1.
    let area = std::f64::consts::PI * 1e-6;
    for (reading, coefficient) in [("corrected", 0.693_712), ("thesis", 1.273_712)] {
        let expected = -0.5 * 1.2 * area * coefficient * 4.0;
        let found = drag(reading);
        assert!(
            abs_diff_eq!(found / expected, 1.0, epsilon = 2e-6),
            "{reading}: {found}, {expected}"
        );
    }
}

#[test]
fn a_truncated_spring_releases_no_more_energy_than_it_stored() {
    use gouge_dem::laws::{CundallStrack, CundallStrackTruncated, TangentialLaw, TangentialMotion};
    // The closed cycle of thesis E15: slide under a low normal force, return under a high one.
    fn work<L: TangentialLaw>(law: L) -> f64 {
        let (mut memory, mut work, n) = (0.0, 0.0, 100_000);
        for k in 0..2 * n {
            let (x, v, load) = if k < n {
                (f64::from(k) * 1e-9, 1.0, -100.0)
            } else {
                (f64::from(2 * n - k) * 1e-9, -1.0, -100_000.0)
            };
            let slide = TangentialMotion {
                displacement: x,
                velocity: v,
            };
            work += law.friction(slide, load, &mut memory).force * v * 1e-9;
        }
        work
    }
    let (friction, stiffness) = (0.7, 1e8);
    let printed = work(CundallStrack {
        friction,
        stiffness,
        grips_at_rest: false,
    });
    let truncated = work(CundallStrackTruncated {
        friction,
        stiffness,
    });
    // Energy created: k z^2 / 2 - mu F z (and the rise to the limit), with z = 0.1 mm.
    let created = 0.5 * 1e8 * 1e-8 - 70.0 * 1e-4 + 0.5 * 70.0 * 70.0 / 1e8;
    assert!(
        abs_diff_eq!(printed / created, 1.0, epsilon = 1e-3),
        "{printed}, {created}"
    );
    assert!(truncated < 0.0, "{truncated}");
}
