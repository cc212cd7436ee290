//! Assemblies of units: what is refused, walls, torques, reproducibility.

use crate::generators::Uniform;
use crate::systems::{System, law, moving};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::assembly::Body;
use gouge_contact_dynamics::detection::HalfPlane;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::units::{InverseMass, Velocity};

#[test]
fn wrong_assemblies_are_refused() {
    let mut system = System::new(1.0, law(0.0, 0.0, GapRule::Closed));
    system.body(0, 0.5, (0.0, 0.0), 0.0, Velocity::default());
    let shape = system.assembly.shape[0];
    let at = |position: Vec2, scale: f64| Body {
        shape,
        scale,
        position,
        angle: 0.0,
    };
    let (assembly, configuration) = (&mut system.assembly, &mut system.state.configuration);
    let fine = at(Vec2::zero(), 1.0);
    assert!(assembly.add_body(configuration, fine, 0).is_err());
    assert!(assembly.add_body(configuration, fine, 7).is_err());
    let nowhere = at(Vec2::new(f64::NAN, 0.0), 1.0);
    let inside_out = at(Vec2::zero(), -1.0);
    for (body, density) in [(fine, 0.0), (inside_out, 1.0), (nowhere, 1.0)] {
        let added = assembly.add_free(configuration, body, density, Velocity::default());
        assert!(added.is_err(), "{body:?} {density}");
    }
    let slanted = HalfPlane {
        position: Vec2::zero(),
        normal: Vec2::new(1.0, 1.0),
    };
    assert!(assembly.add_wall(configuration, slanted, 0).is_err());
    let floor = HalfPlane {
        normal: Vec2::new(0.0, 1.0),
        ..slanted
    };
    assert!(assembly.add_wall(configuration, floor, 0).is_err());
    assert!(law(-0.1, 0.0, GapRule::Closed).validate().is_err());
    assert!(law(0.1, 1.1, GapRule::Closed).validate().is_err());
    assert!(law(0.1, 1.0, GapRule::Closed).validate().is_ok());
    let negative = InverseMass {
        x: -1.0,
        ..InverseMass::IMPOSED
    };
    assert!(
        assembly
            .add_unit(configuration, negative, Velocity::default())
            .is_err()
    );
    assert!(system.settings.validate().is_ok());
    system.settings.time_step = 0.0;
    assert!(system.settings.validate().is_err());
}

/// A wall that moves freely up and down and is driven sideways: a disc between two such walls under a load rolls
/// with half the speed, and carries the load.
#[test]
fn a_disc_rolls_under_a_driven_wall() {
    let mut system = System::new(1e-3, law(0.5, 0.0, GapRule::Predicted));
    system.body(0, 0.5, (0.0, 0.5), 0.0, Velocity::default());
    system.floor(0.0);
    let configuration = &mut system.state.configuration;
    let vertical = InverseMass {
        x: 0.0,
        y: 0.5,
        rotation: 0.0,
    };
    let unit = system
        .assembly
        .add_unit(configuration, vertical, moving(1.0, 0.0, 0.0))
        .unwrap();
    let wall = HalfPlane {
        position: Vec2::new(0.0, 1.0),
        normal: Vec2::new(0.0, -1.0),
    };
    system.assembly.add_wall(configuration, wall, unit).unwrap();
    system.assembly.load[unit as usize].force = Vec2::new(0.0, -50.0);
    system.steps(1000);
    let v = system.velocity(0);
    assert!((v.linear.x - 0.5).abs() < 1e-9 && v.linear.y.abs() < 1e-9);
    assert!((v.angular + 1.0).abs() < 1e-9);
    let impulses = system.impulses();
    assert!(impulses.iter().all(|p| (p.n - 0.05).abs() < 1e-9));
}

/// A torque turns a body, and bodies of one unit do not touch each other.
#[test]
fn units_turn_under_torques_and_do_not_touch_themselves() {
    let mut system = System::new(0.1, law(0.4, 0.0, GapRule::Closed));
    let unit = system.body(0, 0.5, (5.0, 0.0), 0.0, Velocity::default());
    system.assembly.load[unit].torque = 1.0;
    let shape = system.assembly.shape[0];
    let (assembly, configuration) = (&mut system.assembly, &mut system.state.configuration);
    let free_to_slide = InverseMass {
        x: 1.0,
        y: 1.0,
        rotation: 0.0,
    };
    let block = assembly
        .add_unit(configuration, free_to_slide, Velocity::default())
        .unwrap();
    for x in [0.0, 0.4] {
        let body = Body {
            shape,
            scale: 0.5,
            position: Vec2::new(x, 0.0),
            angle: 0.0,
        };
        assembly.add_body(configuration, body, block).unwrap();
    }
    let report = system.steps(10);
    assert_eq!(report.points, 0);
    let moment_of_inertia = 0.5 * core::f64::consts::PI * 0.5f64.powi(4);
    assert!((system.velocity(unit).angular * moment_of_inertia - 1.0).abs() < 1e-12);
    // The trapezoidal rule.
    assert!((system.state.configuration.angle[0] * moment_of_inertia - 0.5).abs() < 1e-12);
}

/// The same bits for the same start, and for a copy of a state with fresh buffers.
#[test]
fn states_are_reproduced_to_the_bit() {
    let heap = || {
        let mut random = Uniform::new(4);
        let mut system = System::new(0.01, law(0.4, 0.0, GapRule::Predicted));
        for k in 0..30 {
            let place = (f64::from(k % 6) * 0.95, 0.6 + 1.05 * f64::from(k / 6));
            let angle = random.within(-3.0, 3.0);
            system.body(
                [0, 3, 4, 6, 17][k as usize % 5],
                0.45,
                place,
                angle,
                moving(0.0, -0.5, 0.0),
            );
        }
        system.floor(0.0);
        system.gravity(0.0, -1.0);
        system.settings.sweeps.max_sweeps = 50;
        system
    };
    let (mut one, mut other) = (heap(), heap());
    one.steps(60);
    other.steps(30);
    other.forget_buffers();
    assert!(other.steps(30).points > 8);
    assert_eq!(one.state.configuration, other.state.configuration);
}
