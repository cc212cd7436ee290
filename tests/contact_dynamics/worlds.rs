//! Worlds: driven cells, the balance of energy, records, steps that fail.

use crate::cells::{COMPACTION, compacted, loose, settings};
use crate::systems::{System, law, moving};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::cell::{Cell, Drive, LOWER, Speed, UPPER, roof_height};
use gouge_contact_dynamics::error::StepError;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::preparation::glue;
use gouge_contact_dynamics::shape::Shapes;
use gouge_contact_dynamics::units::{InverseMass, Load};
use gouge_contact_dynamics::world::World;

fn shear(speed: Speed) -> Drive {
    Drive::Shear {
        normal_stress: 1.0,
        speed,
    }
}

fn glued(sides: Option<usize>) -> Cell {
    glue(&compacted(sides, 120, 2), 0.03, 1.0).unwrap()
}

/// Kinetic energy changes by the work that is booked, to rounding, with friction, restitution, overlaps that are
/// corrected, a loaded wall and an imposed velocity; and each term has the sign of what it stands for.
#[test]
fn the_balance_of_energy_closes() {
    for restitution in [Components::default(), Components { n: 0.6, t: 0.3 }] {
        let mut settings = settings(0.4, 1e-3);
        settings.law.restitution = restitution;
        let drive = shear(Speed::Rate(0.01));
        let world = World::of_cell(glued(Some(4)), settings, drive).unwrap();
        let mut world = world.with_work(true);
        let beginning = world.kinetic_energy();
        for _ in 0..200 {
            world.step().unwrap();
        }
        let work = world.work().unwrap();
        let change = world.kinetic_energy() - beginning;
        assert!(
            (change - work.total()).abs() < 1e-12 * work.drive,
            "{work:?}"
        );
        assert!(work.drive > 0.1 && work.friction < 0.0, "{work:?}");
        assert!(work.collision < 0.0, "{work:?}");
        assert!(
            work.correction >= 0.0 && work.correction < 0.1 * work.drive,
            "{work:?}"
        );
    }
}

/// A disc between a floor and a roof at the same imposed velocity slides until it rolls: the floor does no work, and
/// the work of the roof is what friction takes and the disc gains.
#[test]
fn the_drive_does_the_work_of_its_reaction() {
    let roof = InverseMass {
        y: 1.0,
        ..InverseMass::IMPOSED
    };
    let mut shapes = Shapes::new();
    let shape = shapes.add_disc();
    let mut cell = Cell::new(10.0, 1.0, roof, shapes).unwrap();
    let body = gouge_contact_dynamics::assembly::Body {
        shape,
        scale: 0.5,
        position: Vec2::new(5.0, 0.5),
        angle: 0.0,
    };
    let rest = moving(0.0, 0.0, 0.0);
    let configuration = &mut cell.state.configuration;
    cell.assembly
        .add_free(configuration, body, 1.0, rest)
        .unwrap();
    let mut exact = settings(0.5, 1e-15);
    exact.time_step = 1e-3;
    exact.sweeps.max_sweeps = 5000;
    let mut world = World::of_cell(cell, exact, shear(Speed::Constant(1.0))).unwrap();
    world = world.with_work(true);
    // The load is 10 N on the width of 10 m, so that friction is 5 N at the roof while the disc slides there.
    world.step().unwrap();
    let work = world.work().unwrap();
    assert!((work.drive - 5.0 * 1.0 * 1e-3).abs() < 1e-9, "{work:?}");
    for _ in 0..2000 {
        world.step().unwrap();
    }
    let [mass, moment] = [0.25, 0.03125].map(|factor| factor * core::f64::consts::PI);
    // It rolls at half the speed of the roof with the angular velocity -1.
    let kinetic = 0.5 * mass * 0.25 + 0.5 * moment;
    assert!((world.kinetic_energy() - kinetic).abs() < 1e-9);
    let work = world.work().unwrap();
    assert!(
        (work.drive + work.friction - kinetic).abs() < 1e-9,
        "{work:?}"
    );
    assert!(work.friction < -1e-3);
}

#[test]
fn a_constant_rate_follows_the_height() {
    for speed in [Speed::Rate(0.01), Speed::Constant(0.05)] {
        let cell = glued(None);
        let height = cell.height();
        let mut world = World::of_cell(cell, settings(0.4, 1e-2), shear(speed)).unwrap();
        let mut strain = 0.0;
        for _ in 0..100 {
            let height = roof_height(world.state());
            world.step().unwrap();
            let velocity = world.state().configuration.velocity[UPPER as usize]
                .linear
                .x;
            strain += velocity * 0.05 / height;
        }
        let wanted = match speed {
            Speed::Rate(rate) => 100.0 * 0.05 * rate,
            Speed::Constant(velocity) => 100.0 * 0.05 * velocity / height,
        };
        let tolerance = if speed == Speed::Rate(0.01) {
            1e-12
        } else {
            0.02
        };
        assert!((strain / wanted - 1.0).abs() < tolerance);
        let floor = world.state().configuration.velocity[LOWER as usize].linear;
        assert_eq!(floor, Vec2::zero());
    }
}

/// Two worlds, one of them stopped, recorded and continued in each step.
#[test]
fn a_record_continues_bit_by_bit() {
    let drives = [
        (loose(Some(3), 80, 4), COMPACTION, 230),
        (glued(Some(6)), shear(Speed::Rate(0.01)), 40),
    ];
    for (cell, drive, steps) in drives {
        let make = || {
            let world = World::of_cell(cell.clone(), settings(0.4, 1e-2), drive).unwrap();
            world.with_work(true)
        };
        let (mut straight, mut stopped) = (make(), make());
        for step in 0..steps {
            straight.step().unwrap();
            if step % 7 == 0 {
                stopped = make().restored(&stopped.record()).unwrap();
            }
            stopped.step().unwrap();
            assert_eq!(straight.record(), stopped.record(), "step {step}");
        }
        assert_eq!(straight.steps(), steps);
        assert_eq!(straight.has_settled(), stopped.has_settled());
    }
}

#[test]
fn records_of_other_worlds_are_refused() {
    let make = |number| {
        let cell = loose(None, number, 4);
        World::of_cell(cell, settings(0.4, 1e-2), COMPACTION).unwrap()
    };
    let mut world = make(20);
    for _ in 0..50 {
        world.step().unwrap();
    }
    let record = world.record();
    assert!(make(20).restored(&record).is_some());
    assert!(make(21).restored(&record).is_none());
    let mut other = record.clone();
    other.model = "dem".to_owned();
    assert!(make(20).restored(&other).is_none());
    for column in 0..record.columns.len() {
        let mut broken = record.clone();
        broken.columns[column].words.push(0);
        assert!(make(20).restored(&broken).is_none(), "{column}");
        let mut renamed = record.clone();
        renamed.columns[column].name.push('x');
        assert!(make(20).restored(&renamed).is_none());
    }
    let mut beyond = record;
    let impulses = beyond.columns.last_mut().unwrap();
    impulses.words.extend([3, 99, 0, 0, 0, 0, 0]);
    assert!(make(20).restored(&beyond).is_none());
}

#[test]
fn steps_that_make_no_sense_fail() {
    let make = |speed: f64, force: f64| {
        let mut system = System::new(1.0, law(0.4, 0.0, GapRule::Predicted));
        system.body(0, 0.5, (0.0, 0.0), 0.0, moving(speed, 0.0, 0.0));
        system.assembly.load[0] = Load {
            force: Vec2::new(force, 0.0),
            torque: 0.0,
        };
        World::new(system.assembly, system.state, system.settings).unwrap()
    };
    assert!(make(0.9, 0.0).step().is_ok());
    let too_fast = make(1.1, 0.0).step();
    assert!(matches!(too_fast, Err(StepError::TooFast { body: 0, .. })));
    let infinite = make(0.0, f64::INFINITY).step();
    assert!(matches!(
        infinite,
        Err(StepError::NotFinite { unit: 0, .. })
    ));
}

#[test]
fn drives_out_of_range_are_refused() {
    let cell = || loose(None, 20, 4);
    let compaction = |slowing, window| Drive::Compaction {
        normal_stress: 1.0,
        largest_speed: 1.0,
        slowing,
        window,
        settled_distance: 0.1,
    };
    let wrong = [
        Drive::Shear {
            normal_stress: -1.0,
            speed: Speed::Rate(1.0),
        },
        shear(Speed::Rate(f64::NAN)),
        compaction(1.1, 1),
        compaction(0.9, 0),
    ];
    for drive in wrong {
        assert!(World::of_cell(cell(), settings(0.4, 1e-2), drive).is_err());
    }
    let roof = InverseMass::IMPOSED;
    assert!(Cell::new(0.0, 1.0, roof, Shapes::new()).is_err());
    assert!(Cell::new(1.0, f64::NAN, roof, Shapes::new()).is_err());
}
