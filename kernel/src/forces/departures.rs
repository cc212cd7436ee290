//! What links of a part do to particles of later parts.

use crate::geometry::Vec2;
use crate::instructions::Instructions;
use crate::links::{Edition, Pair, pairs_before};
use crate::parts::{Ready, Work};
use crate::scalar::Real;
use core::ops::Range;
use pulp::NullaryFnOnce;

/// What a link does to its second particle, where that belongs to a later part.
#[derive(Clone, Debug)]
pub(crate) struct Arrival<S> {
    /// The second particle.
    pub particle: usize,
    /// Force on the first in N, whose reaction arrives.
    pub force: Vec2<S>,
    /// Torque on the second in N m.
    pub torque: S,
}

/// The links of a part that lead to later parts, and what they do at present.
#[derive(Clone, Debug, Default)]
pub(crate) struct Departures<S> {
    /// The list of links in which they were sought.
    edition: Option<Edition>,
    positions: Vec<u32>,
    pub arrivals: Vec<Arrival<S>>,
}

/// The work of finding what leaves each part, done before any part changes what links remember.
pub(crate) struct Depart<'a, F> {
    /// All links in order.
    pub pairs: &'a [Pair],
    /// Which list of links they are.
    pub edition: Edition,
    /// The particles of the part.
    pub part: Range<usize>,
    /// Force on i and torque on j of the link at a position; nothing if it exerts none.
    pub effect: F,
}

impl<S: Real, F: Fn(usize) -> Option<(Vec2<S>, S)> + Copy + Send> Work<Departures<S>>
    for Depart<'_, F>
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

    fn act(self, departures: &mut Departures<S>, _: Instructions) {
        if departures.edition != Some(self.edition) {
            departures.edition = Some(self.edition);
            departures.positions.clear();
            departures.positions.extend(self.leaving());
        }
        departures.arrivals.clear();
        for &position in &departures.positions {
            if let Some((force, torque)) = (self.effect)(position as usize) {
                departures.arrivals.push(Arrival {
                    particle: self.pairs[position as usize].j as usize,
                    force,
                    torque,
                });
            }
        }
    }

    fn start(ready: Ready<Self, Departures<S>>) {
        ready.call();
    }
}

impl<F> Depart<'_, F> {
    /// Positions of the links of this part whose second particle belongs to a later one.
    fn leaving(&self) -> impl Iterator<Item = u32> {
        let Range { start, end } = self.part;
        let links = pairs_before(self.pairs, start)..pairs_before(self.pairs, end);
        let leaves = move |&position: &usize| self.pairs[position].j as usize >= end;
        links.filter(leaves).map(|position| position as u32)
    }
}
