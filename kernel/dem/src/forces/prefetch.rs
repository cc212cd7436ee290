//! Prefetching for worlds that do not fit into the caches.
//!
//! The hardware prefetcher recognises a column that is read from beginning to end, but only a few cache lines
//! ahead, and pairs read many columns alternately.

use super::block::PAIRS;
use gouge_common::pair::Pair;

/// Number of particles that fit into the last-level cache: with their pairs they take some 500 bytes each.
const SMALL: usize = 20_000;
/// How many pairs ahead of those that are gathered to prefetch.
const DISTANCE: usize = 4 * PAIRS;

/// Whether a world of so many particles profits from prefetching.
pub(super) fn is_large(particles: usize) -> bool {
    particles > SMALL
}

/// Position of the pair to prefetch while the one at `now` is gathered, and its second particle; none near the
/// end.
#[inline(always)]
pub(super) fn ahead_of(pairs: &[Pair], now: usize) -> Option<(usize, usize)> {
    let later = now + DISTANCE;
    Some((later, pairs.get(later)?.j as usize))
}
