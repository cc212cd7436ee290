//! What links of a part do to particles of later parts.

use super::block::LINKS;
use crate::geometry::Vec2;
use crate::instructions::Instructions;
use crate::links::{Pair, pairs_before};
use crate::parts::{Ready, Work};
use crate::scalar::Real;
use core::ops::Range;
use pulp::NullaryFnOnce;

/// What a link does to its second particle, where that belongs to a later part.
#[derive(Clone, Debug)]
pub(crate) struct Arrival<S> {
    /// The link.
    pub pair: Pair,
    /// Force on i in N, whose reaction arrives.
    pub force: Vec2<S>,
    /// Torque on j in N m.
    pub torque: S,
}

/// Whether the second particle of some pair belongs to a later part. Without an early end, so that many pairs
/// are looked at together.
fn leaves(pairs: &[Pair], end: usize) -> bool {
    pairs
        .iter()
        .fold(false, |some, pair| some | (pair.j as usize >= end))
}

/// The search for what leaves each part, done before any part changes what links remember.
pub(crate) struct Departures<'a, F> {
    /// All links in order.
    pub pairs: &'a [Pair],
    /// The particles of the part.
    pub part: Range<usize>,
    /// Force on i and torque on j of the link at a position; nothing if it exerts none.
    pub effect: F,
}

impl<S: Real, F: Fn(usize) -> Option<(Vec2<S>, S)> + Copy + Send> Work<Vec<Arrival<S>>>
    for Departures<'_, F>
{
    fn split_at(self, particle: usize) -> (Self, Self) {
        let Range { start, end } = self.part;
        let middle = start + particle;
        let left = Self {
            part: start..middle,
            ..self
        };
        let right = Self {
            part: middle..end,
            ..self
        };
        (left, right)
    }

    fn act(self, departures: &mut Vec<Arrival<S>>, _: Instructions) {
        departures.clear();
        let Range { start, end } = self.part;
        let links = pairs_before(self.pairs, start)..pairs_before(self.pairs, end);
        for first in links.clone().step_by(LINKS) {
            let block = first..links.end.min(first + LINKS);
            if leaves(&self.pairs[block.clone()], end) {
                self.depart(block, departures);
            }
        }
    }

    fn start(ready: Ready<Self, Vec<Arrival<S>>>) {
        ready.call();
    }
}

impl<S, F: Fn(usize) -> Option<(Vec2<S>, S)>> Departures<'_, F> {
    /// Note what leaves through some links.
    fn depart(&self, links: Range<usize>, departures: &mut Vec<Arrival<S>>) {
        for (pair, position) in self.pairs[links.clone()].iter().zip(links) {
            if (pair.j as usize) < self.part.end {
                continue;
            }
            if let Some((force, torque)) = (self.effect)(position) {
                departures.push(Arrival {
                    pair: *pair,
                    force,
                    torque,
                });
            }
        }
    }
}
