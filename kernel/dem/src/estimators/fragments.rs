//! Fragments of a state.

use crate::particles::Role;
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

/// Which particles belong to the debris: to fragments that hold neither a driven nor a fixed particle.
pub fn debris<S: Real>(state: &State<S>) -> Vec<bool> {
    let fragments = fragments(state);
    let mut is_block = vec![false; fragments.number];
    for (&label, role) in fragments.label.iter().zip(&state.particles().role) {
        is_block[label] |= *role != Role::Free;
    }
    let labels = fragments.label.iter();
    labels.map(|&label| !is_block[label]).collect()
}
