//! Nodes that are too fast for contact: nothing passes unseen at the bound, and what cannot touch is never stopped.

use crate::cloud::{H, contact, grain, lattice, settings, throw, walls, world};
use crate::quadrature::Random;
use gouge_common::geometry::Vec2;
use gouge_peridem::error::{SetupError, StepError, TooFast};
use gouge_peridem::forces::Settings;
use gouge_peridem::material::Weight;
use gouge_peridem::state::State;
use gouge_peridem::world::{Beginning, World};

const STEP: f64 = 1e-8;
/// Contact radius in m.
const RADIUS: f64 = 1.5 * H;

fn touching() -> Settings {
    let mut settings = settings(STEP);
    settings.contact = Some(contact(0.0, 0.0));
    settings
}

/// The velocity in m/s of a displacement per step in contact radii.
fn velocity(x: f64, y: f64) -> Vec2 {
    Vec2::new(x, y) * (RADIUS / STEP)
}

/// Two blocks far apart, with velocities in contact radii per step.
fn pair(settings: Settings, velocities: [Vec2; 2]) -> World {
    let far = |node: &Vec2| *node + Vec2::new(1.0, 0.0);
    let other = lattice(2, 2).iter().map(far).collect();
    let blocks = [lattice(3, 3), other].map(|nodes| grain(nodes, 1.5, Weight::Constant));
    world(&blocks, settings, |state| {
        state.velocity[..9].fill(velocities[0]);
        state.velocity[9..].fill(velocities[1]);
    })
}

/// A node crosses a row of nodes that exert next to no force. Whether it was seen before it was level with them.
fn is_seen(random: &mut Random, gap: f64, moved: Vec2) -> bool {
    let row = (-20..=20).map(|k| Vec2::new(f64::from(k) * gap * RADIUS, 0.0));
    let start = -moved * random.between(3.0, 4.0) + Vec2::new(random.unit() * gap, 0.0);
    let nodes = [row.collect(), vec![start * RADIUS]];
    let grains = nodes.map(|nodes| grain(nodes, 1e-3, Weight::Constant));
    let mut settings = touching();
    settings.contact.as_mut().unwrap().stiffness = vec![vec![1e-30]];
    let mut world = world(&grains, settings, |state| {
        *state.velocity.last_mut().unwrap() = moved * (RADIUS / STEP);
    });
    let mut seen = false;
    while world.state().places[41].position().y < 0.0 {
        seen |= world.energies().contacts > 0.0;
        world.step().unwrap();
    }
    seen
}

#[test]
fn at_the_bound_no_node_passes_between_others_unseen() {
    let mut random = Random(5);
    let gap = 2.0_f64.sqrt();
    for x in [0.0, 0.2, 0.5] {
        for _ in 0..300 {
            assert!(is_seen(&mut random, gap, Vec2::new(x, 0.5)), "{x}");
        }
    }
    let unseen = (0..300).filter(|_| !is_seen(&mut random, gap, Vec2::new(0.0, 1.5)));
    assert!(unseen.count() > 30);
}

#[test]
fn nodes_may_move_by_half_a_contact_radius_relative_to_each_other() {
    let guarded = |x: f64, y: f64| pair(touching(), [velocity(x, y), Vec2::zero()]).guarded();
    let (below, above) = (0.5 - 1e-9, 0.5 + 1e-9);
    for sign in [1.0, -1.0] {
        assert!(guarded(sign * below, sign * below).is_ok());
        assert!(guarded(sign * above, 0.0).is_err() && guarded(0.0, sign * above).is_err());
    }
    let apart = [velocity(0.3, 0.0), velocity(-0.3, 0.0)];
    assert!(pair(touching(), apart).guarded().is_err());
    let common = velocity(50.0, -70.0);
    assert!(pair(touching(), [common; 2]).guarded().is_ok());
}

#[test]
fn what_cannot_touch_is_never_stopped() {
    let fast = [velocity(9.0, 0.0), Vec2::zero()];
    assert!(pair(settings(STEP), fast).guarded().is_ok());
    let single = |touches_itself: bool| {
        let mut block = grain(lattice(2, 1), 0.5, Weight::Constant);
        block.touches_itself = touches_itself;
        let prepare = |state: &mut State| state.velocity[0] = velocity(9.0, 0.0);
        world(&[block], touching(), prepare).guarded()
    };
    assert!(single(false).is_ok() && single(true).is_err());
}

#[test]
fn nodes_may_move_by_half_a_contact_radius_relative_to_walls() {
    let guarded = |node: Vec2, wall: usize, speed: f64| {
        let mut settings = touching();
        let mut walls = walls(0.0, 0.0);
        walls.velocity[wall] = speed * RADIUS / STEP;
        settings.walls = Some(walls);
        let block = grain(lattice(2, 2), 1.5, Weight::Constant);
        let world = world(&[block], settings, |state| {
            let outer = [-1.0, 1.0, 1.0, -1.0];
            state.walls[wall] = outer[wall];
            state.velocity.fill(node);
        });
        world.guarded()
    };
    for wall in 0..4 {
        let across = |distance: f64| match wall {
            0 | 1 => velocity(distance, 0.0),
            _ => velocity(0.0, distance),
        };
        let along = |distance: f64| match wall {
            0 | 1 => velocity(0.0, distance),
            _ => velocity(distance, 0.0),
        };
        assert!(guarded(along(9.0), wall, 0.0).is_ok(), "{wall}");
        for sign in [1.0, -1.0] {
            assert!(guarded(across(0.49 * sign), wall, 0.0).is_ok(), "{wall}");
            assert!(
                guarded(across(0.3 * sign), wall, 0.7 * sign).is_ok(),
                "{wall}"
            );
            let error = guarded(across(0.3 * sign), wall, -0.3 * sign).unwrap_err();
            assert_eq!(error.other, "a wall");
            assert!((error.distance / RADIUS - 0.6).abs() < 1e-12, "{error}");
            assert!((error.speed * STEP / RADIUS - 0.3).abs() < 1e-12, "{error}");
        }
    }
}

#[test]
fn the_error_names_the_fast_node_and_a_step_that_is_short_enough() {
    let begin = |step: f64| {
        let mut settings = touching();
        settings.time_step = step;
        let mut world = pair(settings, [Vec2::zero(); 2]);
        let mut state = world.state().clone();
        throw(world.grains(), &mut state, 1, velocity(0.1, 0.2));
        state.velocity[11] = velocity(0.0, -0.9);
        let (grains, settings) = (world.grains().clone(), world.settings().clone());
        world = World::new(grains, settings, state, Beginning::Given).unwrap();
        world.guarded()
    };
    let error = begin(STEP).unwrap_err();
    assert_eq!(
        (error.grain, error.node, error.other),
        (1, 2, "another node")
    );
    assert!((error.speed * STEP / RADIUS - 0.9).abs() < 1e-12);
    assert!((error.distance / RADIUS - 1.1).abs() < 1e-12);
    assert!((error.limit / RADIUS - 0.5).abs() < 1e-12);
    assert!(begin(error.safe_step * (1.0 - 1e-9)).is_ok());
    assert!(begin(error.safe_step * (1.0 + 1e-9)).is_err());
}

#[test]
fn a_guarded_world_stops_before_nodes_pass_each_other() {
    let mut settings = touching();
    settings.gravity = Vec2::new(0.0, -0.06 * RADIUS / (STEP * STEP));
    let mut hung = grain(lattice(1, 1), 0.5, Weight::Constant);
    hung.clamped = vec![0];
    let falling = vec![Vec2::new(1.0, 0.0)];
    let grains = [hung, grain(falling, 0.5, Weight::Constant)];
    let mut guarded = world(&grains, settings.clone(), |_| ()).guarded().unwrap();
    let mut free = world(&grains, settings, |_| ());
    let error = (0..20).find_map(|_| guarded.step().err()).unwrap();
    // In its n-th step it falls by (n - 1/2) times 0.06 radii.
    let StepError::TooFast { motion, time } = &error else {
        panic!("{error}");
    };
    assert_eq!(
        (motion.grain, motion.node, guarded.state().steps),
        (1, 0, 8)
    );
    assert!((time / STEP - 8.0).abs() < 1e-12);
    for _ in 0..20 {
        free.step().unwrap();
        if free.state().steps == 8 {
            assert_eq!(free.state(), guarded.state());
        }
    }
}

#[test]
fn safe_worlds_refuse_fast_nodes() {
    let slow = pair(touching(), [Vec2::zero(); 2]);
    let mut state = slow.state().clone();
    throw(slow.grains(), &mut state, 0, velocity(0.6, 0.0));
    let settings = slow.settings().clone();
    let refused = World::within_limits(slow.grains().clone(), settings, state, Beginning::Forces);
    let motion: Box<TooFast> = match refused {
        Err(SetupError::TooFast(motion)) => motion,
        other => panic!("{other:?}"),
    };
    assert_eq!(motion.grain, 0);
}
