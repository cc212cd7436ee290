//! Frequencies and stable time steps against eigenvalues.

use crate::cloud::{
    H, at_rest, contact, disc, energy, grain, lattice, run, settings, vibration, walls, world,
};
use crate::quadrature::Random;
use faer::{Mat, Side};
use gouge_common::geometry::Vec2;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::error::SetupError;
use gouge_peridem::grain::Grain;
use gouge_peridem::limits::{BondLimits, Limits};
use gouge_peridem::material::Weight;
use gouge_peridem::state::State;
use gouge_peridem::world::{Beginning, World};

/// Grains of different shapes, with nodes of different areas and clamped nodes.
fn examples() -> [Grain; 4] {
    let mut random = Random(7);
    let mut scattered = lattice(7, 6);
    for node in &mut scattered {
        *node += Vec2::new(random.between(-0.2, 0.2), random.between(-0.2, 0.2)) * H;
    }
    let mut scattered = grain(scattered, 2.6, Weight::Conic);
    for area in &mut scattered.area {
        *area *= random.between(0.5, 1.5);
    }
    scattered.clamped = vec![0, 3, 20];
    [
        grain(lattice(14, 4), 3.015, Weight::Constant),
        grain(disc(Vec2::zero(), 4.1 * H), 4.015, Weight::Parabolic),
        grain(lattice(40, 1), 2.015, Weight::Constant),
        scattered,
    ]
}

/// Squares of the frequencies, in ascending order; clamped nodes do not move.
fn frequencies_squared(grain: &Grain) -> Vec<f64> {
    let (grains, state) = at_rest(std::slice::from_ref(grain));
    let mut matrix = vibration(&grains, &settings(1e-8), &state);
    for row in grain
        .clamped
        .iter()
        .flat_map(|node| [2 * node, 2 * node + 1])
    {
        for other in 0..matrix.nrows() {
            matrix[(row, other)] = 0.0;
            matrix[(other, row)] = 0.0;
        }
    }
    matrix.self_adjoint_eigenvalues(Side::Lower).unwrap()
}

#[test]
fn the_limit_of_bonds_is_that_of_the_largest_eigenvalue() {
    for grain in examples() {
        let exact = 2.0 / frequencies_squared(&grain).last().unwrap().sqrt();
        let (grains, state) = at_rest(&[grain]);
        let limits = BondLimits::of(&grains, &state.bonds);
        let error = limits.exact / exact - 1.0;
        assert!(error.abs() < 1e-8, "{error:e}");
        assert!(limits.row_sum <= exact && limits.row_sum > 0.45 * exact);
    }
}

#[test]
fn a_grain_without_bonds_has_no_limit() {
    let (grains, _) = at_rest(&[grain(lattice(2, 2), 1.5, Weight::Constant)]);
    let none = Bonds::from_pairs(&grains, &[]).unwrap();
    let limits = BondLimits::of(&grains, &none);
    assert_eq!(
        (limits.exact, limits.row_sum),
        (f64::INFINITY, f64::INFINITY)
    );
}

/// Growth of the largest velocity from a small noise over 600 steps; infinite if the step fails.
fn growth(grain: &Grain, ratio: f64) -> f64 {
    let (grains, state) = at_rest(std::slice::from_ref(grain));
    let limit = BondLimits::of(&grains, &state.bonds).exact;
    let mut random = Random(3);
    let noise = |state: &mut State| {
        for velocity in &mut state.velocity {
            *velocity = Vec2::new(random.between(-1e-9, 1e-9), random.between(-1e-9, 1e-9));
        }
    };
    let mut world = world(std::slice::from_ref(grain), settings(ratio * limit), noise);
    let largest = |world: &World| {
        let speeds = world
            .state()
            .velocity
            .iter()
            .map(|velocity| velocity.norm());
        speeds.fold(0.0, f64::max)
    };
    let before = largest(&world);
    for _ in 0..600 {
        if world.step().is_err() {
            return f64::INFINITY;
        }
    }
    largest(&world) / before
}

#[test]
fn runs_are_bounded_below_the_limit_and_grow_above_it() {
    for grain in examples() {
        let (below, above) = (growth(&grain, 0.999), growth(&grain, 1.001));
        assert!(below < 100.0 && above > 1e6, "{below:e} {above:e}");
    }
}

#[test]
fn a_mode_oscillates_with_the_frequency_of_velocity_verlet() {
    let bar = grain(lattice(14, 4), 3.015, Weight::Constant);
    let (grains, state) = at_rest(std::slice::from_ref(&bar));
    let matrix: Mat<f64> = vibration(&grains, &settings(1e-8), &state);
    let modes = matrix.self_adjoint_eigen(Side::Lower).unwrap();
    let step = 0.7 * BondLimits::of(&grains, &state.bonds).exact;
    for mode in [3, 10, 60, 111] {
        let square = modes.S().column_vector()[mode];
        let shape = |node: usize| {
            let column = modes.U().col(mode);
            Vec2::new(column[2 * node], column[2 * node + 1])
        };
        let size = 1e-10 * H;
        let mut world = world(std::slice::from_ref(&bar), settings(step), |state| {
            for (node, place) in state.places.iter_mut().enumerate() {
                place.displacement = shape(node) * size;
            }
        });
        // The exact motion is the cosine of a phase that grows by 2 asin(omega dt/2) per step.
        let phase = 2.0 * (0.5 * square.sqrt() * step).asin();
        for steps in 1..=300 {
            run(&mut world, 1);
            let places = world.state().places.iter().enumerate();
            let part: f64 = places
                .map(|(node, place)| place.displacement.dot(shape(node)))
                .sum();
            let error = part / size - (phase * f64::from(steps)).cos();
            assert!(
                error.abs() < 1e-8 * f64::from(steps).max(10.0),
                "{mode} {steps}: {error:e}"
            );
        }
    }
}

/// Two blocks that face each other at a distance, with the horizon in lattice distances.
fn facing(gap: f64, ratio: f64) -> [Grain; 2] {
    let upper = lattice(9, 3)
        .iter()
        .map(|&at| at + Vec2::new(0.0, 2.0 * H + gap))
        .collect();
    [lattice(9, 3), upper].map(|nodes| grain(nodes, ratio, Weight::Constant))
}

#[test]
fn the_limit_of_contact_is_below_that_of_two_blocks() {
    for gap in [0.2, 0.5, 1.0] {
        let (grains, state) = at_rest(&facing(gap * H, 0.5));
        let mut settings = settings(1e-8);
        settings.contact = Some(contact(0.0, 0.0));
        let limits = Limits::of(&grains, &state.bonds, &settings);
        let largest = vibration(&grains, &settings, &state)
            .self_adjoint_eigenvalues(Side::Lower)
            .unwrap();
        let exact = 2.0 / largest.last().unwrap().sqrt();
        assert!(
            limits.contact <= exact && limits.contact > exact / 3.0,
            "{gap}: {limits:?}"
        );
        assert_eq!(limits.contact, limits.damping);
        assert_eq!(limits.walls, f64::INFINITY);
    }
}

#[test]
fn damped_contact_and_walls_are_stable_below_their_limits() {
    let grains = facing(0.5 * H, 0.5);
    let (all, state) = at_rest(&grains);
    let mut settings = settings(1e-8);
    settings.contact = Some(contact(0.8, 0.0));
    settings.walls = Some(walls(0.8, 0.0));
    let limits = Limits::of(&all, &state.bonds, &settings);
    assert!(limits.damping < 0.8 * limits.contact && limits.walls.is_finite());
    settings.time_step = limits.damping.min(limits.walls);
    let mut world = world(&grains, settings, |state| {
        state.walls = [-0.5 * H, 8.5 * H, 5.2 * H, -0.5 * H];
    });
    let before = energy(&world);
    run(&mut world, 2000);
    assert!(energy(&world) < before, "{} {before}", energy(&world));
}

/// Growth of the energy of two bonded blocks in damped contact, for a step as a fraction of the limit of bonds.
fn damped_growth(damping: f64, fraction: f64) -> f64 {
    let mut grains = facing(1.35 * H, 3.015);
    grains[0].clamped = (0..9).collect();
    grains[1].clamped = (18..27).collect();
    let (all, state) = at_rest(&grains);
    let mut settings = settings(fraction * BondLimits::of(&all, &state.bonds).exact);
    settings.contact = Some(contact(damping, 0.0));
    let mut random = Random(9);
    let mut world = world(&grains, settings, |state| {
        for velocity in &mut state.velocity {
            *velocity = Vec2::new(random.between(-1e-3, 1e-3), random.between(-1e-3, 1e-3));
        }
    });
    let before = energy(&world);
    for _ in 0..3000 {
        if world.step().is_err() {
            return f64::INFINITY;
        }
    }
    energy(&world) / before
}

#[test]
fn damping_of_contacts_lowers_the_limit_of_bonds() {
    // Elastic contact leaves the limit of bonds alone, and the weakest damping does not.
    assert!(damped_growth(0.0, 0.95) < 1.0 && damped_growth(0.05, 0.95) > 1e6);
    let (all, state) = at_rest(&facing(1.35 * H, 3.015));
    for damping in [0.05, 0.8] {
        let mut settings = settings(1e-9);
        settings.contact = Some(contact(damping, 0.0));
        let limits = Limits::of(&all, &state.bonds, &settings);
        let fraction = limits.damping / limits.bonds.exact;
        assert!(fraction < 0.5_f64.sqrt() && limits.contact > limits.bonds.exact);
        let growth = damped_growth(damping, fraction);
        assert!(growth < 1.0, "{damping}: {growth:e}");
    }
}

#[test]
fn steps_above_a_limit_and_small_contact_radii_are_refused() {
    let grains = [grain(lattice(6, 6), 3.015, Weight::Constant)];
    let (all, state) = at_rest(&grains);
    let begin = |factor: f64, name: &str, radius: f64, damping: f64| {
        let mut settings = settings(1e-8);
        let mut contact = contact(damping, 0.0);
        contact.law.radius = radius * H;
        settings.contact = Some(contact);
        settings.walls = (name == "walls").then(|| {
            let mut walls = walls(0.0, 0.0);
            walls.law.stiffness *= 100.0;
            walls
        });
        let named = Limits::of(&all, &state.bonds, &settings).named();
        settings.time_step = factor * named.iter().find(|(own, _)| *own == name).unwrap().1;
        let forced = World::new(
            all.clone(),
            settings.clone(),
            state.clone(),
            Beginning::Forces,
        );
        assert!(forced.is_ok(), "the unchecked beginning takes everything");
        World::within_limits(all.clone(), settings, state.clone(), Beginning::Forces)
    };
    for (name, radius, damping) in [
        ("bonds", 1.21, 0.0),
        ("contact", 2.9, 0.0),
        ("damping", 2.9, 1.0),
        ("walls", 1.21, 0.0),
    ] {
        assert!(begin(0.999, name, radius, damping).is_ok(), "{name}");
        match begin(1.001, name, radius, damping) {
            Err(SetupError::TimeStep { limit, step, value }) => {
                assert!(
                    limit == name || name == "contact" && limit == "damping",
                    "{limit}"
                );
                assert!((step / value - 1.001).abs() < 1e-12);
            }
            other => panic!("{name}: {other:?}"),
        }
    }
    let error = begin(0.5, "bonds", 1.19, 0.0).unwrap_err();
    assert!(matches!(error, SetupError::ContactRadius { .. }), "{error}");
}
