//! Whatever the state is: no panic, and nothing that is not a number.

use crate::cloud::{H, contact, grain, settings, walls};
use crate::quadrature::Random;
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::contact_law::ContactReading;
use gouge_peridem::error::{SetupError, StepError};
use gouge_peridem::forces::Settings;
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::limits::Limits;
use gouge_peridem::material::Weight;
use gouge_peridem::state::State;
use gouge_peridem::wall_law::WallReading;
use gouge_peridem::world::{Beginning, World};
use proptest::prelude::*;

/// Number of nodes of each of two grains.
const NODES: usize = 12;

fn pick<T: Copy>(random: &mut Random, choices: &[T]) -> T {
    choices[(random.unit() * choices.len() as f64) as usize]
}

fn cloud(random: &mut Random, shift: f64) -> Grain {
    let node = |k: usize, random: &mut Random| {
        let at = Vec2::new((k % 4) as f64 + shift, (k / 4) as f64);
        (at + Vec2::new(random.between(-0.4, 0.4), random.between(-0.4, 0.4))) * H
    };
    let nodes = (0..NODES).map(|k| node(k, random)).collect();
    let weight = pick(
        random,
        &[Weight::Constant, Weight::Conic, Weight::Parabolic],
    );
    let mut grain = grain(nodes, random.between(1.0, 4.0), weight);
    let rules = [
        None,
        Some(BreakingRule::TensionOnly),
        Some(BreakingRule::TwoSided),
    ];
    grain.breaking = pick(random, &rules);
    grain.touches_itself = random.unit() < 0.7;
    grain
}

fn any_settings(random: &mut Random) -> Settings {
    let mut settings = settings(10_f64.powf(random.between(-12.0, -3.0)));
    settings.break_order = pick(random, &[BreakOrder::BreakFirst, BreakOrder::ForceFirst]);
    let mut contact = contact(random.unit(), random.between(0.0, 2.0));
    contact.law.reading = pick(
        random,
        &[
            ContactReading::Symmetric,
            ContactReading::OneSided,
            ContactReading::Authors,
            ContactReading::Printed,
        ],
    );
    contact.shares_sticking = random.unit() < 0.5;
    settings.contact = Some(contact);
    if random.unit() < 0.5 {
        let mut walls = walls(random.unit(), random.between(0.0, 2.0));
        walls.law.reading = pick(
            random,
            &[
                WallReading::Paper,
                WallReading::Exact,
                WallReading::TwoFixes,
                WallReading::Authors,
            ],
        );
        walls.velocity = [random.between(-9.0, 9.0), 0.0, -1.0, 0.0];
        settings.walls = Some(walls);
    }
    settings
}

/// Displace and throw nodes: a little, far, onto each other, or nowhere.
fn disturb(random: &mut Random, state: &mut State) {
    let size = pick(random, &[0.0, 1e-9, 0.1, 1.0, 1e3, 1e12]) * H;
    let speed = pick(random, &[0.0, 1e-6, 1.0, 1e3, 1e9]);
    for node in 0..state.places.len() {
        let mut vector =
            |size: f64| Vec2::new(random.between(-size, size), random.between(-size, size));
        state.places[node].displacement = vector(size);
        state.velocity[node] = vector(speed);
    }
    if random.unit() < 0.3 {
        // Coincident nodes: bonded, in different grains, at a wall.
        let place = state.places[0].position();
        for node in [1, 5, NODES, NODES + 3] {
            state.places[node].displacement = place - state.places[node].reference;
        }
    }
    state.walls = [-3.0 * H, 12.0 * H, 9.0 * H, -2.0 * H];
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]
    #[test]
    fn a_million_nodes_in_any_state_give_numbers(seed in any::<u64>()) {
        let mut random = Random(seed);
        // 64 times 652 times 24 nodes are a million.
        for _ in 0..652 {
            let grains = [cloud(&mut random, 0.0), cloud(&mut random, 4.5)];
            let grains = Grains::new(&grains).unwrap();
            let bonds = Bonds::within_horizon(&grains, |_, _, _| true).unwrap();
            let mut state = State::at_rest(&grains, bonds);
            disturb(&mut random, &mut state);
            let settings = any_settings(&mut random);
            let world = World::new(grains, settings, state, Beginning::Forces).unwrap();
            let accelerations = &world.state().acceleration;
            prop_assert!(accelerations.iter().all(|a| a.is_finite()), "{seed} {accelerations:?}");
            let energies = world.energies();
            let sum = energies.kinetic + energies.bonds + energies.contacts;
            prop_assert!(sum.is_finite() && sum >= 0.0, "{seed} {energies:?}");
        }
    }
}

#[test]
fn runs_from_any_state_end_with_numbers_or_an_error() {
    let mut random = Random(17);
    let mut outcomes = [0; 3];
    for _ in 0..400 {
        let grains = [cloud(&mut random, 0.0), cloud(&mut random, 4.5)];
        let grains = Grains::new(&grains).unwrap();
        let bonds = Bonds::within_horizon(&grains, |_, _, _| true).unwrap();
        let mut state = State::at_rest(&grains, bonds);
        disturb(&mut random, &mut state);
        let settings = any_settings(&mut random);
        let mut world = World::new(grains, settings, state, Beginning::Forces).unwrap();
        let end = (0..30).find_map(|_| world.step().err());
        match end {
            None => outcomes[0] += 1,
            Some(StepError::NotFinite { .. }) => outcomes[1] += 1,
            Some(StepError::BehindWall { .. }) => outcomes[2] += 1,
            Some(StepError::TooFast { .. }) => panic!("worlds are not guarded unless asked"),
        }
        if end.is_none() {
            let state = world.state();
            assert!(state.velocity.iter().all(|velocity| velocity.is_finite()));
            assert!(
                state
                    .places
                    .iter()
                    .all(|place| place.displacement.is_finite())
            );
        }
    }
    assert!(outcomes.iter().all(|&number| number > 0), "{outcomes:?}");
}

#[test]
fn extreme_inputs_are_refused_or_give_numbers_or_an_error() {
    let base = || cloud(&mut Random(2), 0.0);
    let extremes = [1e-300, 1e-30, 1e30, 1e300];
    for (field, &value) in (0..6).flat_map(|field| extremes.iter().map(move |value| (field, value)))
    {
        let mut grain = base();
        let mut settings = settings(1e-8);
        settings.contact = Some(contact(0.5, 0.5));
        settings.walls = Some(walls(0.5, 0.5));
        match field {
            0 => grain.density = value,
            1 => grain.constants.stiffness = value,
            2 => grain.area = vec![value; NODES],
            3 => settings.time_step = value,
            4 => settings.contact.as_mut().unwrap().stiffness[0][0] = value,
            _ => settings.walls.as_mut().unwrap().law.stiffness = value,
        }
        let Ok(grains) = Grains::new(&[grain]) else {
            continue;
        };
        let bonds = Bonds::within_horizon(&grains, |_, _, _| true).unwrap();
        let limits = Limits::of(&grains, &bonds, &settings);
        assert!(
            limits.named().iter().all(|(_, value)| *value >= 0.0),
            "{field} {value}: {limits:?}"
        );
        let mut state = State::at_rest(&grains, bonds);
        state.walls = [-H, 12.0 * H, 9.0 * H, -H];
        state.places[0].displacement = Vec2::new(0.3, 0.1) * H;
        let Ok(mut world) = World::new(grains, settings, state, Beginning::Forces) else {
            continue;
        };
        let failed = (0..20).any(|_| world.step().is_err());
        let state = world.state();
        let is_finite = state.velocity.iter().all(|velocity| velocity.is_finite());
        assert!(failed || is_finite, "{field} {value}");
    }
}

#[test]
fn nodes_at_one_place_give_numbers_in_grains_of_any_size() {
    for size in [1e-3, 1e-8, 1e-12] {
        let mut grain = base_pair(size);
        grain.constants.horizon = 2.0 * size;
        let grains = Grains::new(&[grain]).unwrap();
        let bonds = Bonds::within_horizon(&grains, |_, _, _| true).unwrap();
        let mut state = State::at_rest(&grains, bonds);
        state.places[1].displacement = Vec2::new(-size, 0.0);
        let world = World::new(grains, settings(1e-8), state, Beginning::Forces).unwrap();
        assert_eq!(world.state().acceleration, [Vec2::zero(); 2], "{size:e}");
    }
}

fn base_pair(size: f64) -> Grain {
    grain(
        vec![Vec2::zero(), Vec2::new(size, 0.0)],
        3.0,
        Weight::Constant,
    )
}

#[test]
fn too_many_bonds_are_refused() {
    // 300 x 300 nodes within one horizon: every node would have 89 999 bonds.
    let nodes = crate::cloud::lattice(1, 70_000)
        .iter()
        .map(|at| *at * 1e-6)
        .collect();
    let grains = Grains::new(&[grain(nodes, 1.0, Weight::Constant)]).unwrap();
    let pairs: Vec<[usize; 2]> = (1..70_000).map(|node| [0, node]).collect();
    let error = Bonds::from_pairs(&grains, &[pairs]).unwrap_err();
    assert!(
        matches!(error, SetupError::Bond { grain: 0, i: 0, .. }),
        "{error}"
    );
}
