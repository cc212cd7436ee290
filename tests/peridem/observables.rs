//! Quantities that are read off a state, against constructed states.

use crate::cloud::{H, at_rest, grain, lattice};
use gouge_common::geometry::Vec2;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::forces::Workspace;
use gouge_peridem::grain::Grains;
use gouge_peridem::material::Weight;
use gouge_peridem::observables::{
    Crack, bulk_damage, connected_damage, face_gap, free_distance, grain_damage, pieces,
    softened_area,
};
use gouge_peridem::state::State;

/// A lattice, and another of half its nodes, torn along lines: nodes are moved away, bonds break, and nodes come back.
fn torn(moves: impl Fn(Vec2) -> Vec2) -> (Grains, State) {
    let mut first = grain(lattice(20, 20), 3.015, Weight::Constant);
    first.breaking = Some(gouge_peridem::bond_law::BreakingRule::TensionOnly);
    let second = grain(
        lattice(20, 10)
            .iter()
            .map(|&at| at + Vec2::new(100.0 * H, 0.0))
            .collect(),
        3.015,
        Weight::Constant,
    );
    let (grains, mut state) = at_rest(&[first, second]);
    for place in &mut state.places {
        place.displacement = moves(place.reference);
    }
    let settings = crate::cloud::settings(1e-8);
    Workspace::new(&grains, &settings, &state).evaluate(&grains, &settings, &mut state);
    for place in &mut state.places {
        place.displacement = Vec2::zero();
    }
    (grains, state)
}

#[test]
fn pieces_are_counted_above_a_fraction() {
    let halves = |at: Vec2| match (at.x > 9.5 * H, at.y > 15.5 * H) {
        (false, _) => Vec2::zero(),
        (true, false) => Vec2::new(100.0 * H, 0.0),
        (true, true) => Vec2::new(0.0, 100.0 * H),
    };
    let (grains, state) = torn(|at| {
        if at.x < 50.0 * H {
            halves(at)
        } else {
            Vec2::zero()
        }
    });
    let count = |grain, fraction| pieces(&grains, &state.bonds, grain, fraction);
    // Parts of 200, 160 and 40 of 400 nodes.
    assert_eq!(
        [0.0, 0.05, 0.1, 0.39, 0.4, 0.5].map(|f| count(0, f)),
        [3, 3, 2, 2, 1, 0]
    );
    assert_eq!([0.1, 0.4].map(|f| count(0, f * (1.0 - 5e-7))), [3, 2]);
    assert_eq!(count(1, 0.5), 1);
    let alone = Bonds::from_pairs(&grains, &[]).unwrap();
    assert_eq!(pieces(&grains, &alone, 1, 0.0), 200);
}

#[test]
fn damage_is_averaged_over_nodes_and_then_over_grains() {
    let (grains, state) = torn(|at| {
        Vec2::new(
            if at.x > 9.5 * H && at.x < 50.0 * H {
                H
            } else {
                0.0
            },
            0.0,
        )
    });
    let bonds = &state.bonds;
    assert_eq!(
        (
            grain_damage(&grains, bonds, 1),
            softened_area(&grains, bonds, 1)
        ),
        (0.0, 0.0)
    );
    // Bonds reach three columns on either side.
    let softened = softened_area(&grains, bonds, 0) / (6.0 * 20.0 * H * H);
    assert!((softened - 1.0).abs() < 1e-12, "{softened}");
    let mean = (0..400).map(|node| bonds.damage(node)).sum::<f64>() / 400.0;
    assert!(mean > 0.05 && (grain_damage(&grains, bonds, 0) - mean).abs() < 1e-15);
    assert!((bulk_damage(&grains, bonds) - 0.5 * mean).abs() < 1e-15);
}

#[test]
fn the_line_of_a_crack_is_found_with_its_sign() {
    let tip = Vec2::new(9.5, 9.5) * H;
    for degrees in [68.0_f64, -68.0, 112.0, 180.0, 0.0, -123.0] {
        let way = Vec2::new(degrees.to_radians().cos(), degrees.to_radians().sin());
        // Nodes beyond the tip are moved apart across the line.
        let (grains, state) = torn(|at| {
            let arm = at - tip;
            let is_beyond = arm.dot(way) > 0.0 && at.x < 50.0 * H;
            let side = if way.cross(arm) > 0.0 { 1.0 } else { -1.0 };
            if is_beyond {
                way.perpendicular() * (side * 0.02 * arm.dot(way))
            } else {
                Vec2::zero()
            }
        });
        let belongs = |node: usize| grains.position[node].x < 50.0 * H;
        let crack = Crack::from_tip(&grains, &state.bonds, tip, 0.3, belongs).unwrap();
        let error = (crack.angle.to_degrees() - degrees + 540.0).rem_euclid(360.0) - 180.0;
        assert!(error.abs() < 3.0, "{degrees}: {crack:?}");
        assert!(
            crack.length > 8.0 * H && crack.length < 15.0 * H && crack.nodes > 10,
            "{crack:?}"
        );
        assert_eq!(
            Crack::from_tip(&grains, &state.bonds, tip, 1.0, belongs),
            None
        );
    }
}

#[test]
fn distances_of_nodes_without_bonds_and_of_faces() {
    let (grains, mut state) = torn(|at| {
        Vec2::new(
            0.0,
            if at.y > 9.5 * H && at.x < 50.0 * H {
                H
            } else {
                0.0
            },
        )
    });
    let row = |y: usize| (0..20).map(|x| 20 * y + x).collect::<Vec<usize>>();
    let (upper, lower) = (row(10), row(9));
    for gap in [1.5, 1.0, 0.25, -0.5] {
        for node in 200..400 {
            state.places[node].displacement = Vec2::new(0.0, (gap - 1.0) * H);
        }
        let found = face_gap(&state, &upper, &lower).unwrap();
        assert!((found / H - gap).abs() < 1e-12, "{gap}: {found}");
        let free = free_distance(&grains, &state, 2.0 * H).unwrap();
        assert!((free / H - gap.abs()).abs() < 1e-12, "{gap}: {free}");
    }
    assert_eq!(free_distance(&grains, &state, 0.4 * H), None);
    let half = [1.0 - 3e-7, 1.0 + 3e-7].map(|f| free_distance(&grains, &state, 0.5 * H * f));
    assert!(half[0].is_none() && half[1].is_some(), "{half:?}");
    assert_eq!(face_gap(&state, &upper, &lower[..1]), None);
    assert_eq!(face_gap(&state, &[], &lower), None);
}

#[test]
fn a_face_beyond_the_end_of_the_other_has_the_distance_from_that_end() {
    let (_, state) = torn(|_| Vec2::zero());
    // Columns 3 and 13 of the tenth row, and columns 6 to 10 of the ninth one.
    let chain: Vec<usize> = (6..=10).map(|x| 20 * 9 + x).collect();
    for (node, expected) in [(20 * 10 + 13, 10.0_f64), (20 * 10 + 3, 10.0)] {
        let found = face_gap(&state, &[node], &chain).unwrap();
        assert!((found / H - expected.sqrt()).abs() < 1e-11, "{found}");
    }
}

#[test]
fn a_crack_along_lattice_nodes_has_their_direction() {
    let (grains, state) = torn(|_| Vec2::zero());
    for (node, way) in [
        (105, (2, 1)),
        (105, (1, 3)),
        (313, (-3, -2)),
        (190, (-1, 1)),
    ] {
        let tip = grains.position[node];
        let along = Vec2::new(f64::from(way.0), f64::from(way.1)) * H;
        let of_crack = |other: usize| {
            let arm = grains.position[other] - tip;
            arm.cross(along).abs() < 1e-3 * H * H && arm.dot(along) > 0.0 && other < 400
        };
        let crack = Crack::from_tip(&grains, &state.bonds, tip, -1.0, of_crack).unwrap();
        assert!(
            (crack.angle - along.y.atan2(along.x)).abs() < 1e-12,
            "{crack:?}"
        );
        let farthest = crack.nodes as f64 * along.norm();
        assert!((crack.length / farthest - 1.0).abs() < 1e-12, "{crack:?}");
    }
}

#[test]
fn nodes_belong_to_a_crack_above_the_threshold_of_damage() {
    let (grains, state) = torn(|at| {
        let is_moved = at.x > 9.5 * H && at.x < 50.0 * H;
        Vec2::new(if is_moved { H } else { 0.0 }, 0.0)
    });
    let node = 20 * 10 + 10;
    let damage = state.bonds.damage(node);
    assert!(damage > 0.0);
    let tip = grains.position[node] - Vec2::new(H, 0.0);
    let count = |threshold: f64| {
        let only = |other: usize| other == node;
        Crack::from_tip(&grains, &state.bonds, tip, threshold, only).map(|crack| crack.nodes)
    };
    let factors = [1.0 - 5e-7, 1.0, 1.0 + 5e-7];
    assert_eq!(factors.map(|f| count(f * damage)), [Some(1), None, None]);
}

#[test]
fn damage_is_connected_with_a_tip_by_short_steps() {
    let horizon = 3.015 * H;
    // A row along y = 0, and one that is too far from it; all nodes count, whatever their damage.
    let found = |step: f64, begin: f64| {
        let row = |y: f64| (0..4).map(move |k| Vec2::new(begin + f64::from(k) * step, y) * horizon);
        let position: Vec<_> = row(0.0).chain(row(1.2)).collect();
        let (grains, state) = at_rest(&[grain(position, 3.015, Weight::Constant)]);
        connected_damage(&grains, &state.bonds, 0, Vec2::zero(), -1.0)
    };
    let (below, above) = (1.0 - 5e-7, 1.0 + 5e-7);
    assert_eq!(found(0.5 * below, below), [0, 1, 2, 3]);
    assert_eq!(found(0.5 * above, below), [0]);
    assert!(found(0.5 * below, above).is_empty());
    let (grains, state) = torn(|at| Vec2::new(if at.x > 9.5 * H { H } else { 0.0 }, 0.0));
    let node = 20 * 10 + 10;
    let damage = state.bonds.damage(node);
    let tip = grains.position[node];
    let is_found =
        |threshold: f64| connected_damage(&grains, &state.bonds, 0, tip, threshold).contains(&node);
    assert!(damage > 0.0 && is_found(damage * below) && !is_found(damage * above));
    let (grains, state) = torn(|_| Vec2::zero());
    let tip = grains.position[0];
    assert!(connected_damage(&grains, &state.bonds, 0, tip, 0.0).is_empty());
}
