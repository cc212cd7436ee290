//! The same bits: for any number of threads, after a restart, without allocations.

use crate::cloud::{H, at_rest, contact, disc, grain, lattice, run, settings, throw, walls, world};
use gouge_common::geometry::Vec2;
use gouge_common::instructions::Instructions;
use gouge_common::record::Record;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::error::SetupError;
use gouge_peridem::grain::Grain;
use gouge_peridem::material::Weight;
use gouge_peridem::state::State;
use gouge_peridem::world::{Beginning, World};
use rayon::ThreadPoolBuilder;

/// A grain of several blocks that is torn while it falls on a floor.
fn large() -> World {
    let mut grain = grain(lattice(60, 50), 3.015, Weight::Constant);
    grain.breaking = Some(BreakingRule::TensionOnly);
    grain.touches_itself = true;
    grain.constants.critical_stretch = 0.01;
    let mut settings = settings(2e-7);
    settings.contact = Some(contact(0.3, 0.4));
    settings.walls = Some(walls(0.3, 0.4));
    world(&[grain], settings, |state| {
        state.walls = [-3.0 * H, 70.0 * H, 60.0 * H, -H];
        for (velocity, place) in state.velocity.iter_mut().zip(&state.places) {
            let from = place.reference - Vec2::new(30.0, 25.0) * H;
            *velocity = from * (3.0 / H) + Vec2::new(5.0, -40.0);
        }
    })
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let final_state = |threads: usize| {
        let pool = ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| {
            let mut world = large();
            run(&mut world, 40);
            world.state().clone()
        })
    };
    let one = final_state(1);
    assert!(one.work.broken > 0.0 && one.work.friction > 0.0);
    for threads in [2, 4] {
        assert_eq!(final_state(threads), one, "{threads} threads");
    }
    let mut outside = large();
    run(&mut outside, 40);
    assert_eq!(outside.state(), &one, "the pool of the process");
}

/// A grain that is torn in one direction and crushed in the other, with rows of bonds of all lengths up to several vectors.
fn torn(weight: Weight, rule: Option<BreakingRule>, order: BreakOrder) -> World {
    let mut grain = grain(lattice(23, 17), 6.015, weight);
    grain.breaking = rule;
    grain.constants.critical_stretch = 0.01;
    for (k, area) in grain.area.iter_mut().enumerate() {
        *area *= 1.0 + 0.01 * (k % 7) as f64;
    }
    let mut settings = settings(1e-7);
    settings.break_order = order;
    world(&[grain], settings, |state| {
        for (velocity, place) in state.velocity.iter_mut().zip(&state.places) {
            let from = place.reference - Vec2::new(9.0, 7.0) * H;
            *velocity = Vec2::new(from.x, -from.y) * (20.0 / H);
        }
    })
}

#[test]
fn the_instructions_do_not_matter() {
    let rules = [BreakingRule::TensionOnly, BreakingRule::TwoSided];
    for rule in [None].into_iter().chain(rules.map(Some)) {
        for order in [BreakOrder::BreakFirst, BreakOrder::ForceFirst] {
            for weight in [Weight::Constant, Weight::Conic, Weight::Parabolic] {
                let final_state = |instructions: Instructions| {
                    let mut world = torn(weight, rule, order).with_instructions(instructions);
                    run(&mut world, 60);
                    world.state().clone()
                };
                let portable = final_state(Instructions::portable());
                assert_eq!(portable.work.broken > 0.0, rule.is_some());
                for instructions in Instructions::available() {
                    let name = instructions.name();
                    assert!(
                        final_state(instructions) == portable,
                        "{name}, {rule:?}, {order:?}, {weight:?}"
                    );
                }
            }
        }
    }
}

/// Two discs that collide, break and touch themselves near a corner.
fn collision(order: BreakOrder) -> ([Grain; 2], World) {
    let grains = [Vec2::zero(), Vec2::new(9.0, 1.0) * H].map(|centre| {
        let mut grain = grain(disc(centre, 3.6 * H), 3.015, Weight::Constant);
        grain.breaking = Some(BreakingRule::TensionOnly);
        grain.touches_itself = true;
        grain.constants.critical_stretch = 0.02;
        grain
    });
    let (all, _) = at_rest(&grains);
    let mut settings = settings(3e-7);
    settings.break_order = order;
    settings.contact = Some(contact(0.4, 0.5));
    settings.walls = Some(walls(0.1, 0.5));
    settings.gravity = Vec2::new(0.0, -1e4);
    let world = world(&grains, settings, |state| {
        state.walls = [-6.0 * H, 20.0 * H, 20.0 * H, -6.0 * H];
        throw(&all, state, 0, Vec2::new(30.0, -20.0));
        throw(&all, state, 1, Vec2::new(-30.0, 0.0));
    });
    (grains, world)
}

#[test]
fn a_run_continues_from_a_copied_state_bit_by_bit() {
    for order in [BreakOrder::BreakFirst, BreakOrder::ForceFirst] {
        let (_, mut world) = collision(order);
        let mut broken = 0;
        for _ in 0..12 {
            let (grains, settings) = (world.grains().clone(), world.settings().clone());
            let copy: State = world.state().clone();
            let mut other = World::new(grains, settings, copy, Beginning::Given).unwrap();
            run(&mut world, 50);
            run(&mut other, 50);
            assert_eq!(world.state(), other.state());
            broken += usize::from(world.state().work.broken > 0.0);
        }
        let work = world.state().work;
        assert!(broken > 5 && work.walls != 0.0 && work.friction > 0.0);
    }
}

#[test]
fn a_run_continues_from_a_record_bit_by_bit() {
    let (_, mut world) = collision(BreakOrder::BreakFirst);
    run(&mut world, 300);
    let record = world.record();
    let layout: Vec<_> = (record.columns.iter())
        .map(|one| (&one.name[..], one.shape))
        .collect();
    let record = Record::from_words(&record.model, &layout, &record.words()).unwrap();
    let mut other = collision(BreakOrder::BreakFirst)
        .1
        .restored(&record)
        .unwrap();
    assert_eq!(world.state(), other.state());
    run(&mut world, 200);
    run(&mut other, 200);
    assert_eq!(world.state(), other.state());
    assert_eq!(world.record(), other.record());
}

#[test]
fn records_of_other_worlds_are_refused() {
    let (_, world) = collision(BreakOrder::BreakFirst);
    let whole = world.record();
    let refuses = |change: &dyn Fn(&mut Record)| {
        let mut record = whole.clone();
        change(&mut record);
        world.clone().restored(&record).is_none()
    };
    assert!(!refuses(&|_| ()));
    assert!(refuses(&|record| record.model = "dem".to_owned()));
    assert!(refuses(&|record| record.columns.truncate(10)));
    for column in 0..whole.columns.len() {
        let name = &whole.columns[column].name;
        assert!(
            refuses(&|record| record.columns[column].name.push('x')),
            "{name}"
        );
        assert!(
            refuses(&|record| {
                record.columns[column].words.pop();
            }),
            "{name}"
        );
        assert!(
            refuses(&|record| record.columns[column].words.extend([1, 1])),
            "{name}"
        );
    }
    let at = |name: &str| {
        whole
            .columns
            .iter()
            .position(|one| one.name == name)
            .unwrap()
    };
    let begin = whole.columns[at("start")].words[20] as usize;
    assert!(refuses(&|record| record.columns[at("earlier")]
        .words
        .swap(begin, begin + 1)));
    let bonds = world.bonds().count() as u64;
    for (name, place, word) in [
        ("start", 5, bonds + 1),
        ("held", 20, 60),
        ("held", 20, 1 << 16),
        ("earlier", 40, 1 << 32),
        ("earlier", 40, 90),
        ("earlier", bonds as usize - 1, 0),
        ("length", 7, f64::NAN.to_bits()),
        ("length", 7, (-1.0_f64).to_bits()),
        ("initial", 30, 2),
    ] {
        let change = |record: &mut Record| record.columns[at(name)].words[place] = word;
        assert!(refuses(&change), "{name}");
    }
}

#[test]
fn states_of_other_grains_are_refused() {
    let (grains, world) = collision(BreakOrder::BreakFirst);
    let (all, state) = (world.grains(), world.state());
    let (_, other) = at_rest(&grains[..1]);
    let refused = |change: &dyn Fn(&mut State)| {
        let mut state = state.clone();
        change(&mut state);
        match World::new(all.clone(), settings(1e-7), state, Beginning::Given) {
            Err(SetupError::StateLength { column, .. }) => column,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(refused(&|state| state.places.truncate(9)), "places");
    assert_eq!(refused(&|state| state.velocity.truncate(9)), "velocity");
    assert_eq!(refused(&|state| state.acceleration.clear()), "acceleration");
    assert_eq!(refused(&|state| state.bonds = other.bonds.clone()), "bonds");
}

#[test]
fn steps_allocate_nothing_unless_something_breaks_or_moves_far() {
    let grains = [0.0, 4.4 * H].map(|y| {
        let nodes = lattice(12, 4)
            .iter()
            .map(|&at| at + Vec2::new(0.0, y))
            .collect();
        let mut grain = grain(nodes, 3.015, Weight::Conic);
        grain.breaking = Some(BreakingRule::TensionOnly);
        grain.constants.critical_stretch = 0.5;
        grain
    });
    let mut settings = settings(1e-7);
    settings.contact = Some(contact(0.4, 0.5));
    settings.walls = Some(walls(0.4, 0.5));
    let mut world = world(&grains, settings, |state| {
        state.walls = [-H, 13.0 * H, 20.0 * H, -1.4 * H];
        state.velocity.fill(Vec2::new(0.1, -0.1));
    });
    let pool = ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let counted = pool.install(|| {
        run(&mut world, 5);
        allocation_counter::measure(|| run(&mut world, 100))
    });
    let work = world.state().work;
    assert!(work.friction > 0.0 && work.broken == 0.0);
    assert_eq!(counted.count_total, 0);
}

#[test]
fn a_pair_that_breaks_far_apart_touches_when_it_comes_back() {
    // A bond of 1.02 contact radii breaks at 1.107 radii, beyond the reach of the list, and a load brings the nodes
    // back before one of them has moved by half the skin of the list.
    let radius = 1.5 * H;
    let mut pair = grain(
        [0.0, 1.02]
            .map(|x| Vec2::new(40.0 * H + x * radius, 30.0 * H))
            .to_vec(),
        3.0,
        Weight::Constant,
    );
    pair.breaking = Some(BreakingRule::TensionOnly);
    pair.touches_itself = true;
    pair.constants.critical_stretch = 0.085;
    pair.constants.stiffness *= 1e-9;
    let load = Vec2::new(1e6, 0.0);
    pair.load = vec![load, -load];
    let acceleration = load.x / pair.density;
    let speed = (2.0 * acceleration * 0.049 * radius).sqrt();
    let mut settings = settings(1e-7);
    settings.contact = Some(contact(0.0, 0.0));
    let mut world = world(&[pair], settings, |state| {
        state.velocity = vec![Vec2::new(-speed, 0.0), Vec2::new(speed, 0.0)];
    });
    let distance = |world: &World| world.state().places[0].to(world.state().places[1]).norm();
    for _ in 0..10_000 {
        run(&mut world, 1);
        if distance(&world) < 0.9999 * radius {
            break;
        }
    }
    assert_eq!(world.bonds().count(), 0);
    assert!(
        world.energies().contacts > 0.0,
        "{}",
        distance(&world) / radius
    );
}
