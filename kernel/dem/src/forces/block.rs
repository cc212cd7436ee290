//! Links side by side: what a pass gathers from the particles, and what it scatters back to them.

use super::prefetch::ahead_of;
use super::{MISSING, Sums};
use crate::geometry::PairFrame;
use crate::particles::Particles;
use core::ops::Range;
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;
use gouge_common::parts::LINE;
use prefetch_index::prefetch_index;

/// How many links a block holds.
pub(crate) const LINKS: usize = 64;

/// The flag of a link that exerts nothing: a bond that breaks, a pair that does not touch.
pub(super) const IDLE: u64 = 1;
/// The flag of a link that is not what it seems, and is to be computed again.
pub(super) const IRREGULAR: u64 = 2;

/// What a law reads of the ends of links, besides their positions and velocities.
#[derive(Clone, Copy)]
pub(crate) struct Reads {
    pub angles: bool,
    pub spins: bool,
    pub radii: bool,
}

/// A link's part of the state of its particles.
#[derive(Clone, Copy)]
pub(crate) struct Ends<S> {
    /// Difference of the positions of j and i in m, before the nearest image is taken.
    pub difference: Vec2<S>,
    /// Velocity of j relative to i in m/s.
    pub velocity: Vec2<S>,
    /// Angles in rad.
    pub angles: [S; 2],
    /// Angular velocities in rad/s.
    pub spins: [S; 2],
    /// Radii in m.
    pub radii: [S; 2],
}

/// The columns of particles that links read, known to be equally long: one check serves all.
#[derive(Clone, Copy)]
pub(crate) struct Columns<'a, S> {
    position: &'a [Vec2<S>],
    velocity: &'a [Vec2<S>],
    angle: &'a [S],
    angular_velocity: &'a [S],
    radius: &'a [S],
}

impl<'a, S: Lanes> Columns<'a, S> {
    #[inline(always)]
    pub fn of(particles: &'a Particles<S>) -> Self {
        let number = particles.len();
        Self {
            position: &particles.position[..number],
            velocity: &particles.velocity[..number],
            angle: &particles.angle[..number],
            angular_velocity: &particles.angular_velocity[..number],
            radius: &particles.radius[..number],
        }
    }
    #[inline(always)]
    fn indices(&self, pair: Pair) -> (usize, usize) {
        let (i, j) = pair.indices();
        let number = self.position.len();
        assert!(i < number && j < number, "{MISSING}");
        (i, j)
    }
    /// The ends of a link between two particles.
    #[inline(always)]
    pub fn ends(&self, pair: Pair) -> Ends<S> {
        Ends {
            difference: vector(self.difference(pair)),
            velocity: vector(self.relative_velocity(pair)),
            angles: self.angles(pair),
            spins: self.spins(pair),
            radii: self.radii(pair),
        }
    }
    /// Prefetch what links read of a particle, and of its neighbours in the same lines of the cache.
    #[inline(always)]
    fn prefetch(&self, particle: usize, reads: Reads) {
        prefetch_index(self.position, particle);
        prefetch_index(self.velocity, particle);
        if reads.angles {
            prefetch_index(self.angle, particle);
        }
        if reads.spins {
            prefetch_index(self.angular_velocity, particle);
        }
        if reads.radii {
            prefetch_index(self.radius, particle);
        }
    }
    #[inline(always)]
    fn difference(&self, pair: Pair) -> [S; 2] {
        let (i, j) = self.indices(pair);
        difference(&self.position[j], &self.position[i])
    }
    #[inline(always)]
    fn relative_velocity(&self, pair: Pair) -> [S; 2] {
        let (i, j) = self.indices(pair);
        difference(&self.velocity[j], &self.velocity[i])
    }
    #[inline(always)]
    fn angles(&self, pair: Pair) -> [S; 2] {
        let (i, j) = self.indices(pair);
        [self.angle[i], self.angle[j]]
    }
    #[inline(always)]
    fn spins(&self, pair: Pair) -> [S; 2] {
        let (i, j) = self.indices(pair);
        [self.angular_velocity[i], self.angular_velocity[j]]
    }
    #[inline(always)]
    fn radii(&self, pair: Pair) -> [S; 2] {
        let (i, j) = self.indices(pair);
        [self.radius[i], self.radius[j]]
    }
}

/// Components of the difference of two vectors.
#[inline(always)]
fn difference<S: Lanes>(to: &Vec2<S>, from: &Vec2<S>) -> [S; 2] {
    S::differences([to.x, to.y], [from.x, from.y])
}

#[inline(always)]
fn vector<S: Lanes>([x, y]: [S; 2]) -> Vec2<S> {
    Vec2::new(x, y)
}

/// Where the blocks of consecutive links begin and end, the first of them at a position among all: blocks begin
/// where lines of columns do, but for the first one.
pub(super) fn blocks(first: usize, number: usize) -> impl Iterator<Item = Range<usize>> {
    let before = first % LINKS;
    (0..before + number)
        .step_by(LINKS)
        .map(move |begin| begin.saturating_sub(before)..number.min(begin + LINKS - before))
}

/// What links read, as columns: one instruction serves several of them.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Inputs<S> {
    difference: [[S; LINKS]; 2],
    velocity: [[S; LINKS]; 2],
    angles: [[S; LINKS]; 2],
    spins: [[S; LINKS]; 2],
    radii: [[S; LINKS]; 2],
}

/// Frames of links, as columns.
///
/// They are found in a loop of their own: a root and a quotient take long, and while the law waits for them
/// too few links are under way.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Frames<S> {
    normal: [[S; LINKS]; 2],
    /// Distance, and its inverse.
    distances: [[S; LINKS]; 2],
}

/// What links do, as columns.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Outputs<S> {
    /// Force on i in N.
    pub force: [[S; LINKS]; 2],
    /// Torques on both ends in N m.
    pub torques: [[S; LINKS]; 2],
    /// Power turned into heat in W.
    pub heat_rate: [S; LINKS],
    /// Energy turned into heat at once in J.
    pub heat: [S; LINKS],
    /// What the contact remembers from now on, where it changes step by step.
    pub rest: [[S; LINKS]; 2],
    pub state: [S; LINKS],
    /// What needs a second look.
    pub flags: [u64; LINKS],
}

/// A block of links. Inputs and outputs lie apart, so that no result can be the input of a later link. Each begins
/// at a line of the cache, as every column in it then does.
#[derive(Clone, Debug, Default)]
pub(crate) struct Block<S: Lanes> {
    pub inputs: Box<Inputs<S>>,
    pub frames: Box<Frames<S>>,
    pub outputs: Box<Outputs<S>>,
}

impl<S: Lanes> Block<S> {
    /// Gather the ends of the links at some positions. Where there are sums, prefetch what later links need, and
    /// by `prefetch` what these keep, from a position on.
    #[inline(always)]
    pub fn gather(
        &mut self,
        columns: Columns<S>,
        (pairs, links): (&[Pair], Range<usize>),
        reads: Reads,
        sums: Option<&Sums<S>>,
        prefetch: impl Fn(usize),
    ) {
        let now = &pairs[links.clone()];
        let Some(sums) = sums else {
            return self.inputs.gather(columns, now, reads, |_| {});
        };
        self.inputs.gather(columns, now, reads, |lane| {
            if let Some((link, particle)) = ahead_of(pairs, links.start + lane) {
                prefetch_index(pairs, link + LINKS);
                prefetch(link);
                columns.prefetch(particle, reads);
                sums.prefetch(particle, reads.spins);
            }
        });
    }

    /// What laws read of the first links, their frames found, and where laws write.
    #[inline(always)]
    pub fn open<M: Metric>(
        &mut self,
        metric: M,
        number: usize,
    ) -> (&Inputs<S>, &Frames<S>, &mut Outputs<S>) {
        self.frames.find(metric, &self.inputs, number);
        (&self.inputs, &self.frames, &mut self.outputs)
    }
}

impl<S: Lanes> Default for Inputs<S> {
    fn default() -> Self {
        let zeros = [[S::zero(); LINKS]; 2];
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
        let zeros = [[S::zero(); LINKS]; 2];
        Self {
            normal: zeros,
            distances: zeros,
        }
    }
}

impl<S: Lanes> Default for Outputs<S> {
    fn default() -> Self {
        Self {
            force: [[S::zero(); LINKS]; 2],
            torques: [[S::zero(); LINKS]; 2],
            heat_rate: [S::zero(); LINKS],
            heat: [S::zero(); LINKS],
            rest: [[S::zero(); LINKS]; 2],
            state: [S::zero(); LINKS],
            flags: [0; LINKS],
        }
    }
}

#[inline(always)]
fn put<S>(columns: &mut [[S; LINKS]; 2], lane: usize, [first, second]: [S; 2]) {
    columns[0][lane] = first;
    columns[1][lane] = second;
}

/// Put down two numbers of each of two links, so that one store serves both links.
#[inline(always)]
fn put_two<S: Lanes>(columns: &mut [[S; LINKS]; 2], two: usize, numbers: [[S; 2]; 2]) {
    let [firsts, seconds] = S::transposed(numbers);
    columns[0].as_chunks_mut().0[two] = firsts;
    columns[1].as_chunks_mut().0[two] = seconds;
}

#[inline(always)]
fn taken<S: Copy>(columns: &[[S; LINKS]; 2], lane: usize) -> [S; 2] {
    [columns[0][lane], columns[1][lane]]
}

impl<S: Lanes> Inputs<S> {
    /// Gather the ends of at most a block of links; the rest keeps old values. `beside` is done with every
    /// eighth of them.
    #[inline(always)]
    fn gather(
        &mut self,
        columns: Columns<S>,
        pairs: &[Pair],
        reads: Reads,
        beside: impl Fn(usize),
    ) {
        let (twos, rest) = pairs.as_chunks();
        for (two, &pairs) in (0..LINKS / 2).zip(twos) {
            if two % (LINE / 2) == 0 {
                beside(2 * two);
            }
            self.gather_two(two, columns, pairs, reads);
        }
        if let &[last] = rest {
            self.gather_two(twos.len(), columns, [last; 2], reads);
        }
    }
    /// Gather the ends of two links, those in the given place of all twos.
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
    /// Find the frames of the first links of a block.
    #[inline(always)]
    pub fn find<M: Metric>(&mut self, metric: M, inputs: &Inputs<S>, number: usize) {
        for lane in 0..number.min(LINKS) {
            let difference = vector(taken(&inputs.difference, lane));
            let frame = PairFrame::new(metric.nearest(difference));
            put(&mut self.normal, lane, [frame.normal.x, frame.normal.y]);
            let distances = [frame.distance, frame.inverse_distance];
            put(&mut self.distances, lane, distances);
        }
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
    /// Put down the force on i in N.
    #[inline(always)]
    pub fn set_force(&mut self, lane: usize, force: Vec2<S>) {
        put(&mut self.force, lane, [force.x, force.y]);
    }
    /// Put down the torques on both ends in N m.
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
