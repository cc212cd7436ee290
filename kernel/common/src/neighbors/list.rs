//! The neighbour list: pairs that may touch soon, found by cells and rebuilt only if necessary.

use super::sizes::SizeClass;
use crate::geometry::{Domain, Metric, Vec2};
use crate::pair::Pair;
use crate::scalar::Real;
use gouge_equations::rendered;

/// Skin of the neighbour list, in typical radii, unless a narrow periodic box allows less.
const SKIN: f64 = 0.2;

/// The spheres whose neighbours are searched, as columns of equal length.
#[derive(Clone, Copy, Debug)]
pub struct SearchSpheres<'a, S> {
    /// Centres in m.
    pub positions: &'a [Vec2<S>],
    /// Search radii in m: the particle radii for contacts, or larger ones. Pairs are found if their spheres
    /// overlap or are closer than the skin.
    pub radii: &'a [S],
}

impl<S: Real> SearchSpheres<'_, S> {
    /// The largest radius in m, zero without spheres.
    pub fn largest_radius(&self) -> f64 {
        self.radii.iter().map(|r| r.to_f64()).fold(0.0, f64::max)
    }
}

/// The neighbour list (Verlet list): every pair whose gap is smaller than the skin and that a filter accepts.
///
/// A list contains every contact until a particle has moved by more than half the skin since the list was built:
///
/// $$ \Delta x = \frac{d^{cut}}{2} - r^{max}, \qquad d^{cut} = 2 r^{max} + \text{skin} $$
///
/// Thesis eqs. (98)-(99), with the cutoff distance of the list instead of the cell side. The cell side would be safe
/// only if the list contained all pairs of adjacent cells (erratum E32 of the thesis).
#[doc(alias = "Verlet list")]
#[rendered]
#[derive(Clone, Debug)]
pub struct Neighbors<S> {
    /// From the largest particles to the smallest.
    classes: Vec<SizeClass>,
    skin: f64,
    built_at: Vec<Vec2<S>>,
    rebuilds: u64,
    examined: usize,
}

/// The mean of some radii, of which huge ones count as ten times the median: a floor of one huge grain must not widen
/// the skin of all.
fn typical(radii: &[f64]) -> f64 {
    if radii.is_empty() {
        return 0.0;
    }
    let mut selected = radii.to_vec();
    let (_, &mut median, _) = selected.select_nth_unstable_by(radii.len() / 2, f64::total_cmp);
    radii
        .iter()
        .map(|radius| radius.min(10.0 * median))
        .sum::<f64>()
        / radii.len() as f64
}

impl<S: Real> Neighbors<S> {
    /// An empty list for particles in a box that is open or periodic in x. Searches are for the same particles.
    ///
    /// The skin is as large as the box permits, up to a fixed fraction of the typical radius.
    pub fn new(particles: SearchSpheres<S>, domain: &Domain) -> Self {
        let period = domain.period();
        let largest = 2.0 * particles.largest_radius();
        let radii = || particles.radii.iter().map(|r| r.to_f64());
        let typical = typical(&radii().collect::<Vec<_>>());
        let available = period.map_or(f64::INFINITY, |width| 0.5 * width - largest);
        let skin = (SKIN * typical).min(available).max(0.0);
        let reaches: Vec<_> = radii().map(|r| 2.0 * r + skin).collect();
        Self {
            classes: SizeClass::all(&reaches, period),
            skin,
            built_at: Vec::new(),
            rebuilds: 0,
            examined: 0,
        }
    }

    /// Largest gap in m of the pairs in the list.
    pub fn skin(&self) -> f64 {
        self.skin
    }

    /// Number of times the list was built.
    pub fn rebuilds(&self) -> u64 {
        self.rebuilds
    }

    /// Number of candidates that the latest search looked at: the measure of its work.
    pub fn examined(&self) -> usize {
        self.examined
    }

    /// Whether the list may miss a contact, because a particle has moved too far or its position is not finite.
    pub fn is_stale<M: Metric>(&self, metric: M, positions: &[Vec2<S>]) -> bool {
        self.built_at.len() != positions.len()
            || Staleness::new(Some(self), metric).is_stale(positions)
    }

    /// Replace `pairs` by all pairs that are near and that `may_interact` accepts, sorted.
    pub fn rebuild<M: Metric>(
        &mut self,
        metric: M,
        particles: SearchSpheres<S>,
        may_interact: impl Fn(usize, usize) -> bool,
        pairs: &mut Vec<Pair>,
    ) {
        pairs.clear();
        self.append_new(metric, particles, may_interact, pairs);
        pairs.sort_unstable();
    }

    /// Find all near pairs, and append those that the sorted `pairs` does not contain yet, unsorted.
    pub fn append_new<M: Metric>(
        &mut self,
        metric: M,
        particles: SearchSpheres<S>,
        may_interact: impl Fn(usize, usize) -> bool,
        pairs: &mut Vec<Pair>,
    ) {
        self.rebuilds += 1;
        self.built_at.clear();
        self.built_at.extend_from_slice(particles.positions);
        for class in &mut self.classes {
            class.sort(particles.positions);
        }
        let held = pairs.len();
        let skin = S::from_f64(self.skin);
        let mut examined = 0;
        let mut visit = |i: usize, j: usize| {
            if !may_interact(i, j) {
                return;
            }
            let d = metric.displacement(particles.positions[i], particles.positions[j]);
            let reach = particles.radii[i] + particles.radii[j] + skin;
            let pair = Pair::new(i, j);
            if d.norm_squared() <= reach * reach && pairs[..held].binary_search(&pair).is_err() {
                pairs.push(pair);
            }
        };
        for (class, own) in self.classes.iter().enumerate() {
            examined += own.pairs_within(&mut visit);
            for larger in &self.classes[..class] {
                examined += larger.pairs_with(own, particles.positions, &mut visit);
            }
        }
        self.examined = examined;
    }
}

/// The displacement test of the neighbour list, for consecutive particles.
#[derive(Clone, Copy)]
pub struct Staleness<'a, S, M> {
    /// The metric of the box.
    pub metric: M,
    built_at: &'a [Vec2<S>],
    /// Square of the distance by which a particle may move, in m^2.
    limit_squared: S,
}

impl<'a, S: Real, M: Metric> Staleness<'a, S, M> {
    /// The test for a list. Without a list nothing is ever stale.
    pub fn new(neighbors: Option<&'a Neighbors<S>>, metric: M) -> Self {
        let skin = neighbors.map_or(0.0, |neighbors| neighbors.skin);
        Self {
            metric,
            built_at: neighbors.map_or(&[], |neighbors| &neighbors.built_at),
            limit_squared: S::from_f64(0.25 * skin * skin),
        }
    }
    /// Split the test before a particle.
    #[inline(always)]
    pub fn split_at(self, at: usize) -> (Self, Self) {
        let (before, after) = self.built_at.split_at(at.min(self.built_at.len()));
        let left = Self {
            built_at: before,
            ..self
        };
        let right = Self {
            built_at: after,
            ..self
        };
        (left, right)
    }
    /// Whether a particle has moved too far, or its position is not finite.
    #[inline(always)]
    pub fn is_stale(&self, positions: &[Vec2<S>]) -> bool {
        let moves = self.built_at.iter().zip(positions);
        // No early exit, so that the loop is vectorised.
        !moves.fold(true, |all_near, (&then, &now)| {
            all_near & (self.metric.displacement(then, now).norm_squared() < self.limit_squared)
        })
    }
}
