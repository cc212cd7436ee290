//! Forces of a part's pairs on particles of earlier parts.

use super::block::{IDLE, Outputs};
use super::sums::Sums;
use crate::pairs::Edition;
use core::ops::Range;
use gouge_common::geometry::Vec2;
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;

/// What a pair exerts on its first particle, if that belongs to an earlier part.
#[derive(Clone, Debug)]
struct CrossPartForce<S> {
    /// The first particle.
    particle: u32,
    /// Force on it in N.
    force: Vec2<S>,
    /// Torque on it in N m; zero if pairs exert no torques.
    torque: S,
}

/// The pairs of a part whose first particle belongs to an earlier part, and the forces on it.
///
/// A pair belongs to the part of its second particle. Pairs are in the order of their second particles, so that
/// in a single loop these forces would be added after all others of the first particle: adding them when all
/// parts are done gives the same sums.
#[derive(Clone, Debug, Default)]
pub(crate) struct CrossPartForces<S> {
    /// The list of pairs in which they were sought.
    edition: Option<Edition>,
    /// Their positions among the pairs of the part.
    positions: Vec<usize>,
    /// Index of the next of these positions.
    next: usize,
    present: Vec<CrossPartForce<S>>,
}

impl<S: Lanes> CrossPartForces<S> {
    /// Begin an evaluation: find the pairs with particles before the first of the part, if the list has changed.
    pub fn begin(&mut self, edition: Edition, pairs: &[Pair], first: usize) {
        self.present.clear();
        self.next = 0;
        if self.edition != Some(edition) {
            self.edition = Some(edition);
            let crosses = |&position: &usize| (pairs[position].i as usize) < first;
            self.positions.clear();
            self.positions.extend((0..pairs.len()).filter(crosses));
            self.present.reserve(self.positions.len());
        }
    }
    /// Note the forces of a block of pairs on earlier parts, and the torques if pairs exert any.
    #[inline(always)]
    pub fn note(
        &mut self,
        pairs: &[Pair],
        positions: Range<usize>,
        outputs: &Outputs<S>,
        has_torques: bool,
    ) {
        let next = self.positions.get(self.next);
        if next.is_some_and(|&position| position < positions.end) {
            self.note_block(pairs, positions, outputs, has_torques);
        }
    }

    #[cold]
    #[inline(never)]
    fn note_block(
        &mut self,
        pairs: &[Pair],
        positions: Range<usize>,
        outputs: &Outputs<S>,
        has_torques: bool,
    ) {
        while let Some(&position) = self.positions.get(self.next)
            && position < positions.end
        {
            self.next += 1;
            let lane = position - positions.start;
            if outputs.flags[lane] & IDLE == 0 {
                let [torque, _] = outputs.torques(lane);
                self.present.push(CrossPartForce {
                    particle: pairs[position].i,
                    force: outputs.force(lane),
                    torque: if has_torques { torque } else { S::zero() },
                });
            }
        }
    }

    /// Add what was noted to the sums of all particles.
    pub fn add_to(&self, sums: &mut Sums<S>) {
        for noted in &self.present {
            let particle = noted.particle as usize;
            sums.force[particle] += noted.force;
            sums.torque[particle] += noted.torque;
        }
    }
}
