//! Contact of two nodes.

use crate::quadrature::{Random, derivative};
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::Elongation;
use gouge_peridem::contact_law::{
    ContactForce, ContactLaw, ContactMaterial, ContactReading, ContactSpring, ContactStiffness,
    FrictionStep, Motion, Node, NodePair, largest_step,
};
use gouge_peridem::material::{BondConstants, Material, Plane, Weight};
use std::f64::consts::PI;

const STEP: FrictionStep = FrictionStep {
    time_step: 7e-8,
    stick_share: 1.0,
};

fn law(reading: ContactReading) -> ContactLaw {
    ContactLaw {
        radius: 1e-4,
        damping_ratio: 0.8,
        friction: 0.8,
        reading,
    }
}

fn spring() -> ContactSpring {
    law(ContactReading::Symmetric).between_grains(2.8e23)
}

fn random_pair(random: &mut Random) -> NodePair {
    let angle = random.between(0.0, 2.0 * PI);
    let mut node = || Node {
        area: random.between(1e-9, 5e-9),
        density: random.between(800.0, 9000.0),
    };
    let (x, y) = (node(), node());
    let distance = random.between(0.0, 1.1e-4);
    let speed = 10.0_f64.powf(random.between(-6.0, 2.0));
    NodePair {
        separation: Vec2::new(distance * angle.cos(), distance * angle.sin()),
        velocity: Vec2::new(random.between(-speed, speed), random.between(-speed, speed)),
        x,
        y,
    }
}

fn exchanged(pair: &NodePair) -> NodePair {
    NodePair {
        separation: -pair.separation,
        velocity: -pair.velocity,
        x: pair.y,
        y: pair.x,
    }
}

#[test]
fn symmetric_forces_are_opposite_to_the_last_bit() {
    let (law, spring) = (law(ContactReading::Symmetric), spring());
    let mut random = Random(2);
    for _ in 0..300_000 {
        let pair = random_pair(&mut random);
        let here = law.force(&pair, &spring, &STEP);
        let there = law.force(&exchanged(&pair), &spring, &STEP);
        assert_eq!(here.total(), -there.total());
        assert_eq!(here.motion, there.motion);
    }
}

#[test]
fn one_sided_forces_are_not_opposite() {
    let mut random = Random(3);
    let law = law(ContactReading::OneSided);
    let mut pair = random_pair(&mut random);
    pair.separation = Vec2::new(5e-5, 0.0);
    let here = law.force(&pair, &spring(), &STEP);
    let there = law.force(&exchanged(&pair), &spring(), &STEP);
    assert_eq!(here.repulsion, -there.repulsion);
    let ratio = -here.damping.x / there.damping.x;
    assert!((ratio * ratio - pair.x.mass() / pair.y.mass()).abs() < 1e-13);
}

#[test]
fn a_million_states_have_finite_forces() {
    let mut random = Random(4);
    let readings = [
        ContactReading::Symmetric,
        ContactReading::OneSided,
        ContactReading::Authors,
    ];
    for k in 0..1_000_000 {
        let law = law(readings[k % 3]);
        let mut pair = random_pair(&mut random);
        if k % 7 == 0 {
            pair.separation = pair.separation * 10.0_f64.powf(random.between(-320.0, 0.0));
        }
        if k % 11 == 0 {
            pair.velocity = Vec2::zero();
        }
        let spring = law.within_grain(2.8e19, random.between(1e-6, 3e-4));
        let force = law.force(&pair, &spring, &STEP);
        assert!(force.total().is_finite(), "{pair:?}");
    }
}

#[test]
fn coincident_nodes_and_distant_nodes_exert_no_force() {
    let law = law(ContactReading::Symmetric);
    let mut pair = random_pair(&mut Random(5));
    for separation in [Vec2::zero(), Vec2::new(1e-4, 0.0), Vec2::new(0.0, -2e-4)] {
        pair.separation = separation;
        assert_eq!(law.force(&pair, &spring(), &STEP), ContactForce::default());
    }
}

#[test]
fn repulsion_is_minus_the_gradient_of_the_energy_and_starts_at_zero() {
    let (law, spring) = (law(ContactReading::Symmetric), spring());
    let mut pair = random_pair(&mut Random(6));
    let energy = |d: f64| spring.energy(d, pair.x.area, pair.y.area);
    for distance in [1e-5, 4e-5, 9e-5] {
        pair.separation = Vec2::new(distance, 0.0);
        let push = -law.force(&pair, &spring, &STEP).repulsion.x;
        let slope = derivative(distance, 1e-6, energy);
        assert!((push / -slope - 1.0).abs() < 1e-10);
    }
    pair.separation = Vec2::new(1e-4 * (1.0 - 1e-12), 0.0);
    let force = law.force(&pair, &spring, &STEP);
    assert!(force.repulsion.norm() < 1e-8 && force.friction.norm() < 1e-8);
    assert_eq!(energy(1e-4), 0.0);
}

/// Speed at which two nodes that approach at one leave the contact, by the midpoint rule with a tiny step.
fn rebound(law: &ContactLaw) -> f64 {
    let (x, y) = (
        Node {
            area: 4e-9,
            density: 1200.0,
        },
        Node {
            area: 3e-9,
            density: 700.0,
        },
    );
    let reduced = x.mass() * y.mass() / (x.mass() + y.mass());
    let spring = law.between_grains(2.8e23);
    let acceleration = |d: f64, v: f64| {
        // v is the rate of the distance; the velocity of x relative to y is its opposite along the separation.
        let pair = NodePair {
            separation: Vec2::new(d, 0.0),
            velocity: Vec2::new(-v, 0.0),
            x,
            y,
        };
        -law.force(&pair, &spring, &STEP).total().x / reduced
    };
    let step = 2e-11;
    let (mut d, mut v) = (law.radius * (1.0 - 1e-14), -1.0);
    while d < law.radius {
        let (dm, vm) = (d + 0.5 * step * v, v + 0.5 * step * acceleration(d, v));
        (d, v) = (d + step * vm, v + step * acceleration(dm, vm));
    }
    v
}

#[test]
fn a_damped_collision_rebounds_as_an_oscillator() {
    for damping_ratio in [0.0, 0.1, 0.3, 0.8_f64] {
        let law = ContactLaw {
            damping_ratio,
            ..law(ContactReading::Symmetric)
        };
        let exact = (-PI * damping_ratio / (1.0 - damping_ratio.powi(2)).sqrt()).exp();
        let measured = rebound(&law);
        assert!(
            (measured - exact).abs() < 1e-4,
            "{damping_ratio}: {measured} {exact}"
        );
    }
}

#[test]
fn friction_stops_two_free_nodes_in_one_step() {
    let law = law(ContactReading::Symmetric);
    let mut pair = random_pair(&mut Random(7));
    pair.separation = Vec2::new(5e-5, 0.0);
    pair.velocity = Vec2::new(0.0, 1e-3);
    let force = law.force(&pair, &spring(), &STEP);
    assert_eq!(force.motion, Motion::Stick);
    let gain = force.friction.y * STEP.time_step * (1.0 / pair.x.mass() + 1.0 / pair.y.mass());
    assert!((gain / -1e-3 - 1.0).abs() < 1e-14);
    let shared = FrictionStep {
        stick_share: 4.0,
        ..STEP
    };
    let quarter = law.force(&pair, &spring(), &shared).friction;
    assert_eq!(quarter * 4.0, force.friction);
}

#[test]
fn friction_never_accelerates_and_obeys_the_limit_of_coulomb() {
    let law = law(ContactReading::Symmetric);
    let mut random = Random(8);
    let mut seen = [0; 3];
    for _ in 0..20_000 {
        let pair = random_pair(&mut random);
        let force = law.force(&pair, &spring(), &STEP);
        let direction = pair.separation * (1.0 / pair.separation.norm());
        let tangential = pair.velocity - direction * pair.velocity.dot(direction);
        let inverse = 1.0 / pair.x.mass() + 1.0 / pair.y.mass();
        let after = tangential + force.friction * (STEP.time_step * inverse);
        assert!(after.dot(tangential) >= -1e-12 * tangential.norm_squared());
        assert!(after.norm() <= tangential.norm() * (1.0 + 1e-12));
        let limit = law.friction * force.repulsion.norm();
        assert!(force.friction.norm() <= limit * (1.0 + 1e-12));
        assert!(force.damping.dot(pair.velocity) <= 0.0);
        if force.motion == Motion::Slip {
            assert!((force.friction.norm() / limit - 1.0).abs() < 1e-12);
        }
        seen[force.motion as usize] += 1;
    }
    assert!(seen.iter().all(|&count| count > 500), "{seen:?}");
}

#[test]
fn the_authors_sticking_force_is_negligible() {
    let mut pair = random_pair(&mut Random(9));
    pair.separation = Vec2::new(5e-5, 0.0);
    pair.velocity = Vec2::new(0.0, 1e-4);
    let [printed, authors] = [ContactReading::OneSided, ContactReading::Authors]
        .map(|reading| law(reading).force(&pair, &spring(), &STEP).friction.y);
    let ratio = authors / printed * pair.x.density.powi(2);
    assert!((ratio - 1.0).abs() < 1e-13);
}

#[test]
fn self_contact_is_a_bond_that_only_repels() {
    let law = law(ContactReading::Symmetric);
    let bonds = BondConstants {
        weight: Weight::Constant,
        horizon: 5e-4,
        stiffness: 2.8e19,
        critical_stretch: 0.01,
    };
    let mut pair = random_pair(&mut Random(10));
    let areas = pair.x.area * pair.y.area;
    let reference = Vec2::new(6e-5, 3e-5);
    let near = law.within_grain(bonds.stiffness, reference.norm());
    for scale in [0.2, 0.9, 1.1] {
        pair.separation = reference * scale;
        let bond = Elongation::new(reference, reference * (scale - 1.0), reference.norm());
        let expected = if scale < 1.0 {
            bond.pull(bonds.weight, bonds.horizon) * (bonds.stiffness * areas)
        } else {
            Vec2::zero()
        };
        let force = law.force(&pair, &near, &STEP).repulsion;
        assert!((force - expected).norm() <= 1e-12 * expected.norm());
    }
    let far = law.within_grain(bonds.stiffness, 3e-4);
    assert_eq!(far, law.between_grains(bonds.stiffness / law.radius));
}

fn contact_material(scale: f64) -> ContactMaterial {
    ContactMaterial {
        material: Material {
            young_modulus: 1.23e9,
            poisson_ratio: 1.0 / 3.0,
            fracture_energy: 135.0,
            density: 1200.0,
            plane: Plane::Stress,
        },
        bulk_modulus: 2e9,
        horizon: 5e-4 * scale,
    }
}

#[test]
fn only_the_printed_stiffness_breaks_similarity() {
    // With lengths twice as large, stresses at equal strain are equal, and forces per metre of depth double.
    let growth = |stiffness: ContactStiffness| {
        let force = |scale: f64| {
            let material = contact_material(scale);
            let k = stiffness
                .between(&material, &material, 1e-4 * scale)
                .unwrap();
            k * (1e-5 * scale) * (4e-9 * scale * scale).powi(2)
        };
        force(2.0) / force(1.0)
    };
    assert!((growth(ContactStiffness::FromBonds) - 2.0).abs() < 1e-13);
    assert!((growth(ContactStiffness::Published) - 2.0).abs() < 1e-13);
    assert!((growth(ContactStiffness::Printed) - 1.0).abs() < 1e-13);
}

#[test]
fn stiffness_of_two_materials_is_a_harmonic_mean() {
    let soft = contact_material(1.0);
    let mut stiff = soft;
    stiff.bulk_modulus *= 3.0;
    stiff.material.young_modulus *= 3.0;
    for rule in [ContactStiffness::FromBonds, ContactStiffness::Published] {
        let of = |a, b| rule.between(a, b, 1e-4).unwrap();
        assert!((of(&soft, &stiff) / of(&soft, &soft) - 1.5).abs() < 1e-14);
        assert_eq!(of(&soft, &stiff), of(&stiff, &soft));
    }
    assert!(
        ContactStiffness::Given(0.0)
            .between(&soft, &soft, 1e-4)
            .is_err()
    );
    assert!(
        ContactStiffness::FromBonds
            .between(&soft, &soft, -1.0)
            .is_err()
    );
}

/// Whether an oscillator under velocity Verlet, damped by its previous velocity, stays bounded.
fn is_stable(frequency_squared: f64, damping_rate: f64, step: f64) -> bool {
    let (mut u, mut v, mut a) = (1.0, 0.0, -frequency_squared);
    for _ in 0..20_000 {
        u += step * v + 0.5 * step * step * a;
        let next = -frequency_squared * u - damping_rate * v;
        v += 0.5 * step * (a + next);
        a = next;
    }
    u.abs() < 10.0
}

#[test]
fn the_largest_step_is_sharp() {
    for (frequency_squared, damping_rate) in [(1.0, 0.0), (1.0, 0.1), (1.0, 1.6), (0.01, 3.0)] {
        let limit = largest_step(frequency_squared, damping_rate);
        assert!(is_stable(frequency_squared, damping_rate, 0.99 * limit));
        assert!(!is_stable(frequency_squared, damping_rate, 1.01 * limit));
    }
    assert_eq!(largest_step(0.0, 0.0), f64::INFINITY);
}

#[test]
fn printed_signs_turn_damping_and_friction_around() {
    let mut random = Random(12);
    for _ in 0..100 {
        let pair = random_pair(&mut random);
        let [one, printed] = [ContactReading::OneSided, ContactReading::Printed]
            .map(|reading| law(reading).force(&pair, &spring(), &STEP));
        assert_eq!(printed.repulsion, one.repulsion);
        assert_eq!(printed.friction, -one.friction);
        let sum = printed.damping * pair.velocity.norm() + one.damping;
        assert!(sum.norm() <= 1e-14 * one.damping.norm());
        assert_eq!(printed.motion, one.motion);
    }
}

#[test]
fn nodes_stick_up_to_the_limit_of_friction() {
    let law = law(ContactReading::Symmetric);
    let mut pair = random_pair(&mut Random(13));
    pair.separation = Vec2::new(5e-5, 0.0);
    let reduced = 1.0 / (1.0 / pair.x.mass() + 1.0 / pair.y.mass());
    for (factor, motion) in [(1.0 - 1e-7, Motion::Stick), (1.0 + 1e-7, Motion::Slip)] {
        let limit = 0.8 * law.force(&pair, &spring(), &STEP).repulsion.norm();
        pair.velocity = Vec2::new(0.0, factor * limit * STEP.time_step / reduced);
        let force = law.force(&pair, &spring(), &STEP);
        assert_eq!(force.motion, motion, "{factor}");
        assert!((force.friction.norm() / limit - 1.0).abs() < 2e-7);
    }
}

#[test]
fn printed_and_published_stiffness_are_as_by_hand() {
    // The harmonic mean of pi and 3 pi is 1.5 pi.
    let mut sides = [contact_material(1.0), contact_material(1.0)];
    sides[0].bulk_modulus = PI;
    sides[1].bulk_modulus = 3.0 * PI;
    for (horizons, published, printed) in [
        ([0.5, 1.5], 27.0, 27.0),
        ([1.5, 2.5], 27.0 / 16.0, 27.0 / 32.0),
    ] {
        sides[0].horizon = horizons[0];
        sides[1].horizon = horizons[1];
        for (rule, expected) in [
            (ContactStiffness::Published, published),
            (ContactStiffness::Printed, printed),
        ] {
            let found = rule.between(&sides[0], &sides[1], 1e-4).unwrap();
            assert!((found / expected - 1.0).abs() < 1e-14, "{rule:?} {found}");
        }
    }
}

/// One step of the oscillator as a matrix, whose columns are what becomes of unit vectors of displacement, velocity and
/// acceleration.
fn step_matrix(frequency_squared: f64, damping_rate: f64, step: f64) -> [[f64; 3]; 3] {
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|[u, v, a]| {
        let u = u + step * v + 0.5 * step * step * a;
        let next = -frequency_squared * u - damping_rate * v;
        [u, v + 0.5 * step * (a + next), next]
    })
}

/// Determinant of a matrix minus a number times the identity.
fn characteristic(mut matrix: [[f64; 3]; 3], value: f64) -> f64 {
    for (k, column) in matrix.iter_mut().enumerate() {
        column[k] -= value;
    }
    let [a, b, c] = matrix;
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

#[test]
fn an_eigenvalue_of_the_largest_step_has_magnitude_one() {
    // Without damping it is -1. With damping two conjugate ones have magnitude 1 if the third is the product of all.
    for (frequency_squared, damping_rate) in
        [(1.0, 0.0), (3.0, 0.0), (1.0, 0.1), (2.0, 1.6), (0.01, 3.0)]
    {
        let limit = largest_step(frequency_squared, damping_rate);
        let [below, above] = [1.0 - 1e-7, 1.0 + 1e-7].map(|factor| {
            let matrix = step_matrix(frequency_squared, damping_rate, factor * limit);
            let value = if damping_rate > 0.0 {
                characteristic(matrix, 0.0)
            } else {
                -1.0
            };
            characteristic(matrix, value)
        });
        assert!(below * above < 0.0, "{frequency_squared} {damping_rate}");
    }
}

#[test]
fn invalid_coefficients_are_refused() {
    let good = law(ContactReading::Symmetric);
    assert!(good.validate().is_ok());
    for bad in [
        ContactLaw {
            radius: 0.0,
            ..good
        },
        ContactLaw {
            damping_ratio: 1.1,
            ..good
        },
        ContactLaw {
            friction: -0.1,
            ..good
        },
    ] {
        assert!(bad.validate().is_err());
    }
}
