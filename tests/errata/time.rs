//! Time and energy.

use crate::worlds::{advance, world};
use approx::{assert_relative_eq, relative_eq};
use gouge_dem::integrators::{Integrator, crack_bound, wave_bound};
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli, KelvinVoigt, ZhangEckert};
use gouge_dem::material::GRANITE;
use gouge_validation::scenes::{Draft, Grain};

#[test]
fn time_step_bounds_match_waves_and_cracks() {
    let bound = |r: f64| crack_bound(GRANITE.elastic(), 2700.0, r, 15.0);
    // Neither the mean nor the smallest radius gives the 18 ns of section 4.2.
    assert!(
        relative_eq!(bound(1e-3), 28.998e-9, epsilon = 0.0, max_relative = 1e-4)
            && relative_eq!(
                bound(0.82843e-3),
                24.022e-9,
                epsilon = 0.0,
                max_relative = 1e-4
            )
    );
    assert_relative_eq!(
        wave_bound(GRANITE.elastic(), 2700.0, 1e-3),
        15.0 * bound(1e-3),
        epsilon = 0.0,
        max_relative = 1e-14
    );
}

#[test]
fn a_displacement_below_half_an_ulp_is_lost() {
    let draft = Draft::open_box(Integrator::Euler, 1e-8)
        .grain(Grain::at([1.0, 0.0], 1e-3).moving([1e-9, 1e-9]));
    let mut world = world(&draft);
    advance(&mut world, 1000);
    let x = world.particles().position[0];
    assert_eq!(x.x, 1.0, "lost in a coordinate of one metre");
    assert!(
        relative_eq!(x.y, 1e-14, epsilon = 0.0, max_relative = 1e-9),
        "kept in a coordinate of zero"
    );
}

/// Largest residual over the largest energy of a run, and the terms at its end.
fn balance(draft: &Draft, steps: u64) -> (f64, gouge_dem::balance::Energy) {
    let mut world = world(draft);
    let (mut residual, mut scale) = (0.0_f64, world.energy().mechanical());
    for _ in 0..steps {
        advance(&mut world, 1);
        let energy = world.energy();
        residual = residual.max(energy.residual.abs());
        scale = scale.max(energy.mechanical());
    }
    (residual / scale, world.energy())
}

/// Two spheres meet obliquely with spin.
fn oblique(step: f64, law: &str, constant: f64) -> Draft {
    Draft::open_box(Integrator::VelocityVerlet, step)
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 1.0,
        })
        .friction(law, 0.5, constant)
        .gravity(1e4)
        .creeping_drag(0.3)
        .grain(
            Grain::at([0.0, 0.0], 1e-3)
                .moving([3.0, 1.0])
                .spinning(900.0),
        )
        .grain(
            Grain::at([2.3e-3, 0.8e-3], 1.4e-3)
                .moving([-2.0, 0.0])
                .spinning(-200.0),
        )
}

#[test]
fn the_balance_of_a_collision_closes() {
    let laws = [
        ("haff-werner", 3.0, 1e-3),
        ("cundall-strack-truncated", 3e6, 1e-3),
        // Its sign may flip in the middle of a step; the force then jumps by twice the limit.
        ("cundall-strack", 3e6, 1e-2),
    ];
    for (law, constant, tolerance) in laws {
        let (coarse, _) = balance(&oblique(4e-9, law, constant), 20_000);
        let (fine, end) = balance(&oblique(0.5e-9, law, constant), 160_000);
        assert!(
            fine < tolerance && fine < coarse.max(1e-7),
            "{law} {coarse} {fine}"
        );
        assert!(end.friction > 0.0 && end.ambient > 0.0, "{end:?}");
        assert_eq!([end.breaking, end.bonding, end.driving], [0.0; 3]);
        assert_eq!(end.contact, 0.0, "they have parted");
    }
}

#[test]
fn the_balance_of_a_breaking_bond_closes() {
    // The bond is pulled or pressed until it breaks. In compression a contact begins, whose energy is booked as
    // bonding.
    for (speed, bonds) in [(8.0, false), (-8.0, true)] {
        let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
            .law(KelvinVoigt {
                stiffness: 1e7,
                damping: 2.0,
            })
            .law(AdjustedKelvinVoigt {
                stiffness: 1e7,
                damping: 1.0,
            })
            .law(EulerBernoulli {
                stiffness: 1e7,
                damping: 1.0,
            })
            .law(ZhangEckert {
                normal_strength: 28e6,
                tangential_strength: 16.8e6,
            })
            .grain(
                Grain::at([0.0, 0.0], 1e-3)
                    .moving([-speed, 0.0])
                    .spinning(1000.0),
            )
            .grain(Grain::at([2.0e-3, 0.0], 1e-3).moving([speed, 0.0]))
            .bonded(0, 1);
        let (residual, end) = balance(&draft, 5000);
        assert!(residual < 1e-3, "{residual}");
        assert!(end.breaking > 0.0 && end.friction > 0.0);
        assert_eq!(end.bonding > 0.0, bonds, "{end:?}");
        // A bond that breaks in pure tension at F = 88 N, 28 MPa on pi mm^2, stores F^2 / (2 k).
        assert!(end.breaking < 88.0_f64.powi(2) / 2e7 * 1.5);
    }
}
