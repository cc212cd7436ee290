//! Fields, driving and friction.

use crate::worlds::{INTEGRATORS, advance, world};
use approx::{abs_diff_eq, assert_relative_eq, relative_eq};
use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::estimators::{friction_feedback, friction_load};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{Controller, KelvinVoigt, characteristic_length, drag_coefficient};
use gouge_runner::scene::DrivingTable;
use gouge_validation::scenes::{Draft, Grain};
use std::f64::consts::PI;

#[test]
fn the_drag_of_nonspherical_particles_uses_base_ten() {
    // At large Reynolds numbers only the last term remains: 0.42 for a sphere. Sphericities of 10^-1 and 10^-32, whose
    // negative logarithms have the fifth roots 1 and 2, multiply it by 10^0.4 and 10^0.8.
    let limit = |sphericity: f64| drag_coefficient(1e300, [1.0, sphericity, 1.0]);
    assert_relative_eq!(limit(1.0), 0.42, epsilon = 0.0, max_relative = 1e-12);
    assert_relative_eq!(
        limit(0.1),
        0.42 * 100.0_f64.powf(0.2),
        epsilon = 0.0,
        max_relative = 1e-12
    );
    assert_relative_eq!(
        limit(1e-32),
        0.42 * 10_000.0_f64.powf(0.2),
        epsilon = 0.0,
        max_relative = 1e-12
    );
    // The first term depends on the square root of the lengthwise sphericity, the last on the crosswise sphericity.
    let at = |lengthwise, crosswise| drag_coefficient(1.0, [lengthwise, 1.0, crosswise]);
    assert_relative_eq!(
        at(0.25, 1.0) - at(1.0, 1.0),
        8.0,
        epsilon = 0.0,
        max_relative = 1e-12
    );
    assert_relative_eq!(
        at(1.0, 0.5) - at(1.0, 1.0),
        0.42,
        epsilon = 0.0,
        max_relative = 1e-12
    );
    // The third term at Re = 1: for a sphericity of 1/16 it is 3 times 16^(3/4).
    let whole = drag_coefficient(1.0, [1.0, 0.0625, 1.0]);
    let rest = whole - 8.0 - 16.0 * 4.0 - limit(0.0625);
    assert!(
        relative_eq!(rest, 24.0, epsilon = 0.0, max_relative = 1e-12),
        "{rest}"
    );
}

/// Two driven particles of different size in a drag, with an exact controller.
fn driven(driving: DrivingTable) -> World {
    let draft = Draft::open_box(Integrator::SymplecticEuler, 1e-7)
        .with("box.width", 0.02)
        .creeping_drag(1.0)
        .driving(driving)
        .grain(Grain::at([0.0, 0.0], 1e-3).driven())
        .grain(Grain::at([0.01, 0.0], 2e-3).moving([1.0, 0.0]).driven());
    world(&draft)
}

#[test]
fn exact_driving_holds_the_mean_speed_and_the_load() {
    let mut world = driven(DrivingTable {
        controller: Controller::Exact,
        speed: 2.0,
        pressure: 1e6,
        area: None,
        initial_force: [0.0; 2],
    });
    for _ in 0..50 {
        advance(&mut world, 1);
        let v = &world.particles().velocity;
        assert_relative_eq!(
            0.5 * (v[0].x + v[1].x),
            2.0,
            epsilon = 0.0,
            max_relative = 1e-12
        );
        // The load is the sum over all driven particles and points down. The area is the width times twice the mean
        // radius: 1 MPa on 20 mm times 3 mm.
        assert_relative_eq!(
            world.drive().force.y,
            -60.0,
            epsilon = 0.0,
            max_relative = 1e-12
        );
    }
    assert_relative_eq!(
        characteristic_length(&[1e-3, 2e-3]),
        3e-3,
        epsilon = 0.0,
        max_relative = 1e-15
    );
    // Each carries the same share, along the axes of the laboratory.
    let mut world = driven(DrivingTable {
        controller: Controller::RateLimited { force_rate: 0.0 },
        speed: 2.0,
        pressure: 0.0,
        area: None,
        initial_force: [6.0, -4.0],
    });
    world.evaluate_if_pending().expect("finite");
    let drag = 6.0 * PI * 2e-3;
    let force = &world.forces().force;
    assert_eq!(force[0], Vec2::new(3.0, -2.0));
    assert!((force[1] - Vec2::new(3.0 - drag, -2.0)).norm() < 1e-15);
}

#[test]
fn exact_driving_settles_with_every_integrator() {
    // A grain in a viscous medium starts at rest, is accelerated to 2 m/s and then driven at this speed. The force
    // only has to balance the drag 6 pi eta r v.
    for integrator in INTEGRATORS {
        let draft = Draft::open_box(integrator, 1e-6)
            .creeping_drag(1.0)
            .driving(DrivingTable {
                controller: Controller::Exact,
                speed: 2.0,
                pressure: 0.0,
                area: Some(1.0),
                initial_force: [0.0; 2],
            })
            .grain(Grain::at([0.0, 0.0], 1e-3).driven());
        let mut world = world(&draft);
        advance(&mut world, 200);
        for _ in 0..20 {
            advance(&mut world, 1);
            assert!(
                relative_eq!(
                    world.particles().velocity[0].x,
                    2.0,
                    epsilon = 0.0,
                    max_relative = 1e-12
                ),
                "{integrator}"
            );
            let force = world.drive().force.x;
            assert!(
                relative_eq!(
                    force,
                    6.0 * PI * 1e-3 * 2.0,
                    epsilon = 0.0,
                    max_relative = 1e-10
                ),
                "{integrator}: {force}"
            );
        }
    }
}

#[test]
fn the_rate_limited_controller_brings_the_reaction_to_the_load() {
    let draft = Draft::open_box(Integrator::SymplecticEuler, 1e-8)
        .law(KelvinVoigt {
            stiffness: 1e6,
            damping: 3.0,
        })
        .driving(DrivingTable {
            controller: Controller::RateLimited { force_rate: 1e3 },
            speed: 0.0,
            pressure: 1e5,
            area: Some(1e-5),
            initial_force: [0.0; 2],
        })
        .grain(Grain::at([0.0, 0.0], 1e-3).fixed())
        .grain(Grain::at([0.0, 2e-3], 1e-3).driven());
    let mut world = world(&draft);
    advance(&mut world, 50_000);
    assert!(
        abs_diff_eq!(world.drive().force.y, -0.5, epsilon = 0.005),
        "the rate limits the force"
    );
    advance(&mut world, 150_000);
    for _ in 0..100 {
        advance(&mut world, 100);
        let drive = world.drive();
        assert!(
            abs_diff_eq!(drive.reaction.y, 1.0, epsilon = 0.01)
                && abs_diff_eq!(drive.force.y, -1.0, epsilon = 0.01),
            "{drive:?}"
        );
    }
}

#[test]
fn friction_is_the_signed_ratio_of_sums() {
    // Dragged at constant speed through a medium while a harmonic well carries the load: friction is 6 pi eta r v /
    // (p A).
    for speed in [2.0, -2.0] {
        let draft = Draft::open_box(Integrator::SymplecticEuler, 1e-6)
            .with("box.height", 0.2)
            .creeping_drag(10.0)
            .harmonic_well(1e3)
            .driving(DrivingTable {
                controller: Controller::Exact,
                speed,
                pressure: 1e3,
                area: Some(1e-3),
                initial_force: [0.0; 2],
            })
            .grain(Grain::at([0.0, 0.1], 1e-3).driven())
            .grain(Grain::at([0.5, 0.1], 2e-3).driven());
        let mut world = world(&draft);
        advance(&mut world, 30_000);
        world.evaluate_if_pending().expect("finite");
        let drive = world.drive();
        let reaction_ratio = -drive.reaction.x / drive.reaction.y;
        assert_eq!(friction_feedback(drive), reaction_ratio);
        // Both particles accelerate equally, so the shares balance the drag only for the mean speed.
        assert!(
            relative_eq!(drive.reaction.y, 1.0, epsilon = 0.0, max_relative = 1e-6),
            "the well carries the load: {drive:?}"
        );
        assert!(
            relative_eq!(
                friction_load(drive),
                friction_feedback(drive),
                epsilon = 0.0,
                max_relative = 1e-6
            ),
            "machine_independent motion"
        );
        assert!(friction_load(drive) * speed > 0.0);
    }
}

#[test]
fn work_of_driving_is_signed() {
    // A driven particle is braked by a small constant force: the work is what its energy changes by.
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-8)
        .driving(DrivingTable {
            controller: Controller::RateLimited { force_rate: 0.0 },
            speed: 0.0,
            pressure: 0.0,
            area: Some(1.0),
            initial_force: [-1.0, 0.0],
        })
        .grain(Grain::at([0.0, 0.0], 1e-3).moving([3.0, 0.0]).driven());
    let mut world = world(&draft);
    let before = world.energy();
    assert!(before.kinetic > 0.0);
    assert_eq!(
        before.residual, 0.0,
        "energies count from the initial state"
    );
    advance(&mut world, 2000);
    let after = world.energy();
    assert!(after.driving < 0.0);
    assert_relative_eq!(
        after.driving,
        after.kinetic - before.kinetic,
        epsilon = 0.0,
        max_relative = 1e-9
    );
}

#[test]
fn a_column_in_a_harmonic_well_has_a_parabolic_pressure() {
    let (n, k) = (9, 1e2);
    let mut draft = Draft::open_box(Integrator::VelocityVerlet, 1e-7)
        .with("box.height", 0.02)
        .creeping_drag(200.0)
        .harmonic_well(1e2)
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 0.0,
        });
    for i in 0..n {
        let y = 0.01 + 2e-3 * (f64::from(i) - 4.0);
        draft = draft.grain(Grain::at([0.0, y], 1e-3));
    }
    let mut world = world(&draft);
    advance(&mut world, 40_000);
    let links = world.interactions();
    assert_eq!(links.len(), n as usize - 1);
    for link in links {
        // Sum of k (y - y0) over all grains above a contact: k / (4 r) times (h^2 - y^2).
        let y = link.focal_point.y - 0.01;
        let expected = k / 4e-3 * (9e-3_f64.powi(2) - y * y);
        assert!(
            abs_diff_eq!(-link.normal_force, expected, epsilon = 2e-3 * expected),
            "{y}: {}",
            link.normal_force
        );
    }
}
