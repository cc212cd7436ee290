//! Prefetching for worlds that do not fit the caches.
//!
//! The hardware prefetcher recognises a column that is read from beginning to end, but looks only a few cache lines
//! ahead, and pairs read many columns alternately.

use gouge_common::pair::Pair;

/// Number of particles that fit the last-level cache: about 500 bytes per particle, including its pairs.
const SMALL: usize = 20_000;
/// Number of blocks between the one that is gathered and the one that is prefetched.
pub(super) const BLOCKS_AHEAD: usize = 4;

/// Whether a world with this number of particles benefits from prefetching.
pub(super) fn is_large(particles: usize) -> bool {
    particles > SMALL
}

/// Second particle of the pair at an index; `None` beyond the end.
///
/// The first pair that reads a particle has it as its second particle.
#[inline(always)]
pub(super) fn needed_at(pairs: &[Pair], position: usize) -> Option<usize> {
    Some(pairs.get(position)?.j as usize)
}
