//! What later links need, prefetched for worlds that do not stay in the caches.
//!
//! The processor finds out by itself that a column is read from its beginning to its end, but it looks a few
//! lines ahead only, and links read many columns in turns.

use super::block::LINKS;
use gouge_common::pair::Pair;

/// Particles that stay in the last cache: they and their links take some 500 bytes each.
const SMALL: usize = 20_000;
/// Links between those that are gathered and those that are prefetched.
const DISTANCE: usize = 4 * LINKS;

/// Whether a world of so many particles needs what follows.
pub(super) fn is_large(particles: usize) -> bool {
    particles > SMALL
}

/// Position of the link to be prefetched with that at a position, and its second particle, whose own links
/// are the first to need it; nothing near the end.
#[inline(always)]
pub(super) fn ahead_of(pairs: &[Pair], now: usize) -> Option<(usize, usize)> {
    let later = now + DISTANCE;
    Some((later, pairs.get(later)?.j as usize))
}
