//! Fragments of a state.

use crate::world::State;
use gouge_common::estimators::{Fragments, connected};
use gouge_common::scalar::Real;

/// Fragments of a state: particles held together by bonds. A particle without bonds is a fragment of its own.
pub fn fragments<S: Real>(state: &State<S>) -> Fragments {
    let pairs = state.bonds().map_or(&[][..], |bonds| bonds.pairs());
    connected(
        state.particles().len(),
        pairs.iter().map(|pair| pair.indices()),
    )
}
