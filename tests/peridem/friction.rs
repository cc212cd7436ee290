//! Sliding and sticking blocks.

use crate::cloud::{H, at_rest, contact, grain, lattice, run, settings, throw, walls, world};
use gouge_common::geometry::Vec2;
use gouge_peridem::contacts::Contact;
use gouge_peridem::grain::Grain;
use gouge_peridem::limits::Limits;
use gouge_peridem::material::Weight;
use gouge_peridem::world::World;

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
    World::new(
        grains,
        settings,
        state,
        gouge_peridem::world::Beginning::Forces,
    )
    .unwrap()
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
    assert!(lowest > -0.01 && last < 0.002, "{lowest} {last}");
}

/// A block without bonds that is pressed on a clamped one, with a number of contacts per node.
fn on_block(contact: Contact, speed: f64, fraction: f64) -> (World, [Grain; 2]) {
    let mut lower = grain(lattice(24, 3), 3.015, Weight::Constant);
    lower.clamped = (0..72).collect();
    let above = lattice(8, 3)
        .iter()
        .map(|&at| at + Vec2::new(8.3, 3.2) * H)
        .collect();
    let mut upper = grain(above, 3.015, Weight::Constant);
    upper.load = vec![Vec2::new(0.0, -1e7); 24];
    let grains = [lower, upper];
    let (all, state) = at_rest(&grains);
    let mut settings = settings(1.0);
    settings.contact = Some(contact);
    settings.time_step = fraction * Limits::of(&all, &state.bonds, &settings).smallest().1;
    let world = world(&grains, settings, |state| {
        throw(&all, state, 1, Vec2::new(speed, 0.0));
    });
    (world, grains)
}

#[test]
fn many_contacts_of_a_node_stop_it_without_reversing_it() {
    let changes = |shares: bool| {
        let mut contact = contact(0.9, 5.0);
        contact.law.radius = 2.4 * H;
        contact.shares_sticking = shares;
        let (mut world, _) = on_block(contact, 1e-3, 0.2);
        let mut signs = 0;
        let mut before = mean_velocity(&world, 1).x;
        for _ in 0..60 {
            run(&mut world, 1);
            let now = mean_velocity(&world, 1).x;
            signs += usize::from(now * before < 0.0);
            before = now;
        }
        (signs, before.abs())
    };
    eprintln!("{:?} {:?}", changes(true), changes(false));
}
