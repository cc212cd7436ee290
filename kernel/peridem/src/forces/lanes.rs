//! Bonds side by side, so that one vector instruction computes several of them.

use crate::bond_law::Elongation;
use crate::state::Place;
use gouge_common::geometry::Vec2;

/// Bonds of several nodes are computed together once there are this many, which still fit into the first-level cache. Those
/// of one node would fill their last vector badly, and the processor would guess the end of each of its loops wrongly.
pub(super) const BATCH: usize = 192;
/// Numbers of bonds are filled up to a multiple of this one, so that no bond is left to scalar instructions.
const VECTOR: usize = 8;

/// Bonds as columns.
#[derive(Clone, Debug, Default)]
pub(super) struct Lanes {
    /// From the earlier node to the later one: differences of references and of displacements.
    difference: Vec<Place>,
    /// Reference length in m.
    length: Vec<f64>,
    /// Number of bonds.
    pub(super) number: usize,
}

impl Lanes {
    /// Append the bonds of a node at `own`, given by the places of the earlier nodes and the lengths in m.
    #[inline(always)]
    pub(super) fn gather(
        &mut self,
        own: Place,
        earlier: impl ExactSizeIterator<Item = Place>,
        length: &[f64],
    ) {
        let begin = self.number;
        self.number += length.len();
        if self.difference.len() < self.number {
            self.grow();
        }
        let differences = self.difference[begin..self.number].iter_mut();
        let lengths = self.length[begin..self.number].iter_mut();
        for (((difference, copy), from), &length) in
            differences.zip(lengths).zip(earlier).zip(length)
        {
            *difference = Place {
                reference: own.reference - from.reference,
                displacement: own.displacement - from.displacement,
            };
            *copy = length;
        }
    }

    #[cold]
    fn grow(&mut self) {
        let filled = self.number.next_multiple_of(VECTOR).max(2 * BATCH);
        self.difference.resize(filled, Place::default());
        self.length.resize(filled, 0.0);
    }

    /// Compute a vector for each bond. Returns whether any of them breaks.
    ///
    /// What `of_bond` needs, it must hold by value: a loop that may write what it reads is not vectorised.
    #[inline(always)]
    pub(super) fn compute(
        &mut self,
        vectors: &mut Vec<Vec2>,
        of_bond: impl Fn(&Elongation) -> (Vec2, bool),
    ) -> bool {
        let filled = self.number.next_multiple_of(VECTOR);
        self.difference[self.number..filled].fill(Place::default());
        self.length[self.number..filled].fill(1.0);
        vectors.resize(filled.max(vectors.len()), Vec2::zero());
        let inputs = self.difference[..filled].iter().zip(&self.length);
        let mut any_breaks = false;
        for ((difference, &length), vector) in inputs.zip(vectors) {
            let elongation = Elongation::new(difference.reference, difference.displacement, length);
            let breaks;
            (*vector, breaks) = of_bond(&elongation);
            any_breaks |= breaks;
        }
        any_breaks
    }
}
