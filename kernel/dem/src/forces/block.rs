//! A block of pairs that are computed together with vector instructions.

use super::ends::{Columns, Ends, Reads, vector};
use super::prefetch::{BLOCKS_AHEAD, needed_at};
use super::sums::Sums;
use crate::geometry::PairFrame;
use core::ops::Range;
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;
use gouge_common::parts::NUMBERS_PER_LINE;
use prefetch_index::prefetch_index;

/// Number of pairs in a block.
pub(super) const PAIRS: usize = 64;

/// Flag of a pair without force: a bond that breaks, or particles that do not touch.
pub(super) const IDLE: u64 = 1;
/// Flag of a pair that the regular path does not cover; it is recomputed by the general path.
pub(super) const IRREGULAR: u64 = 2;

/// Ranges of the blocks of consecutive pairs; `first` is the index of the first pair among all pairs.
///
/// All blocks except the first one begin at cache lines of the columns.
pub(super) fn blocks(first: usize, number: usize) -> impl Iterator<Item = Range<usize>> {
    let before = first % PAIRS;
    (0..before + number)
        .step_by(PAIRS)
        .map(move |begin| begin.saturating_sub(before)..number.min(begin + PAIRS - before))
}

/// Input of a block: particle data of its pairs, as columns for vector instructions.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Inputs<S> {
    difference: [[S; PAIRS]; 2],
    velocity: [[S; PAIRS]; 2],
    angles: [[S; PAIRS]; 2],
    spins: [[S; PAIRS]; 2],
    radii: [[S; PAIRS]; 2],
    reduced_masses: [S; PAIRS],
}

/// Pair frames of a block, as columns.
///
/// They are computed in a loop of their own. Square root and division have a long latency, and a loop that also
/// evaluates the laws has too few pairs in flight to hide it.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Frames<S> {
    normal: [[S; PAIRS]; 2],
    /// Distance in m, and its inverse in 1/m.
    distances: [[S; PAIRS]; 2],
}

/// Forces of a block, as columns.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Outputs<S> {
    /// Force on i in N.
    pub force: [[S; PAIRS]; 2],
    /// Torques on both ends in N m.
    pub torques: [[S; PAIRS]; 2],
    /// Continuous heat production in W.
    pub heat_rate: [S; PAIRS],
    /// Heat released instantaneously, in J.
    pub heat: [S; PAIRS],
    /// New values of [`ContactMemory::ends`](crate::contacts::ContactMemory::ends), for lever arms that accumulate.
    pub memory_ends: [[S; PAIRS]; 2],
    /// New values of [`ContactMemory::state`](crate::contacts::ContactMemory::state).
    pub memory_state: [S; PAIRS],
    /// Union of [`IDLE`] and [`IRREGULAR`].
    pub flags: [u64; PAIRS],
}

/// A block of pairs.
///
/// Inputs and outputs are separate allocations, so that the compiler knows that no output is the input of a later
/// pair. Each allocation begins at a cache line, and so does every column in it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Block<S: Lanes> {
    pub inputs: Box<Inputs<S>>,
    pub frames: Box<Frames<S>>,
    pub outputs: Box<Outputs<S>>,
}

impl<S: Lanes> Block<S> {
    /// Gather the particle data of the pairs in a range of indices.
    ///
    /// If `sums` is given, prefetch the particle data and force sums for later pairs, and call `prefetch` with the
    /// index from which these pairs need their own data.
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

    /// Compute the frames of the first `number` pairs. Returns the inputs of the laws and their outputs.
    #[inline(always)]
    pub fn with_frames<M: Metric>(
        &mut self,
        metric: M,
        number: usize,
    ) -> (&Inputs<S>, &Frames<S>, &mut Outputs<S>) {
        if S::IS_WIDE {
            self.frames.compute(metric, &self.inputs, number);
        } else {
            self.frames
                .compute_out_of_line(metric, &self.inputs, number);
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
            reduced_masses: [S::zero(); PAIRS],
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
            memory_ends: [[S::zero(); PAIRS]; 2],
            memory_state: [S::zero(); PAIRS],
            flags: [0; PAIRS],
        }
    }
}

#[inline(always)]
fn set<S>(columns: &mut [[S; PAIRS]; 2], lane: usize, [first, second]: [S; 2]) {
    columns[0][lane] = first;
    columns[1][lane] = second;
}

/// Write two numbers for each of two pairs, so that one store serves both pairs.
#[inline(always)]
fn set_two<S: Lanes>(columns: &mut [[S; PAIRS]; 2], two: usize, numbers: [[S; 2]; 2]) {
    let [firsts, seconds] = S::transposed(numbers);
    columns[0].as_chunks_mut().0[two] = firsts;
    columns[1].as_chunks_mut().0[two] = seconds;
}

#[inline(always)]
fn get<S: Copy>(columns: &[[S; PAIRS]; 2], lane: usize) -> [S; 2] {
    [columns[0][lane], columns[1][lane]]
}

impl<S: Lanes> Inputs<S> {
    /// Gather the particle data of at most one block of pairs. Other lanes keep old values.
    ///
    /// `beside` is called once per eight pairs.
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
            if two % (NUMBERS_PER_LINE / 2) == 0 {
                beside(2 * two);
            }
            self.gather_two(two, columns, pairs, reads);
        }
        if let &[last] = rest {
            self.gather_two(twos.len(), columns, [last; 2], reads);
        }
    }
    /// The same without anything beside, as one function for all laws.
    #[inline(never)]
    fn gather_out_of_line(&mut self, columns: Columns<S>, pairs: &[Pair], reads: Reads) {
        self.gather(columns, pairs, reads, |_| {});
    }
    /// Gather the particle data of two pairs into two lanes.
    #[inline(always)]
    fn gather_two(&mut self, two: usize, columns: Columns<S>, pairs: [Pair; 2], reads: Reads) {
        let [a, b] = pairs;
        set_two(
            &mut self.difference,
            two,
            [columns.difference(a), columns.difference(b)],
        );
        let velocities = [columns.relative_velocity(a), columns.relative_velocity(b)];
        set_two(&mut self.velocity, two, velocities);
        if reads.radii {
            set_two(&mut self.radii, two, [columns.radii(a), columns.radii(b)]);
        }
        if reads.masses {
            let masses = [columns.reduced_mass(a), columns.reduced_mass(b)];
            self.reduced_masses.as_chunks_mut().0[two] = masses;
        }
        if reads.angles {
            set_two(
                &mut self.angles,
                two,
                [columns.angles(a), columns.angles(b)],
            );
        }
        if reads.spins {
            set_two(&mut self.spins, two, [columns.spins(a), columns.spins(b)]);
        }
    }
    #[inline(always)]
    pub fn ends(&self, lane: usize) -> Ends<S> {
        Ends {
            difference: vector(get(&self.difference, lane)),
            velocity: vector(get(&self.velocity, lane)),
            angles: get(&self.angles, lane),
            spins: get(&self.spins, lane),
            radii: get(&self.radii, lane),
            reduced_mass: self.reduced_masses[lane],
        }
    }
}

impl<S: Lanes> Frames<S> {
    /// Compute the frames of the first `number` pairs.
    #[inline(always)]
    pub fn compute<M: Metric>(&mut self, metric: M, inputs: &Inputs<S>, number: usize) {
        for lane in 0..number.min(PAIRS) {
            let difference = vector(get(&inputs.difference, lane));
            let frame = PairFrame::new(metric.nearest(difference));
            set(&mut self.normal, lane, [frame.normal.x, frame.normal.y]);
            let distances = [frame.distance, frame.inverse_distance];
            set(&mut self.distances, lane, distances);
        }
    }
    /// The same, as one function for all laws.
    #[inline(never)]
    fn compute_out_of_line<M: Metric>(&mut self, metric: M, inputs: &Inputs<S>, number: usize) {
        self.compute(metric, inputs, number);
    }
    #[inline(always)]
    pub fn at(&self, lane: usize) -> PairFrame<S> {
        let [distance, inverse_distance] = get(&self.distances, lane);
        PairFrame {
            distance,
            inverse_distance,
            normal: vector(get(&self.normal, lane)),
        }
    }
}

impl<S: Lanes> Outputs<S> {
    /// Set the force on i in N.
    #[inline(always)]
    pub fn set_force(&mut self, lane: usize, force: Vec2<S>) {
        set(&mut self.force, lane, [force.x, force.y]);
    }
    /// Set the torques on both ends in N m.
    #[inline(always)]
    pub fn set_torques(&mut self, lane: usize, torques: [S; 2]) {
        set(&mut self.torques, lane, torques);
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
