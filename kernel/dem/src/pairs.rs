//! Shared by the lists of contacts and bonds.

use crate::error::ModelError;
use crate::geometry::{PairFrame, angle_of, reversed, wrapped};
use gouge_common::pair::Pair;
use gouge_common::scalar::Real;

/// Identifies the contents of the contact list or bond list of a world.
///
/// A rebuild replaces the contact list. Between rebuilds pairs are only added to the contact list, when bonds break,
/// and only removed from the bond list. The number of rebuilds and the length therefore identify a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ListVersion {
    pub rebuilds: u64,
    pub pairs: usize,
}

/// Angles of both particles in rad at which the ends are not rotated, for the present pair frame.
///
/// These are the present angles of the particles if the interaction begins now. If it began earlier, `initial` holds
/// the angles in its frame at that time, thesis eq. (30).
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

/// Check that the particles of every pair exist and are distinct, and that no pair is repeated.
pub(crate) fn check_pairs(
    particles: usize,
    pairs: impl Iterator<Item = [usize; 2]>,
) -> Result<(), ModelError> {
    let mut seen = std::collections::HashSet::new();
    for (index, [i, j]) in pairs.enumerate() {
        if let Some(particle) = [i, j].into_iter().find(|&p| p >= particles) {
            return Err(ModelError::NoSuchParticle {
                index,
                particle,
                particles,
            });
        }
        if i == j {
            return Err(ModelError::SelfPair { index, particle: i });
        }
        if !seen.insert(Pair::new(i, j)) {
            return Err(ModelError::DuplicatePair { index, i, j });
        }
    }
    Ok(())
}
