//! Bonds of a node side by side, so that one vector instruction computes several of them.

use crate::bond_law::Elongation;
use crate::state::Place;
use gouge_common::geometry::Vec2;

/// Most bonds that are computed together.
pub(super) const LANES: usize = 32;
/// Numbers of bonds are filled up to a multiple of this one, so that no bond is left to scalar instructions.
const VECTOR: usize = 8;

/// Bonds of a node with earlier ones, as columns.
#[derive(Default)]
pub(super) struct Lanes {
    /// From the earlier node to the later one: differences of references and of displacements.
    difference: [Place; LANES],
    /// Reference length in m.
    length: [f64; LANES],
}

impl Lanes {
    /// Take the bonds of a node at `own` with earlier ones, and bonds without elongation behind them.
    #[inline(always)]
    pub(super) fn gather(
        &mut self,
        own: Place,
        earlier: impl Iterator<Item = Place>,
        length: &[f64],
    ) {
        for (difference, from) in self.difference.iter_mut().zip(earlier) {
            *difference = Place {
                reference: own.reference - from.reference,
                displacement: own.displacement - from.displacement,
            };
        }
        // Whole vectors: what single numbers have just stored, no vector instruction can load without waiting.
        let (whole, rest) = length.as_chunks::<VECTOR>();
        let (lengths, _) = self.length.as_chunks_mut::<VECTOR>();
        for (lengths, whole) in lengths.iter_mut().zip(whole) {
            *lengths = *whole;
        }
        if !rest.is_empty() {
            let (number, filled) = (length.len(), length.len().next_multiple_of(VECTOR));
            self.length[number - rest.len()..number].copy_from_slice(rest);
            self.length[number..filled].fill(1.0);
            self.difference[number..filled].fill(Place::default());
        }
    }

    /// Compute a vector for each of a number of bonds. Returns whether any of them breaks.
    ///
    /// The vectors are no field of the lanes: a loop over columns of one object that it also writes is not vectorised.
    #[inline(always)]
    pub(super) fn compute(
        &self,
        number: usize,
        vectors: &mut [Vec2; LANES],
        of_bond: impl Fn(&Elongation) -> (Vec2, bool),
    ) -> bool {
        let filled = number.next_multiple_of(VECTOR);
        let inputs = self.difference[..filled].iter().zip(&self.length[..filled]);
        let mut any_breaks = false;
        for ((difference, &length), vector) in inputs.zip(&mut vectors[..filled]) {
            let elongation = Elongation::new(difference.reference, difference.displacement, length);
            let breaks;
            (*vector, breaks) = of_bond(&elongation);
            any_breaks |= breaks;
        }
        any_breaks
    }
}
