//! Bonds between nearest neighbours, thesis sections 3.5.2 and 3.7.5.

use crate::particles::Particles;
use gouge_common::geometry::Domain;
use gouge_common::geometry::{Metric, Open, PeriodicX, Vec2};
use gouge_common::neighbors::Neighbors;
use gouge_common::pair::Pair;

/// Reach of bonds in sums of radii that the thesis author used: the root of 3/2.
pub const REACH: f64 = 1.224_744_871_391_589;

/// All pairs whose distance is at most `reach` times the sum of their radii, in the order of their first and
/// then of their second particles.
pub fn bonds_within(particles: &Particles, domain: &Domain, reach: f64) -> Vec<Pair> {
    let period = domain.period();
    let displacement = |from: Vec2, to: Vec2| match period {
        Some(length) => PeriodicX { length }.displacement(from, to),
        None => Open.displacement(from, to),
    };
    let mut reaching = particles.clone();
    reaching.radius.iter_mut().for_each(|r| *r *= reach);
    let mut neighbors = Neighbors::new(reaching.reaching(), domain);
    let mut pairs = Vec::new();
    let may_interact = |i, j| particles.may_interact(i, j);
    match period {
        Some(length) => neighbors.rebuild(
            PeriodicX { length },
            reaching.reaching(),
            may_interact,
            &mut pairs,
        ),
        None => neighbors.rebuild(Open, reaching.reaching(), may_interact, &mut pairs),
    }
    pairs.retain(|pair| {
        let (i, j) = pair.indices();
        let distance = displacement(particles.position[i], particles.position[j]).norm();
        distance <= reach * (particles.radius[i] + particles.radius[j])
    });
    pairs.sort_unstable_by_key(|pair| pair.indices());
    pairs
}

/// So many independent strength factors, uniform in [1 - spread, 1 + spread).
pub fn strength_factors(number: usize, spread: f64, mut uniform: impl FnMut() -> f64) -> Vec<f64> {
    (0..number)
        .map(|_| 1.0 + spread * (2.0 * uniform() - 1.0))
        .collect()
}
