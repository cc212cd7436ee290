//! Neighbour search finds exactly the interacting pairs; bonds and contacts follow from them.

use crate::worlds::{advance, world};
use gouge_common::geometry::{Domain, Metric, Open, PeriodicX, Vec2};
use gouge_common::neighbors::{Cells, Neighbors, precedes};
use gouge_common::pair::Pair;
use gouge_common::parts::Parts;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, KelvinVoigt, ZhangEckert};
use gouge_dem::model::{BondLaws, Model, Yielding};
use gouge_dem::particles::{Particle, Particles, Role, SPHERE_INERTIA_FACTOR};
use gouge_validation::scenes::{Draft, Grain};
use proptest::prelude::*;

fn particles(points: &[(f64, f64, f64)]) -> Particles {
    points
        .iter()
        .map(|&(x, y, radius)| Particle {
            position: Vec2::new(x, y),
            velocity: Vec2::zero(),
            angle: 0.0,
            angular_velocity: 0.0,
            radius,
            density: 1.0,
            inertia_factor: SPHERE_INERTIA_FACTOR,
            role: Role::Free,
        })
        .collect()
}

/// A box with the given width and height.
fn domain([width, height]: [Option<f64>; 2], periodic: bool) -> Domain {
    Domain {
        width,
        height,
        periodic,
    }
}

/// All overlapping pairs, by brute force.
fn overlapping(metric: impl Metric, p: &Particles) -> Vec<Pair> {
    let mut pairs = Vec::new();
    for i in 0..p.len() {
        for j in i + 1..p.len() {
            let d = metric.displacement(p.position[i], p.position[j]).norm();
            if d < p.radius[i] + p.radius[j] {
                pairs.push(Pair::new(i, j));
            }
        }
    }
    pairs.sort();
    pairs
}

fn found(metric: impl Metric, p: &Particles, neighbors: &mut Neighbors<f64>) -> Vec<Pair> {
    let mut pairs = Vec::new();
    neighbors.rebuild(metric, p.search_spheres(), |_, _| true, &mut pairs);
    assert!(
        pairs.windows(2).all(|two| two[0] < two[1]),
        "each pair once and in order"
    );
    pairs.retain(|pair| {
        let (i, j) = pair.indices();
        metric.displacement(p.position[i], p.position[j]).norm() < p.radius[i] + p.radius[j]
    });
    pairs
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn open_box_equals_brute_force(
        points in prop::collection::vec((-3.0..5.0, -2.0..9.0, 0.05..0.5), 0..60),
        given in any::<bool>(),
    ) {
        let p = particles(&points);
        let extent = if given { [Some(2.0), Some(3.0)] } else { [None, None] };
        let mut neighbors = Neighbors::new(p.search_spheres(), &domain(extent, false));
        prop_assert_eq!(found(Open, &p, &mut neighbors), overlapping(Open, &p));
    }

    #[test]
    fn periodic_box_equals_brute_force(
        columns in 2.0..9.0,
        points in prop::collection::vec((0.0..1.0, -1.0..4.0, 0.1..0.5), 1..60),
    ) {
        // Starting with the narrowest valid box: two cells.
        let length = columns * 1.0;
        let points: Vec<_> = points.iter().map(|&(x, y, r)| (x * length, y, r)).collect();
        let p = particles(&points);
        let metric = PeriodicX { length };
        let mut neighbors = Neighbors::new(p.search_spheres(), &domain([Some(length), Some(3.0)], true));
        prop_assert_eq!(found(metric, &p, &mut neighbors), overlapping(metric, &p));
    }

    #[test]
    fn a_neighbour_list_that_is_not_stale_misses_no_contact(
        points in prop::collection::vec((0.0..4.0, 0.0..4.0, 0.1..0.3), 2..40),
        moves in prop::collection::vec((-1.0..1.0, -1.0..1.0), 40),
        size in 0.0..0.2,
    ) {
        let mut p = particles(&points);
        let metric = PeriodicX { length: 4.0 };
        let mut neighbors = Neighbors::new(p.search_spheres(), &domain([Some(4.0), Some(4.0)], true));
        let mut pairs = Vec::new();
        neighbors.rebuild(metric, p.search_spheres(), |_, _| true, &mut pairs);
        for (x, (dx, dy)) in p.position.iter_mut().zip(&moves) {
            *x = metric.wrap(*x + Vec2::new(dx * size, dy * size));
        }
        if !neighbors.is_stale(metric, &p.position) {
            for pair in overlapping(metric, &p) {
                prop_assert!(pairs.binary_search(&pair).is_ok(), "missed {pair:?}");
            }
        }
    }

    #[test]
    fn index_space_is_a_generalised_inverse(x in -9.0..9.0, y in -9.0..9.0) {
        let cells = Cells::new(0.3, None);
        let index = cells.cell_at(Vec2::new(x, y));
        prop_assert_eq!(cells.cell_at(cells.centre(index)), index);
        prop_assert_eq!(cells.centre(cells.cell_at(cells.centre(index))), cells.centre(index));
    }

    #[test]
    fn cells_meet_halfway_between_their_centres(x in 0.3..3.6, y in 0.3..2.6) {
        let cells = Cells::new(0.3, None);
        let index = cells.cell_at(Vec2::new(x, y));
        let (centre, side) = (cells.centre(index), cells.side());
        for step in [Vec2::new(1.2 * side.x, 0.0), Vec2::new(0.0, 1.2 * side.y)] {
            let next = cells.cell_at(centre + step);
            prop_assert_eq!(cells.distance(index, next), 1);
            let half = (cells.centre(next) - centre) * 0.5;
            prop_assert_eq!(cells.cell_at(centre + half * (1.0 - 1e-9)), index);
            prop_assert_eq!(cells.cell_at(centre + half * (1.0 + 1e-9)), next);
        }
    }

    #[test]
    fn the_order_of_particles_is_a_total_order(
        a in (0.0..4.0, 0.0..3.0), b in (0.0..4.0, 0.0..3.0), i in 0_usize..3, j in 0_usize..3,
    ) {
        let cells = Cells::new(0.9, Some(4.0));
        let place = |(x, y): (f64, f64)| cells.cell_at(Vec2::new(x, y));
        let (a, b) = ((place(a), i), (place(b), j));
        let before = [precedes(a, b), precedes(b, a), a == b];
        prop_assert_eq!(before.iter().filter(|&&holds| holds).count(), 1);
    }
}

#[test]
fn chebyshev_distance_uses_the_nearest_periodic_image() {
    let cells = Cells::new(1.0, Some(10.0));
    let at = |x: f64, y: f64| cells.cell_at(Vec2::new(x, y));
    assert_eq!(cells.distance(at(0.5, 0.5), at(9.5, 0.5)), 1);
    assert_eq!(cells.distance(at(0.5, 0.5), at(5.5, 0.5)), 5);
    assert_eq!(cells.distance(at(9.5, 7.5), at(0.5, 2.5)), 5);
}

#[test]
fn a_world_without_particles_has_no_pairs() {
    let nothing = particles(&[]);
    assert!(nothing.is_empty() && !particles(&[(0.0, 0.0, 1.0)]).is_empty());
    assert!(overlapping(Open, &nothing).is_empty());
    let mut neighbors = Neighbors::new(nothing.search_spheres(), &domain([None, None], false));
    assert!(found(Open, &nothing, &mut neighbors).is_empty());
}

/// The list reaches beyond the touching distance only as far as the box permits.
#[test]
fn the_list_of_the_narrowest_box_has_no_margin() {
    let listed = |length: f64| {
        let p = particles(&[(0.005, 0.0, 0.005), (0.005, 0.0105, 0.005)]);
        let box_ = domain([Some(length), Some(0.1)], true);
        let mut pairs = Vec::new();
        Neighbors::new(p.search_spheres(), &box_).rebuild(
            PeriodicX { length },
            p.search_spheres(),
            |_, _| true,
            &mut pairs,
        );
        pairs.len()
    };
    assert_eq!([listed(0.02), listed(0.2)], [0, 1]);
}

#[test]
fn parts_divide_all_particles() {
    for particles in [0, 1, 7, 100, 12_345] {
        for threads in 1..6 {
            let parts = Parts::new(particles, threads);
            assert_eq!(parts.sizes().sum::<usize>(), particles);
            assert_eq!(parts.sizes().count(), parts.number());
        }
    }
}

/// Two grains that leave the reach of the list in the same step, each on its way to a fixed one.
#[test]
fn grains_that_move_alike_both_make_the_list_stale() {
    let mut draft = Draft::open_box(Integrator::VelocityVerlet, 1e-6).law(KelvinVoigt {
        stiffness: 1e5,
        damping: 0.0,
    });
    for y in [0.0, 0.02] {
        draft = draft
            .grain(Grain::at([0.0, y], 1e-3).moving([1.0, 0.0]))
            .grain(Grain::at([0.02, y], 1e-3).fixed());
    }
    let mut world = world(&draft);
    advance(&mut world, 25_000);
    for i in [0, 2] {
        assert!(
            world.particles().velocity[i].x < -0.9,
            "grain {i} missed its target"
        );
    }
}

/// Two bonded grains that are torn apart, the second with a role.
fn torn(role: Role, yielding: bool) -> gouge_dem::World {
    let strength = Draft::empty().law(ZhangEckert {
        normal_strength: 28e6,
        tangential_strength: 16.8e6,
    });
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
        .law(AdjustedKelvinVoigt {
            stiffness: 1e7,
            damping: 1.0,
        })
        .and(&if yielding { strength } else { Draft::empty() })
        .grain(Grain::at([0.0, 0.0], 1e-3).moving([-16.0, 0.0]))
        .grain(Grain::at([2.0e-3, 0.0], 1e-3).with_role(role))
        .bonded(0, 1);
    world(&draft)
}

#[test]
fn edge_bonds_break_only_in_phases_that_let_them() {
    let model = |edges: bool| {
        let model = *torn(Role::Free, true).model();
        let yielding = |yielding| Yielding {
            tensile_strength: None,
            unbreakable_edges: edges,
            ..yielding
        };
        let bond = model.bond.map(|bond| BondLaws {
            yielding: bond.yielding.map(yielding),
            ..bond
        });
        Model { bond, ..model }
    };
    let edge = Some(vec![Role::Free, Role::Fixed]);
    let phases = [
        (Role::Free, true, model(true), None, 0),
        (Role::Fixed, true, model(true), None, 1),
        // The edge comes to be only now.
        (Role::Free, true, model(true), edge.clone(), 1),
        (Role::Free, true, model(false), edge, 0),
        // No bond could break before, and now every one can.
        (Role::Fixed, false, model(false), None, 0),
    ];
    for (role, yielding, model, roles, holding) in phases {
        let mut world = torn(role, yielding)
            .continue_with(model, roles)
            .expect("the kernel goes on");
        advance(&mut world, 5000);
        let found = world.bonds().map(|strong| strong.len());
        assert_eq!(found, Some(holding), "{role:?} {yielding} {model:?}");
    }
}
