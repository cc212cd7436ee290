//! Forces of the pairs of a part on particles of earlier parts.

use super::block::{IDLE, Outputs};
use super::sums::Sums;
use crate::pairs::ListVersion;
use core::ops::Range;
use gouge_common::geometry::Vec2;
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;

/// Force of a pair on its first particle, if that particle belongs to an earlier part.
#[derive(Clone, Debug)]
struct CrossPartForce<S> {
    /// The first particle.
    particle: u32,
    /// Force on it in N.
    force: Vec2<S>,
    /// Torque on it in N m; zero if pairs exert no torques.
    torque: S,
}

/// The pairs of a part whose first particle belongs to an earlier part, and their forces on that particle.
///
/// A pair belongs to the part of its second particle, and pairs are sorted by second particle. In a single loop
/// these forces would therefore be added after all other forces on the first particle. Adding them when all parts
/// are finished gives the same sums.
#[derive(Clone, Debug, Default)]
pub(crate) struct CrossPartForces<S> {
    /// Version of the pair list in which these pairs were searched.
    list_version: Option<ListVersion>,
    /// Indices of these pairs among the pairs of the part.
    positions: Vec<usize>,
    /// How many of these pairs the present evaluation has passed.
    next: usize,
    forces: Vec<CrossPartForce<S>>,
}

impl<S: Lanes> CrossPartForces<S> {
    /// Begin an evaluation. If the pair list has changed, search the pairs whose first particle precedes the part.
    pub fn begin(&mut self, list_version: ListVersion, pairs: &[Pair], first: usize) {
        self.forces.clear();
        self.next = 0;
        if self.list_version != Some(list_version) {
            self.list_version = Some(list_version);
            let crosses = |&position: &usize| (pairs[position].i as usize) < first;
            self.positions.clear();
            self.positions.extend((0..pairs.len()).filter(crosses));
            self.forces.reserve(self.positions.len());
        }
    }
    /// Collect the forces of a block on earlier parts, and the torques if pairs exert any.
    #[inline(always)]
    pub fn collect(
        &mut self,
        pairs: &[Pair],
        positions: Range<usize>,
        outputs: &Outputs<S>,
        has_torques: bool,
    ) {
        let next = self.positions.get(self.next);
        if next.is_some_and(|&position| position < positions.end) {
            self.collect_block(pairs, positions, outputs, has_torques);
        }
    }

    #[cold]
    #[inline(never)]
    fn collect_block(
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
                self.forces.push(CrossPartForce {
                    particle: pairs[position].i,
                    force: outputs.force(lane),
                    torque: if has_torques { torque } else { S::zero() },
                });
            }
        }
    }

    /// Add the collected forces and torques to the sums of all particles.
    pub fn add_to(&self, sums: &mut Sums<S>) {
        for collected in &self.forces {
            let particle = collected.particle as usize;
            sums.force[particle] += collected.force;
            sums.torque[particle] += collected.torque;
        }
    }
}
