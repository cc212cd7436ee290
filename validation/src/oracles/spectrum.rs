//! The largest stable step of a linear network M q'' = -K q - C q', by faer.
//!
//! Stability at a given step is a property of the matrix pencil of a method. Let lambda be an
//! eigenvalue and u its eigenvector: u* P(lambda) u = 0, where P is the polynomial of the method with
//! the numbers k and c replaced by dt^2 K and dt C. For symmetric K and C the numbers u* K u and u* C u
//! are those of a single oscillator. Hence no lambda leaves the unit circle as long as no oscillator
//! with numbers in their range is unstable. Symplectic Euler and velocity Verlet lose stability at
//! lambda = -1 only. Therefore positive definiteness, up to sign, of P(-1),
//!
//! 4 M - 2 dt C - dt^2 K and 4 M - 4 dt C - dt^2 K,
//!
//! is sufficient. It is also necessary: if P(-1) is indefinite, P is definite with the opposite sign
//! further out on the negative axis, so an eigenvalue lies in between.
//! further out on the negative axis, and an eigenvalue vanishes in between.

use super::amplification::Method;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};

/// An entry of a sparse matrix: row, column, value.
pub type Entry = (usize, usize, f64);

/// A linear network with a diagonal mass matrix.
#[derive(Clone, Debug, Default)]
pub struct Network {
    /// Masses in kg and moments of inertia in kg m^2, on the diagonal of M.
    pub inertia: Vec<f64>,
    /// Stiffness K.
    pub stiffness: Vec<Entry>,
    /// Damping C.
    pub damping: Vec<Entry>,
}

impl Network {
    /// Entries divided by the square roots of the inertias of their row and column.
    fn scaled<'a>(&'a self, entries: &'a [Entry]) -> impl Iterator<Item = Entry> + 'a {
        entries.iter().map(|&(row, column, value)| {
            let root = (self.inertia[row] * self.inertia[column]).sqrt();
            (row, column, value / root)
        })
    }

    /// Squared angular frequencies in 1/s^2, in ascending order; none if the decomposition fails.
    pub fn squared_frequencies(&self) -> Vec<f64> {
        let size = self.inertia.len();
        let mut dense = Mat::<f64>::zeros(size, size);
        for (row, column, value) in self.scaled(&self.stiffness) {
            dense[(row, column)] += value;
        }
        dense
            .self_adjoint_eigenvalues(Side::Lower)
            .unwrap_or_default()
    }

    /// Whether 4 M - a dt C - dt^2 K is positive definite, by a sparse Cholesky decomposition.
    fn is_definite(&self, step: f64, weight: f64) -> bool {
        let size = self.inertia.len();
        let stiff = self
            .scaled(&self.stiffness)
            .map(|(row, column, value)| (row, column, -step * step * value));
        let damped = self
            .scaled(&self.damping)
            .map(|(row, column, value)| (row, column, -weight * step * value));
        let diagonal = (0..size).map(|n| (n, n, 4.0));
        let triplets: Vec<Triplet<usize, usize, f64>> = diagonal
            .chain(stiff)
            .chain(damped)
            .map(|(row, column, value)| Triplet::new(row, column, value))
            .collect();
        SparseColMat::try_new_from_triplets(size, size, &triplets)
            .is_ok_and(|matrix| matrix.sp_cholesky(Side::Lower).is_ok())
    }

    /// The largest stable step in s of a method that loses stability only at an eigenvalue of minus
    /// one, for any symmetric damping; none for other methods.
    pub fn critical_step(&self, method: Method) -> Option<f64> {
        let weight = match method {
            Method::SymplecticEuler => 2.0,
            Method::VelocityVerlet => 4.0,
            Method::Euler | Method::Taylor | Method::Beeman => return None,
        };
        let (mut low, mut high) = (0.0, 1.0e-12);
        while self.is_definite(high, weight) {
            (low, high) = (high, 4.0 * high);
        }
        while high - low > 1e-10 * high {
            let middle = 0.5 * (low + high);
            if self.is_definite(middle, weight) {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(low)
    }
}

#[cfg(test)]
mod tests {
    use super::{Entry, Network};
    use crate::oracles::amplification::Method;
    use nalgebra::DMatrix;

    /// A symmetric matrix of low rank plus a diagonal, different for each seed.
    fn symmetric(seed: f64, diagonal: f64) -> DMatrix<f64> {
        let factor = DMatrix::from_fn(3, 2, |i, j| (seed * (1 + 2 * i + 3 * j) as f64).sin());
        &factor * factor.transpose() + DMatrix::identity(3, 3) * diagonal
    }

    fn entries(matrix: &DMatrix<f64>) -> Vec<Entry> {
        let all = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
        all.map(|(i, j)| (i, j, matrix[(i, j)])).collect()
    }

    /// Largest modulus of the block matrix of one step.
    fn radius(method: Method, k: &DMatrix<f64>, c: &DMatrix<f64>, step: f64) -> f64 {
        let one = DMatrix::<f64>::identity(3, 3);
        let (k, c) = (k * (step * step), c * step);
        let blocks: Vec<Vec<DMatrix<f64>>> = match method {
            Method::SymplecticEuler => {
                vec![vec![&one - &k, &one - &c], vec![-&k, &one - &c]]
            }
            _ => {
                let zero = DMatrix::zeros(3, 3);
                let new = [-&k, -&k - &c, -&k * 0.5 - &c];
                let half = |block: &DMatrix<f64>| block * 0.5;
                vec![
                    vec![one.clone(), one.clone(), &one * 0.5],
                    vec![
                        zero + half(&new[0]),
                        &one + half(&new[1]),
                        &one * 0.5 + half(&new[2]),
                    ],
                    new.to_vec(),
                ]
            }
        };
        let size = 3 * blocks.len();
        let whole = DMatrix::from_fn(size, size, |i, j| blocks[i / 3][j / 3][(i % 3, j % 3)]);
        let values = whole.complex_eigenvalues();
        values.iter().map(|z| z.re.hypot(z.im)).fold(0.0, f64::max)
    }

    #[test]
    fn matrices_that_do_not_commute_lose_stability_where_the_pencil_says() {
        let (k, c) = (symmetric(0.7, 0.1), symmetric(1.9, 0.05) * 0.3);
        assert!((&k * &c - &c * &k).norm() > 0.05);
        let network = Network {
            inertia: vec![1.0; 3],
            stiffness: entries(&k),
            damping: entries(&c),
        };
        for method in [Method::SymplecticEuler, Method::VelocityVerlet] {
            let step = network.critical_step(method).unwrap_or(f64::NAN);
            assert!(radius(method, &k, &c, 0.9999 * step) < 1.0);
            assert!(radius(method, &k, &c, 1.0001 * step) > 1.0);
        }
    }
}
