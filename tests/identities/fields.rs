//! Drag and external forces.

use crate::worlds::{advance, world};
use approx::{assert_abs_diff_eq, assert_relative_eq, relative_eq};
use gouge_common::geometry::Vec2;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{
    AmbientLaw, CorrelationDrag, CreepingDrag, drag_coefficient, reynolds_number,
};
use gouge_validation::scenes::{Draft, Grain};
use std::f64::consts::PI;

#[test]
fn drag_has_its_limits() {
    let (viscosity, density, radius) = (18e-6, 1.2, 1e-3_f64);
    let correlation = CorrelationDrag {
        viscosity,
        density,
        constant: CorrelationDrag::CONSTANT,
    };
    let creeping = CreepingDrag { viscosity };
    let drag = |speed: f64| -correlation.drag(radius, Vec2::new(speed, 0.0), 0.0).force.x;
    // Slow: Stokes drag, with a relative excess of sqrt(Re) / 8.
    let slow = 1e-9;
    let re = reynolds_number(viscosity, density, radius, slow);
    let stokes = -creeping.drag(radius, Vec2::new(slow, 0.0), 0.0).force.x;
    assert_relative_eq!(
        stokes,
        6.0 * PI * 18e-6 * 1e-3 * 1e-9,
        epsilon = 0.0,
        max_relative = 1e-14
    );
    assert_abs_diff_eq!(drag(slow) / stokes - 1.0, re.sqrt() / 8.0, epsilon = 1e-6);
    assert_eq!(drag(0.0), 0.0);
    // Fast: dynamic pressure times cross-section times the constant.
    let fast = 1e9;
    assert_relative_eq!(
        drag(fast),
        0.42 * 0.5 * 1.2 * 1e18 * PI * 1e-6,
        epsilon = 0.0,
        max_relative = 1e-4
    );
    // Between: the general correlation for the sphericities of a sphere.
    for speed in [1e-3, 0.1, 2.0, 50.0] {
        let re = reynolds_number(viscosity, density, radius, speed);
        assert_relative_eq!(
            re,
            2e-3 * speed * 1.2 / 18e-6,
            epsilon = 0.0,
            max_relative = 1e-14
        );
        let coefficient = drag_coefficient(re, [1.0; 3]);
        assert_relative_eq!(
            drag(speed),
            coefficient * 0.5 * 1.2 * speed * speed * PI * 1e-6,
            epsilon = 0.0,
            max_relative = 1e-13
        );
    }
    // The torque is that of creeping flow at any speed.
    let velocity = Vec2::new(30.0, 0.0);
    let torques = [
        correlation.drag(radius, velocity, 5.0).torque,
        creeping.drag(radius, Vec2::zero(), 5.0).torque,
    ];
    assert_eq!(torques[0], torques[1]);
    assert_relative_eq!(
        torques[1],
        -8.0 * PI * 18e-6 * 1e-9 * 5.0,
        epsilon = 0.0,
        max_relative = 1e-14
    );
}

#[test]
fn creeping_flow_stops_each_particle_at_its_own_rate() {
    // v = v0 exp(-6 pi eta r t / m) and likewise the spin with 8 pi eta r^3 / J, per particle.
    let (viscosity, step, steps) = (10.0, 1e-9, 20_000);
    let radii = [1e-3, 1.7e-3_f64];
    let draft = Draft::open_box(Integrator::VelocityVerlet, step)
        .creeping_drag(viscosity)
        .grain(
            Grain::at([0.0, 0.0], radii[0])
                .moving([1.0, 2.0])
                .spinning(300.0),
        )
        .grain(
            Grain::at([9.0, 0.0], radii[1])
                .moving([1.0, 2.0])
                .spinning(300.0),
        );
    let mut world = world(&draft);
    advance(&mut world, steps);
    let (p, time) = (world.particles(), step * steps as f64);
    for (i, r) in radii.iter().enumerate() {
        let mass = 2700.0 * 4.0 / 3.0 * PI * r.powi(3);
        let linear = (-6.0 * PI * viscosity * r * time / mass).exp();
        let angular = (-8.0 * PI * viscosity * r.powi(3) * time / (0.4 * mass * r * r)).exp();
        assert!(linear < 0.9 && angular < 0.9);
        // The method is of second order: (rate step)^2 / 6 times rate time is below 1e-8.
        assert!(
            relative_eq!(p.velocity[i].x, linear, epsilon = 0.0, max_relative = 1e-8)
                && relative_eq!(
                    p.velocity[i].y,
                    2.0 * linear,
                    epsilon = 0.0,
                    max_relative = 1e-8
                )
        );
        assert_relative_eq!(
            p.angular_velocity[i],
            300.0 * angular,
            epsilon = 0.0,
            max_relative = 1e-8
        );
    }
}

#[test]
fn external_forces_derive_from_their_potentials_and_turn_nothing() {
    let fields = [
        Draft::empty().gravity(9.81),
        Draft::empty().with("box.height", 0.4).harmonic_well(50.0),
    ];
    for field in fields {
        let at = |x: f64, y: f64| {
            world(
                &Draft::open_box(Integrator::Euler, 1e-6)
                    .and(&field)
                    .grain(Grain::at([x, y], 0.01).moving([1.0, 0.0]).spinning(3.0)),
            )
        };
        let potential = |x: f64, y: f64| at(x, y).energy().external;
        let (x, y, h) = (0.3, 0.7, 1e-4);
        let mut world = at(x, y);
        world.evaluate_if_pending().expect("finite");
        let force = world.forces().force[0];
        let slope_x = (potential(x + h, y) - potential(x - h, y)) / (2.0 * h);
        let slope_y = (potential(x, y + h) - potential(x, y - h)) / (2.0 * h);
        assert_eq!((force.x, slope_x), (0.0, 0.0));
        assert!(
            relative_eq!(force.y, -slope_y, epsilon = 0.0, max_relative = 1e-9) && force.y < 0.0,
            "pulls down from above"
        );
        assert_eq!(world.forces().torque[0], 0.0);
    }
}
