//! Small vibrations of clouds of nodes, and energies of their bonds.

use super::WeightFunction;
use crate::oracles::spectrum::Network;
use nalgebra::DMatrix;

/// Nodes with bonds between all that are not farther apart than a horizon.
pub struct Cloud {
    /// Positions in m.
    pub nodes: Vec<[f64; 2]>,
    /// Areas in m^2.
    pub areas: Vec<f64>,
    /// Density in kg/m^3.
    pub density: f64,
    /// Horizon in m.
    pub horizon: f64,
    /// Stiffness of bonds in N/m^6.
    pub stiffness: f64,
    /// Weight of bonds.
    pub weight: WeightFunction,
}

/// A mode: its squared frequency in 1/s^2, and displacements of nodes.
pub struct Mode {
    /// Squared frequency in 1/s^2.
    pub squared_frequency: f64,
    /// Displacements, of norm one with the masses.
    pub shape: Vec<[f64; 2]>,
}

impl Cloud {
    /// Pairs of nodes within the horizon.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let near = |i: usize, j: usize| {
            let [[a, b], [c, d]] = [self.nodes[i], self.nodes[j]];
            (c - a).hypot(d - b) <= self.horizon
        };
        let all = (0..self.nodes.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        all.filter(move |&(i, j)| near(i, j))
    }

    /// Energy in J/m of the bonds for displacements in m.
    pub fn energy(&self, displacement: impl Fn([f64; 2]) -> [f64; 2]) -> f64 {
        let of_pair = |(i, j): (usize, usize)| {
            let [[a, b], [c, d]] = [self.nodes[i], self.nodes[j]];
            let [[p, q], [r, s]] = [displacement([a, b]), displacement([c, d])];
            let length = (c - a).hypot(d - b);
            let stretch = (c + r - a - p).hypot(d + s - b - q) / length - 1.0;
            let areas = self.areas[i] * self.areas[j];
            let weight = (self.weight)(length / self.horizon);
            0.5 * self.stiffness * weight * stretch * stretch * length * areas
        };
        self.pairs().map(of_pair).sum()
    }

    fn network(&self) -> Network {
        let mut network = Network::default();
        for area in &self.areas {
            network.inertia.extend([self.density * area; 2]);
        }
        for (i, j) in self.pairs() {
            let [[a, b], [c, d]] = [self.nodes[i], self.nodes[j]];
            let length = (c - a).hypot(d - b);
            let direction = [(c - a) / length, (d - b) / length];
            let weight = (self.weight)(length / self.horizon);
            let stiffness = self.stiffness * weight * self.areas[i] * self.areas[j] / length;
            for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let value = stiffness * direction[row] * direction[column];
                let ends = [(i, i, 1.0), (j, j, 1.0), (i, j, -1.0), (j, i, -1.0)];
                let entry = |(m, n, sign)| (2 * m + row, 2 * n + column, sign * value);
                network.stiffness.extend(ends.map(entry));
            }
        }
        network
    }

    /// Largest angular frequency in 1/s.
    pub fn largest_frequency(&self) -> f64 {
        let all = self.network().squared_frequencies();
        all.last().copied().unwrap_or(f64::NAN).sqrt()
    }

    /// All modes, from the slowest, by nalgebra: eigenvectors of faer have residuals of 1e-3 here.
    pub fn modes(&self) -> Vec<Mode> {
        let network = self.network();
        let size = network.inertia.len();
        let mut dense = DMatrix::<f64>::zeros(size, size);
        for &(row, column, value) in &network.stiffness {
            let scale = (network.inertia[row] * network.inertia[column]).sqrt();
            dense[(row, column)] += value / scale;
        }
        let decomposed = dense.symmetric_eigen();
        let mode = |k: usize| {
            let part = |row: usize| decomposed.eigenvectors[(row, k)] / network.inertia[row].sqrt();
            let shape = (0..size / 2).map(|node| [part(2 * node), part(2 * node + 1)]);
            Mode {
                squared_frequency: decomposed.eigenvalues[k],
                shape: shape.collect(),
            }
        };
        let mut modes: Vec<_> = (0..size).map(mode).collect();
        modes.sort_by(|a, b| a.squared_frequency.total_cmp(&b.squared_frequency));
        modes
    }
}
