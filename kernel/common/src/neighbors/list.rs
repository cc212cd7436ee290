//! Pairs that may touch soon: lists by cells, rebuilt only when they must be.

use super::cells::{Cells, Index, precedes};
use crate::geometry::{Domain, Metric, Vec2};
use crate::pair::Pair;
use crate::scalar::Real;
use gouge_equations::rendered;

/// Width of the margin around contacts, in mean reaches, where the box does not ask for less.
const MARGIN: f64 = 0.2;
/// How much wider than two of the largest reaches a cell is at least, in mean reaches: more than the
/// margin, because a particle may move by one cell per step.
const ROOM: f64 = 0.4;

/// What the search sees of particles: columns of equal length.
#[derive(Clone, Copy, Debug)]
pub struct Reaching<'a, S> {
    /// Positions in m.
    pub positions: &'a [Vec2<S>],
    /// How far each particle reaches from its position, in m: for a sphere its radius.
    pub reaches: &'a [S],
}

impl<S: Real> Reaching<'_, S> {
    /// The largest reach in m, zero without particles.
    pub fn largest(&self) -> f64 {
        self.reaches.iter().map(|r| r.to_f64()).fold(0.0, f64::max)
    }
}

/// The neighbour list: every pair whose gap is smaller than a margin and which a filter accepts.
///
/// A list made at one moment holds every contact for as long as no particle has moved farther than half
/// the margin since.
///
/// $$ \Delta x = \frac{d^{cut}}{2} - r^{max}, \qquad d^{cut} = 2 r^{max} + \text{margin} $$
///
/// Thesis eqs. (98)-(99), with the cutoff distance of the list in place of the side of the cell, which
/// would be safe only if the list held all pairs of adjacent cells (erratum E32 of the thesis).
#[rendered]
#[derive(Clone, Debug)]
pub struct Neighbors<S> {
    cells: Cells,
    margin: f64,
    built_at: Vec<Vec2<S>>,
    rebuilds: u64,
    members: Vec<u32>,
    starts: Vec<u32>,
}

impl<S: Real> Neighbors<S> {
    /// Cells for a box, open or periodic in x; the margin is as large as the box allows, up to a fraction
    /// of the mean reach.
    pub fn new(particles: Reaching<S>, domain: &Domain) -> Self {
        let period = domain.period();
        let largest = 2.0 * particles.largest();
        let number = particles.reaches.len().max(1);
        let mean = particles.reaches.iter().map(|r| r.to_f64()).sum::<f64>() / number as f64;
        let room = period.map_or(f64::INFINITY, |width| 0.5 * width - largest);
        let within_box = |width: f64| (width * mean).min(room).max(0.0);
        let margin = within_box(MARGIN);
        let (low, high) = bounds(particles.positions);
        let side = |given: Option<f64>, low: f64, high: f64| match given {
            Some(length) => (0.0, length),
            None => (low, (high - low).max(largest)),
        };
        let (x, width) = side(domain.width, low.x, high.x);
        let (y, height) = side(domain.height, low.y, high.y);
        let cutoff = (largest + within_box(ROOM)).max(f64::MIN_POSITIVE);
        let (origin, extent) = (Vec2::new(x, y), Vec2::new(width, height));
        Self {
            cells: Cells::new(origin, extent, period.is_some(), cutoff, number + 16),
            margin,
            built_at: Vec::new(),
            rebuilds: 0,
            members: Vec::new(),
            starts: Vec::new(),
        }
    }

    /// How often the list was built.
    pub fn rebuilds(&self) -> u64 {
        self.rebuilds
    }

    /// Side of a cell in m: how far a particle may move in one step.
    pub fn cell_side(&self) -> f64 {
        self.cells.smaller_side()
    }

    /// Whether some particle has moved so far that the list may miss a contact, or is not finite.
    pub fn are_stale<M: Metric>(&self, metric: M, positions: &[Vec2<S>]) -> bool {
        self.built_at.len() != positions.len()
            || Staleness::of(Some(self), metric).is_stale(positions)
    }

    /// Find all pairs anew, in order, into `pairs`; only those that `may_interact` accepts.
    pub fn rebuild<M: Metric>(
        &mut self,
        metric: M,
        particles: Reaching<S>,
        may_interact: impl Fn(usize, usize) -> bool,
        pairs: &mut Vec<Pair>,
    ) {
        pairs.clear();
        self.append_new(metric, particles, may_interact, pairs);
        pairs.sort_unstable();
    }

    /// Find all pairs anew, and append those that `pairs`, in order, does not hold yet, in any order.
    pub fn append_new<M: Metric>(
        &mut self,
        metric: M,
        particles: Reaching<S>,
        may_interact: impl Fn(usize, usize) -> bool,
        pairs: &mut Vec<Pair>,
    ) {
        self.rebuilds += 1;
        self.built_at.clear();
        self.built_at.extend_from_slice(particles.positions);
        self.sort_into_cells(particles.positions);
        let held = pairs.len();
        let margin = S::from_f64(self.margin);
        for (i, &position) in particles.positions.iter().enumerate() {
            let own = self.cell_of(position);
            for cell in self.cells.neighbors_from(own) {
                for &j in self.members_of(cell) {
                    let j = j as usize;
                    if !may_interact(i, j) || !precedes(&self.cells, (own, i), (cell, j)) {
                        continue;
                    }
                    let d = metric.displacement(position, particles.positions[j]);
                    let reach = particles.reaches[i] + particles.reaches[j] + margin;
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

    fn cell_of(&self, position: Vec2<S>) -> Index {
        self.cells
            .down(Vec2::new(position.x.to_f64(), position.y.to_f64()))
    }

    fn members_of(&self, cell: Index) -> &[u32] {
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
            // Filled from behind: afterwards each start is again the first member of its cell.
            self.starts[cell + 1] -= 1;
            self.members[self.starts[cell + 1] as usize] = i as u32;
        }
        self.starts.rotate_left(1);
        if let Some(last) = self.starts.last_mut() {
            *last = positions.len() as u32;
        }
    }
}

/// Where consecutive particles were when the list was built, and how far they may move.
#[derive(Clone, Copy)]
pub struct Staleness<'a, S, M> {
    /// The metric of the box.
    pub metric: M,
    built_at: &'a [Vec2<S>],
    /// Square of the distance that is not far, in m^2.
    safe: S,
}

impl<'a, S: Real, M: Metric> Staleness<'a, S, M> {
    /// What tells whether a list may miss a contact; without a list nothing does.
    pub fn of(neighbors: Option<&'a Neighbors<S>>, metric: M) -> Self {
        let margin = neighbors.map_or(0.0, |neighbors| neighbors.margin);
        Self {
            metric,
            built_at: neighbors.map_or(&[], |neighbors| &neighbors.built_at),
            safe: S::from_f64(0.25 * margin * margin),
        }
    }
    /// The same for the particles before and from a position on.
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
    /// Whether some particle has moved far, or is not finite.
    #[inline(always)]
    pub fn is_stale(&self, positions: &[Vec2<S>]) -> bool {
        let moves = self.built_at.iter().zip(positions);
        // No early end, so that many particles are looked at together.
        !moves.fold(true, |all_near, (&then, &now)| {
            all_near & (self.metric.displacement(then, now).norm_squared() < self.safe)
        })
    }
}

/// Corners of the smallest box around all centres.
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
