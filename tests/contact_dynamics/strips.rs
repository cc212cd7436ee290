//! Sweeps by strips: the same bits for any number of threads, and the solution of other orders.

use crate::cells::{COMPACTION, random, settings};
use crate::generators::Uniform;
use crate::systems::{System, law, moving};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::cell::{Cell, Drive, Speed};
use gouge_contact_dynamics::detection::HalfPlane;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::preparation::{
    DiameterRange, Filling, deposit, draw_diameters, glue, inscribe,
};
use gouge_contact_dynamics::step::StepSettings;
use gouge_contact_dynamics::sweep::{StopCriterion, SweepOrder};
use gouge_contact_dynamics::units::{InverseMass, Velocity};
use gouge_contact_dynamics::world::World;
use std::sync::LazyLock;

const WIDTH: f64 = 50.0;

/// A wide cell that is about dense; bodies at the walls are glued to them.
static WIDE: LazyLock<Cell> = LazyLock::new(|| {
    let mut random = random(3);
    let range = DiameterRange::with_mean(1.0, 3.0).unwrap();
    let diameters = draw_diameters(range, 700, &mut random);
    let deposited = deposit(&diameters, WIDTH).unwrap();
    let filling = Filling {
        sides: Some(5),
        density: 1.0,
        roof_mass: 3.0,
    };
    let cell = inscribe(&deposited, &diameters, WIDTH, &filling, &mut random).unwrap();
    let mut settings = settings(0.0, 1e-2);
    settings.sweeps.max_sweeps = 30;
    let mut world = World::of_cell(cell, settings, COMPACTION).unwrap();
    for _ in 0..1000 {
        world.step().unwrap();
    }
    glue(&world.into_cell(), 0.05, 1.0).unwrap()
});

fn by_strips(friction: f64) -> StepSettings {
    let mut settings = settings(friction, 1e-3);
    settings.sweeps.order = SweepOrder::Strips;
    settings.sweeps.max_sweeps = 25;
    settings
}

fn sheared(settings: StepSettings) -> World {
    let drive = Drive::Shear {
        normal_stress: 1.0,
        speed: Speed::Rate(1e-2),
    };
    World::of_cell(WIDE.clone(), settings, drive).unwrap()
}

/// Velocities and impulses after some steps with a number of threads.
fn bits(settings: StepSettings, threads: usize, steps: usize) -> Vec<u64> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    let mut world = sheared(settings).with_threads(threads);
    pool.build().unwrap().install(|| {
        for _ in 0..steps {
            let report = world.step().unwrap();
            assert!(report.points > 1200, "{}", report.points);
            assert!(world.workspace().solver().strips() >= 8);
        }
    });
    let velocity = |v: &Velocity| [v.linear.x, v.linear.y, v.angular];
    let velocities = &world.state().configuration.velocity;
    let rows = world.workspace().solver().rows();
    let impulses = rows.iter().map(|row| row.impulse());
    velocities
        .iter()
        .flat_map(velocity)
        .chain(impulses.flat_map(|Components { n, t }| [n, t]))
        .map(f64::to_bits)
        .collect()
}

#[test]
fn bits_do_not_depend_on_threads() {
    let mut careful = by_strips(0.4);
    careful.sweeps.momentum = 0.9;
    careful.sweeps.largest_residual = Some(1e-3);
    for (settings, steps) in [(by_strips(0.4), 100), (careful, 20)] {
        let one = bits(settings, 1, steps);
        for threads in [2, 3, 8] {
            assert!(bits(settings, threads, steps) == one, "{threads} threads");
        }
    }
}

/// Bodies between a floor and a loaded roof, in an open box or in a periodic one.
fn pressed(period: Option<f64>) -> System {
    let mut system = System::new(0.01, law(0.4, 0.0, GapRule::Predicted));
    let mut random = Uniform::new(7);
    for k in 0..120 {
        let at = (1.02 * (k % 40) as f64, 0.5 + (k / 40) as f64);
        let velocity = moving(random.within(-0.5, 0.5), -1.0, random.within(-1.0, 1.0));
        system.body(
            [0, 3, 6, 11][k % 4],
            0.5,
            at,
            random.within(0.0, 6.0),
            velocity,
        );
    }
    system.floor(0.0);
    system.gravity(0.0, -1.0);
    if let Some(period) = period {
        system.assembly.domain.width = Some(period);
        system.assembly.domain.periodic = true;
    }
    let (assembly, configuration) = (&mut system.assembly, &mut system.state.configuration);
    let mass = InverseMass {
        y: 0.1,
        ..InverseMass::IMPOSED
    };
    let roof = assembly.add_unit(configuration, mass, Velocity::default());
    let roof = roof.unwrap();
    let wall = HalfPlane {
        position: Vec2::new(0.0, 3.1),
        normal: Vec2::new(0.0, -1.0),
    };
    assembly.add_wall(configuration, wall, roof).unwrap();
    assembly.load[roof as usize].force = Vec2::new(0.0, -30.0);
    system.settings.sweeps.stop = StopCriterion::NaturalMap { velocity: 1e-12 };
    system
}

/// The roof moves, and its points belong to no strip.
#[test]
fn velocities_are_those_of_alternating_sweeps() {
    for period in [None, Some(40.8)] {
        let run = |order, momentum| {
            let mut system = pressed(period);
            system.settings.sweeps.max_sweeps = 100;
            system.steps(100);
            system.settings.sweeps.max_sweeps = 100_000;
            (
                system.settings.sweeps.order,
                system.settings.sweeps.momentum,
            ) = (order, momentum);
            let report = system.step();
            assert!(report.sweeps.has_converged && report.points > 150);
            let is_by_strips = system.workspace().solver().strips() >= 8;
            assert_eq!(is_by_strips, order == SweepOrder::Strips);
            let roof = system.impulses().iter().rev().any(|p| p.n > 0.0);
            assert!(roof, "nothing bears the roof");
            system.state.configuration.velocity
        };
        let expected = run(SweepOrder::Alternating, 0.9);
        for momentum in [0.0, 0.9] {
            for (a, b) in expected.iter().zip(&run(SweepOrder::Strips, momentum)) {
                let difference = (a.linear - b.linear).norm() + (a.angular - b.angular).abs();
                assert!(difference < 1e-9, "{difference}");
            }
        }
    }
}

/// Each row belongs to the point at its place, and velocities follow from all impulses, across the period, too.
#[test]
fn rows_keep_the_order_of_points() {
    for momentum in [0.0, 0.9] {
        let mut settings = by_strips(0.4);
        (settings.sweeps.momentum, settings.sweeps.max_sweeps) = (momentum, 17);
        let mut world = sheared(settings);
        let before = world.state().configuration.velocity.clone();
        world.step().unwrap();
        let workspace = world.workspace();
        assert!(workspace.solver().strips() >= 8);
        let assembly = world.assembly();
        let mut velocities: Vec<_> = before
            .iter()
            .zip(&assembly.inverse_mass)
            .zip(&assembly.load)
            .map(|((&v, mass), &load)| mass.accelerated(v, load, settings.time_step))
            .collect();
        // The drive sets the velocity of the roof.
        velocities[1].linear.x = world.state().configuration.velocity[1].linear.x;
        let rows = workspace.solver().rows();
        assert_eq!(rows.len(), workspace.points().len());
        for (row, point) in rows.iter().zip(workspace.points()) {
            assert_eq!(*row.kinematics(), point.kinematics);
            let masses = &assembly.inverse_mass;
            row.kinematics()
                .apply(row.impulse(), masses, &mut velocities);
        }
        for (found, expected) in world.state().configuration.velocity.iter().zip(&velocities) {
            assert!((found.linear - expected.linear).norm() < 1e-12);
            assert!((found.angular - expected.angular).abs() < 1e-12);
        }
    }
}

/// A wide heap in an open box, of bodies that fly at each other.
fn heap(friction: f64, restitution: f64) -> System {
    let mut system = System::new(0.005, law(friction, restitution, GapRule::Closed));
    let mut random = Uniform::new(9);
    for k in 0..160 {
        let at = (1.001 * (k % 40) as f64, 0.5 + 1.001 * (k / 40) as f64);
        let speed = moving(
            random.within(-0.5, 0.5) - 0.2 * (at.0 - 20.0),
            random.within(-0.5, 0.5) - 3.0 * (at.1 - 2.0),
            random.within(-2.0, 2.0),
        );
        let angle = random.within(0.0, 6.0);
        system.body(0, 0.5, at, angle, speed);
    }
    system.floor(0.0);
    system.settings.sweeps.order = SweepOrder::Strips;
    system.settings.sweeps.momentum = 0.9;
    system.settings.sweeps.stop = StopCriterion::NaturalMap { velocity: 1e-10 };
    system
}

#[test]
fn energy_never_grows() {
    for (friction, restitution) in [(0.4, 0.0), (0.0, 0.7)] {
        let mut system = heap(friction, restitution);
        let mut energy = system.energy();
        let mut divided = 0;
        for _ in 0..100 {
            let report = system.step();
            assert!(report.sweeps.has_converged, "{friction} {report:?}");
            // Impulses do work on the residual of 1e-10 at velocities of about one.
            assert!(system.energy() <= energy * (1.0 + 1e-9));
            energy = system.energy();
            divided += usize::from(system.workspace().solver().strips() > 0);
        }
        assert!(divided > 40, "{divided}");
    }
}

/// Three touching discs fill the period: a strip would be its own neighbour on both sides.
#[test]
fn narrow_systems_are_swept_in_the_plain_order() {
    let run = |order| {
        let mut system = System::new(0.005, law(0.4, 0.0, GapRule::Predicted));
        let mut random = Uniform::new(4);
        for k in 0..90 {
            let at = ((k % 3) as f64, 0.5 + (k / 3) as f64);
            let velocity = moving(random.within(-1.0, 1.0), random.within(-1.0, 1.0), 0.0);
            system.body(0, 0.5, at, 0.0, velocity);
        }
        system.assembly.domain.width = Some(3.0);
        system.assembly.domain.periodic = true;
        system.settings.sweeps.order = order;
        system.settings.sweeps.max_sweeps = 100;
        for _ in 0..10 {
            assert!(system.step().points > 100);
            assert_eq!(system.workspace().solver().strips(), 0);
        }
        system.state
    };
    assert_eq!(run(SweepOrder::Strips), run(SweepOrder::Alternating));
}

#[test]
fn a_step_in_one_thread_allocates_nothing() {
    let mut settings = by_strips(0.4);
    settings.sweeps.momentum = 0.9;
    let mut world = sheared(settings);
    for _ in 0..20 {
        world.step().unwrap();
    }
    let info = allocation_counter::measure(|| {
        world.step().unwrap();
    });
    assert_eq!(info.count_total, 0);
}
