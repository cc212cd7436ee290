//! What links of a part do to particles of earlier parts.

use super::Sums;
use super::block::{IDLE, Outputs};
use crate::bonds::Edition;
use core::ops::Range;
use gouge_common::geometry::Vec2;
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;

/// What a link does to its first particle, where that belongs to an earlier part.
#[derive(Clone, Debug)]
struct Departure<S> {
    /// The first particle.
    particle: u32,
    /// Force on it in N.
    force: Vec2<S>,
    /// Torque on it in N m; zero if links do not turn their ends.
    torque: S,
}

/// The links of a part that lead to earlier parts, and what they do at present.
///
/// Links are in the order of their second particles, to which their part belongs: what they do to earlier
/// particles comes after all that these do to each other, and may be added when all parts are done.
#[derive(Clone, Debug, Default)]
pub(crate) struct Departures<S> {
    /// The list of links in which they were sought.
    edition: Option<Edition>,
    /// Where they are among the links of the part.
    positions: Vec<usize>,
    /// Which of these comes next.
    next: usize,
    present: Vec<Departure<S>>,
}

impl<S: Lanes> Departures<S> {
    /// Begin an evaluation: find the links that lead to particles before the first of the part, where they
    /// may be others than before.
    pub fn begin(&mut self, edition: Edition, pairs: &[Pair], first: usize) {
        self.present.clear();
        self.next = 0;
        if self.edition != Some(edition) {
            self.edition = Some(edition);
            let leaves = |&position: &usize| (pairs[position].i as usize) < first;
            self.positions.clear();
            self.positions.extend((0..pairs.len()).filter(leaves));
            self.present.reserve(self.positions.len());
        }
    }
    /// Note what a block of the links does to earlier parts, and its torques if links turn their ends.
    #[inline(always)]
    pub fn note(&mut self, pairs: &[Pair], links: Range<usize>, outputs: &Outputs<S>, turns: bool) {
        let next = self.positions.get(self.next);
        if next.is_some_and(|&position| position < links.end) {
            self.note_block(pairs, links, outputs, turns);
        }
    }

    #[cold]
    #[inline(never)]
    fn note_block(
        &mut self,
        pairs: &[Pair],
        links: Range<usize>,
        outputs: &Outputs<S>,
        turns: bool,
    ) {
        while let Some(&position) = self.positions.get(self.next)
            && position < links.end
        {
            self.next += 1;
            let lane = position - links.start;
            if outputs.flags[lane] & IDLE == 0 {
                let [torque, _] = outputs.torques(lane);
                self.present.push(Departure {
                    particle: pairs[position].i,
                    force: outputs.force(lane),
                    torque: if turns { torque } else { S::zero() },
                });
            }
        }
    }

    /// Add what has been noted to the sums of all particles.
    pub fn arrive(&self, sums: &mut Sums<S>) {
        for departure in &self.present {
            let particle = departure.particle as usize;
            sums.force[particle] += departure.force;
            sums.torque[particle] += departure.torque;
        }
    }
}
