//! Fragments and cracks in the final state of a sheared block.

use gouge_common::estimators::{Fragments, connected};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// The final state of a run: grains, which of them belong to the debris, and the bonds that broke.
///
/// Fragments that hold a driven or fixed grain are blocks; all others together are the debris.
#[derive(Clone, Debug)]
pub struct FinalState {
    grains: Vec<Grain>,
    fragments: Fragments,
    /// Whether a grain belongs to the debris.
    is_debris: Vec<bool>,
    breaks: Vec<(usize, usize)>,
    /// Period in x in m.
    width: f64,
}

#[derive(Clone, Debug, Deserialize)]
struct Grain {
    x: f64,
    y: f64,
    radius: f64,
    role: String,
}

impl Grain {
    /// Whether it is driven or fixed.
    fn is_edge(&self) -> bool {
        self.role != "free"
    }
}

/// A bond or a break.
#[derive(Deserialize)]
struct Pair {
    i: usize,
    j: usize,
}

/// The rows of a CSV file; none if it cannot be read.
fn rows<T: for<'de> Deserialize<'de>>(path: &Path) -> Option<Vec<T>> {
    let reader = csv::Reader::from_path(path).ok()?;
    reader.into_deserialize().collect::<Result<_, _>>().ok()
}

fn pairs(path: &Path) -> Option<Vec<(usize, usize)>> {
    let pairs = rows::<Pair>(path)?.into_iter();
    Some(pairs.map(|pair| (pair.i, pair.j)).collect())
}

impl FinalState {
    /// The final state of the run in a folder, in a box with a period in x in m; none if the run has no bonds that can
    /// break, or its files do not fit each other.
    pub fn read(folder: &Path, width: f64) -> Option<Self> {
        let grains: Vec<Grain> = rows(&folder.join("particles.csv"))?;
        let bonds = pairs(&folder.join("bonds.csv"))?;
        let breaks = pairs(&folder.join("breaks.csv"))?;
        let exists = |(i, j): &(usize, usize)| *i < grains.len() && *j < grains.len();
        if grains.is_empty() || !bonds.iter().chain(&breaks).all(exists) {
            return None;
        }
        let fragments = connected(grains.len(), bonds.into_iter());
        let mut is_block = vec![false; fragments.number];
        for (&label, grain) in fragments.label.iter().zip(&grains) {
            is_block[label] |= grain.is_edge();
        }
        let is_debris = fragments.label.iter().map(|&label| !is_block[label]);
        Some(Self {
            is_debris: is_debris.collect(),
            grains,
            fragments,
            breaks,
            width,
        })
    }

    /// Mean diameter of the grains in m.
    fn diameter(&self) -> f64 {
        let sum: f64 = self.grains.iter().map(|grain| grain.radius).sum();
        2.0 * sum / self.grains.len() as f64
    }

    /// The grains of the debris.
    fn debris(&self) -> impl Iterator<Item = usize> {
        (0..self.grains.len()).filter(|&grain| self.is_debris[grain])
    }

    /// Number of fragments in the debris.
    pub fn debris_fragments(&self) -> usize {
        let mut labels: Vec<usize> = self
            .debris()
            .map(|grain| self.fragments.label[grain])
            .collect();
        labels.sort_unstable();
        labels.dedup();
        labels.len()
    }

    /// Mean number of grains of the debris that lie above each other.
    pub fn debris_depth(&self) -> f64 {
        self.debris().count() as f64 * self.diameter() / self.width
    }

    /// Length of the longest crack in mean diameters. A crack is a chain of broken bonds within a block, each of which
    /// shares a grain with the next; its length is the diagonal of the rectangle around its grains.
    pub fn longest_crack(&self) -> f64 {
        let label = &self.fragments.label;
        let is_inside = |(i, j): &(usize, usize)| label[*i] == label[*j] && !self.is_debris[*i];
        let cracks = self.chains(|pair| is_inside(pair));
        let lengths = cracks.iter().map(|crack| self.diagonal(crack));
        lengths.fold(0.0, f64::max) / self.diameter()
    }

    /// Least distance in mean diameters between a driven or fixed grain and a crack that begins at the debris; infinite
    /// if there is none. Here all broken bonds form cracks, those within the debris, too.
    pub fn crack_gap(&self) -> f64 {
        let cracks = self.chains(|_| true);
        let begins_there = |crack: &&Crack| crack.grains().any(|grain| self.is_debris[grain]);
        let grains = cracks.iter().filter(begins_there).flat_map(Crack::grains);
        let gaps = grains.map(|grain| self.gap(grain));
        gaps.fold(f64::INFINITY, f64::min) / self.diameter()
    }

    /// Number of grains of the debris less than 1.5 mean diameters away from a driven or fixed grain.
    pub fn edge_debris(&self) -> usize {
        let limit = 1.5 * self.diameter();
        self.debris()
            .filter(|&grain| self.gap(grain) < limit)
            .count()
    }

    /// Distance between a grain and the nearest driven or fixed one.
    fn gap(&self, grain: usize) -> f64 {
        let edge = (0..self.grains.len()).filter(|&other| self.grains[other].is_edge());
        let distances = edge.map(|other| {
            let [x, y] = self.displacement(grain, other);
            x.hypot(y)
        });
        distances.fold(f64::INFINITY, f64::min)
    }

    /// Displacement from one grain to another, the shortest one across the period.
    fn displacement(&self, from: usize, to: usize) -> [f64; 2] {
        let (from, to) = (&self.grains[from], &self.grains[to]);
        let x = to.x - from.x;
        [x - self.width * (x / self.width).round(), to.y - from.y]
    }

    /// Chains of the broken bonds that count.
    fn chains(&self, counts: impl Fn(&(usize, usize)) -> bool) -> Vec<Crack> {
        let counted = || self.breaks.iter().copied().filter(|pair| counts(pair));
        let label = connected(self.grains.len(), counted()).label;
        let mut cracks: BTreeMap<usize, Crack> = BTreeMap::new();
        for (i, j) in counted() {
            cracks.entry(label[i]).or_default().0.push((i, j));
        }
        cracks.into_values().collect()
    }

    /// Diagonal of the rectangle around the grains of a crack in m.
    fn diagonal(&self, crack: &Crack) -> f64 {
        let places = self.places(crack);
        let extent = |axis: usize| {
            let values = || places.values().map(|place| place[axis]);
            values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
        };
        extent(0).hypot(extent(1))
    }

    /// Places of the grains of a crack, followed from pair to pair across the period.
    fn places(&self, crack: &Crack) -> BTreeMap<usize, [f64; 2]> {
        let mut places = BTreeMap::new();
        places.extend(crack.0.first().map(|&(first, _)| (first, [0.0; 2])));
        let mut is_growing = true;
        while is_growing {
            is_growing = false;
            for (i, j) in crack.0.iter().flat_map(|&(i, j)| [(i, j), (j, i)]) {
                if let (Some(&[x, y]), false) = (places.get(&i), places.contains_key(&j)) {
                    let [along, up] = self.displacement(i, j);
                    places.insert(j, [x + along, y + up]);
                    is_growing = true;
                }
            }
        }
        places
    }
}

/// Broken bonds that are connected through shared grains.
#[derive(Clone, Debug, Default)]
struct Crack(Vec<(usize, usize)>);

impl Crack {
    fn grains(&self) -> impl Iterator<Item = usize> {
        self.0.iter().flat_map(|&(i, j)| [i, j])
    }
}
