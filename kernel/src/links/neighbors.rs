//! Pairs that may touch soon: lists by cells, rebuilt only when they must be.

use super::cells::{Cells, Index};
use super::{Pair, precedes};
use crate::geometry::{Metric, Vec2};
use crate::particles::Particles;
use crate::scalar::Real;
use gouge_equations::rendered;

/// Width of the margin around contacts, in mean radii, where the box does not ask for less.
const MARGIN: f64 = 0.2;
/// How much wider than two of the largest radii a cell is at least, in mean radii: more than the margin
/// asks for, because a particle may move a cell a step.
const ROOM: f64 = 0.4;

/// The neighbour list: every pair whose surfaces are closer than a margin, but for pairs of fixed
/// particles, whose forces move nothing.
///
/// A list made at one moment holds every contact for as long as no particle has moved farther than half
/// the margin since.
///
/// $$ \Delta x = \frac{d^{cut}}{2} - r^{max}, \qquad d^{cut} = 2 r^{max} + \text{margin} $$
///
/// Thesis eqs. (98)-(99), with the cutoff distance of the list in place of the side of the cell, which
/// would be safe only if the list held all pairs of adjacent cells (E32 of `docs/errata.md`).
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
    /// Cells for the given box; the margin is as large as the box allows, up to a fraction of the mean
    /// radius.
    pub fn new(particles: &Particles<S>, extent: [Option<f64>; 2], period: Option<f64>) -> Self {
        let largest = 2.0 * particles.largest_radius();
        let number = particles.len().max(1);
        let mean = particles.radius.iter().map(|r| r.to_f64()).sum::<f64>() / number as f64;
        let room = period.map_or(f64::INFINITY, |width| 0.5 * width - largest);
        let within_box = |width: f64| (width * mean).min(room).max(0.0);
        let margin = within_box(MARGIN);
        let (low, high) = bounds(particles);
        let side = |given: Option<f64>, low: f64, high: f64| match given {
            Some(length) => (0.0, length),
            None => (low, (high - low).max(largest)),
        };
        let (x, width) = side(extent[0], low.x, high.x);
        let (y, height) = side(extent[1], low.y, high.y);
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
    pub fn are_stale<M: Metric>(&self, metric: M, particles: &Particles<S>) -> bool {
        self.built_at.len() != particles.len()
            || Watch::of(Some(self), metric).is_stale(&particles.position)
    }

    /// Find all pairs anew, in order, into `pairs`.
    pub fn rebuild<M: Metric>(
        &mut self,
        metric: M,
        particles: &Particles<S>,
        pairs: &mut Vec<Pair>,
    ) {
        pairs.clear();
        self.rebuild_around(metric, particles, pairs);
        pairs.sort_unstable();
    }

    /// Find all pairs anew, and append those that `pairs`, in order, does not hold, in any order.
    pub(super) fn rebuild_around<M: Metric>(
        &mut self,
        metric: M,
        particles: &Particles<S>,
        pairs: &mut Vec<Pair>,
    ) {
        self.rebuilds += 1;
        self.built_at.clone_from(&particles.position);
        self.sort_into_cells(particles);
        let held = pairs.len();
        for i in 0..particles.len() {
            let own = self.cell_of(particles, i);
            for cell in self.cells.neighbors_from(own) {
                self.pairs_with_cell(metric, particles, (own, i), cell, (held, pairs));
            }
        }
    }

    fn cell_of(&self, particles: &Particles<S>, i: usize) -> Index {
        let position = particles.position[i];
        self.cells
            .down(Vec2::new(position.x.to_f64(), position.y.to_f64()))
    }

    fn sort_into_cells(&mut self, particles: &Particles<S>) {
        let number = particles.len();
        let rank = |own: &Self, i| own.cells.rank(own.cell_of(particles, i));
        self.starts.clear();
        self.starts.resize(self.cells.number() + 1, 0);
        for i in 0..number {
            let cell = rank(self, i);
            self.starts[cell + 1] += 1;
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        self.members.clear();
        self.members.resize(number, 0);
        for i in (0..number).rev() {
            let cell = rank(self, i);
            // Filled from behind: afterwards each start is again the first member of its cell.
            self.starts[cell + 1] -= 1;
            self.members[self.starts[cell + 1] as usize] = i as u32;
        }
        self.starts.rotate_left(1);
        if let Some(last) = self.starts.last_mut() {
            *last = number as u32;
        }
    }

    fn pairs_with_cell<M: Metric>(
        &self,
        metric: M,
        particles: &Particles<S>,
        (own, i): (Index, usize),
        cell: Index,
        (held, pairs): (usize, &mut Vec<Pair>),
    ) {
        let rank = self.cells.rank(cell);
        let members = &self.members[self.starts[rank] as usize..self.starts[rank + 1] as usize];
        for &j in members {
            let j = j as usize;
            let both_fixed = particles.is_fixed(i) && particles.is_fixed(j);
            if both_fixed || !precedes(&self.cells, (own, i), (cell, j)) {
                continue;
            }
            let d = metric.displacement(particles.position[i], particles.position[j]);
            let reach = particles.radius[i] + particles.radius[j] + S::from_f64(self.margin);
            let pair = Pair::new(i, j);
            if d.norm_squared() <= reach * reach && pairs[..held].binary_search(&pair).is_err() {
                pairs.push(pair);
            }
        }
    }
}

/// Where consecutive particles were when the list was built, and how far they may move.
#[derive(Clone, Copy)]
pub(crate) struct Watch<'a, S, M> {
    pub metric: M,
    built_at: &'a [Vec2<S>],
    /// Square of the distance that is not far, in m^2.
    safe: S,
}

impl<'a, S: Real, M: Metric> Watch<'a, S, M> {
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
fn bounds<S: Real>(particles: &Particles<S>) -> (Vec2, Vec2) {
    let infinite = Vec2::new(f64::INFINITY, f64::INFINITY);
    let (mut low, mut high) = (infinite, -infinite);
    for x in &particles.position {
        let (x, y) = (x.x.to_f64(), x.y.to_f64());
        low = Vec2::new(low.x.min(x), low.y.min(y));
        high = Vec2::new(high.x.max(x), high.y.max(y));
    }
    if particles.is_empty() {
        (Vec2::zero(), Vec2::zero())
    } else {
        (low, high)
    }
}
