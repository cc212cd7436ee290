//! Single steps against closed forms: free flight, nodes at walls, two nodes that touch, a bond that breaks.

use crate::cloud::{
    H, contact, energy, forces, grain, lattice, material, run, settings, walls, world,
};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::contact_law::ContactMaterial;
use gouge_peridem::contact_law::{ContactReading, ContactStiffness, Node};
use gouge_peridem::error::StepError;
use gouge_peridem::forces::{Settings, Workspace};
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::Weight;
use gouge_peridem::state::State;
use gouge_peridem::world::World;

fn assert_near(found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error < 1e-11 * expected.abs(), "{found:e} {expected:e}");
}

/// Grains of one node each, with different areas and densities.
fn singles(places: &[Vec2]) -> Vec<Grain> {
    let single = |(k, &place): (usize, &Vec2)| {
        let mut single = grain(vec![place], 0.5, Weight::Constant);
        single.area[0] *= 1.0 + 0.3 * k as f64;
        single.density *= 1.0 + 0.2 * k as f64;
        single
    };
    places.iter().enumerate().map(single).collect()
}

/// Forces on nodes in N/m, and the state with its losses, after one evaluation.
fn evaluated(
    grains: &[Grain],
    settings: &Settings,
    prepare: impl Fn(&mut State),
) -> (Vec<Vec2>, State) {
    let grains = Grains::new(grains).unwrap();
    let bonds = Bonds::from_pairs(&grains, &[]).unwrap();
    let mut state = State::at_rest(&grains, bonds);
    prepare(&mut state);
    let mut workspace = Workspace::new(&grains, settings, &state);
    workspace.evaluate(&grains, settings, &mut state);
    let forces = workspace.force.iter().zip(&grains.area);
    (forces.map(|(&force, &area)| force * area).collect(), state)
}

fn node(grain: &Grain) -> Node {
    Node {
        area: grain.area[0],
        density: grain.density,
    }
}

#[test]
fn a_grain_falls_freely() {
    let (pull, step, steps) = (Vec2::new(3.0, -7.0), 1e-7, 200);
    for by_load in [false, true] {
        let mut block = grain(lattice(3, 3), 1.5, Weight::Constant);
        let mut settings = settings(step);
        if by_load {
            block.load = vec![pull * block.density; 9];
        } else {
            settings.gravity = pull;
        }
        let mut world = world(&[block], settings, |_| ());
        run(&mut world, steps);
        let time = step * steps as f64;
        assert_near(world.time(), time);
        let state = world.state();
        for (place, velocity) in state.places.iter().zip(&state.velocity) {
            assert_near(velocity.x, pull.x * time);
            assert_near(velocity.y, pull.y * time);
            assert_near(place.displacement.x, 0.5 * pull.x * time * time);
            assert_near(place.displacement.y, 0.5 * pull.y * time * time);
        }
        let mass = 9.0 * H * H * material().density;
        let energies = world.energies();
        let kinetic = 0.5 * mass * pull.norm_squared() * time * time;
        assert_near(energies.kinetic, kinetic);
        assert_near(energies.external, -kinetic);
        assert!(energies.bonds.abs() < 1e-9 * kinetic && energies.contacts == 0.0);
    }
}

/// Places near the left, right, top and bottom wall, far from corners, with distances and inward normals.
const AT_WALLS: [([f64; 2], f64, [f64; 2]); 4] = [
    ([-29.6, 31.0], 0.4, [1.0, 0.0]),
    ([69.2, 32.0], 0.8, [-1.0, 0.0]),
    ([33.0, 48.7], 1.3, [0.0, -1.0]),
    ([34.0, -19.9], 0.1, [0.0, 1.0]),
];
const CONTAINER: [f64; 4] = [-30.0 * H, 70.0 * H, 50.0 * H, -20.0 * H];

fn at_walls() -> Vec<Grain> {
    singles(&AT_WALLS.map(|([x, y], ..)| Vec2::new(x, y) * H))
}

#[test]
fn walls_push_nodes_inwards_by_their_distances() {
    let (grains, mut settings) = (at_walls(), settings(1e-7));
    settings.walls = Some(walls(0.0, 0.0));
    let (forces, _) = evaluated(&grains, &settings, |state| state.walls = CONTAINER);
    for (k, (_, distance, [x, y])) in AT_WALLS.into_iter().enumerate() {
        let push = walls(0.0, 0.0).law.push(distance * H, grains[k].area[0]);
        assert!((forces[k] - Vec2::new(x, y) * push).norm() < 1e-11 * push);
    }
}

#[test]
fn walls_damp_the_normal_velocity_relative_to_them() {
    let (grains, mut settings) = (at_walls(), settings(1e-7));
    let mut moving = walls(0.3, 0.0);
    moving.velocity = [2.0, -1.0, -0.5, 3.0];
    settings.walls = Some(moving);
    let still = {
        let mut settings = settings.clone();
        settings.walls = Some(walls(0.0, 0.0));
        evaluated(&grains, &settings, |state| state.walls = CONTAINER).0
    };
    let own = Vec2::new(0.7, -0.9);
    let (forces, state) = evaluated(&grains, &settings, |state| {
        state.walls = CONTAINER;
        state.velocity.fill(own);
    });
    let mut power = 0.0;
    for (k, (_, distance, [x, y])) in AT_WALLS.into_iter().enumerate() {
        let along = moving.velocity[k];
        let relative = if x == 0.0 {
            own.y - along
        } else {
            own.x - along
        };
        let rate = moving.law.damping(distance * H, &node(&grains[k]));
        let expected = Vec2::new(x.abs(), y.abs()) * (-rate * relative);
        let found = forces[k] - still[k];
        assert!((found - expected).norm() < 1e-9 * expected.norm());
        power += rate * relative * relative;
    }
    assert_near(state.work.damping, power * settings.time_step);
}

#[test]
fn walls_that_stick_stop_nodes_in_one_step() {
    let (grains, mut settings) = (at_walls(), settings(1e-7));
    settings.walls = Some(walls(0.0, 0.8));
    let slow = Vec2::new(3e-5, 4e-5);
    let (_, state) = evaluated(&grains, &settings, |state| {
        state.walls = CONTAINER;
        state.velocity.fill(slow);
    });
    // The friction -m v/dt does the work -m v^2 in a step.
    let lost = AT_WALLS.iter().zip(&grains).map(|((.., [x, _]), grain)| {
        let speed = if *x == 0.0 { slow.x } else { slow.y };
        node(grain).mass() * speed * speed
    });
    assert_near(state.work.friction, lost.sum());
}

#[test]
fn walls_move_with_their_velocity_and_do_the_work_of_their_mean_force() {
    let mut settings = settings(1e-7);
    let mut moving = walls(0.0, 0.0);
    moving.velocity = [2.0, -1.0, -0.5, 3.0];
    settings.walls = Some(moving);
    let mut world = world(&at_walls(), settings, |state| {
        state.walls = CONTAINER;
        state.velocity.fill(Vec2::new(0.7, -0.9));
    });
    let before = world.state().clone();
    run(&mut world, 1);
    let (after, law) = (world.state(), moving.law);
    let mut work = 0.0;
    for (k, (_, distance, [x, y])) in AT_WALLS.into_iter().enumerate() {
        assert_near(after.walls[k], CONTAINER[k] + moving.velocity[k] * 1e-7);
        let inward = Vec2::new(x, y);
        let way = after.places[k].displacement - before.places[k].displacement;
        let wall = inward.dot(Vec2::new(1.0, 1.0)) * moving.velocity[k] * 1e-7;
        let area = world.grains().area[k];
        let now = distance * H + inward.dot(way) - wall;
        let mean = 0.5 * (law.push(distance * H, area) + law.push(now, area));
        work += mean * inward.dot(way);
    }
    let error = (after.work.walls / work - 1.0).abs();
    assert!(error < 1e-9, "{error:e}");
}

#[test]
fn a_node_is_behind_a_wall_beyond_the_contact_radius() {
    let radius = walls(0.0, 0.0).law.radius;
    for (depth, is_behind) in [(1.0 + 5e-7, true), (1.0 - 5e-7, false)] {
        let mut settings = settings(1e-12);
        settings.walls = Some(walls(0.0, 0.0));
        let place = Vec2::new(33.0 * H, CONTAINER[2] + depth * radius);
        let grains = singles(&[Vec2::zero(), place]);
        let mut world = world(&grains, settings, |state| state.walls = CONTAINER);
        match world.step() {
            Err(StepError::BehindWall { lost, .. }) => {
                assert!(is_behind);
                assert_eq!((lost.grain, lost.node, lost.wall), (1, 0, "top"));
                assert_near(lost.depth, depth * radius);
            }
            other => assert!(other.is_ok() && !is_behind, "{other:?}"),
        }
    }
}

/// Two nodes that touch, and a third that is hardly too far from the first.
fn touching() -> Vec<Grain> {
    let radius = contact(0.0, 0.0).law.radius;
    let arm = Vec2::new(0.6, 0.8);
    let beyond = Vec2::new(-radius * (1.0 + 3e-7), 0.0);
    singles(&[Vec2::zero(), arm * (0.7 * radius), beyond])
}

/// Velocities with the given parts along and across the line from the first to the second node.
fn set_velocities(state: &mut State, first: [f64; 2], second: [f64; 2]) {
    let along = Vec2::new(0.6, 0.8);
    let vector = |[a, b]: [f64; 2]| along * a + along.perpendicular() * b;
    state.velocity = vec![vector(first), vector(second), Vec2::zero()];
}

#[test]
fn two_nodes_repel_and_damp_each_other() {
    let (grains, mut settings) = (touching(), settings(1e-7));
    settings.contact = Some(contact(0.3, 0.0));
    let (first, second) = (3.0, 1.0);
    let prepare = |state: &mut State| set_velocities(state, [first, 0.0], [second, 0.0]);
    let (forces, state) = evaluated(&grains, &settings, prepare);
    let (law, stiffness) = (contact(0.3, 0.0).law, contact(0.3, 0.0).stiffness[0][0]);
    let spring = stiffness * grains[0].area[0] * grains[1].area[0];
    let masses = [0, 1].map(|k| node(&grains[k]).mass());
    let reduced = 1.0 / (1.0 / masses[0] + 1.0 / masses[1]);
    let rate = 0.3 * 2.0 * (spring * reduced).sqrt();
    let push = spring * 0.3 * law.radius + rate * (first - second);
    let along = Vec2::new(0.6, 0.8);
    assert!((forces[0] + along * push).norm() < 1e-11 * push);
    assert!((forces[1] - along * push).norm() < 1e-11 * push);
    assert_eq!(forces[2], Vec2::zero());
    let power = rate * (first - second).powi(2);
    assert_near(state.work.damping, power * settings.time_step);
}

#[test]
fn two_nodes_stick_without_their_neighbour() {
    let (grains, mut settings) = (touching(), settings(1e-7));
    settings.contact = Some(contact(0.0, 0.8));
    let (first, second) = (5e-5, -2e-5);
    let prepare = |state: &mut State| set_velocities(state, [0.0, first], [0.0, second]);
    let (_, state) = evaluated(&grains, &settings, prepare);
    let masses = [0, 1].map(|k| node(&grains[k]).mass());
    let reduced = 1.0 / (1.0 / masses[0] + 1.0 / masses[1]);
    // The friction -m v/dt of the reduced mass does the work -m v^2 in a step.
    assert_near(state.work.friction, reduced * (first - second).powi(2));
    settings.contact.as_mut().unwrap().law.reading = ContactReading::OneSided;
    let (_, state) = evaluated(&grains, &settings, prepare);
    let lost = (masses[0] * first - masses[1] * second) * (first - second);
    assert_near(state.work.friction, lost);
}

#[test]
fn two_nodes_stick_without_a_node_of_the_same_grain_beyond_its_reference_distance() {
    let reference = 1.2 * H;
    let nodes = vec![Vec2::zero(), Vec2::new(-reference, 0.0)];
    let mut own = grain(nodes, 0.5, Weight::Constant);
    own.touches_itself = true;
    let other = grain(vec![Vec2::new(0.6, 0.8) * H], 0.5, Weight::Constant);
    let mass = node(&other).mass();
    let mut settings = settings(1e-7);
    settings.contact = Some(contact(0.0, 0.8));
    let speed = 5e-5;
    let (_, state) = evaluated(&[own, other], &settings, |state| {
        state.places[1].displacement.x = -3e-7 * reference;
        state.velocity[2] = Vec2::new(-0.8, 0.6) * speed;
    });
    assert_near(state.work.friction, 0.5 * mass * speed * speed);
}

#[test]
fn contacts_are_listed_with_the_forces_that_act() {
    let mut settings = settings(1e-7);
    let mut contact = contact(0.3, 0.8);
    contact.shares_sticking = false;
    settings.contact = Some(contact.clone());
    let prepare = |state: &mut State| set_velocities(state, [0.3, 5e-5], [0.1, -2e-5]);
    let (forces, _) = evaluated(&touching(), &settings, prepare);
    let world = world(&touching(), settings, prepare);
    let listed = world.contacts();
    assert_eq!(listed.len(), 1);
    assert_eq!(listed[0].pair, Pair::new(0, 1));
    assert_eq!(listed[0].rest_distance, contact.law.radius);
    let error = listed[0].on_first.total() - forces[0];
    assert!(error.norm() < 1e-12 * forces[0].norm());
    let separation = listed[0].separation - Vec2::new(0.6, 0.8) * (0.7 * contact.law.radius);
    assert!(separation.norm() < 1e-12 * H);
}

#[test]
fn contacts_store_the_work_that_brings_nodes_together() {
    let mut settings = settings(1e-7);
    settings.contact = Some(contact(0.0, 0.0));
    let between = world(&touching(), settings.clone(), |_| ());
    let areas = touching()[0].area[0] * touching()[1].area[0];
    let (radius, stiffness) = (1.5 * H, contact(0.0, 0.0).stiffness[0][0]);
    let overlap = 0.3 * radius;
    let expected = 0.5 * stiffness * areas * overlap * overlap;
    assert_near(between.energies().contacts, expected);
    // Two nodes of one grain repel each other below their reference distance, by the stiffness of bonds.
    let mut own = grain(
        vec![Vec2::zero(), Vec2::new(1.2 * H, 0.0)],
        0.5,
        Weight::Conic,
    );
    own.touches_itself = true;
    let within = world(std::slice::from_ref(&own), settings, |state| {
        state.places[1].displacement = Vec2::new(-0.2 * H, 0.0);
    });
    let listed = within.contacts();
    assert_eq!(listed.len(), 1);
    assert_eq!(listed[0].rest_distance, 1.2 * H);
    let push = own.contact_stiffness * (0.2 / 1.2) * H.powi(4);
    assert_near(listed[0].on_first.repulsion.x, -push);
    assert_near(within.energies().contacts, 0.5 * push * 0.2 * H);
}

#[test]
fn contact_between_grains_of_one_material_is_contact_within_a_grain() {
    let side = ContactMaterial {
        material: material(),
        bulk_modulus: 1e9,
        horizon: 3.0 * H,
    };
    let law = contact(0.0, 0.0).law;
    let rule = ContactStiffness::FromBonds;
    let between = law.between_grains(rule.between(&side, &side, law.radius).unwrap());
    let bonds = material()
        .bond_constants(Weight::Constant, 3.0 * H)
        .unwrap();
    let within = law.within_grain(bonds.stiffness, 9.0 * H);
    assert_eq!(between.rest_distance, law.radius);
    assert_eq!(within.rest_distance, law.radius);
    assert_near(between.stiffness, within.stiffness);
}

/// A bond that will exceed its critical stretch within the next step.
fn about_to_break(order: BreakOrder) -> (World, f64) {
    let mut pair = grain(vec![Vec2::zero(), Vec2::new(H, 0.0)], 1.5, Weight::Conic);
    pair.breaking = Some(BreakingRule::TensionOnly);
    let critical = 0.01;
    pair.constants.critical_stretch = critical;
    // Much slower than the step, so that what is of second order in it is lost.
    let frequency = (pair.constants.stiffness * H / pair.density).sqrt();
    let mut settings = settings(3e-7 / frequency);
    settings.break_order = order;
    let way = 1e-5 * critical * H;
    let speed = way / settings.time_step;
    let world = world(&[pair], settings, |state| {
        state.places[1].displacement = Vec2::new(critical * (1.0 - 1e-7) * H, 0.0);
        state.velocity[1] = Vec2::new(speed, 0.0);
    });
    (world, way)
}

#[test]
fn the_energy_of_a_step_in_which_a_bond_breaks_is_balanced() {
    for order in [BreakOrder::BreakFirst, BreakOrder::ForceFirst] {
        let (mut world, way) = about_to_break(order);
        let pull = forces(world.grains(), world.settings(), world.state())[1].norm() * H * H;
        let before = energy(&world);
        run(&mut world, 1);
        assert_eq!(world.broken().len(), 1);
        if order == BreakOrder::ForceFirst {
            run(&mut world, 1);
        }
        let error = energy(&world) + world.state().work.broken - before;
        assert!(
            error.abs() < 1e-7 * pull * way,
            "{order:?}: {:e}",
            error / (pull * way)
        );
    }
}

#[test]
fn bonds_break_just_above_the_critical_stretch() {
    let critical = 0.01;
    for (rule, sign) in [
        (BreakingRule::TensionOnly, 1.0),
        (BreakingRule::TwoSided, 1.0),
        (BreakingRule::TwoSided, -1.0),
    ] {
        for (factor, left) in [(1.0 - 3e-7, 1), (1.0 + 3e-7, 0)] {
            let mut pair = grain(lattice(2, 1), 1.5, Weight::Constant);
            pair.breaking = Some(rule);
            pair.constants.critical_stretch = critical;
            let world = world(&[pair], settings(1e-9), |state| {
                state.places[1].displacement = Vec2::new(sign * factor * critical * H, 0.0);
            });
            assert_eq!(world.bonds().count(), left, "{rule:?} {sign} {factor}");
        }
    }
}
