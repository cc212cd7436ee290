//! Stable time steps against closed forms.

use crate::cloud::{H, at_rest, contact, grain, lattice, material, settings, walls};
use gouge_peridem::contact_law::{Node, largest_step};
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::limits::{BondLimits, Limits};
use gouge_peridem::material::Weight;
use gouge_peridem::wall_law::WallReading;
use std::f64::consts::PI;

fn assert_near(found: f64, expected: f64) {
    assert!(
        (found / expected - 1.0).abs() < 1e-11,
        "{found:e} {expected:e}"
    );
}

#[test]
fn two_equal_nodes_reach_the_bound_by_row_sums() {
    for weight in [Weight::Constant, Weight::Conic, Weight::Parabolic] {
        let pair = grain(lattice(2, 1), 1.5, weight);
        let spring = pair.constants.stiffness * weight.at(H, 1.5 * H) * H.powi(4) / H;
        let reduced = 0.5 * material().density * H * H;
        let (grains, state) = at_rest(&[pair]);
        let limits = BondLimits::of(&grains, &state.bonds);
        let expected = 2.0 * (reduced / spring).sqrt();
        assert_near(limits.exact, expected);
        assert_near(limits.row_sum, expected);
    }
}

/// Nodes without bonds, one of which is smaller.
fn loose() -> (Grain, Node) {
    let mut block = grain(lattice(3, 3), 0.5, Weight::Constant);
    block.area[4] *= 0.6;
    let smallest = Node {
        area: 0.6 * H * H,
        density: block.density,
    };
    (block, smallest)
}

/// Square of the frequency and rate of damping of a node among equal ones in half a disc, all of which may move
/// against it.
fn among_partners(node: &Node, stiffness: f64) -> [f64; 2] {
    let law = contact(0.3, 0.0).law;
    let partners = 0.5 * PI * law.radius.powi(2) / node.area;
    let spring = stiffness * node.area * node.area;
    let reduced = 0.5 * node.mass();
    let rate = 2.0 * 0.3 * (spring * reduced).sqrt();
    [spring, rate].map(|one| 2.0 * partners * one / node.mass())
}

#[test]
fn contacts_limit_the_step_like_equal_partners_in_half_a_disc() {
    let (mut block, smallest) = loose();
    let mut settings = settings(1e-9);
    let mut contact = contact(0.3, 0.0);
    let stiffness = contact.stiffness[0][0];
    contact.stiffness = vec![
        vec![stiffness, 3.0 * stiffness],
        vec![3.0 * stiffness, stiffness],
    ];
    let radius = contact.law.radius;
    settings.contact = Some(contact);
    for (touches_itself, largest) in [(false, 3.0 * stiffness), (true, 7.0 * stiffness)] {
        block.touches_itself = touches_itself;
        block.contact_stiffness = 7.0 * stiffness * radius;
        let (grains, state) = at_rest(std::slice::from_ref(&block));
        let limits = Limits::of(&grains, &state.bonds, &settings);
        let [square, rate] = among_partners(&smallest, largest);
        assert_near(limits.contact, largest_step(square, 0.0));
        assert_near(limits.damping, largest_step(square, rate));
    }
}

#[test]
fn damping_also_acts_on_the_vibrations_of_bonds() {
    let block = grain(lattice(4, 4), 2.5, Weight::Constant);
    let (grains, state) = at_rest(std::slice::from_ref(&block));
    let node = Node {
        area: H * H,
        density: block.density,
    };
    let mut settings = settings(1e-9);
    let mut weak = contact(0.3, 0.0);
    weak.stiffness[0][0] *= 1e-3;
    let [square, rate] = among_partners(&node, weak.stiffness[0][0]);
    settings.contact = Some(weak);
    let limits = Limits::of(&grains, &state.bonds, &settings);
    let of_bonds = 4.0 / limits.bonds.exact.powi(2);
    assert!(of_bonds > square);
    assert_near(limits.contact, largest_step(square, 0.0));
    assert_near(limits.damping, largest_step(of_bonds, rate));
}

#[test]
fn walls_limit_the_step_by_their_steepest_slope_and_largest_damping() {
    let (block, smallest) = loose();
    let grains = Grains::new(&[block]).unwrap();
    let (_, state) = at_rest(&[loose().0]);
    // The disc is half beyond the authors' wall at most, and all of it beyond that of the paper.
    for (reading, share) in [(WallReading::Paper, 1.0), (WallReading::TwoFixes, 0.5)] {
        let mut settings = settings(1e-9);
        let mut own = walls(0.3, 0.0);
        own.law.reading = reading;
        settings.walls = Some(own);
        let beyond = share * PI * own.law.radius.powi(2);
        let spring = own.law.stiffness * smallest.area * beyond;
        let rate = 2.0 * 0.3 * (spring / smallest.mass()).sqrt();
        let square = own.law.steepest(smallest.area) / smallest.mass();
        let limits = Limits::of(&grains, &state.bonds, &settings);
        assert_near(limits.walls, largest_step(square, rate));
    }
}
