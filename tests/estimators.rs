//! Estimators on states with known results.

use crate::worlds::{advance, world};
use approx::{abs_diff_eq, assert_abs_diff_eq};
use gouge_common::estimators::{
    Region, connected, packing_fraction, radial_distribution, visible_fraction,
};
use gouge_common::geometry::Vec2;
use gouge_dem::estimators::fragments;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, Controller, EulerBernoulli, HaffWerner, KelvinVoigt};
use gouge_runner::scene::DrivingTable;
use gouge_validation::scenes::events::stretched_chain;
use gouge_validation::scenes::{Draft, Grain};
use rand::RngExt;
use rand_pcg::Pcg64;

#[test]
fn packing_fraction_of_touching_discs_is_that_of_their_lattice() {
    let q = packing_fraction(&[0.5; 100], 100.0);
    assert_abs_diff_eq!(q, std::f64::consts::FRAC_PI_4, epsilon = 1e-14);
}

#[test]
fn the_part_of_a_circle_inside_a_region_matches_sampling() {
    let mut random = Pcg64::new(5, 1);
    for periodic in [true, false] {
        let region = Region {
            width: 4.0,
            height: 1.0,
            periodic,
        };
        for _ in 0..200 {
            let point = Vec2::new(4.0 * random.random::<f64>(), random.random::<f64>());
            let distance = random.random::<f64>();
            let samples = 20_000;
            let inside = (0..samples).filter(|&k| {
                let angle = std::f64::consts::TAU * (f64::from(k) + 0.5) / f64::from(samples);
                let (x, y) = (
                    point.x + distance * angle.cos(),
                    point.y + distance * angle.sin(),
                );
                (0.0..=1.0).contains(&y) && (periodic || (0.0..=4.0).contains(&x))
            });
            let counted = inside.count() as f64 / f64::from(samples);
            let found = visible_fraction(&region, point, distance);
            // Each of the at most eight ends of arcs is wrong by at most one sample.
            assert!(
                abs_diff_eq!(found, counted, epsilon = 8.0 / f64::from(samples)),
                "{found} {counted}"
            );
        }
    }
}

#[test]
fn an_ideal_gas_has_no_excess_entropy() {
    let mut random = Pcg64::new(11, 3);
    let region = Region {
        width: 40.0,
        height: 20.0,
        periodic: true,
    };
    let points: Vec<Vec2> = (0..3000)
        .map(|_| Vec2::new(40.0 * random.random::<f64>(), 20.0 * random.random::<f64>()))
        .collect();
    let gas = radial_distribution(&points, &region, 0.4, 500);
    // Except near zero, within the reach of the smoothing kernel, g is one up to noise of about 1 %.
    for (d, g) in gas.distance.iter().zip(&gas.g) {
        assert!(
            *d < 0.8 || *d > 9.6 || abs_diff_eq!(*g, 1.0, epsilon = 0.05),
            "g({d}) = {g}"
        );
    }
    let spacing = 2.0 * gas.distance[0];
    let norm: f64 = gas.density.iter().sum::<f64>() * spacing;
    assert_abs_diff_eq!(norm, 1.0, epsilon = 1e-12);
    assert!(gas.excess_entropy() <= 0.0 && gas.excess_entropy() > -1.0);
}

#[test]
fn a_lattice_has_its_shells_and_far_less_entropy_than_a_gas() {
    let region = Region {
        width: 40.0,
        height: 20.0,
        periodic: true,
    };
    let points: Vec<Vec2> = (0..800)
        .map(|k| Vec2::new(f64::from(k % 40) + 0.5, f64::from(k / 40) + 0.5))
        .collect();
    let lattice = radial_distribution(&points, &region, 0.1, 2000);
    let at = |distance: f64| {
        let near = |d: &f64| (d - distance).abs() < 0.1;
        let pairs = lattice.distance.iter().zip(&lattice.g);
        pairs
            .filter(|(d, _)| near(d))
            .map(|(_, g)| *g)
            .fold(0.0, f64::max)
    };
    // Four neighbours per shell: 4 / (2 pi d) times the peak of the smoothing kernel, 0.75 / 0.1, gives 4.8 and 3.4.
    assert!(at(0.8) < 0.01 && at(1.0) > 4.5 && at(2.0_f64.sqrt()) > 3.0 && at(1.2) < 0.01);
    assert!(lattice.excess_entropy() < -20.0);
}

#[test]
fn the_stress_of_a_stretched_chain_is_its_force_over_its_section() {
    let world = world(&stretched_chain([1.0, 0.0], 2.002e-3));
    // Nine bonds of 2.002 mm in a volume of nine such lengths times one square millimetre.
    let stress = world.contact_network().mean_stress(9.0 * 2.002e-3 * 1e-6);
    let expected = 1e7 * 2e-6 / 1e-6;
    assert!(
        abs_diff_eq!(stress[0][0] / expected, 1.0, epsilon = 1e-10),
        "{stress:?}"
    );
    assert_eq!([stress[0][1], stress[1][0], stress[1][1]], [0.0; 3]);
    assert_abs_diff_eq!(
        world.contact_network().coordination_number(),
        1.8,
        epsilon = 1e-15
    );
    assert_eq!(fragments(world.state()).number, 1);
}

#[test]
fn friction_of_a_driven_grain_is_the_ratio_of_its_forces() {
    use gouge_dem::estimators::{friction_feedback, friction_load};
    // Pulled at constant speed against creeping drag and pressed against the drag's absence: the
    // reaction along x is the drag 6 pi eta r v alone.
    let draft = Draft::open_box(Integrator::SymplecticEuler, 1e-6)
        .creeping_drag(10.0)
        .driving(DrivingTable {
            controller: Controller::Exact,
            speed: 2.0,
            pressure: 3.0,
            area: Some(1.0),
            initial_force: [0.0; 2],
        })
        .grain(Grain::at([0.0, 0.0], 1e-3).moving([2.0, 0.0]).driven());
    let mut world = world(&draft);
    advance(&mut world, 100);
    world.evaluate_if_pending().expect("finite");
    let drag = 6.0 * std::f64::consts::PI * 10.0 * 1e-3 * 2.0;
    assert_abs_diff_eq!(world.particles().velocity[0].x, 2.0, epsilon = 1e-14);
    assert_abs_diff_eq!(
        friction_load(world.drive()) / (drag / 3.0),
        1.0,
        epsilon = 1e-12
    );
    let reaction = world.drive().reaction;
    assert_abs_diff_eq!(reaction.x / -drag, 1.0, epsilon = 1e-12);
    assert_eq!(friction_feedback(world.drive()), -reaction.x / reaction.y);
}

/// A frame of bonded and touching grains with random velocities and spins.
fn moving_frame() -> Draft {
    let mut random = Pcg64::new(7, 7);
    let mut noise = |scale: f64| scale * (random.random::<f64>() - 0.5);
    let (stiffness, damping) = (1e7, 10.0);
    let mut draft = Draft::open_box(Integrator::SymplecticEuler, 1e-9)
        .law(AdjustedKelvinVoigt { stiffness, damping })
        .law(EulerBernoulli { stiffness, damping })
        .law(KelvinVoigt { stiffness, damping })
        .law(HaffWerner {
            friction: 0.7,
            damping: 3.0,
        });
    for k in 0..25 {
        let at = [
            f64::from(k % 5) * 1.9e-3 + noise(1e-4),
            f64::from(k / 5) * 1.9e-3 + noise(1e-4),
        ];
        draft = draft.grain(
            Grain::at(at, 1e-3)
                .moving([noise(1.0), noise(1.0)])
                .spinning(noise(500.0)),
        );
    }
    for k in (0..25).filter(|k| k % 5 != 4).step_by(2) {
        draft = draft.bonded(k, k + 1);
    }
    draft
}

#[test]
fn the_mean_stress_is_the_virial_of_the_forces() {
    let mut world = world(&moving_frame());
    advance(&mut world, 20);
    world.evaluate_if_pending().expect("finite");
    let stress = world.contact_network().mean_stress(1.0);
    let mut virial = [[0.0; 2]; 2];
    for (force, x) in world.forces().force.iter().zip(&world.particles().position) {
        for (row, force) in virial.iter_mut().zip([force.x, force.y]) {
            row[0] -= force * x.x;
            row[1] -= force * x.y;
        }
    }
    let scale = virial
        .iter()
        .flatten()
        .fold(0.0, |m: f64, x| m.max(x.abs()));
    for (found, expected) in stress.iter().flatten().zip(virial.iter().flatten()) {
        assert!(
            abs_diff_eq!(found, expected, epsilon = 1e-10 * scale),
            "{stress:?} {virial:?}"
        );
    }
    assert!(
        (stress[0][1] - stress[1][0]).abs() > 1e-6 * scale,
        "torques are at work"
    );
    assert!((stress[0][1]).abs() > 1e-3 * scale);
}

#[test]
fn entropy_of_simple_radial_distributions_is_closed_form() {
    use gouge_common::estimators::RadialDistribution;
    let (samples, limit, number_density) = (4000_u32, 2.5, 3.0);
    let spacing = limit / f64::from(samples);
    let distance: Vec<f64> = (0..samples)
        .map(|k| (f64::from(k) + 0.5) * spacing)
        .collect();
    let with = |g: &dyn Fn(f64) -> f64| {
        let g: Vec<f64> = distance.iter().map(|d| g(*d)).collect();
        RadialDistribution {
            distance: distance.clone(),
            density: vec![],
            g,
            number_density,
        }
    };
    let close = |found: f64, expected: f64| {
        abs_diff_eq!(found, expected, epsilon = 1e-6 * expected.abs().max(1.0))
    };
    let area = std::f64::consts::PI * limit * limit;
    let ideal = with(&|_| 1.0);
    assert!(close(ideal.excess_entropy(), 0.0) && close(ideal.excess_entropy_printed(), 0.0));
    // A hard core that changes nothing else: n times half the area of the core.
    let core = with(&|d| if d < 1.0 { 0.0 } else { 1.0 });
    assert!(close(core.excess_entropy(), -1.5 * std::f64::consts::PI));
    assert!(close(core.excess_entropy_printed(), -1.5));
    let flat = with(&|_| std::f64::consts::E);
    assert!(close(flat.excess_entropy(), -1.5 * area));
    assert!(close(flat.excess_entropy_printed(), -1.5 * limit));
    // A g of mean one: minus n A / 2 times the information gain relative to a uniform disc, here ln 2.
    let ring = with(&|d| {
        if 2.0 * d * d < limit * limit {
            2.0
        } else {
            0.0
        }
    });
    let expected = -0.5 * number_density * area * 2.0_f64.ln();
    assert_abs_diff_eq!(ring.excess_entropy() / expected, 1.0, epsilon = 1e-3);
}

#[test]
fn the_radial_distribution_ignores_points_outside_the_region() {
    let mut random = Pcg64::new(3, 9);
    for periodic in [true, false] {
        let region = Region {
            width: 10.0,
            height: 10.0,
            periodic,
        };
        let mut points: Vec<Vec2> = (0..500)
            .map(|_| Vec2::new(10.0 * random.random::<f64>(), 10.0 * random.random::<f64>()))
            .collect();
        let inside = radial_distribution(&points, &region, 0.2, 100);
        points.extend([
            Vec2::new(5.0, -0.01),
            Vec2::new(5.1, -0.3),
            Vec2::new(2.0, 10.2),
        ]);
        assert_eq!(radial_distribution(&points, &region, 0.2, 100), inside);
    }
}

#[test]
fn the_radial_distribution_of_an_ideal_gas_is_corrected_for_edges() {
    let mut random = Pcg64::new(21, 4);
    // A strip hardly higher than the diameter of the circles: nearly every circle is cut.
    for periodic in [true, false] {
        let region = Region {
            width: 20.0,
            height: 6.0,
            periodic,
        };
        let points: Vec<Vec2> = (0..4000)
            .map(|_| Vec2::new(20.0 * random.random::<f64>(), 6.0 * random.random::<f64>()))
            .collect();
        let gas = radial_distribution(&points, &region, 0.25, 200);
        let far = gas.distance.iter().zip(&gas.g).filter(|(d, _)| **d > 0.5);
        let worst = far.map(|(_, g)| (g - 1.0).abs()).fold(0.0, f64::max);
        assert!(worst < 0.06, "{worst}");
    }
}

#[test]
fn a_chain_a_ring_and_single_particles_are_separate_components() {
    let edges = [(5, 2), (2, 8), (1, 3), (3, 7), (7, 1)];
    let found = connected(9, edges.into_iter());
    assert_eq!(found.number, 5);
    assert_eq!(found.label, [0, 1, 2, 1, 3, 2, 4, 1, 2]);
}
