//! Assembly of a network of beams, and its linear statics.

use super::Springs;
use faer::linalg::solvers::Solve;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};
use nalgebra::DMatrix;

/// A beam between two bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// The bodies.
    pub between: [usize; 2],
    /// Vector from the first to the second in m.
    pub apart: [f64; 2],
    /// Lever arms in m.
    pub radii: [f64; 2],
}

impl Beam {
    /// Elongation and displacements of both ends, as linear forms in (x, y, phi) of both bodies.
    fn strains(&self) -> [[f64; 6]; 3] {
        let [x, y] = self.apart;
        let length = x.hypot(y);
        let (c, s) = (x / length, y / length);
        let line = [s, -c, 0.0, -s, c, 0.0].map(|part| part / length);
        let end = |n: usize| {
            let mut row = line.map(|part| -self.radii[n] * part);
            row[3 * n + 2] += self.radii[n];
            row
        };
        [[-c, -s, 0.0, c, s, 0.0], end(0), end(1)]
    }

    /// Stiffness matrix: the sum of k times the square of each strain.
    fn stiffness(&self, springs: Springs) -> [[f64; 6]; 6] {
        let constants = [springs.normal, springs.tangential, springs.tangential];
        let mut matrix = [[0.0; 6]; 6];
        for (row, k) in self.strains().iter().zip(constants) {
            for (line, a) in matrix.iter_mut().zip(row) {
                for (entry, b) in line.iter_mut().zip(row) {
                    *entry += k * a * b;
                }
            }
        }
        matrix
    }

    /// Indices of its coordinates among those of all bodies.
    fn places(&self) -> [usize; 6] {
        std::array::from_fn(|n| 3 * self.between[n / 3] + n % 3)
    }

    /// Entries of the matrix of the network.
    fn entries(&self, springs: Springs) -> impl Iterator<Item = (usize, usize, f64)> {
        let (matrix, places) = (self.stiffness(springs), self.places());
        (0..36).map(move |n| (places[n / 6], places[n % 6], matrix[n / 6][n % 6]))
    }
}

/// Stiffness matrix of the given number of bodies, in the order x, y, phi for each.
pub fn stiffness(bodies: usize, beams: &[Beam], springs: Springs) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(3 * bodies, 3 * bodies);
    for (row, column, value) in beams.iter().flat_map(|beam| beam.entries(springs)) {
        matrix[(row, column)] += value;
    }
    matrix
}

/// Displacements of all coordinates if the given ones are prescribed and the others are free of force;
/// none if the network is not rigid.
pub fn settle(beams: &[Beam], springs: Springs, held: &[Option<f64>]) -> Option<Vec<f64>> {
    let mut place = vec![None; held.len()];
    let free: Vec<usize> = (0..held.len()).filter(|&n| held[n].is_none()).collect();
    free.iter()
        .enumerate()
        .for_each(|(at, &n)| place[n] = Some(at));
    let mut triplets = Vec::new();
    let mut load = Mat::<f64>::zeros(free.len(), 1);
    for (row, column, value) in beams.iter().flat_map(|beam| beam.entries(springs)) {
        match (place[row], place[column], held[column]) {
            (Some(row), Some(column), _) => triplets.push(Triplet::new(row, column, value)),
            (Some(row), None, Some(given)) => load[(row, 0)] -= value * given,
            _ => {}
        }
    }
    let matrix = SparseColMat::try_new_from_triplets(free.len(), free.len(), &triplets).ok()?;
    let solved = matrix.sp_cholesky(Side::Lower).ok()?.solve(&load);
    let value = |n: usize| place[n].map_or(held[n], |at| Some(solved[(at, 0)]));
    (0..held.len()).map(value).collect()
}
