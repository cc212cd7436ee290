//! What pairs read of their particles.

use super::sums::MISSING;
use crate::particles::Particles;
use gouge_common::geometry::Vec2;
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;
use prefetch_index::prefetch_index;

/// What a law reads of both particles of a pair, besides their positions and velocities.
#[derive(Clone, Copy)]
pub(crate) struct Reads {
    pub angles: bool,
    pub spins: bool,
    pub radii: bool,
}

/// What a pair reads of its particles.
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

/// The columns of particles that pairs read, known to be equally long: one bounds check serves all.
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
    /// What a pair reads.
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
    /// Prefetch what pairs read of a particle, and of its neighbours in the same cache lines.
    #[inline(always)]
    pub fn prefetch(&self, particle: usize, reads: Reads) {
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
    pub fn difference(&self, pair: Pair) -> [S; 2] {
        let (i, j) = self.indices(pair);
        difference(&self.position[j], &self.position[i])
    }
    #[inline(always)]
    pub fn relative_velocity(&self, pair: Pair) -> [S; 2] {
        let (i, j) = self.indices(pair);
        difference(&self.velocity[j], &self.velocity[i])
    }
    #[inline(always)]
    pub fn angles(&self, pair: Pair) -> [S; 2] {
        let (i, j) = self.indices(pair);
        [self.angle[i], self.angle[j]]
    }
    #[inline(always)]
    pub fn spins(&self, pair: Pair) -> [S; 2] {
        let (i, j) = self.indices(pair);
        [self.angular_velocity[i], self.angular_velocity[j]]
    }
    #[inline(always)]
    pub fn radii(&self, pair: Pair) -> [S; 2] {
        let (i, j) = self.indices(pair);
        [self.radius[i], self.radius[j]]
    }
}

/// Components of the difference of two vectors.
#[inline(always)]
fn difference<S: Lanes>(to: &Vec2<S>, from: &Vec2<S>) -> [S; 2] {
    S::differences([to.x, to.y], [from.x, from.y])
}

/// A vector of its components.
#[inline(always)]
pub(super) fn vector<S: Lanes>([x, y]: [S; 2]) -> Vec2<S> {
    Vec2::new(x, y)
}
