//! Numbers outside their ranges: where a range ends, and that errors repeat numbers as they were given.

use crate::cells::settings;
use crate::systems::{OPEN, law, moving};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::assembly::{Assembly, Body, Configuration};
use gouge_contact_dynamics::cell::{Cell, Drive, Speed};
use gouge_contact_dynamics::detection::HalfPlane;
use gouge_contact_dynamics::error::{SetupError, StepError};
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::preparation::{DiameterRange, deposit};
use gouge_contact_dynamics::shape::Shapes;
use gouge_contact_dynamics::step::{State, StepSettings};
use gouge_contact_dynamics::units::{InverseMass, Velocity};
use gouge_contact_dynamics::world::World;

const WRONG: f64 = -1.3;
/// A little more and a little less than one.
pub const MORE: f64 = 1.0 + 1e-9;
pub const LESS: f64 = 1.0 - 1e-9;

/// The number that was refused.
#[track_caller]
fn refused<T>(result: Result<T, SetupError>) -> f64 {
    match result {
        Err(SetupError::Parameter { value, .. }) => value,
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("accepted"),
    }
}

#[track_caller]
fn refuses<T>(result: Result<T, SetupError>, number: f64) {
    assert_eq!(refused(result), number);
}

/// An assembly with a unit that turns, which has a body.
fn turning() -> (Assembly, Configuration, Body) {
    let mut shapes = Shapes::new();
    let body = Body {
        shape: shapes.add_disc(),
        scale: 1.0,
        position: Vec2::zero(),
        angle: 0.0,
    };
    let (mut assembly, mut configuration) = (Assembly::new(OPEN, shapes), Configuration::default());
    let mass = InverseMass {
        x: 1.0,
        y: 1.0,
        rotation: 0.7,
    };
    let unit = assembly.add_unit(&mut configuration, mass, Velocity::default());
    let body_in_unit = assembly.add_body(&mut configuration, body, unit.unwrap());
    body_in_unit.unwrap();
    (assembly, configuration, body)
}

#[test]
fn bodies_and_walls_out_of_range_are_refused() {
    let (mut assembly, mut configuration, body) = turning();
    for part in 0..3 {
        let mut numbers = [1.0; 3];
        numbers[part] = WRONG;
        let [x, y, rotation] = numbers;
        let mass = InverseMass { x, y, rotation };
        let unit = assembly.add_unit(&mut configuration, mass, Velocity::default());
        refuses(unit, WRONG);
    }
    let inverted = Body {
        scale: WRONG,
        ..body
    };
    refuses(assembly.add_body(&mut configuration, inverted, 0), WRONG);
    refuses(assembly.add_body(&mut configuration, body, 0), 0.7);
    let wall = |y: f64| HalfPlane {
        position: Vec2::zero(),
        normal: Vec2::new(0.0, y),
    };
    refuses(assembly.add_wall(&mut configuration, wall(1.0), 0), 0.7);
    refuses(assembly.add_wall(&mut configuration, wall(MORE), 0), MORE);
    refuses(InverseMass::free(WRONG, 1.0), WRONG);
    refuses(InverseMass::free(1.0, WRONG), WRONG);
    // The inverse must be finite.
    for (factor, is_fine) in [(1.0 + 1e-7, true), (1.0 - 1e-7, false)] {
        let tiny = factor / f64::MAX;
        assert_eq!(InverseMass::free(tiny, 1.0).is_ok(), is_fine);
        assert_eq!(InverseMass::free(1.0, tiny).is_ok(), is_fine);
    }
}

/// The largest number is finite, too.
#[test]
fn finite_numbers_of_any_size_are_accepted() {
    let far = f64::MAX;
    for (x, y, angle) in [(far, 0.0, 0.0), (0.0, far, 0.0), (0.0, 0.0, far)] {
        let (mut assembly, mut configuration, body) = turning();
        let free = InverseMass::free(1.0, 1.0).unwrap();
        let fast = moving(x, y, angle);
        let unit = assembly.add_unit(&mut configuration, free, fast).unwrap();
        let body = Body {
            position: Vec2::new(x, y),
            angle,
            ..body
        };
        assembly.add_body(&mut configuration, body, unit).unwrap();
        let mut empty = Assembly::new(OPEN, Shapes::new());
        let mut state = State::default();
        empty
            .add_unit(&mut state.configuration, free, fast)
            .unwrap();
        // Without a body nothing can pass a body unseen.
        let mut world = World::new(empty, state, settings(0.4, 1e-3)).unwrap();
        assert!(world.step().is_ok());
    }
    assert!(Cell::new(far, 1.0, InverseMass::IMPOSED, Shapes::new()).is_ok());
}

#[test]
fn laws_out_of_range_are_refused() {
    let refuses_law = |law: ContactLaw, number| refuses(law.validate(), number);
    refuses_law(law(WRONG, 0.0, GapRule::Closed), WRONG);
    for e in [WRONG, MORE] {
        refuses_law(law(0.4, e, GapRule::Closed), e);
    }
    for t in [WRONG, -MORE, MORE] {
        let restitution = Components { n: 0.0, t };
        let rebounding = ContactLaw {
            restitution,
            ..ContactLaw::inelastic(0.4)
        };
        refuses_law(rebounding, t);
    }
    for (fraction, allowed_overlap, number) in
        [(WRONG, 0.0, WRONG), (MORE, 0.0, MORE), (1.0, WRONG, WRONG)]
    {
        let gap = GapRule::Stabilized {
            fraction,
            allowed_overlap,
        };
        refuses_law(law(0.4, 0.0, gap), number);
    }
    let limits = law(0.4, 1.0, GapRule::Closed);
    for t in [-1.0, 1.0] {
        let restitution = Components { n: 1.0, t };
        assert!(
            ContactLaw {
                restitution,
                ..limits
            }
            .validate()
            .is_ok()
        );
    }
}

#[test]
fn settings_out_of_range_are_refused() {
    let refuses_setting = |change: &dyn Fn(&mut StepSettings), number| {
        let mut settings = settings(0.4, 1e-3);
        change(&mut settings);
        refuses(settings.validate(), number);
    };
    refuses_setting(&|s| s.time_step = WRONG, WRONG);
    refuses_setting(&|s| s.detection.alert_distance = WRONG, WRONG);
    refuses_setting(&|s| s.detection.merge_distance = WRONG, WRONG);
    refuses_setting(&|s| s.detection.tie_distance = WRONG, WRONG);
    refuses_setting(&|s| s.warm_start_distance = WRONG, WRONG);
    refuses_setting(&|s| s.sweeps.largest_residual = Some(WRONG), WRONG);
    refuses_setting(&|s| s.sweeps.momentum = WRONG, WRONG);
    refuses_setting(&|s| s.sweeps.momentum = 1.0, 1.0);
    let mut zero = settings(0.4, 1e-3);
    zero.warm_start_distance = 0.0;
    let lengths = &mut zero.detection;
    lengths.alert_distance = 0.0;
    (lengths.merge_distance, lengths.tie_distance) = (0.0, 0.0);
    assert!(zero.validate().is_ok());
}

/// The first vertex at which a polygon does not turn is named.
#[test]
fn straight_angles_are_no_vertices() {
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (-1.0, 2.0), (-1.0, 0.0)];
    for first in 0..5 {
        let vertices: Vec<_> = (0..5)
            .map(|k| corners[(first + k) % 5])
            .map(|(x, y)| Vec2::new(x, y))
            .collect();
        let vertex = (5 - first) % 5;
        let found = Shapes::new().add_polygon(&vertices);
        assert_eq!(found, Err(SetupError::NotConvex { vertex }));
    }
}

#[test]
fn cells_and_drives_out_of_range_are_refused() {
    let cell = |width, height| Cell::new(width, height, InverseMass::IMPOSED, Shapes::new());
    refuses(cell(WRONG, 1.0), WRONG);
    refuses(cell(1.0, WRONG), WRONG);
    let shear = |normal_stress, speed| {
        let speed = Speed::Rate(speed);
        Drive::Shear {
            normal_stress,
            speed,
        }
        .validate()
    };
    refuses(shear(WRONG, 1.0), WRONG);
    assert!(shear(1.0, f64::MAX).is_ok());
    let compaction = |normal_stress, largest_speed, slowing, settled_distance| {
        Drive::Compaction {
            normal_stress,
            largest_speed,
            slowing,
            window: 1,
            settled_distance,
        }
        .validate()
    };
    refuses(compaction(WRONG, 1.0, 1.0, 1.0), WRONG);
    refuses(compaction(1.0, WRONG, 1.0, 1.0), WRONG);
    refuses(compaction(1.0, 1.0, WRONG, 1.0), WRONG);
    refuses(compaction(1.0, 1.0, MORE, 1.0), MORE);
    refuses(compaction(1.0, 1.0, 1.0, WRONG), WRONG);
    assert!(compaction(1.0, 1.0, 1.0, 1.0).is_ok());
}

#[test]
fn samples_out_of_range_are_refused() {
    refuses(DiameterRange::with_mean(WRONG, 2.0), WRONG);
    refuses(DiameterRange::with_mean(1.0, LESS), LESS);
    refuses(DiameterRange::printed(WRONG), WRONG);
    refuses(deposit(&[WRONG], 9.0), WRONG);
    refuses(deposit(&[1.0], 4.0 * LESS), 4.0 * LESS);
    assert!(deposit(&[1.0], 4.0).is_ok());
}

/// A body may move by its diameter per step, and not by more.
#[test]
fn a_step_that_is_too_long_says_how_far_the_body_would_go() {
    let step = |speed: f64| {
        let (mut assembly, mut state) = (Assembly::new(OPEN, Shapes::new()), State::default());
        let shape = assembly.shapes.add_regular(3).unwrap();
        let body = Body {
            shape,
            scale: 0.7,
            position: Vec2::zero(),
            angle: 0.0,
        };
        let configuration = &mut state.configuration;
        let fast = moving(0.6 * speed, -0.8 * speed, 0.0);
        assembly.add_free(configuration, body, 1.0, fast).unwrap();
        let mut settings = settings(0.4, 1e-3);
        settings.time_step = 0.5;
        World::new(assembly, state, settings).unwrap().step()
    };
    // The circumscribed circle has the diameter 1.4 m.
    assert!(step(2.8 * LESS).is_ok());
    let Err(StepError::TooFast {
        distance,
        limit,
        time,
        ..
    }) = step(2.8 * MORE)
    else {
        panic!("accepted");
    };
    assert!((distance - 1.4 * MORE).abs() < 1e-14 && (limit - 1.4).abs() < 1e-14);
    assert_eq!(time, 0.5);
}
