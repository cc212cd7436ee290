//! Bonds between neighbours, thesis sections 3.5.2 and 3.7.5.

use crate::particles::Particles;
use gouge_common::geometry::{Domain, Metric, WithMetric};
use gouge_common::neighbors::{Neighbors, SearchSpheres};
use gouge_common::pair::Pair;

/// Largest distance of bonded particles in units of the sum of their radii, as chosen by the thesis's author: the
/// square root of 3/2.
pub const REACH: f64 = 1.224_744_871_391_589;

/// All pairs whose distance is at most `reach` times the sum of their radii, sorted by first particle, then by
/// second.
pub fn bonds_within(particles: &Particles, domain: &Domain, reach: f64) -> Vec<Pair> {
    let radii: Vec<f64> = particles.radius.iter().map(|r| r * reach).collect();
    let spheres = SearchSpheres {
        positions: &particles.position,
        radii: &radii,
    };
    let mut pairs = domain.with_metric(Candidates {
        particles,
        spheres,
        neighbors: Neighbors::new(spheres, domain),
    });
    pairs.retain(|pair| {
        let (i, j) = pair.indices();
        let branch = domain.displacement(particles.position[i], particles.position[j]);
        branch.norm() <= reach * (particles.radius[i] + particles.radius[j])
    });
    pairs.sort_unstable_by_key(|pair| pair.indices());
    pairs
}

/// Searches the pairs that may be near enough.
struct Candidates<'a> {
    particles: &'a Particles,
    spheres: SearchSpheres<'a, f64>,
    neighbors: Neighbors<f64>,
}

impl WithMetric for Candidates<'_> {
    type Output = Vec<Pair>;
    fn call<M: Metric>(mut self, metric: M) -> Vec<Pair> {
        let mut pairs = Vec::new();
        let may_interact = |i, j| self.particles.may_interact(i, j);
        self.neighbors
            .rebuild(metric, self.spheres, may_interact, &mut pairs);
        pairs
    }
}

/// Independent strength factors, uniform in [1 - spread, 1 + spread), dimensionless.
pub fn strength_factors(number: usize, spread: f64, mut uniform: impl FnMut() -> f64) -> Vec<f64> {
    (0..number)
        .map(|_| 1.0 + spread * (2.0 * uniform() - 1.0))
        .collect()
}
