//! Contacts: they begin and end with overlap. The thesis calls them weak links.

use crate::bonds::Bonds;
use crate::error::ModelError;
use crate::geometry::PairFrame;
use crate::pairs::{ListVersion, check_pairs, rest_angles};
use crate::particles::Particles;
use core::ops::{Deref, Range};
use gouge_common::columns;
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::neighbors::Neighbors;
use gouge_common::pair::Pair;
use gouge_common::parts::split_or_empty;
use gouge_common::scalar::Real;
use prefetch_index::prefetch_index;

/// A contact in the initial state that began earlier.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactStart {
    /// The two particles.
    pub between: [usize; 2],
    /// Angles of both ends in the pair frame when the contact began, in rad, thesis eq. (30).
    pub initial_angles: [f64; 2],
}

/// Memory of a contact: its state when it began, and the history variable of its tangential law.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactMemory<S> {
    /// Whether the pair touches. If not, the other fields are meaningless.
    pub touches: bool,
    /// Reference direction from which the rotation of the pair frame is measured.
    pub reference: Vec2<S>,
    /// Angles of both particles in rad at which the tangential displacement is zero, for a pair frame along
    /// `reference`. For lever arms that accumulate: the tangential displacements of both ends so far, in m.
    pub ends: [S; 2],
    /// History variable of the tangential law.
    pub state: S,
}

impl<S: Real> ContactMemory<S> {
    /// Memory of a contact that begins in the given frame; `ends` are the entries of its two ends.
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

/// Memories of all contacts, one per pair, as columns of equal length.
#[derive(Clone, Debug, Default)]
pub(crate) struct Memories<S> {
    pub touches: Vec<bool>,
    pub references: [Vec<S>; 2],
    pub ends: [Vec<S>; 2],
    pub states: Vec<S>,
}

/// Memories of a range of consecutive pairs.
pub(crate) struct MemoryColumns<'a, S> {
    pub touches: &'a mut [bool],
    pub references: [&'a mut [S]; 2],
    pub ends: [&'a mut [S]; 2],
    pub states: &'a mut [S],
}

impl<S: Real> MemoryColumns<'_, S> {
    pub fn split_at(self, at: usize) -> (Self, Self) {
        let (touches, other_touches) = split_or_empty(self.touches, at);
        let (references, other_references) = columns::split_mut(self.references, at);
        let (ends, other_ends) = columns::split_mut(self.ends, at);
        let (states, other_states) = split_or_empty(self.states, at);
        (
            Self {
                touches,
                references,
                ends,
                states,
            },
            Self {
                touches: other_touches,
                references: other_references,
                ends: other_ends,
                states: other_states,
            },
        )
    }
    /// The memories in a range of indices.
    #[inline(always)]
    pub fn part(&mut self, positions: Range<usize>) -> MemoryColumns<'_, S> {
        MemoryColumns {
            touches: &mut self.touches[positions.clone()],
            references: columns::range_mut(&mut self.references, positions.clone()),
            ends: columns::range_mut(&mut self.ends, positions.clone()),
            states: &mut self.states[positions],
        }
    }
    /// Prefetch the cache line of each column that holds an index.
    #[inline(always)]
    pub fn prefetch(&self, position: usize) {
        prefetch_index(&*self.touches, position);
        columns::prefetch(&self.references, position);
        columns::prefetch(&self.ends, position);
        prefetch_index(&*self.states, position);
    }
    /// The memory at an index.
    #[inline(always)]
    pub fn get(&self, position: usize) -> ContactMemory<S> {
        let touches = self.touches[position];
        memory_at(touches, &self.references, &self.ends, self.states, position)
    }
    /// Set the memory at an index.
    #[inline(always)]
    pub fn set(&mut self, position: usize, memory: ContactMemory<S>) {
        self.touches[position] = memory.touches;
        let reference = [memory.reference.x, memory.reference.y];
        columns::set(&mut self.references, position, reference);
        columns::set(&mut self.ends, position, memory.ends);
        self.states[position] = memory.state;
    }
}

impl<S: Real> Memories<S> {
    fn reserve(&mut self, capacity: usize) {
        set_capacity(&mut self.touches, capacity);
        for column in self.number_columns() {
            set_capacity(column, capacity);
        }
    }
    /// The memory at an index.
    pub fn get(&self, position: usize) -> ContactMemory<S> {
        let touches = self.touches[position];
        memory_at(
            touches,
            &self.references,
            &self.ends,
            &self.states,
            position,
        )
    }
    /// All memories, mutable; empty if the laws have no memory.
    pub fn columns(&mut self) -> MemoryColumns<'_, S> {
        MemoryColumns {
            touches: &mut self.touches,
            references: columns::slices_mut(&mut self.references),
            ends: columns::slices_mut(&mut self.ends),
            states: &mut self.states,
        }
    }
    fn set(&mut self, position: usize, memory: ContactMemory<S>) {
        self.columns().set(position, memory);
    }
    fn insert(&mut self, position: usize, memory: ContactMemory<S>) {
        self.touches.insert(position, memory.touches);
        for column in self.number_columns() {
            column.insert(position, S::zero());
        }
        self.set(position, memory);
    }
    fn resize(&mut self, number: usize) {
        self.touches.resize(number, false);
        for column in self.number_columns() {
            column.resize(number, S::zero());
        }
    }
    fn number_columns(&mut self) -> impl Iterator<Item = &mut Vec<S>> {
        let pairs = self.references.iter_mut().chain(&mut self.ends);
        pairs.chain([&mut self.states])
    }
}

/// The memory at an index of columns.
#[inline(always)]
fn memory_at<S: Real, C: Deref<Target = [S]>>(
    touches: bool,
    references: &[C; 2],
    ends: &[C; 2],
    states: &[S],
    position: usize,
) -> ContactMemory<S> {
    let [x, y] = columns::at(references, position);
    ContactMemory {
        touches,
        reference: Vec2::new(x, y),
        ends: columns::at(ends, position),
        state: states[position],
    }
}

/// Capacity for the given number of near pairs, bonded pairs included, with a reserve so that lists rarely grow.
fn capacity_for(near: usize) -> usize {
    near + near / 128 + 64
}

/// Set the capacity of a column exactly.
fn set_capacity<T>(column: &mut Vec<T>, capacity: usize) {
    column.shrink_to(capacity);
    column.reserve_exact(capacity.saturating_sub(column.len()));
}

/// The contact list: pairs that may touch, sorted, with their memories if a law has memory.
#[doc(alias = "weak link")]
#[derive(Clone, Debug)]
pub struct Contacts<S> {
    /// Pairs that are near enough to touch before the next rebuild, without the bonded pairs.
    pub pairs: Vec<Pair>,
    pub(crate) memories: Memories<S>,
    remembers: bool,
    /// Number of pairs for which memory is reserved.
    capacity: usize,
}

impl<S: Real> Contacts<S> {
    /// An empty list, to be filled by the first [`rebuild`](Self::rebuild).
    pub fn new(remembers: bool) -> Self {
        Self {
            pairs: Vec::new(),
            memories: Memories::default(),
            remembers,
            capacity: 0,
        }
    }

    /// Version of the contact list; `neighbors` is the search that built it.
    pub(crate) fn list_version(&self, neighbors: &Neighbors<S>) -> ListVersion {
        ListVersion {
            rebuilds: neighbors.rebuilds(),
            pairs: self.pairs.len(),
        }
    }

    /// Number of memories that fit without allocation.
    pub fn memory_capacity(&self) -> usize {
        self.memories.states.capacity()
    }

    /// Memory of the pair at an index; `None` if the pair does not touch or contacts have no memory.
    #[inline]
    pub(crate) fn memory_at(&self, position: usize) -> Option<ContactMemory<S>> {
        let touches = self.memories.touches.get(position).copied();
        touches
            .unwrap_or_default()
            .then(|| self.memories.get(position))
    }

    /// Search all pairs again; the memories of touching pairs are kept.
    ///
    /// Allocates only if more pairs are near than ever before.
    pub fn rebuild<M: Metric>(
        &mut self,
        metric: M,
        particles: &Particles<S>,
        bonds: Option<&Bonds<S>>,
        neighbors: &mut Neighbors<S>,
    ) {
        let touching = self.gather_touching();
        neighbors.append_new(
            metric,
            particles.search_spheres(),
            |i, j| particles.may_interact(i, j),
            &mut self.pairs,
        );
        self.reserve();
        self.mark_and_sort(touching);
        if let Some(bonds) = bonds {
            remove_bonded(&mut self.pairs, bonds);
        }
        self.spread_touching(touching);
    }

    /// Reserve memory for all near pairs, including the bonded ones, whose bonds may break.
    fn reserve(&mut self) {
        if self.pairs.len() <= self.capacity {
            return;
        }
        self.capacity = capacity_for(self.pairs.len());
        set_capacity(&mut self.pairs, self.capacity);
        if self.remembers {
            self.memories.reserve(self.capacity);
        }
    }

    /// Move the touching pairs and their memories to the front and drop all other pairs. Returns the number of
    /// touching pairs.
    ///
    /// Touching pairs are kept even outside the skin, so that the end of a contact is noticed whenever the list is
    /// rebuilt.
    fn gather_touching(&mut self) -> usize {
        let mut touching = 0;
        for position in 0..self.memories.touches.len() {
            if let Some(memory) = self.memory_at(position) {
                self.memories.set(touching, memory);
                self.pairs[touching] = self.pairs[position];
                touching += 1;
            }
        }
        self.pairs.truncate(touching);
        touching
    }

    /// Sort the pairs. The leading `touching` pairs are marked by reversing them.
    fn mark_and_sort(&mut self, touching: usize) {
        for pair in &mut self.pairs[..touching] {
            *pair = pair.reversed();
        }
        self.pairs.sort_unstable_by_key(|pair| pair.in_order());
    }

    /// Move the memories at the front to the marked pairs, and remove the marks.
    fn spread_touching(&mut self, mut touching: usize) {
        if !self.remembers {
            return;
        }
        self.memories.resize(self.pairs.len());
        // From the end: a memory never moves forward, so none is overwritten before it is moved.
        for position in (0..self.pairs.len()).rev() {
            let pair = self.pairs[position];
            let touches = pair != pair.in_order();
            if touches {
                touching -= 1;
                self.pairs[position] = pair.in_order();
                let memory = self.memories.get(touching);
                self.memories.set(position, memory);
            }
            self.memories.touches[position] = touches;
        }
    }

    /// Add pairs whose bonds just broke.
    pub(crate) fn add_broken(&mut self, bonds: &Bonds<S>) {
        for &position in &bonds.broken {
            let pair = bonds.pairs[position as usize];
            if let Err(at) = self.pairs.binary_search(&pair) {
                self.pairs.insert(at, pair);
                if self.remembers {
                    self.memories.insert(at, ContactMemory::default());
                }
            }
        }
    }

    /// Set the memories of contacts that began before the initial state.
    ///
    /// # Errors
    /// If a pair does not exist, is repeated, or does not overlap.
    pub fn remember<M: Metric>(
        &mut self,
        metric: M,
        particles: &Particles<S>,
        starts: &[ContactStart],
    ) -> Result<(), ModelError> {
        check_pairs(particles.len(), starts.iter().map(|start| start.between))?;
        for (index, start) in starts.iter().enumerate() {
            let pair = Pair::new(start.between[0], start.between[1]);
            let (i, j) = pair.indices();
            let displacement = metric.displacement(particles.position[i], particles.position[j]);
            let reach = particles.radius[i] + particles.radius[j];
            let found = self.pairs.binary_search(&pair);
            let (Ok(at), true) = (found, displacement.norm_squared() < reach * reach) else {
                return Err(ModelError::NoOverlap { index, i, j });
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
                self.memories.set(at, ContactMemory::begin(&frame, rest));
            }
        }
        Ok(())
    }

    /// The touching pairs with their memories, if contacts have memory.
    pub fn remembered(&self) -> impl Iterator<Item = (Pair, ContactMemory<S>)> {
        let pairs = self.pairs.iter().enumerate();
        pairs.filter_map(|(position, &pair)| Some((pair, self.memory_at(position)?)))
    }

    /// Restore the memories of a checkpoint, in the order of [`remembered`](Self::remembered).
    pub fn restore(&mut self, memories: &[(Pair, ContactMemory<S>)]) {
        if self.remembers {
            self.pairs.clear();
            self.memories.resize(memories.len());
            for (position, &(pair, memory)) in memories.iter().enumerate() {
                self.pairs.push(pair);
                self.memories.set(position, memory);
            }
        }
    }
}

/// Remove the bonded pairs from sorted pairs. Pairs marked as touching are never bonded.
fn remove_bonded<S: Real>(pairs: &mut Vec<Pair>, bonds: &Bonds<S>) {
    let mut bonded = bonds.pairs.iter().copied().peekable();
    pairs.retain(|&pair| {
        while bonded.next_if(|&other| other < pair.in_order()).is_some() {}
        bonded.peek() != Some(&pair)
    });
}
