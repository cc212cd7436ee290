//! Prefetching for worlds that do not fit into the caches.
//!
//! The hardware prefetcher recognises a column that is read from beginning to end, but only a few cache lines
//! ahead, and pairs read many columns alternately.

use gouge_common::pair::Pair;

/// Number of particles that fit into the last-level cache: with their pairs they take some 500 bytes each.
const SMALL: usize = 20_000;
/// How many blocks ahead of the one that is gathered to prefetch.
pub(super) const BLOCKS_AHEAD: usize = 4;

/// Whether a world of so many particles profits from prefetching.
pub(super) fn is_large(particles: usize) -> bool {
    particles > SMALL
}

/// The second particle of the pair at a position, whose own pairs are the first to need it; none beyond the end.
#[inline(always)]
pub(super) fn needed_at(pairs: &[Pair], position: usize) -> Option<usize> {
    Some(pairs.get(position)?.j as usize)
}
