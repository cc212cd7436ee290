//! Sliding and sticking blocks.

use crate::cloud::{H, at_rest, contact, grain, lattice, run, settings, throw, walls, world};
use gouge_common::geometry::Vec2;
use gouge_peridem::limits::Limits;
use gouge_peridem::material::Weight;
use gouge_peridem::world::{Beginning, World};

const GRAVITY: f64 = 1e4;
const FRICTION: f64 = 0.4;

/// Mean horizontal and vertical velocity of a grain.
fn mean_velocity(world: &World, grain: usize) -> Vec2 {
    let nodes = world.grains().rows[grain].nodes.clone();
    let number = nodes.len() as f64;
    let sum = nodes.fold(Vec2::zero(), |sum, node| sum + world.state().velocity[node]);
    sum * (1.0 / number)
}

/// A block on a floor.
fn on_floor(speed: f64) -> World {
    let block = grain(lattice(16, 4), 3.015, Weight::Constant);
    let mut settings = settings(1e-7);
    settings.gravity = Vec2::new(0.0, -GRAVITY);
    settings.walls = Some(walls(0.5, FRICTION));
    let mut world = world(&[block], settings, |state| state.walls[3] = -1.45 * H);
    // Let it come to rest on the floor before it is pushed.
    run(&mut world, 6000);
    let (grains, settings) = (world.grains().clone(), world.settings().clone());
    let mut state = world.state().clone();
    throw(&grains, &mut state, 0, Vec2::new(speed, 0.0));
    World::new(grains, settings, state, Beginning::Forces).unwrap()
}

#[test]
fn a_block_slides_on_a_wall_with_the_coefficient_of_friction() {
    let mut world = on_floor(2.0);
    let (mut force, before) = (Vec2::zero(), mean_velocity(&world, 0));
    let steps = 400;
    for _ in 0..steps {
        run(&mut world, 1);
        force += world.reactions()[3];
    }
    assert!(
        (force.x / force.y.abs() / FRICTION - 1.0).abs() < 0.01,
        "{force:?}"
    );
    let time = f64::from(steps) * world.settings().time_step;
    let deceleration = (before.x - mean_velocity(&world, 0).x) / time;
    assert!(
        (deceleration / (FRICTION * GRAVITY) - 1.0).abs() < 0.1,
        "{deceleration}"
    );
}

#[test]
fn a_block_stops_on_a_wall_and_stays() {
    let mut world = on_floor(0.2);
    let mut lowest = f64::INFINITY;
    for _ in 0..4000 {
        run(&mut world, 1);
        lowest = lowest.min(mean_velocity(&world, 0).x);
    }
    let last = mean_velocity(&world, 0).x.abs();
    assert!(lowest > -0.1 * 0.2 && last < 0.01 * 0.2, "{lowest} {last}");
}

/// A free node between two clamped rows, as far from either as from its neighbours, that moves along them.
fn in_slot(shares: bool, speed: f64) -> World {
    let rows = [-1.2 * H, 1.2 * H].map(|y| (-4..=4).map(move |x| Vec2::new(f64::from(x) * H, y)));
    let mut fixed = grain(rows.into_iter().flatten().collect(), 0.5, Weight::Constant);
    fixed.clamped = (0..18).collect();
    let grains = [fixed, grain(vec![Vec2::zero()], 0.5, Weight::Constant)];
    let (all, state) = at_rest(&grains);
    let mut settings = settings(1.0);
    let mut contact = contact(0.0, 5.0);
    contact.law.radius = 2.9 * H;
    contact.shares_sticking = shares;
    settings.contact = Some(contact);
    settings.time_step = 1e-3 * Limits::of(&all, &state.bonds, &settings).contact;
    world(&grains, settings, |state| {
        throw(&all, state, 1, Vec2::new(speed, 0.0));
    })
}

#[test]
fn many_contacts_stop_a_node_only_if_they_share_its_sticking() {
    let speed = 1e-9;
    let left = [true, false].map(|shares| {
        let mut world = in_slot(shares, speed);
        run(&mut world, 200);
        world.state().velocity[18].x.abs() / speed
    });
    assert!(left[0] < 1e-3 && left[1] > 10.0, "{left:?}");
}

#[test]
fn sticking_with_the_previous_velocity_halves_the_speed_with_a_sign() {
    // One node on a floor with a push that limits friction to more than it needs: with the accelerations
    // -v/dt of the previous velocities, velocity Verlet has v'' = (v' - v)/2.
    let single = grain(vec![Vec2::zero()], 0.5, Weight::Constant);
    let mut settings = settings(1e-7);
    let mut floor = walls(0.0, 2.0);
    floor.law.stiffness *= 1e-3;
    settings.walls = Some(floor);
    let mut world = world(&[single], settings, |state| {
        state.walls[3] = -0.5 * H;
        state.velocity[0] = Vec2::new(1e-6, 0.0);
    });
    let mut before = [1e-6, 1e-6];
    for step in 0..40 {
        let expected = 0.5 * (before[1] - before[0]);
        run(&mut world, 1);
        let now = world.state().velocity[0].x;
        assert!(
            (now - expected).abs() < 1e-12 * 1e-6,
            "{step}: {now:e} {expected:e}"
        );
        before = [before[1], now];
    }
    assert!(before[1].abs() < 1e-11);
}
