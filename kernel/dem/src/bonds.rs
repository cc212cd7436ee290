//! Bonds: made once, and never again after they broke. The thesis calls them strong links.

use crate::error::ModelError;
use crate::geometry::PairFrame;
use crate::laws::weakest_section;
use crate::pairs::{ListVersion, check_pairs, rest_angles};
use crate::particles::{Particles, Role};
use core::ops::{Deref, Range};
use gouge_common::columns;
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::pair::{Pair, map_ends};
use gouge_common::scalar::Real;
use prefetch_index::prefetch_index;

/// A bond in the initial state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondStart {
    /// The two particles.
    pub between: [usize; 2],
    /// Strength factor, dimensionless, thesis eq. (50).
    pub strength_factor: f64,
    /// Initial distance of the centres in m; `None` for the distance in the initial state.
    pub initial_distance: Option<f64>,
    /// Angles of both ends in the pair frame when the bond began, in rad, thesis eq. (30); `None` for those in the
    /// initial state.
    pub initial_angles: Option<[f64; 2]>,
}

/// A bond between two particles.
#[doc(alias = "strong link")]
#[doc(alias = "beam")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bond<S> {
    /// The pair.
    pub pair: Pair,
    /// Unstrained state of the bond.
    pub rest: Rest<S>,
    /// Strength factor, dimensionless; infinite if the bond never breaks.
    pub strength_factor: S,
}

/// Unstrained state of a bond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest<S> {
    /// Reference direction from which the rotation of the pair frame is measured.
    pub reference: Vec2<S>,
    /// Angles of both particles in rad at which the ends are not bent, for a pair frame along `reference`.
    pub angles: [S; 2],
    /// Unstrained distance of the centres in m.
    pub distance: S,
}

/// All bonds, sorted by pair, as columns of equal length.
#[derive(Clone, Debug)]
pub struct Bonds<S> {
    pub(crate) pairs: Vec<Pair>,
    references: [Vec<S>; 2],
    angles: [Vec<S>; 2],
    distances: Vec<S>,
    strength_factors: Vec<S>,
    /// Areas of the weakest sections, in m^2.
    sections: Vec<S>,
    /// Radii of both ends in m. They are constant, so they are stored here instead of being gathered in each step.
    radii: [Vec<S>; 2],
    /// Indices of the bonds that broke in the latest evaluation and are not removed yet.
    pub(crate) broken: Vec<u32>,
}

/// A range of consecutive bonds, with mutable reference directions.
pub(crate) struct BondColumns<'a, S> {
    /// Index of the first of these bonds among all bonds.
    pub first: usize,
    pub pairs: &'a [Pair],
    pub references: [&'a mut [S]; 2],
    pub angles: [&'a mut [S]; 2],
    pub distances: &'a [S],
    pub sections: &'a [S],
    pub radii: [&'a [S]; 2],
}

impl<S: Real> BondColumns<'_, S> {
    /// Prefetch the cache line of each column that holds an index.
    #[inline(always)]
    pub fn prefetch(&self, position: usize) {
        columns::prefetch(&self.references, position);
        columns::prefetch(&self.angles, position);
        prefetch_index(self.distances, position);
        prefetch_index(self.sections, position);
        columns::prefetch(&self.radii, position);
    }
    pub fn split_at(self, at: usize) -> (Self, Self) {
        let (pairs, other_pairs) = self.pairs.split_at(at);
        let (references, other_references) = columns::split_mut(self.references, at);
        let (angles, other_angles) = columns::split_mut(self.angles, at);
        let (distances, other_distances) = self.distances.split_at(at);
        let (sections, other_sections) = self.sections.split_at(at);
        let (radii, other_radii) = columns::split(self.radii, at);
        (
            Self {
                first: self.first,
                pairs,
                references,
                angles,
                distances,
                sections,
                radii,
            },
            Self {
                first: self.first + at,
                pairs: other_pairs,
                references: other_references,
                angles: other_angles,
                distances: other_distances,
                sections: other_sections,
                radii: other_radii,
            },
        )
    }
    /// The bonds in a range of indices.
    #[inline(always)]
    pub fn part(&mut self, positions: Range<usize>) -> BondColumns<'_, S> {
        BondColumns {
            first: self.first + positions.start,
            pairs: &self.pairs[positions.clone()],
            references: columns::range_mut(&mut self.references, positions.clone()),
            angles: columns::range_mut(&mut self.angles, positions.clone()),
            distances: &self.distances[positions.clone()],
            sections: &self.sections[positions.clone()],
            radii: map_ends(self.radii, |radii| &radii[positions.clone()]),
        }
    }
    /// Unstrained state of the bond at an index.
    #[inline(always)]
    pub fn rest(&self, position: usize) -> Rest<S> {
        rest_at(&self.references, &self.angles, self.distances, position)
    }
    /// Set the reference direction, and the angles that belong to it, of the bond at an index.
    pub fn set_reference(&mut self, position: usize, rest: &Rest<S>) {
        let reference = [rest.reference.x, rest.reference.y];
        columns::set(&mut self.references, position, reference);
        columns::set(&mut self.angles, position, rest.angles);
    }
}

impl<S: Real> Bonds<S> {
    /// Bonds for an initial state.
    ///
    /// `period` is the period in x in m, if x is periodic.
    ///
    /// # Errors
    /// If a pair does not exist, is repeated, or is longer than half the period.
    pub fn new<M: Metric>(
        metric: M,
        particles: &Particles<S>,
        starts: &[BondStart],
        unbreakable_edges: bool,
        period: Option<f64>,
    ) -> Result<Self, ModelError> {
        check_pairs(particles.len(), starts.iter().map(|start| start.between))?;
        let mut bonds = Vec::with_capacity(starts.len());
        for (position, start) in starts.iter().enumerate() {
            let length = frame_of(metric, particles, start).distance.to_f64();
            if let Some(width) = period
                && length > 0.5 * width
            {
                return Err(ModelError::LongBond {
                    index: position,
                    length,
                    width,
                });
            }
            bonds.push(begin(metric, particles, start));
        }
        bonds.sort_by_key(|bond| bond.pair);
        let mut bonds = Self::from_bonds(&bonds, particles);
        if unbreakable_edges {
            bonds.make_edges_unbreakable(particles);
        }
        Ok(bonds)
    }

    /// Bonds from records that are sorted by pair and refer to existing particles.
    pub(crate) fn from_bonds(bonds: &[Bond<S>], particles: &Particles<S>) -> Self {
        let radii = |bond: &Bond<S>| {
            let (i, j) = bond.pair.indices();
            [particles.radius[i], particles.radius[j]]
        };
        let zeros = vec![S::zero(); bonds.len()];
        let mut kept = Self {
            pairs: bonds.iter().map(|bond| bond.pair).collect(),
            references: columns::collect(bonds, |Bond { rest, .. }| {
                [rest.reference.x, rest.reference.y]
            }),
            angles: columns::collect(bonds, |bond| bond.rest.angles),
            distances: bonds.iter().map(|bond| bond.rest.distance).collect(),
            strength_factors: zeros.clone(),
            sections: zeros,
            radii: columns::collect(bonds, radii),
            broken: Vec::with_capacity(bonds.len()),
        };
        for (position, bond) in bonds.iter().enumerate() {
            kept.set_strength_factor(position, bond.strength_factor);
        }
        kept
    }

    fn set_strength_factor(&mut self, position: usize, factor: S) {
        self.strength_factors[position] = factor;
        self.sections[position] = weakest_section(columns::at(&self.radii, position), factor);
    }

    /// Make all bonds with a driven or fixed particle unbreakable.
    pub(crate) fn make_edges_unbreakable(&mut self, particles: &Particles<S>) {
        for position in 0..self.len() {
            let (i, j) = self.pairs[position].indices();
            if [i, j].iter().any(|&end| particles.role[end] != Role::Free) {
                self.set_strength_factor(position, S::from_f64(f64::INFINITY));
            }
        }
    }

    /// All bonds, for a pass.
    pub(crate) fn columns(&mut self) -> BondColumns<'_, S> {
        BondColumns {
            first: 0,
            pairs: &self.pairs,
            references: columns::slices_mut(&mut self.references),
            angles: columns::slices_mut(&mut self.angles),
            distances: &self.distances,
            sections: &self.sections,
            radii: columns::slices(&self.radii),
        }
    }

    /// Number of intact bonds.
    pub fn len(&self) -> usize {
        self.pairs.len()
    }
    /// Version of the bond list.
    pub(crate) fn list_version(&self) -> ListVersion {
        ListVersion {
            rebuilds: 0,
            pairs: self.len(),
        }
    }
    /// Whether there are no bonds.
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }
    /// The bonded pairs, sorted.
    pub fn pairs(&self) -> &[Pair] {
        &self.pairs
    }
    /// The bond at an index.
    #[inline(always)]
    pub(crate) fn get(&self, position: usize) -> Bond<S> {
        let (references, angles) = (&self.references, &self.angles);
        Bond {
            pair: self.pairs[position],
            rest: rest_at(references, angles, &self.distances, position),
            strength_factor: self.strength_factors[position],
        }
    }
    /// All intact bonds.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Bond<S>> + Clone {
        (0..self.len()).map(|position| self.get(position))
    }

    /// Whether the bond of a pair broke in the latest evaluation.
    pub(crate) fn just_broke(&self, pair: Pair) -> bool {
        self.broken
            .binary_search_by_key(&pair, |&position| self.pairs[position as usize])
            .is_ok()
    }

    /// Remove the bonds that broke in the latest evaluation.
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
        let Self {
            pairs,
            references,
            angles,
            distances,
            strength_factors,
            sections,
            radii,
            broken,
        } = self;
        remove(pairs, broken);
        for column in references.iter_mut().chain(angles).chain(radii) {
            remove(column, broken);
        }
        remove(distances, broken);
        remove(strength_factors, broken);
        remove(sections, broken);
        broken.clear();
    }
}

/// Unstrained state of the bond at an index.
#[inline(always)]
fn rest_at<S: Real, C: Deref<Target = [S]>>(
    references: &[C; 2],
    angles: &[C; 2],
    distances: &[S],
    position: usize,
) -> Rest<S> {
    let [x, y] = columns::at(references, position);
    Rest {
        reference: Vec2::new(x, y),
        angles: columns::at(angles, position),
        distance: distances[position],
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

fn begin<S: Real, M: Metric>(metric: M, particles: &Particles<S>, start: &BondStart) -> Bond<S> {
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
    Bond {
        pair,
        rest: Rest {
            reference: frame.normal,
            angles: rest_angles(&frame, [particles.angle[i], particles.angle[j]], angles),
            distance: start.initial_distance.map_or(frame.distance, S::from_f64),
        },
        strength_factor: S::from_f64(start.strength_factor),
    }
}
