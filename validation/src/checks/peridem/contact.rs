//! Contact of nodes: restitution and friction.

use super::grains::{MATERIAL, bonds_only, grain, world};
use crate::checks::random::Random;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, peridem};
use crate::oracles::quadrature::{limit, root};
use gouge_common::geometry::Vec2;
use gouge_peridem::contact_law::{ContactLaw, ContactReading};
use gouge_peridem::contacts::Contact;
use gouge_peridem::forces::Settings;
use gouge_peridem::material::Weight;

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "peridem.contact.restitution",
            claim: "Two nodes of unequal areas rebound as a damped oscillator with the damping ratio that was asked for, and no friction acts in a head-on impact.",
            equations: peridem("(4.1), (4.5), P2, P15"),
            scene: "60 pairs of free nodes with area ratios up to 10 and damping ratios from 0 to 0.9, until they are a contact radius apart again; four steps, extrapolated to none",
            oracle: "Zero of the displacement of a damped oscillator of the reduced mass: the ratio of speeds is exp(-r_d p / sqrt(1 - r_d^2)) with p = pi",
            norm: "Largest error of the ratio of speeds",
            origin: Origin::Convergent,
            reason: "Errors of first, second and third order are removed; the shortest step is 1/4000 of the period: (2 pi/4000)^4 times a few",
            effort: Effort::Quick,
            measure: restitution,
        },
        Check {
            id: "peridem.contact.reading",
            claim: "As printed, damping and friction give energy to the nodes.",
            equations: peridem("(4.3), (4.5), P2, P3"),
            scene: "Random pairs of nodes in contact, the power of damping and friction with the signs of the source and with the corrected ones",
            oracle: "The second law: neither may be positive",
            norm: "Number of pairs with a positive power as corrected, or without one as printed",
            origin: Origin::Exact,
            reason: "None is tolerated",
            effort: Effort::Quick,
            measure: reading,
        },
    ]
}

const RADIUS: f64 = 1e-4;

fn law(damping_ratio: f64, friction: f64, reading: ContactReading) -> ContactLaw {
    ContactLaw {
        radius: RADIUS,
        damping_ratio,
        friction,
        reading,
    }
}

/// Ratio of the speeds after and before, with a number of steps per period.
fn rebound(areas: [f64; 2], damping_ratio: f64, steps: f64) -> Result<f64, Failure> {
    const STIFFNESS: f64 = 2.8e23;
    const SPEED: f64 = 1.0;
    let masses = areas.map(|area| MATERIAL.density * area);
    let reduced = masses[0] * masses[1] / (masses[0] + masses[1]);
    let frequency = (STIFFNESS * areas[0] * areas[1] / reduced).sqrt();
    let step = std::f64::consts::TAU / frequency / steps;
    let constants = MATERIAL.bond_constants(Weight::Constant, RADIUS)?;
    let node = |x: f64, area: f64| grain(vec![Vec2::new(x, 0.0)], vec![area], constants);
    // They meet exactly at the beginning of a step.
    let grains = [node(0.0, areas[0]), node(RADIUS, areas[1])];
    let settings = Settings {
        contact: Some(Contact {
            law: law(damping_ratio, 0.0, ContactReading::Symmetric),
            stiffness: vec![vec![STIFFNESS]],
            shares_sticking: false,
        }),
        ..bonds_only(step)
    };
    let speeds = masses.map(|mass| SPEED * reduced / mass);
    let moving = |grain: usize, _| Vec2::new(if grain == 0 { speeds[0] } else { -speeds[1] }, 0.0);
    let mut world = world(&grains, settings, moving)?;
    let state = |world: &gouge_peridem::world::World| {
        let state = world.state();
        let apart = state.places[0].to(state.places[1]).x - RADIUS;
        [apart, state.velocity[1].x - state.velocity[0].x]
    };
    let mut before = [state(&world); LAST];
    for _ in 0..(2.0 * steps) as usize {
        world.step()?;
        let after = state(&world);
        if after[0] >= 0.0 && after[1] > 0.0 {
            return Ok(at_zero(&before) / SPEED);
        }
        before.rotate_left(1);
        before[LAST - 1] = after;
    }
    Err(Failure::Oracle("the nodes do not part".to_owned()))
}

/// Number of the last states in contact through which polynomials are laid.
const LAST: usize = 6;

/// Velocity at the zero of the position in the step after some states of position and velocity in contact. The state after
/// the contact has no damping in half of its step.
fn at_zero(states: &[[f64; 2]; LAST]) -> f64 {
    let at = |place: f64, part: usize| {
        let term = |k: usize| {
            let others = (0..LAST).filter(|&n| n != k);
            let factor = |n: usize| (place - n as f64) / (k as f64 - n as f64);
            states[k][part] * others.map(factor).product::<f64>()
        };
        (0..LAST).map(term).sum::<f64>()
    };
    let last = (LAST - 1) as f64;
    at(root(last, last + 1.0, |place| at(place, 0)), 1)
}

fn restitution() -> Outcome {
    let mut random = Random::new(291);
    let mut all = Vec::new();
    for _ in 0..60 {
        let areas = [0; 2].map(|_| random.magnitude(1e-9, 1e-8));
        let ratio = random.between(0.0, 0.9);
        let mut results = Vec::new();
        for steps in [500.0, 1000.0, 2000.0, 4000.0] {
            results.push([rebound(areas, ratio, steps)?]);
        }
        let [found] = limit(&results, &[1.0, 2.0, 3.0]);
        let expected = (-std::f64::consts::PI * ratio / (1.0 - ratio * ratio).sqrt()).exp();
        all.push(Measurement::absolute(expected, found, 1e-8));
    }
    Ok(Measurement::worst(all).into())
}

fn reading() -> Outcome {
    use gouge_peridem::contact_law::{FrictionStep, Node, NodePair};
    let mut random = Random::new(292);
    let mut wrong = 0;
    for _ in 0..1000 {
        let angle = random.between(-3.0, 3.0);
        let distance = random.between(0.1, 0.9) * RADIUS;
        let mut node = || Node {
            area: random.magnitude(1e-9, 1e-8),
            density: 1200.0,
        };
        let (x, y) = (node(), node());
        let mut part = || random.signed(0.1, 10.0);
        let pair = NodePair {
            separation: Vec2::new(angle.cos(), angle.sin()) * distance,
            velocity: Vec2::new(part(), part()),
            x,
            y,
        };
        let step = FrictionStep {
            time_step: 1e-9,
            stick_share: 1.0,
        };
        for (reading, is_printed) in [
            (ContactReading::Symmetric, false),
            (ContactReading::OneSided, false),
            (ContactReading::Printed, true),
        ] {
            let law = law(0.5, 0.5, reading);
            let force = law.force(&pair, &law.between_grains(2.8e23), &step);
            let powers = [force.damping, force.friction].map(|f| f.dot(pair.velocity));
            let drives = powers.iter().all(|&power| power > 0.0);
            let brakes = powers.iter().all(|&power| power <= 0.0);
            wrong += usize::from(if is_printed { !drives } else { !brakes });
        }
    }
    Ok(Measurement::count(wrong).into())
}
