//! Strong links: made once, broken, never made again.

use super::Pair;
use crate::error::ModelError;
use crate::geometry::{Metric, PairFrame, Vec2, angle_of, reversed, wrapped};
use crate::particles::{Particles, Role};
use crate::scalar::Real;

/// What a scene says of a bond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondStart {
    /// The two particles.
    pub between: [usize; 2],
    /// Strength factor of thesis eq. (50).
    pub strength_factor: f64,
    /// Distance when the bond began in m; that of the initial state if not given.
    pub initial_distance: Option<f64>,
    /// Angles of both ends in the pair frame when the bond began, thesis eq. (30), in rad.
    pub initial_angles: Option<[f64; 2]>,
}

/// A bond between two particles.
#[doc(alias = "bond")]
#[doc(alias = "beam")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrongLink<S> {
    /// The pair.
    pub pair: Pair,
    /// What the bond keeps of its beginning.
    pub rest: Rest<S>,
    /// Strength factor; infinite where the bond never breaks.
    pub strength_factor: S,
}

/// The unstrained state of a bond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest<S> {
    /// Direction of the pair frame from which its turn is measured.
    pub reference: Vec2<S>,
    /// Angles of both particles at which the ends are unbent, while the frame points along `reference`.
    pub angles: [S; 2],
    /// Distance when the bond began, in m.
    pub distance: S,
}

/// All bonds, in the order of their pairs, as columns of equal length.
#[derive(Clone, Debug)]
pub struct StrongLinks<S> {
    pub(crate) pairs: Vec<Pair>,
    pub(crate) references: Vec<Vec2<S>>,
    pub(crate) angles: Vec<[S; 2]>,
    pub(crate) distances: Vec<S>,
    pub(crate) strength_factors: Vec<S>,
    /// Positions of the links that broke in the latest evaluation, before they are removed.
    pub(crate) broken: Vec<u32>,
}

/// Consecutive bonds, of which the rest may be changed.
pub(crate) struct StrongColumns<'a, S> {
    /// Position of the first among all.
    pub first: usize,
    pub pairs: &'a [Pair],
    pub references: &'a mut [Vec2<S>],
    pub angles: &'a mut [[S; 2]],
    pub distances: &'a [S],
    pub strength_factors: &'a [S],
}

impl<S: Real> StrongColumns<'_, S> {
    pub fn split_at(self, at: usize) -> (Self, Self) {
        let (pairs, other_pairs) = self.pairs.split_at(at);
        let (references, other_references) = self.references.split_at_mut(at);
        let (angles, other_angles) = self.angles.split_at_mut(at);
        let (distances, other_distances) = self.distances.split_at(at);
        let (strength_factors, other_factors) = self.strength_factors.split_at(at);
        (
            Self {
                first: self.first,
                pairs,
                references,
                angles,
                distances,
                strength_factors,
            },
            Self {
                first: self.first + at,
                pairs: other_pairs,
                references: other_references,
                angles: other_angles,
                distances: other_distances,
                strength_factors: other_factors,
            },
        )
    }
    /// The unstrained state at a position.
    #[inline(always)]
    pub fn rest(&self, position: usize) -> Rest<S> {
        Rest {
            reference: self.references[position],
            angles: self.angles[position],
            distance: self.distances[position],
        }
    }
}

impl<S: Real> StrongLinks<S> {
    /// Make the bonds of a scene.
    ///
    /// # Errors
    /// Pairs that do not exist, repeat, or are longer than half the period.
    pub fn new<M: Metric>(
        metric: M,
        particles: &Particles<S>,
        starts: &[BondStart],
        unbreakable_edges: bool,
        period: Option<f64>,
    ) -> Result<Self, ModelError> {
        check_pairs(particles.len(), starts.iter().map(|start| start.between))?;
        let mut links = Vec::with_capacity(starts.len());
        for (position, start) in starts.iter().enumerate() {
            let length = frame_of(metric, particles, start).distance.to_f64();
            if let Some(width) = period
                && length > 0.5 * width
            {
                return Err(ModelError::LongBond {
                    link: position,
                    length,
                    width,
                });
            }
            let link = begin(metric, particles, start, unbreakable_edges);
            links.push(link);
        }
        links.sort_by_key(|link| link.pair);
        Ok(Self::from_links(&links))
    }

    /// Links as they were recorded, in the order of their pairs.
    pub(crate) fn from_links(links: &[StrongLink<S>]) -> Self {
        Self {
            pairs: links.iter().map(|link| link.pair).collect(),
            references: links.iter().map(|link| link.rest.reference).collect(),
            angles: links.iter().map(|link| link.rest.angles).collect(),
            distances: links.iter().map(|link| link.rest.distance).collect(),
            strength_factors: links.iter().map(|link| link.strength_factor).collect(),
            broken: Vec::with_capacity(links.len()),
        }
    }

    /// All of them, for a pass.
    pub(crate) fn columns(&mut self) -> StrongColumns<'_, S> {
        StrongColumns {
            first: 0,
            pairs: &self.pairs,
            references: &mut self.references,
            angles: &mut self.angles,
            distances: &self.distances,
            strength_factors: &self.strength_factors,
        }
    }

    /// Number of bonds that hold.
    pub fn len(&self) -> usize {
        self.pairs.len()
    }
    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }
    /// The pairs that are bonded.
    pub fn pairs(&self) -> &[Pair] {
        &self.pairs
    }
    /// The bond at a position.
    #[inline(always)]
    pub(crate) fn get(&self, position: usize) -> StrongLink<S> {
        StrongLink {
            pair: self.pairs[position],
            rest: Rest {
                reference: self.references[position],
                angles: self.angles[position],
                distance: self.distances[position],
            },
            strength_factor: self.strength_factors[position],
        }
    }
    /// The bonds that hold.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = StrongLink<S>> + Clone {
        (0..self.len()).map(|position| self.get(position))
    }

    /// Whether the pair is bonded.
    pub fn contains(&self, pair: Pair) -> bool {
        self.pairs.binary_search(&pair).is_ok()
    }

    /// Whether the bond of the pair broke in the latest evaluation.
    pub(crate) fn breaks_now(&self, pair: Pair) -> bool {
        self.broken
            .binary_search_by_key(&pair, |&position| self.pairs[position as usize])
            .is_ok()
    }

    /// Remove the links that broke.
    pub(crate) fn remove_broken(&mut self) {
        fn remove<T>(column: &mut Vec<T>, broken: &[u32]) {
            let mut broken = broken.iter().copied().peekable();
            let mut position = 0;
            column.retain(|_| {
                let breaks = broken.next_if_eq(&position).is_some();
                position += 1;
                !breaks
            });
        }
        remove(&mut self.pairs, &self.broken);
        remove(&mut self.references, &self.broken);
        remove(&mut self.angles, &self.broken);
        remove(&mut self.distances, &self.broken);
        remove(&mut self.strength_factors, &self.broken);
        self.broken.clear();
    }
}

fn frame_of<S: Real, M: Metric>(
    metric: M,
    particles: &Particles<S>,
    start: &BondStart,
) -> PairFrame<S> {
    let (i, j) = Pair::new(start.between[0], start.between[1]).indices();
    PairFrame::new(metric.displacement(particles.position[i], particles.position[j]))
}

fn begin<S: Real, M: Metric>(
    metric: M,
    particles: &Particles<S>,
    start: &BondStart,
    unbreakable_edges: bool,
) -> StrongLink<S> {
    let pair = Pair::new(start.between[0], start.between[1]);
    let (i, j) = pair.indices();
    let frame = frame_of(metric, particles, start);
    let angles = start.initial_angles.map(|a| {
        if start.between[0] == i {
            a
        } else {
            [a[1], a[0]]
        }
    });
    let at_edge = particles.role[i] != Role::Free || particles.role[j] != Role::Free;
    let strength = if unbreakable_edges && at_edge {
        f64::INFINITY
    } else {
        start.strength_factor
    };
    StrongLink {
        pair,
        rest: Rest {
            reference: frame.normal,
            angles: rest_angles(&frame, [particles.angle[i], particles.angle[j]], angles),
            distance: start.initial_distance.map_or(frame.distance, S::from_f64),
        },
        strength_factor: S::from_f64(strength),
    }
}

/// Angles of the particles at which a link is unbent in the present frame: the present ones, or, if the
/// link began earlier with the given angles in its frame, those by which it has turned since.
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
