//! The neighbour list: pairs that may touch soon, found by cells and rebuilt only if necessary.

use super::cells::{CellIndex, Cells, precedes};
use crate::geometry::{Domain, Metric, Vec2};
use crate::pair::Pair;
use crate::scalar::Real;
use gouge_equations::rendered;

/// Skin of the neighbour list, in mean radii, unless a narrow periodic box allows less.
const SKIN: f64 = 0.2;
/// Minimum cell side less the largest diameter, in mean radii. Larger than the skin, because a particle may move by
/// one cell per step.
const CELL_EXCESS: f64 = 0.4;

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
    cells: Cells,
    skin: f64,
    built_at: Vec<Vec2<S>>,
    rebuilds: u64,
    members: Vec<u32>,
    starts: Vec<u32>,
}

impl<S: Real> Neighbors<S> {
    /// An empty list for a box that is open or periodic in x.
    ///
    /// The skin is as large as the box permits, up to a fixed fraction of the mean radius.
    pub fn new(particles: SearchSpheres<S>, domain: &Domain) -> Self {
        let period = domain.period();
        let largest = 2.0 * particles.largest_radius();
        let number = particles.radii.len().max(1);
        let mean = particles.radii.iter().map(|r| r.to_f64()).sum::<f64>() / number as f64;
        let available = period.map_or(f64::INFINITY, |width| 0.5 * width - largest);
        let within_box = |width: f64| (width * mean).min(available).max(0.0);
        let skin = within_box(SKIN);
        let (low, high) = bounds(particles.positions);
        let side = |given: Option<f64>, low: f64, high: f64| match given {
            Some(length) => (0.0, length),
            None => (low, (high - low).max(largest)),
        };
        let (x, width) = side(domain.width, low.x, high.x);
        let (y, height) = side(domain.height, low.y, high.y);
        let cutoff = (largest + within_box(CELL_EXCESS)).max(f64::MIN_POSITIVE);
        let (origin, extent) = (Vec2::new(x, y), Vec2::new(width, height));
        Self {
            cells: Cells::new(origin, extent, period.is_some(), cutoff, number + 16),
            skin,
            built_at: Vec::new(),
            rebuilds: 0,
            members: Vec::new(),
            starts: Vec::new(),
        }
    }

    /// Number of times the list was built.
    pub fn rebuilds(&self) -> u64 {
        self.rebuilds
    }

    /// The shorter side of a cell in m: how far a particle may move per step.
    pub fn cell_side(&self) -> f64 {
        self.cells.smaller_side()
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
        self.sort_into_cells(particles.positions);
        let held = pairs.len();
        let skin = S::from_f64(self.skin);
        for (i, &position) in particles.positions.iter().enumerate() {
            let own = self.cell_of(position);
            for cell in self.cells.neighbors_from(own) {
                for &j in self.members_of(cell) {
                    let j = j as usize;
                    if !may_interact(i, j) || !precedes(&self.cells, (own, i), (cell, j)) {
                        continue;
                    }
                    let d = metric.displacement(position, particles.positions[j]);
                    let reach = particles.radii[i] + particles.radii[j] + skin;
                    let pair = Pair::new(i, j);
                    if d.norm_squared() <= reach * reach
                        && pairs[..held].binary_search(&pair).is_err()
                    {
                        pairs.push(pair);
                    }
                }
            }
        }
    }

    fn cell_of(&self, position: Vec2<S>) -> CellIndex {
        self.cells
            .cell_at(Vec2::new(position.x.to_f64(), position.y.to_f64()))
    }

    fn members_of(&self, cell: CellIndex) -> &[u32] {
        let rank = self.cells.rank(cell);
        &self.members[self.starts[rank] as usize..self.starts[rank + 1] as usize]
    }

    fn sort_into_cells(&mut self, positions: &[Vec2<S>]) {
        let rank = |own: &Self, i: usize| own.cells.rank(own.cell_of(positions[i]));
        self.starts.clear();
        self.starts.resize(self.cells.number() + 1, 0);
        for i in 0..positions.len() {
            let cell = rank(self, i);
            self.starts[cell + 1] += 1;
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        self.members.clear();
        self.members.resize(positions.len(), 0);
        for i in (0..positions.len()).rev() {
            let cell = rank(self, i);
            // Filled from the end: afterwards each start is again the first member of its cell.
            self.starts[cell + 1] -= 1;
            self.members[self.starts[cell + 1] as usize] = i as u32;
        }
        self.starts.rotate_left(1);
        if let Some(last) = self.starts.last_mut() {
            *last = positions.len() as u32;
        }
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

/// Lower left and upper right corner of the bounding box of all centres.
fn bounds<S: Real>(positions: &[Vec2<S>]) -> (Vec2, Vec2) {
    let infinite = Vec2::new(f64::INFINITY, f64::INFINITY);
    let (mut low, mut high) = (infinite, -infinite);
    for x in positions {
        let (x, y) = (x.x.to_f64(), x.y.to_f64());
        low = Vec2::new(low.x.min(x), low.y.min(y));
        high = Vec2::new(high.x.max(x), high.y.max(y));
    }
    if positions.is_empty() {
        (Vec2::zero(), Vec2::zero())
    } else {
        (low, high)
    }
}
