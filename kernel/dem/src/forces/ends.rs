//! Particle data that pairs read.

use super::sums::MISSING;
use crate::particles::Particles;
use gouge_common::geometry::Vec2;
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;
use gouge_common::scalar::Real;
use prefetch_index::prefetch_index;

/// Which particle data the laws read, besides positions and velocities.
#[derive(Clone, Copy)]
pub(crate) struct Reads {
    pub angles: bool,
    pub spins: bool,
    pub radii: bool,
    pub masses: bool,
}

/// Data of the two particles of a pair.
#[derive(Clone, Copy)]
pub(crate) struct Ends<S> {
    /// Position of j minus position of i in m, not yet that of the nearest image.
    pub difference: Vec2<S>,
    /// Velocity of j relative to i in m/s.
    pub velocity: Vec2<S>,
    /// Angles in rad.
    pub angles: [S; 2],
    /// Angular velocities in rad/s.
    pub spins: [S; 2],
    /// Radii in m.
    pub radii: [S; 2],
    /// Reduced mass in kg; zero if forces can move neither particle.
    pub reduced_mass: S,
}

/// Particles, and how forces move them.
pub(crate) struct Bodies<'a, S> {
    pub particles: &'a Particles<S>,
    /// Inverse masses in 1/kg, zero for particles that forces cannot move.
    pub inverse_mass: &'a [S],
}

impl<S> Clone for Bodies<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<S> Copy for Bodies<'_, S> {}

/// Reduced mass in kg of two particles with inverse masses in 1/kg; zero if forces can move neither.
#[inline(always)]
pub(crate) fn reduced_mass<S: Real>(inverse_masses: [S; 2]) -> S {
    let sum = inverse_masses[0] + inverse_masses[1];
    if sum > S::zero() {
        S::from_f64(1.0) / sum
    } else {
        S::zero()
    }
}

/// The columns of particles that pairs read, all cut to the same length so that one bounds check serves all.
#[derive(Clone, Copy)]
pub(crate) struct Columns<'a, S> {
    position: &'a [Vec2<S>],
    velocity: &'a [Vec2<S>],
    angle: &'a [S],
    angular_velocity: &'a [S],
    radius: &'a [S],
    inverse_mass: &'a [S],
}

impl<'a, S: Lanes> Columns<'a, S> {
    #[inline(always)]
    pub fn of(bodies: Bodies<'a, S>) -> Self {
        let particles = bodies.particles;
        let number = particles.len();
        Self {
            inverse_mass: &bodies.inverse_mass[..number],
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
    /// Data of the two particles of a pair.
    #[inline(always)]
    pub fn ends(&self, pair: Pair) -> Ends<S> {
        Ends {
            difference: vector(self.difference(pair)),
            velocity: vector(self.relative_velocity(pair)),
            angles: self.angles(pair),
            spins: self.spins(pair),
            radii: self.radii(pair),
            reduced_mass: self.reduced_mass(pair),
        }
    }
    /// Prefetch the data of a particle, and of other particles in the same cache lines.
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
        if reads.masses {
            prefetch_index(self.inverse_mass, particle);
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
    #[inline(always)]
    pub fn reduced_mass(&self, pair: Pair) -> S {
        let (i, j) = self.indices(pair);
        reduced_mass([self.inverse_mass[i], self.inverse_mass[j]])
    }
}

/// Components of the difference of two vectors, `to` minus `from`.
#[inline(always)]
fn difference<S: Lanes>(to: &Vec2<S>, from: &Vec2<S>) -> [S; 2] {
    S::differences([to.x, to.y], [from.x, from.y])
}

/// The vector with the given components.
#[inline(always)]
pub(super) fn vector<S: Lanes>([x, y]: [S; 2]) -> Vec2<S> {
    Vec2::new(x, y)
}
