//! Pairs of particles and their order.

use core::cmp::Ordering;

/// A pair of particles, smaller index first.
///
/// Pairs are sorted by second particle, then by first. The interactions of one particle therefore appear in the
/// order of its neighbours, and a particle owns its interactions with earlier particles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pair {
    /// First particle.
    pub i: u32,
    /// Second particle.
    pub j: u32,
}

impl Pair {
    /// The pair of two particles, given in either order.
    pub fn new(a: usize, b: usize) -> Self {
        let (i, j) = if a < b { (a, b) } else { (b, a) };
        Self {
            i: i as u32,
            j: j as u32,
        }
    }
    /// The pair with the larger index first.
    pub fn reversed(self) -> Self {
        Self {
            i: self.j,
            j: self.i,
        }
    }
    /// The pair with the smaller index first.
    pub fn in_order(self) -> Self {
        let (i, j) = self.indices();
        Self::new(i, j)
    }
    /// Both indices.
    #[inline(always)]
    pub fn indices(self) -> (usize, usize) {
        (self.i as usize, self.j as usize)
    }
}

impl Ord for Pair {
    fn cmp(&self, other: &Self) -> Ordering {
        (self.j, self.i).cmp(&(other.j, other.i))
    }
}

impl PartialOrd for Pair {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Apply a function to the values at both ends of a pair.
///
/// Unlike [`array::map`] it is always inlined, so that loops over pairs are vectorised whatever the division of
/// the crate into codegen units.
#[inline(always)]
pub fn map_ends<T, U>([first, second]: [T; 2], function: impl Fn(T) -> U) -> [U; 2] {
    [function(first), function(second)]
}

/// Number of sorted pairs whose second particle precedes the given one.
pub fn pairs_before(pairs: &[Pair], particle: usize) -> usize {
    pairs.partition_point(|pair| (pair.j as usize) < particle)
}
