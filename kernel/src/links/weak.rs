//! Weak links: contacts that begin and end with overlap, and what they remember.

use super::strong::{check_pairs, rest_angles};
use super::{Neighbors, Pair, StrongLinks};
use crate::error::ModelError;
use crate::geometry::{Metric, PairFrame, Vec2};
use crate::particles::Particles;
use crate::scalar::Real;

/// What a scene says of a contact that began before its initial state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactStart {
    /// The two particles.
    pub between: [usize; 2],
    /// Angles of both ends in the pair frame when the contact began, thesis eq. (30), in rad.
    pub initial_angles: [f64; 2],
}

/// What a contact remembers of its beginning.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactMemory<S> {
    /// Whether the pair touches; the rest has no meaning otherwise.
    pub touches: bool,
    /// Direction of the pair frame from which its turn is measured.
    pub reference: Vec2<S>,
    /// Angles of both particles at which the tangential displacement is zero, while the frame points
    /// along `reference`; for arms that accumulate, the displacements of both ends so far, in m.
    pub ends: [S; 2],
    /// The number that the tangential law remembers.
    pub state: S,
}

impl<S: Real> ContactMemory<S> {
    /// A contact that begins in the given frame, with the given entries of both ends.
    #[inline]
    pub(crate) fn begin(frame: &PairFrame<S>, ends: [S; 2]) -> Self {
        Self {
            touches: true,
            reference: frame.normal,
            ends,
            state: S::zero(),
        }
    }
}

/// Room for pairs a particle, so that rebuilding allocates nothing: three contacts, half of the
/// kissing number, and some within the margin.
const PAIRS_A_PARTICLE: usize = 5;

/// The pairs that may touch, in order, and their memory where a law asks for it.
#[derive(Clone, Debug)]
pub struct WeakLinks<S> {
    /// Pairs near enough to touch before the next rebuild, without the bonded ones.
    pub pairs: Vec<Pair>,
    /// One memory a pair, or none at all.
    pub memory: Vec<ContactMemory<S>>,
    remembers: bool,
    neighbors: Neighbors<S>,
    old_pairs: Vec<Pair>,
    old_memory: Vec<ContactMemory<S>>,
}

impl<S: Real> WeakLinks<S> {
    /// An empty list, to be filled by the first [`rebuild`](Self::rebuild).
    pub fn new(neighbors: Neighbors<S>, particles: usize, remembers: bool) -> Self {
        let pairs = PAIRS_A_PARTICLE * particles;
        let memories = if remembers { pairs } else { 0 };
        Self {
            pairs: Vec::with_capacity(pairs),
            memory: Vec::with_capacity(memories),
            remembers,
            neighbors,
            old_pairs: Vec::with_capacity(pairs),
            old_memory: Vec::with_capacity(memories),
        }
    }

    /// The neighbour list behind the pairs.
    pub fn neighbors(&self) -> &Neighbors<S> {
        &self.neighbors
    }

    /// Find the pairs anew; memories of touching pairs are kept.
    pub fn rebuild<M: Metric>(
        &mut self,
        metric: M,
        particles: &Particles<S>,
        strong: Option<&StrongLinks<S>>,
    ) {
        std::mem::swap(&mut self.pairs, &mut self.old_pairs);
        std::mem::swap(&mut self.memory, &mut self.old_memory);
        self.neighbors.rebuild(metric, particles, &mut self.pairs);
        if let Some(strong) = strong {
            remove_bonded(&mut self.pairs, strong);
        }
        if self.remembers {
            self.carry_memory_over();
        }
    }

    /// Give the new pairs the memory of the old ones; a touching pair is kept even if it has left the
    /// margin, so that its end is seen whenever the list happens to be rebuilt.
    fn carry_memory_over(&mut self) {
        self.memory.clear();
        self.memory
            .resize(self.pairs.len(), ContactMemory::default());
        for (pair, memory) in self.old_pairs.iter().zip(&self.old_memory) {
            if !memory.touches {
                continue;
            }
            match self.pairs.binary_search(pair) {
                Ok(at) => self.memory[at] = *memory,
                Err(at) => {
                    self.pairs.insert(at, *pair);
                    self.memory.insert(at, *memory);
                }
            }
        }
    }

    /// Let the pairs of broken bonds touch.
    pub(crate) fn admit_broken(&mut self, strong: &StrongLinks<S>) {
        for &position in &strong.broken {
            let pair = strong.links[position as usize].pair;
            if let Err(at) = self.pairs.binary_search(&pair) {
                self.pairs.insert(at, pair);
                if self.remembers {
                    self.memory.insert(at, ContactMemory::default());
                }
            }
        }
    }

    /// Give contacts the memory that the scene states.
    ///
    /// # Errors
    /// Pairs that do not exist, repeat, or do not overlap.
    pub fn remember<M: Metric>(
        &mut self,
        metric: M,
        particles: &Particles<S>,
        starts: &[ContactStart],
    ) -> Result<(), ModelError> {
        check_pairs(particles.len(), starts.iter().map(|start| start.between))?;
        for (link, start) in starts.iter().enumerate() {
            let pair = Pair::new(start.between[0], start.between[1]);
            let (i, j) = pair.indices();
            let displacement = metric.displacement(particles.position[i], particles.position[j]);
            let reach = particles.radius[i] + particles.radius[j];
            let found = self.pairs.binary_search(&pair);
            let (Ok(at), true) = (found, displacement.norm_squared() < reach * reach) else {
                return Err(ModelError::NoOverlap { link, i, j });
            };
            if self.remembers {
                let given = start.initial_angles;
                let initial = if start.between[0] == i {
                    given
                } else {
                    [given[1], given[0]]
                };
                let frame = PairFrame::new(displacement);
                let angles = [particles.angle[i], particles.angle[j]];
                let rest = rest_angles(&frame, angles, Some(initial));
                self.memory[at] = ContactMemory::begin(&frame, rest);
            }
        }
        Ok(())
    }

    /// The contacts that remember, with their memory.
    pub fn remembered(&self) -> impl Iterator<Item = (Pair, &ContactMemory<S>)> {
        self.pairs
            .iter()
            .copied()
            .zip(&self.memory)
            .filter(|(_, memory)| memory.touches)
    }

    /// Restore memories, in the order of [`remembered`](Self::remembered), as a checkpoint holds them.
    pub fn restore(&mut self, memories: Vec<(Pair, ContactMemory<S>)>) {
        if self.remembers {
            self.pairs.clear();
            self.memory.clear();
            for (pair, memory) in memories {
                self.pairs.push(pair);
                self.memory.push(memory);
            }
        }
    }
}

/// Remove from sorted pairs those that are bonded.
fn remove_bonded<S: Real>(pairs: &mut Vec<Pair>, strong: &StrongLinks<S>) {
    let mut bonded = strong.links.iter().map(|link| link.pair).peekable();
    pairs.retain(|&pair| {
        while bonded.next_if(|&other| other < pair).is_some() {}
        bonded.peek() != Some(&pair)
    });
}
