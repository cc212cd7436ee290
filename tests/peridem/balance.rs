//! Momentum and energy of whole runs.

use crate::cloud::{
    H, at_rest, contact, disc, energy, forces, grain, lattice, momenta, run, settings, throw,
    walls, world,
};
use gouge_common::geometry::Vec2;
use gouge_peridem::grain::Grain;
use gouge_peridem::limits::{BondLimits, Limits};
use gouge_peridem::material::Weight;
use gouge_peridem::world::{Beginning, World};

const WEIGHTS: [Weight; 3] = [Weight::Constant, Weight::Conic, Weight::Parabolic];

#[test]
fn rigid_motions_exert_no_forces() {
    for weight in WEIGHTS {
        let (grains, mut state) = at_rest(&[grain(disc(Vec2::zero(), 5.0 * H), 3.015, weight)]);
        let constants = grains.rows[0].constants;
        // Forces if every bond had a stretch of one.
        let numbers = state.bonds.numbers().iter().max().unwrap();
        let scale = constants.stiffness * f64::from(*numbers) * H * H;
        for place in &mut state.places {
            let turned = place.reference.perpendicular();
            place.displacement = turned - place.reference + Vec2::new(0.3, -0.1) * H;
        }
        let largest = forces(&grains, &settings(1e-8), &state)
            .iter()
            .map(|f| f.norm())
            .fold(0.0, f64::max);
        assert!(largest < 1e-12 * scale, "{weight:?}: {largest:e} {scale:e}");
    }
}

/// Two discs that are about to collide off centre, the second with larger nodes.
fn colliding() -> [Grain; 2] {
    let first = grain(disc(Vec2::zero(), 3.6 * H), 3.015, Weight::Constant);
    let mut second = grain(
        disc(Vec2::new(8.2, 2.3) * H, 3.6 * H),
        3.015,
        Weight::Constant,
    );
    second.density *= 1.7;
    [first, second]
}

/// A collision with coefficients of damping and friction, advanced by a number of steps of a fraction of the limit.
fn collision(damping: f64, friction: f64, fraction: f64) -> World {
    let mut settings = settings(1.0);
    settings.contact = Some(contact(damping, friction));
    let grains = colliding();
    let (all, state) = at_rest(&grains);
    let limits = Limits::of(&all, &state.bonds, &settings);
    settings.time_step = fraction * limits.smallest().1;
    world(&grains, settings, |state| {
        throw(&all, state, 0, Vec2::new(10.0, 3.0));
        throw(&all, state, 1, Vec2::new(-10.0, 0.0));
    })
}

#[test]
fn collisions_conserve_momentum() {
    for (damping, friction) in [(0.0, 0.0), (0.5, 0.0), (0.5, 0.8)] {
        let mut world = collision(damping, friction, 0.5);
        let (linear, angular) = momenta(&world);
        let mass: f64 = (0..world.grains().nodes())
            .map(|node| world.grains().mass(node))
            .sum();
        run(&mut world, 800);
        let (after, angular_after) = momenta(&world);
        let turned = world.state().velocity[0].x;
        assert!(turned < 5.0, "no collision: {turned}");
        assert!(
            (after - linear).norm() < 1e-12 * mass * 10.0,
            "{damping} {friction}"
        );
        let change = (angular_after - angular).abs() / (mass * 10.0 * 8.0 * H);
        assert!(change < 1e-12 || friction > 0.0, "{damping}: {change:e}");
        if friction > 0.0 {
            assert!(world.state().work.friction > 0.0 && world.state().work.damping > 0.0);
        }
    }
}

/// Largest error of the energy, with losses booked, relative to the kinetic energy at the beginning.
fn ledger_error(mut world: World, steps: usize) -> f64 {
    let sum = |world: &World| {
        let work = world.state().work;
        energy(world) + work.damping + work.friction + work.broken - work.walls
    };
    let (before, scale) = (sum(&world), world.energies().kinetic);
    let mut largest = 0.0_f64;
    for _ in 0..steps {
        run(&mut world, 1);
        largest = largest.max((sum(&world) - before).abs() / scale);
    }
    largest
}

/// Mean order by which an error falls while the step is halved twice.
fn order(error: impl Fn(f64, usize) -> f64) -> f64 {
    let errors = [1, 2, 4].map(|part| error(0.4 / part as f64, 800 * part));
    assert!(errors[0] > errors[1] && errors[1] > errors[2], "{errors:?}");
    0.5 * (errors[0] / errors[2]).log2()
}

#[test]
fn the_energy_of_an_elastic_collision_is_of_second_order() {
    let found = order(|fraction, steps| ledger_error(collision(0.0, 0.0, fraction), steps));
    assert!((found - 2.0).abs() < 0.25, "{found:?}");
}

#[test]
fn the_ledger_of_friction_and_damping_closes_at_first_order() {
    let found = order(|fraction, steps| ledger_error(collision(0.3, 0.4, fraction), steps));
    assert!((found - 1.0).abs() < 0.25, "{found:?}");
}

/// A disc thrown at one wall, or into a corner.
fn bounce(velocity: Vec2, fraction: f64) -> World {
    let grains = [grain(disc(Vec2::zero(), 3.6 * H), 3.015, Weight::Constant)];
    let mut settings = settings(1.0);
    settings.walls = Some(walls(0.0, 0.0));
    let (all, state) = at_rest(&grains);
    settings.time_step = fraction * BondLimits::of(&all, &state.bonds).exact;
    world(&grains, settings, |state| {
        state.walls = [-6.0 * H, 20.0 * H, 20.0 * H, -6.0 * H];
        throw(&all, state, 0, velocity);
    })
}

#[test]
fn the_ledger_of_elastic_walls_and_corners_closes_at_second_order() {
    for velocity in [Vec2::new(0.0, -10.0), Vec2::new(-10.0, -9.0)] {
        let mut one = bounce(velocity, 0.4);
        let before = momenta(&one).0;
        run(&mut one, 800);
        let after = momenta(&one).0;
        assert!(after.y > 0.5 * before.norm() / 2.0, "{after:?} {before:?}");
        let found = order(|fraction, steps| ledger_error(bounce(velocity, fraction), steps));
        assert!((found - 2.0).abs() < 0.25, "{velocity:?} {found:?}");
    }
}

/// A wall that moves up against a disc at rest, or one at rest that a disc falls on: the same motion, seen by another one.
#[test]
fn the_ledger_of_walls_that_move_damp_and_rub_closes_at_first_order() {
    let speed = 10.0;
    let pushed = |of_wall: f64, fraction: f64| {
        let mut world = bounce(Vec2::new(4.0, of_wall - speed), fraction);
        let mut settings = world.settings().clone();
        settings.walls = Some(walls(0.4, 0.3));
        settings.walls.as_mut().unwrap().velocity[3] = of_wall;
        let (grains, state) = (world.grains().clone(), world.state().clone());
        world = World::new(grains, settings, state, Beginning::Forces).unwrap();
        world
    };
    for of_wall in [0.0, 4.0, speed] {
        let found = order(|fraction, steps| ledger_error(pushed(of_wall, fraction), steps));
        assert!((found - 1.0).abs() < 0.25, "{of_wall}: {found:?}");
    }
    let [at_rest, moving] = [0.0, speed].map(|of_wall| {
        let mut world = pushed(of_wall, 0.1);
        let before = momenta(&world).0;
        run(&mut world, 3200);
        (world.state().work, momenta(&world).0 - before)
    });
    let (work, momentum) = moving;
    for (lost, seen) in [
        (at_rest.0.damping, work.damping),
        (at_rest.0.friction, work.friction),
    ] {
        assert!((seen / lost - 1.0).abs() < 1e-9, "{at_rest:?} {moving:?}");
    }
    // Seen from elsewhere, the whole force of the wall does work, with damping and friction.
    let more = (work.walls - at_rest.0.walls) / (speed * momentum.y);
    assert!((more - 1.0).abs() < 1e-9, "{more}");
}

#[test]
fn reactions_of_walls_are_the_change_of_momentum() {
    let mut world = bounce(Vec2::new(-3.0, -10.0), 0.4);
    let step = world.settings().time_step;
    let before = momenta(&world).0;
    let mut impulse = Vec2::zero();
    for _ in 0..1500 {
        run(&mut world, 1);
        for reaction in world.reactions() {
            impulse += reaction * step;
        }
    }
    let change = momenta(&world).0 - before;
    let error = (change + impulse).norm() / before.norm();
    assert!(error < 1e-10 && change.y > 0.0, "{error:e} {change:?}");
}

#[test]
fn gravity_and_loads_have_a_potential() {
    let mut block = grain(lattice(4, 4), 3.015, Weight::Constant);
    block.load = vec![Vec2::new(3e6, 1e6); 16];
    block.clamped = vec![0, 1, 2, 3];
    let (grains, state) = at_rest(std::slice::from_ref(&block));
    let step = 0.4 * BondLimits::of(&grains, &state.bonds).exact;
    let error = |fraction: f64, steps: usize| {
        let mut settings = settings(fraction * step);
        settings.gravity = Vec2::new(0.0, -5000.0);
        let mut world = world(std::slice::from_ref(&block), settings, |_| ());
        let (mut largest, mut kinetic) = (0.0_f64, 0.0_f64);
        for _ in 0..steps / 4 {
            run(&mut world, 1);
            largest = largest.max(energy(&world).abs());
            kinetic = kinetic.max(world.energies().kinetic);
        }
        assert_eq!(world.state().places[2].displacement, Vec2::zero());
        largest / kinetic
    };
    let found = order(error);
    assert!((found - 2.0).abs() < 0.25, "{found:?}");
}
