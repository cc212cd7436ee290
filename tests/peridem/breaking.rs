//! Bonds that break.

use crate::cloud::{H, at_rest, forces, grain, lattice, run, settings, world};
use crate::quadrature::Random;
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::error::SetupError;
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::Weight;
use gouge_peridem::world::World;
use std::collections::BTreeSet;

/// Two bonded nodes.
fn pair(rule: Option<BreakingRule>) -> Grain {
    let mut grain = grain(lattice(2, 1), 1.5, Weight::Constant);
    grain.breaking = rule;
    grain.constants.critical_stretch = 0.01;
    grain
}

#[test]
fn a_bond_that_breaks_acts_once_more_only_if_forces_come_first() {
    for order in [BreakOrder::BreakFirst, BreakOrder::ForceFirst] {
        for (rule, stretch) in [
            (BreakingRule::TensionOnly, 0.011),
            (BreakingRule::TwoSided, -0.011),
        ] {
            let (grains, mut state) = at_rest(&[pair(Some(rule))]);
            state.places[1].displacement = Vec2::new(stretch * H, 0.0);
            let mut settings = settings(1e-9);
            settings.break_order = order;
            let first = forces(&grains, &settings, &state);
            let pull = grains.rows[0].constants.stiffness * H * H * stretch;
            let expected = if order == BreakOrder::ForceFirst {
                pull
            } else {
                0.0
            };
            assert!(
                (first[0].x - expected).abs() < 1e-9 * pull.abs(),
                "{order:?} {rule:?}"
            );
            assert_eq!(first[0], -first[1]);
            let mut world = world(&[pair(Some(rule))], settings, |own| *own = state.clone());
            assert_eq!(world.broken().len(), 1);
            run(&mut world, 1);
            assert_eq!((world.broken().len(), world.bonds().count()), (0, 0));
            let after = world.state().acceleration[0];
            assert_eq!(after, Vec2::zero(), "a broken bond acts");
        }
    }
}

#[test]
fn compression_breaks_only_with_the_two_sided_rule_and_nothing_without_a_rule() {
    let stretches = [-0.011, 0.0099, 0.011];
    let holds = |rule| {
        stretches.map(|stretch| {
            let world = world(&[pair(rule)], settings(1e-9), |state| {
                state.places[1].displacement = Vec2::new(stretch * H, 0.0);
            });
            world.bonds().count()
        })
    };
    assert_eq!(holds(None), [1, 1, 1]);
    assert_eq!(holds(Some(BreakingRule::TensionOnly)), [1, 1, 0]);
    assert_eq!(holds(Some(BreakingRule::TwoSided)), [0, 1, 0]);
}

/// A block that tears because its nodes fly apart, in a given order of nodes.
fn torn(order: &[usize], each: impl FnMut(&World)) -> World {
    torn_with(BreakOrder::BreakFirst, 150, order, each)
}

/// The same with a number of steps for the same time.
fn torn_with(
    break_order: BreakOrder,
    steps: usize,
    order: &[usize],
    mut each: impl FnMut(&World),
) -> World {
    let mut random = Random(5);
    let mut nodes = lattice(9, 9);
    let mut velocities = Vec::new();
    for node in &mut nodes {
        *node += Vec2::new(random.between(-0.1, 0.1), random.between(-0.1, 0.1)) * H;
        let noise = Vec2::new(random.between(-9.0, 9.0), random.between(-9.0, 9.0));
        velocities.push((*node - Vec2::new(4.0, 4.0) * H) * (20.0 / H) + noise);
    }
    let mut block = grain(
        order.iter().map(|&k| nodes[k]).collect(),
        3.015,
        Weight::Conic,
    );
    block.breaking = Some(BreakingRule::TensionOnly);
    block.constants.critical_stretch = 0.05;
    let mut settings = settings(3e-5 / steps as f64);
    settings.break_order = break_order;
    let mut world = world(&[block], settings, |state| {
        state.velocity = order.iter().map(|&k| velocities[k]).collect();
    });
    for _ in 0..steps {
        run(&mut world, 1);
        each(&world);
    }
    world
}

/// Bonds that are left, by the original numbers of their nodes.
fn left(world: &World, order: &[usize]) -> BTreeSet<[usize; 2]> {
    let bonds = world.bonds().all();
    let own = |(i, j, _): (usize, usize, f64)| [order[i].min(order[j]), order[i].max(order[j])];
    bonds.map(own).collect()
}

#[test]
fn breaking_is_irreversible_and_counted() {
    let order: Vec<usize> = (0..81).collect();
    let mut before: Option<(BTreeSet<[usize; 2]>, f64)> = None;
    let mut initial = 0;
    let world = torn(&order, |world| {
        let (now, energy) = (left(world, &order), world.state().work.broken);
        if let Some((before, energy_before)) = &before {
            assert!(now.is_subset(before), "a bond came back");
            assert_eq!(before.len() - now.len(), world.broken().len());
            assert_eq!(energy > *energy_before, !world.broken().is_empty());
        } else {
            initial = now.len() + world.broken().len();
        }
        before = Some((now, energy));
    });
    let bonds = world.bonds();
    assert!(
        bonds.count() < initial / 2 && bonds.count() > 0,
        "{initial} {}",
        bonds.count()
    );
    for node in 0..81 {
        let own = bonds
            .all()
            .filter(|&(i, j, _)| i == node || j == node)
            .count();
        let damage = 1.0 - own as f64 / f64::from(bonds.initial_numbers()[node]);
        assert_eq!(
            (bonds.numbers()[node] as usize, bonds.damage(node)),
            (own, damage)
        );
    }
}

#[test]
fn the_energy_of_broken_bonds_leaves_the_grain() {
    let order: Vec<usize> = (0..81).collect();
    for break_order in [BreakOrder::BreakFirst, BreakOrder::ForceFirst] {
        let error = |steps| {
            let mut sums = Vec::new();
            torn_with(break_order, steps, &order, |world| {
                let energies = world.energies();
                sums.push(energies.kinetic + energies.bonds + world.state().work.broken);
            });
            sums[sums.len() - 1] / sums[0] - 1.0
        };
        let errors = [150, 300, 600].map(error);
        let order = 0.5 * (errors[0] / errors[2]).abs().log2();
        assert!(order > 1.6, "{break_order:?} {errors:?}");
    }
}

#[test]
fn numbering_does_not_matter() {
    let order: Vec<usize> = (0..81).collect();
    let mut random = Random(11);
    let expected = left(&torn(&order, |_| ()), &order);
    for _ in 0..3 {
        let mut other = order.clone();
        for k in (1..other.len()).rev() {
            other.swap(k, (random.unit() * (k + 1) as f64) as usize);
        }
        assert_eq!(left(&torn(&other, |_| ()), &other), expected);
    }
    let reversed: Vec<usize> = order.iter().rev().copied().collect();
    assert_eq!(left(&torn(&reversed, |_| ()), &reversed), expected);
}

#[test]
fn nodes_at_exactly_the_horizon_are_bonded() {
    let nodes = || vec![Vec2::zero(), Vec2::new(3.0, 4.0)];
    for (horizon, number) in [(5.0, 1), (5.0_f64.next_down(), 0)] {
        let mut pair = grain(nodes(), 1.5, Weight::Constant);
        pair.constants.horizon = horizon;
        let (_, state) = at_rest(&[pair]);
        assert_eq!(state.bonds.count(), number, "{horizon}");
    }
}

#[test]
fn bonds_of_nodes_that_do_not_exist_are_refused() {
    let blocks = [2, 3].map(|columns| grain(lattice(columns, 1), 1.5, Weight::Constant));
    let grains = Grains::new(&blocks).unwrap();
    let of = |pair: [usize; 2]| Bonds::from_pairs(&grains, &[vec![[0, 1]], vec![pair]]);
    assert_eq!(of([2, 0]).unwrap().count(), 2);
    let (grain, nodes) = (1, 3);
    for node in [3, 4] {
        let expected = SetupError::MissingNode { grain, node, nodes };
        assert_eq!(of([1, node]), Err(expected));
    }
    let wrong = |pairs: &[[usize; 2]]| Bonds::from_pairs(&grains, &[Vec::new(), pairs.to_vec()]);
    let bond = |i, j, what| Err(SetupError::Bond { grain, i, j, what });
    assert_eq!(
        wrong(&[[1, 1]]),
        bond(1, 1, "a bond of one node with itself")
    );
    assert_eq!(wrong(&[[2, 0], [0, 2]]), bond(0, 2, "two bonds"));
}
