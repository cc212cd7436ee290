//! A block of pairs that are computed together, with wide instructions.

use super::ends::{Columns, Ends, Reads, vector};
use super::prefetch::{BLOCKS_AHEAD, needed_at};
use super::sums::Sums;
use crate::geometry::PairFrame;
use core::ops::Range;
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;
use gouge_common::parts::LINE;
use prefetch_index::prefetch_index;

/// Number of pairs in a block.
pub(super) const PAIRS: usize = 64;

/// Flag of a pair that exerts nothing: a bond that breaks, particles that do not touch.
pub(super) const IDLE: u64 = 1;
/// Flag of a pair for which the short way does not hold; it is computed again in full.
pub(super) const IRREGULAR: u64 = 2;

/// The blocks of consecutive pairs, the first of which is at the position `first` among all. Except for the
/// first one, blocks begin at cache lines of the columns.
pub(super) fn blocks(first: usize, number: usize) -> impl Iterator<Item = Range<usize>> {
    let before = first % PAIRS;
    (0..before + number)
        .step_by(PAIRS)
        .map(move |begin| begin.saturating_sub(before)..number.min(begin + PAIRS - before))
}

/// What pairs read, as columns: one instruction serves several pairs.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Inputs<S> {
    difference: [[S; PAIRS]; 2],
    velocity: [[S; PAIRS]; 2],
    angles: [[S; PAIRS]; 2],
    spins: [[S; PAIRS]; 2],
    radii: [[S; PAIRS]; 2],
}

/// Frames of pairs, as columns.
///
/// They are found in a loop of their own: a root and a quotient have a long latency, and a loop that also
/// evaluates the law keeps too few pairs in flight to hide it.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Frames<S> {
    normal: [[S; PAIRS]; 2],
    /// Distance, and its inverse.
    distances: [[S; PAIRS]; 2],
}

/// Forces of pairs, as columns.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Outputs<S> {
    /// Force on i in N.
    pub force: [[S; PAIRS]; 2],
    /// Torques on both ends in N m.
    pub torques: [[S; PAIRS]; 2],
    /// Power turned into heat in W.
    pub heat_rate: [S; PAIRS],
    /// Energy turned into heat at once in J.
    pub heat: [S; PAIRS],
    /// What the contact remembers from now on, where it changes step by step.
    pub rest: [[S; PAIRS]; 2],
    pub state: [S; PAIRS],
    /// [`IDLE`] and [`IRREGULAR`].
    pub flags: [u64; PAIRS],
}

/// A block of pairs. Inputs and outputs are separate allocations, so that the compiler knows that no result is
/// the input of a later pair. Each begins at a cache line, and so does every column in it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Block<S: Lanes> {
    pub inputs: Box<Inputs<S>>,
    pub frames: Box<Frames<S>>,
    pub outputs: Box<Outputs<S>>,
}

impl<S: Lanes> Block<S> {
    /// Gather what the pairs at some positions read. If sums are given, prefetch what later pairs read and add to,
    /// and call `prefetch` with the position from which on these pairs keep something.
    #[inline(always)]
    pub fn gather(
        &mut self,
        columns: Columns<S>,
        (pairs, positions): (&[Pair], Range<usize>),
        reads: Reads,
        sums: Option<&Sums<S>>,
        prefetch: impl Fn(usize),
    ) {
        let now = &pairs[positions.clone()];
        if !S::IS_WIDE {
            return self.inputs.gather_out_of_line(columns, now, reads);
        }
        let Some(sums) = sums else {
            return self.inputs.gather(columns, now, reads, |_| {});
        };
        self.inputs.gather(columns, now, reads, |lane| {
            let position = positions.start + lane + BLOCKS_AHEAD * PAIRS;
            if let Some(particle) = needed_at(pairs, position) {
                prefetch_index(pairs, position + PAIRS);
                prefetch(position);
                columns.prefetch(particle, reads);
                sums.prefetch(particle, reads.spins);
            }
        });
    }

    /// Find the frames of the first pairs; returns what laws read and where they write.
    #[inline(always)]
    pub fn with_frames<M: Metric>(
        &mut self,
        metric: M,
        number: usize,
    ) -> (&Inputs<S>, &Frames<S>, &mut Outputs<S>) {
        if S::IS_WIDE {
            self.frames.find(metric, &self.inputs, number);
        } else {
            self.frames.find_out_of_line(metric, &self.inputs, number);
        }
        (&self.inputs, &self.frames, &mut self.outputs)
    }
}

impl<S: Lanes> Default for Inputs<S> {
    fn default() -> Self {
        let zeros = [[S::zero(); PAIRS]; 2];
        Self {
            difference: zeros,
            velocity: zeros,
            angles: zeros,
            spins: zeros,
            radii: zeros,
        }
    }
}

impl<S: Lanes> Default for Frames<S> {
    fn default() -> Self {
        let zeros = [[S::zero(); PAIRS]; 2];
        Self {
            normal: zeros,
            distances: zeros,
        }
    }
}

impl<S: Lanes> Default for Outputs<S> {
    fn default() -> Self {
        Self {
            force: [[S::zero(); PAIRS]; 2],
            torques: [[S::zero(); PAIRS]; 2],
            heat_rate: [S::zero(); PAIRS],
            heat: [S::zero(); PAIRS],
            rest: [[S::zero(); PAIRS]; 2],
            state: [S::zero(); PAIRS],
            flags: [0; PAIRS],
        }
    }
}

#[inline(always)]
fn put<S>(columns: &mut [[S; PAIRS]; 2], lane: usize, [first, second]: [S; 2]) {
    columns[0][lane] = first;
    columns[1][lane] = second;
}

/// Write two numbers of each of two pairs, so that one store serves both pairs.
#[inline(always)]
fn put_two<S: Lanes>(columns: &mut [[S; PAIRS]; 2], two: usize, numbers: [[S; 2]; 2]) {
    let [firsts, seconds] = S::transposed(numbers);
    columns[0].as_chunks_mut().0[two] = firsts;
    columns[1].as_chunks_mut().0[two] = seconds;
}

#[inline(always)]
fn taken<S: Copy>(columns: &[[S; PAIRS]; 2], lane: usize) -> [S; 2] {
    [columns[0][lane], columns[1][lane]]
}

impl<S: Lanes> Inputs<S> {
    /// Gather what at most a block of pairs reads; the other lanes keep old values. `beside` is called once per
    /// eight pairs.
    #[inline(always)]
    fn gather(
        &mut self,
        columns: Columns<S>,
        pairs: &[Pair],
        reads: Reads,
        beside: impl Fn(usize),
    ) {
        let (twos, rest) = pairs.as_chunks();
        for (two, &pairs) in (0..PAIRS / 2).zip(twos) {
            if two % (LINE / 2) == 0 {
                beside(2 * two);
            }
            self.gather_two(two, columns, pairs, reads);
        }
        if let &[last] = rest {
            self.gather_two(twos.len(), columns, [last; 2], reads);
        }
    }
    /// The same without anything beside, compiled once.
    #[inline(never)]
    fn gather_out_of_line(&mut self, columns: Columns<S>, pairs: &[Pair], reads: Reads) {
        self.gather(columns, pairs, reads, |_| {});
    }
    /// Gather what two pairs read, into the given pair of lanes.
    #[inline(always)]
    fn gather_two(&mut self, two: usize, columns: Columns<S>, pairs: [Pair; 2], reads: Reads) {
        let [a, b] = pairs;
        put_two(
            &mut self.difference,
            two,
            [columns.difference(a), columns.difference(b)],
        );
        let velocities = [columns.relative_velocity(a), columns.relative_velocity(b)];
        put_two(&mut self.velocity, two, velocities);
        if reads.radii {
            put_two(&mut self.radii, two, [columns.radii(a), columns.radii(b)]);
        }
        if reads.angles {
            put_two(
                &mut self.angles,
                two,
                [columns.angles(a), columns.angles(b)],
            );
        }
        if reads.spins {
            put_two(&mut self.spins, two, [columns.spins(a), columns.spins(b)]);
        }
    }
    #[inline(always)]
    pub fn ends(&self, lane: usize) -> Ends<S> {
        Ends {
            difference: vector(taken(&self.difference, lane)),
            velocity: vector(taken(&self.velocity, lane)),
            angles: taken(&self.angles, lane),
            spins: taken(&self.spins, lane),
            radii: taken(&self.radii, lane),
        }
    }
}

impl<S: Lanes> Frames<S> {
    /// Find the frames of the first pairs of a block.
    #[inline(always)]
    pub fn find<M: Metric>(&mut self, metric: M, inputs: &Inputs<S>, number: usize) {
        for lane in 0..number.min(PAIRS) {
            let difference = vector(taken(&inputs.difference, lane));
            let frame = PairFrame::new(metric.nearest(difference));
            put(&mut self.normal, lane, [frame.normal.x, frame.normal.y]);
            let distances = [frame.distance, frame.inverse_distance];
            put(&mut self.distances, lane, distances);
        }
    }
    /// The same, compiled once per metric.
    #[inline(never)]
    fn find_out_of_line<M: Metric>(&mut self, metric: M, inputs: &Inputs<S>, number: usize) {
        self.find(metric, inputs, number);
    }
    #[inline(always)]
    pub fn at(&self, lane: usize) -> PairFrame<S> {
        let [distance, inverse_distance] = taken(&self.distances, lane);
        PairFrame {
            distance,
            inverse_distance,
            normal: vector(taken(&self.normal, lane)),
        }
    }
}

impl<S: Lanes> Outputs<S> {
    /// Write the force on i in N.
    #[inline(always)]
    pub fn set_force(&mut self, lane: usize, force: Vec2<S>) {
        put(&mut self.force, lane, [force.x, force.y]);
    }
    /// Write the torques on both ends in N m.
    #[inline(always)]
    pub fn set_torques(&mut self, lane: usize, torques: [S; 2]) {
        put(&mut self.torques, lane, torques);
    }
    #[inline(always)]
    pub fn force(&self, lane: usize) -> Vec2<S> {
        Vec2::new(self.force[0][lane], self.force[1][lane])
    }
    #[inline(always)]
    pub fn torques(&self, lane: usize) -> [S; 2] {
        [self.torques[0][lane], self.torques[1][lane]]
    }
}
