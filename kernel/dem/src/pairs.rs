//! What lists of contacts and of bonds have in common.

use crate::error::ModelError;
use crate::geometry::{PairFrame, angle_of, reversed, wrapped};
use gouge_common::pair::Pair;
use gouge_common::scalar::Real;

/// Distinguishes the successive lists of contacts or bonds of a world: a rebuild finds all pairs anew, and between
/// rebuilds pairs only join (contacts, of broken bonds) or only leave (bonds).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Edition {
    pub rebuilds: u64,
    pub pairs: usize,
}

/// Angles of both particles, in rad, at which nothing is turned in the present frame: the present angles, or, if
/// the contact or bond began earlier with the given angles in its frame, those it would have now unturned.
pub(crate) fn rest_angles<S: Real>(
    frame: &PairFrame<S>,
    angles: [S; 2],
    initial: Option<[f64; 2]>,
) -> [S; 2] {
    let Some(initial) = initial else {
        return angles;
    };
    let lambda = angle_of(frame.normal);
    let frames = [lambda, reversed(lambda)];
    [0, 1].map(|end| {
        let psi = angles[end] - frames[end];
        angles[end] - wrapped(psi - S::from_f64(initial[end]))
    })
}

/// Check that every pair exists and none repeats.
pub(crate) fn check_pairs(
    particles: usize,
    pairs: impl Iterator<Item = [usize; 2]>,
) -> Result<(), ModelError> {
    let mut seen = std::collections::HashSet::new();
    for (link, [i, j]) in pairs.enumerate() {
        if let Some(particle) = [i, j].into_iter().find(|&p| p >= particles) {
            return Err(ModelError::NoSuchParticle {
                link,
                particle,
                particles,
            });
        }
        if i == j {
            return Err(ModelError::SelfLink { link, particle: i });
        }
        if !seen.insert(Pair::new(i, j)) {
            return Err(ModelError::DuplicateLink { link, i, j });
        }
    }
    Ok(())
}
