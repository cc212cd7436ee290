//! Geometric identities that hold for every pair up to rounding.

mod distances;
mod frames;
mod links;

use crate::checks::random::Random;
use crate::checks::{Check, Effort, Evidence, Measurement, Origin, Outcome, Topic};
use gouge_common::geometry::Vec2;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "identities",
        title: "Identities of geometry",
        about: "Overlap factor, focal point, frames, periodic images and moments: identities that hold for every pair up to rounding.",
        checks: [distances::checks(), frames::checks(), links::checks()]
            .into_iter()
            .flatten()
            .collect(),
    }
}

/// Number of random pairs per identity.
const PAIRS: usize = 100_000;

/// Two spheres with radii over four decades, from far apart through touch to nearly coincident.
struct Spheres {
    radii: [f64; 2],
    distance: f64,
}

impl Spheres {
    fn random(random: &mut Random) -> Self {
        let radii = [random.magnitude(1e-5, 1e-1), random.magnitude(1e-5, 1e-1)];
        let reach = radii[0] + radii[1];
        let distance = match random.below(4) {
            0 => reach * random.magnitude(1e-3, 1e3),
            1 => reach * (1.0 + random.signed(1e-15, 1e-2)),
            2 => (radii[0] - radii[1]).abs() * (1.0 + random.signed(1e-12, 0.5)) + 1e-6 * reach,
            _ => random.between((radii[0] - radii[1]).abs(), reach),
        };
        Self { radii, distance }
    }
    /// Spheres whose surfaces intersect.
    fn crossing(random: &mut Random) -> Self {
        loop {
            let one = Self::random(random);
            let [a, b] = one.radii;
            if one.distance < (a + b) && one.distance > (a - b).abs() {
                return one;
            }
        }
    }
}

/// A vector of any direction, with a magnitude over ten decades.
fn vector(random: &mut Random) -> Vec2 {
    let (length, angle) = (
        random.magnitude(1e-6, 1e4),
        random.between(0.0, std::f64::consts::TAU),
    );
    Vec2::new(length * libm::cos(angle), length * libm::sin(angle))
}

/// The largest error over random inputs, in units of rounding; undefined if an identity fails outright.
fn worst(seed: u64, tolerance: f64, error: impl Fn(&mut Random) -> f64) -> Outcome {
    let mut random = Random::new(seed);
    let unit = f64::EPSILON;
    let measured =
        (0..PAIRS).map(|_| Measurement::scaled(0.0, error(&mut random) * unit, unit, tolerance));
    Ok(Measurement::worst(measured).into())
}

/// A quick check of this topic whose tolerance is rounding alone.
fn identity(
    id: &'static str,
    claim: &'static str,
    equations: Evidence,
    measure: fn() -> Outcome,
) -> Check {
    Check {
        id,
        claim,
        equations,
        scene: "100 000 random pairs with radii over four decades: nearly coincident, one containing the other, touching and far apart",
        oracle: "The identity itself, evaluated in double-double where double precision would round",
        norm: "Largest error in the unit of rounding given under the tolerance",
        origin: Origin::Exact,
        reason: "",
        effort: Effort::Quick,
        measure,
    }
}
