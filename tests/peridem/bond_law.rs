//! The law of one bond.

use crate::quadrature::{Random, derivative};
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::Elongation;
use gouge_peridem::material::{BondConstants, Weight};

const WEIGHTS: [Weight; 3] = [Weight::Constant, Weight::Conic, Weight::Parabolic];

fn constants(weight: Weight) -> BondConstants {
    BondConstants {
        weight,
        horizon: 2.0,
        stiffness: 3.0,
        critical_stretch: 0.1,
    }
}

fn elongation(bond: Vec2, moved: Vec2) -> Elongation {
    Elongation::new(bond, moved, bond.norm())
}

/// Pair force density on the first node.
fn force(constants: &BondConstants, state: &Elongation) -> Vec2 {
    state.pull(constants.weight, constants.horizon) * constants.stiffness
}

#[test]
fn a_tiny_stretch_keeps_its_digits() {
    let bond = Vec2::new(3e-4, 4e-4);
    for stretch in [1e-15, -1e-12, 1e-9, -1e-6, 1e-3, 0.5] {
        let state = elongation(bond, bond * stretch);
        let error = state.stretch() / stretch - 1.0;
        assert!(error.abs() < 2e-15, "{stretch:e}: {error:e}");
    }
}

#[test]
fn a_rigid_motion_stretches_no_bond() {
    let bond = Vec2::new(0.3, -0.7);
    let turned = elongation(bond, bond.perpendicular() - bond);
    assert!(turned.stretch().abs() < 1e-15);
    assert_eq!(elongation(bond, Vec2::zero()).stretch(), 0.0);
}

#[test]
fn the_force_is_minus_the_gradient_of_the_energy() {
    let mut random = Random(1);
    for weight in WEIGHTS {
        let constants = constants(weight);
        for _ in 0..100 {
            let mut vector =
                |size: f64| Vec2::new(random.between(-size, size), random.between(-size, size));
            let (bond, moved) = (vector(1.2), vector(0.3));
            if bond.norm() < 0.5 {
                continue;
            }
            let force = force(&constants, &elongation(bond, moved));
            // The displacement of the first node enters with a minus sign.
            let energy = |x, y| elongation(bond, moved - Vec2::new(x, y)).energy(&constants);
            let gradient = Vec2::new(
                derivative(0.0, 1e-3, |x| energy(x, 0.0)),
                derivative(0.0, 1e-3, |y| energy(0.0, y)),
            );
            assert!((force + gradient).norm() < 1e-9, "{force:?} {gradient:?}");
        }
    }
}

#[test]
fn the_second_node_has_the_opposite_force() {
    let constants = constants(Weight::Conic);
    let (bond, moved) = (Vec2::new(0.31, -0.7), Vec2::new(0.017, 0.023));
    let here = force(&constants, &elongation(bond, moved));
    let there = force(&constants, &elongation(-bond, -moved));
    assert_eq!(here, -there);
    assert!(here.dot(bond) * elongation(bond, moved).stretch() > 0.0);
}

#[test]
fn coincident_nodes_exert_no_force() {
    let bond = Vec2::new(0.75, -1.0);
    let state = elongation(bond, -bond);
    assert_eq!(state.stretch(), -1.0);
    assert_eq!(force(&constants(Weight::Constant), &state), Vec2::zero());
}

#[test]
fn only_the_two_sided_rule_breaks_compressed_bonds() {
    let bond = Vec2::new(0.6, 0.8);
    let states = [-0.2, -0.099, 0.0, 0.099, 0.2].map(|stretch| elongation(bond, bond * stretch));
    let tension_only = states.map(|state| state.exceeds::<false>(0.1));
    let two_sided = states.map(|state| state.exceeds::<true>(0.1));
    assert_eq!(tension_only, [false, false, false, false, true]);
    assert_eq!(two_sided, [true, false, false, false, true]);
}
