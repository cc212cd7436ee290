//! Pairs rebound with the restitution that a scene asks for, whatever their sizes, densities and roles.

use crate::worlds::{INTEGRATORS, advance, sheared_with, world};
use gouge_common::instructions::Instructions;
use gouge_dem::World;
use gouge_dem::calibration::{damping_ratio_for, dissipation_for, viscoelastic_restitution};
use gouge_dem::laws::{Controller, KelvinVoigt};
use gouge_dem::model::Model;
use gouge_runner::scene::DrivingTable;
use gouge_runner::stability::bounds;
use gouge_validation::oracles::head_on::{spring, viscoelastic};
use gouge_validation::oracles::oscillator::truncated_restitution;
use gouge_validation::scenes::{Draft, Grain};
use std::f64::consts::PI;

const STIFFNESS: f64 = 1e7;
const MODULUS: f64 = 50e9;
const POISSON: f64 = 0.22;
/// Methods of second order.
const SECOND_ORDER: [&str; 2] = ["velocity-verlet", "beeman"];

#[test]
fn the_inverse_of_the_restitution_is_one_for_every_restitution() {
    for wanted in [1e-3, 0.05, 0.3, 0.9, 0.9999, 1.0 - 1e-12] {
        let closed: f64 = truncated_restitution(damping_ratio_for(wanted));
        assert!((closed / wanted - 1.0).abs() < 1e-11, "{wanted} {closed}");
    }
    // An overdamped pair creeps: 1 / (4 zeta^2), up to terms of order log(zeta) / zeta^2.
    for wanted in [1e-300, 1e-30, 1e-13] {
        let ratio = damping_ratio_for(wanted);
        assert!(
            (4.0 * ratio * wanted * ratio - 1.0).abs() < 1e-10,
            "{wanted} {ratio}"
        );
    }
    for wanted in [1e-4, 1e-3, 0.01, 0.05, 0.2, 0.5, 0.9, 0.999] {
        let ratio = damping_ratio_for(wanted);
        let integrated = spring(ratio, 1e-14).restitution;
        assert!(
            (integrated / wanted - 1.0).abs() < 1e-8,
            "{wanted} {integrated}"
        );
        let integrated = viscoelastic(dissipation_for(wanted), 1e-14).restitution;
        assert!(
            (integrated / wanted - 1.0).abs() < 1e-8,
            "{wanted} {integrated}"
        );
    }
    assert_eq!([damping_ratio_for(1.0), dissipation_for(1.0)], [0.0; 2]);
    // Of very strong damping, e b^(5/3) is constant: the equation in units of b^(-1/3) no longer contains b.
    let scaled = |b: f64| viscoelastic_restitution(b) * b.powf(5.0 / 3.0);
    assert!((scaled(1e9) / scaled(1e12) - 1.0).abs() < 1e-4);
    assert!(dissipation_for(1e-100) > 1e50);
}

/// Two grains that touch and approach head on.
struct Pair {
    radii: [f64; 2],
    densities: [f64; 2],
    second: fn(Grain) -> Grain,
}

impl Pair {
    fn masses(&self) -> [f64; 2] {
        [0, 1].map(|k| 4.0 / 3.0 * PI * self.densities[k] * self.radii[k].powi(3))
    }

    /// The reduced mass in kg: of a grain against a fixed one, its own mass.
    fn reduced_mass(&self) -> f64 {
        let [a, b] = self.masses();
        match (self.second)(Grain::at([0.0; 2], 1.0)) == Grain::at([0.0; 2], 1.0).fixed() {
            true => a,
            false => a * b / (a + b),
        }
    }

    /// Speed after over speed before the collision, for steps in s.
    fn rebound(&self, law: &Draft, method: &str, step: f64, speed: f64) -> f64 {
        let [r, s] = self.radii;
        let start = s - (r + s) * 4.0 * f64::EPSILON;
        let grain =
            |x: f64, k: usize| Grain::at([x, 0.0], self.radii[k]).of_density(self.densities[k]);
        let draft = Draft::open_box(method, step)
            .and(law)
            .with("output.energy", false)
            .grain(grain(-r, 0).moving([speed, 0.0]))
            .grain((self.second)(grain(start, 1)));
        let mut world = world(&draft);
        for _ in 0..1_000_000 {
            advance(&mut world, 1);
            let velocity = &world.particles().velocity;
            let opening = velocity[1].x - velocity[0].x;
            if opening > 0.0 && world.forces().force[0].x == 0.0 {
                return opening / speed;
            }
        }
        panic!("the collision does not end");
    }
}

/// Size ratios from 1 to 100, density ratios, fixed and driven grains.
fn pairs() -> Vec<Pair> {
    let pair = |ratio: f64, densities: [f64; 2], second: fn(Grain) -> Grain| Pair {
        radii: [1e-3, 1e-3 * ratio],
        densities,
        second,
    };
    vec![
        pair(1.0, [2700.0; 2], |one| one),
        pair(3.0, [2700.0; 2], |one| one),
        pair(100.0, [2700.0; 2], |one| one),
        pair(1.0, [2700.0, 27.0], |one| one),
        pair(5.0, [7800.0, 900.0], |one| one),
        pair(1.0, [2700.0; 2], Grain::fixed),
        pair(0.2, [2700.0, 900.0], Grain::fixed),
    ]
}

const RESTITUTIONS: [f64; 5] = [0.05, 0.3, 0.6, 0.9, 1.0];

#[test]
fn kelvin_voigt_pairs_of_all_sizes_rebound_as_asked() {
    for (pair, wanted) in pairs()
        .iter()
        .flat_map(|pair| RESTITUTIONS.map(|e| (pair, e)))
    {
        let law = kelvin_voigt(wanted);
        let frequency = (STIFFNESS / pair.reduced_mass()).sqrt();
        // The fastest rate of the pair: its frequency, or its damping rate.
        let rate = frequency * (1.0 + 2.0 * damping_ratio_for(wanted));
        for (method, fraction) in SECOND_ORDER
            .into_iter()
            .flat_map(|m| [(m, 0.04), (m, 0.02)])
        {
            let speed = 0.01 * pair.radii[0] * frequency;
            let found = pair.rebound(&law, method, fraction / rate, speed);
            // Of second order in steps of the fastest rate.
            let tolerance = fraction * fraction;
            assert!(
                (found / wanted - 1.0).abs() < tolerance,
                "{method} {:?} {wanted}: {found}",
                pair.radii
            );
        }
    }
}

fn kelvin_voigt(restitution: f64) -> Draft {
    Draft::empty()
        .with("contact.normal.law", "kelvin-voigt")
        .with("contact.normal.stiffness", STIFFNESS)
        .with("contact.normal.restitution", restitution)
}

fn bshp(restitution: f64, speed: f64) -> Draft {
    Draft::empty()
        .with("contact.normal.law", "bshp")
        .with("contact.normal.youngs_modulus", MODULUS)
        .with("contact.normal.poissons_ratio", POISSON)
        .with("contact.normal.restitution", restitution)
        .with("contact.normal.restitution_speed", speed)
}

/// Hertz's unit of time in s of a pair at a relative speed in m/s: the length (m v^2 / P)^(2/5) over the speed.
fn hertzian_time(pair: &Pair, speed: f64) -> f64 {
    let [r, s] = pair.radii;
    let prefactor =
        4.0 / 3.0 * (MODULUS / (2.0 * (1.0 - POISSON * POISSON))) * (r * s / (r + s)).sqrt();
    (pair.reduced_mass() * speed * speed / prefactor).powf(0.4) / speed
}

#[test]
fn viscoelastic_pairs_of_all_sizes_rebound_as_asked_at_the_speed_asked_for() {
    let asked = 0.3;
    for (pair, wanted) in pairs()
        .iter()
        .flat_map(|pair| RESTITUTIONS.map(|e| (pair, e)))
    {
        let law = bshp(wanted, asked);
        let dissipation = dissipation_for(wanted);
        for speed in [asked, 0.1 * asked] {
            let time = hertzian_time(pair, speed);
            let b = dissipation * (speed / asked).powf(0.2);
            let expected = match b > 0.0 {
                true if speed == asked => wanted,
                true => viscoelastic(b, 1e-12).restitution,
                false => 1.0,
            };
            for (method, fraction) in SECOND_ORDER
                .into_iter()
                .flat_map(|m| [(m, 0.02), (m, 0.01)])
            {
                let found = pair.rebound(&law, method, fraction * time / (1.0 + b), speed);
                // The force begins like the square root of time, which costs 0.21 b steps to the power 3/2; the
                // rest is of second order in steps of the fastest rate.
                let tolerance = fraction.powf(1.5);
                assert!(
                    (found / expected - 1.0).abs() < tolerance,
                    "{method} {:?} {wanted} at {speed}: {found} instead of {expected}",
                    pair.radii
                );
            }
        }
    }
}

#[test]
fn a_driven_grain_rebounds_with_its_own_mass() {
    let driving = DrivingTable {
        controller: Controller::RateLimited { force_rate: 0.0 },
        speed: 0.0,
        pressure: 0.0,
        area: Some(1.0),
        initial_force: [0.0; 2],
    };
    let pair = Pair {
        radii: [1e-3, 2e-3],
        densities: [2700.0; 2],
        second: Grain::driven,
    };
    let frequency = (STIFFNESS / pair.reduced_mass()).sqrt();
    let law = kelvin_voigt(0.5).driving(driving);
    let found = pair.rebound(&law, "velocity-verlet", 0.01 / frequency, 1e-3);
    assert!((found / 0.5 - 1.0).abs() < 1e-3, "{found}");
}

/// Grains of one size that collide, spin and fall apart again.
fn equal_grains(law: &Draft, method: &str) -> Draft {
    let grain = |i: u32| {
        let x = f64::from(i);
        Grain::at([1.9e-3 * x, 0.2e-3 * x * x], 1e-3)
            .moving([2.0 - x, 0.3 * x])
            .spinning(100.0 * x)
    };
    Draft::open_box(method, 1e-8)
        .and(law)
        .friction("cundall-strack-truncated", 0.5, 1e7)
        .grains((0..5).map(grain))
}

/// The same scene with the damping that gives equal grains a restitution.
fn with_damping(restitution: f64) -> Draft {
    let mass = 4.0 / 3.0 * PI * 2700.0 * 1e-9;
    Draft::empty().law(KelvinVoigt {
        stiffness: STIFFNESS,
        damping: 2.0 * damping_ratio_for(restitution) * (0.5 * mass * STIFFNESS).sqrt(),
    })
}

#[test]
fn equal_grains_move_as_with_the_damping_of_their_pairs() {
    for method in INTEGRATORS {
        let mut worlds =
            [kelvin_voigt(0.4), with_damping(0.4)].map(|law| world(&equal_grains(&law, method)));
        worlds.iter_mut().for_each(|one| advance(one, 600));
        let [scaled, given] = &worlds;
        for (a, b) in scaled
            .particles()
            .velocity
            .iter()
            .zip(&given.particles().velocity)
        {
            // Rounding of the damping, 1e-16, grows in collisions by far less than a millionfold.
            assert!((*a - *b).norm() < 1e-10, "{method} {a:?} {b:?}");
        }
        let energies = worlds.map(|one| one.energy().values());
        let close = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-10 * energies[1][0].abs().max(1e-6);
        assert!(
            energies[0].iter().zip(&energies[1]).all(close),
            "{method} {energies:?}"
        );
    }
}

#[test]
fn the_bounds_of_the_step_know_the_damping_of_the_pair() {
    for restitution in [0.05, 0.7] {
        let steps = [kelvin_voigt(restitution), with_damping(restitution)].map(|law| {
            let world = world(&equal_grains(&law, "velocity-verlet"));
            let bounds = bounds(&world, 2700.0);
            bounds
                .iter()
                .map(|bound| (bound.name, bound.step))
                .collect::<Vec<_>>()
        });
        assert!(steps[0].len() >= 3);
        for (a, b) in steps[0].iter().zip(&steps[1]) {
            assert!(a.0 == b.0 && (a.1 / b.1 - 1.0).abs() < 1e-9, "{a:?} {b:?}");
        }
    }
}

/// A fault, whose bonds break and become contacts, in a periodic box, with corrected densities.
fn fault(law: &Draft) -> World {
    sheared_with(|fault| fault.without("contact.normal").and(law))
}

#[test]
fn a_fault_with_a_restitution_has_the_same_bits_however_it_is_computed() {
    for law in [kelvin_voigt(0.3), bshp(0.3, 1.0)] {
        let world = fault(&law);
        let model = Model {
            ledger: false,
            ..*world.model()
        };
        let world = world
            .continue_with(model, None)
            .expect("nothing else changes");
        let continued = |instructions: Instructions, threads: usize| {
            let copy = World::from_words(model, &world.to_words()).expect("just recorded");
            let mut copy = copy.with_instructions(instructions).with_threads(threads);
            advance(&mut copy, 1500);
            copy.to_words()
        };
        let plain = continued(Instructions::portable(), 1);
        let mut uninterrupted = world.clone();
        advance(&mut uninterrupted, 1500);
        assert!(uninterrupted.to_words() == plain);
        for threads in [1, 3] {
            assert!(
                continued(Instructions::widest(), threads) == plain,
                "{threads}"
            );
        }
    }
}

#[test]
fn the_energy_balance_of_a_fault_with_a_restitution_closes() {
    for law in [kelvin_voigt(0.3), bshp(0.3, 1.0)] {
        let mut world = fault(&law);
        let bonds = |world: &World| world.bonds().map_or(0, |bonds| bonds.len());
        let before = bonds(&world);
        advance(&mut world, 12_000);
        let energy = world.energy();
        assert!(bonds(&world) < before && world.number_of_contacts() > 0);
        assert!(energy.friction > 0.0);
        assert!(energy.residual.abs() < 0.01 * energy.friction, "{energy:?}");
    }
}
