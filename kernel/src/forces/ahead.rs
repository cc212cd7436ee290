//! What later links need, prefetched for worlds that do not stay in the caches.
//!
//! The processor finds out by itself that a column is read from its beginning to its end, but it looks a few
//! lines ahead only, and links read many columns in turns.

use super::block::LINKS;
use crate::links::Pair;

/// Particles that stay in the last cache: they and their links take some 500 bytes each.
const SMALL: usize = 20_000;
/// Links between those that are gathered and those that are prefetched.
const DISTANCE: usize = 4 * LINKS;

/// Where later links and their particles are.
pub(crate) struct Ahead {
    /// Difference of the indices of both ends that most links do not exceed: a link is the first to need the
    /// particle that lies so far behind its own.
    reach: usize,
}

impl Ahead {
    /// For consecutive links of a world of so many particles; nothing if it is small.
    pub fn of(pairs: &[Pair], particles: usize) -> Option<Self> {
        if particles <= SMALL || pairs.is_empty() {
            return None;
        }
        let mut spans = [0; LINKS];
        let sample = pairs.iter().step_by(pairs.len().div_ceil(LINKS));
        let number = sample.len();
        for (span, pair) in spans.iter_mut().zip(sample) {
            *span = pair.j - pair.i;
        }
        let spans = &mut spans[..number];
        spans.sort_unstable();
        Some(Self {
            reach: spans[number * 3 / 4] as usize,
        })
    }
    /// Position of the link to be prefetched with that at a position, and the particle; nothing near the end.
    #[inline(always)]
    pub fn of_link(&self, pairs: &[Pair], now: usize) -> Option<(usize, usize)> {
        let later = now + DISTANCE;
        let first = pairs.get(later)?.i as usize;
        Some((later, first + self.reach))
    }
}
