//! Beads on a line, joined by springs along it and by springs between the turning of each end and the
//! turning of the line of centres: what follows from the energy
//!
//! U = k (D - D0)^2 / 2 + k r_i^2 (phi_i - lambda)^2 / 2 + k r_j^2 (phi_j - lambda)^2 / 2.

use nalgebra::{Matrix2, Matrix3, SymmetricEigen};
use std::f64::consts::TAU;

/// Squared angular frequencies over k / kg of a pair with the given masses, moments of inertia, radii and
/// distance, in rising order: three of free motion, then those of its springs.
pub fn pair(mass: [f64; 2], inertia: [f64; 2], radii: [f64; 2], distance: f64) -> [f64; 6] {
    let reduced = mass[0] * mass[1] / (mass[0] + mass[1]);
    let [a, b] = radii.map(|r| r * r);
    let stiffness = Matrix3::new(
        a,
        0.0,
        -a / distance,
        0.0,
        b,
        -b / distance,
        -a / distance,
        -b / distance,
        (a + b) / (distance * distance),
    );
    let roots = [inertia[0], inertia[1], reduced].map(f64::sqrt);
    let scaled = Matrix3::from_fn(|i, j| stiffness[(i, j)] / (roots[i] * roots[j]));
    let across = SymmetricEigen::new(scaled).eigenvalues;
    let mut all = [0.0, 0.0, 1.0 / reduced, across[0], across[1], across[2]];
    all.sort_by(f64::total_cmp);
    all
}

/// Deflection of the last bead of a cantilever of so many links under a force across it, in units of
/// F D^2 / (k r^2): moments between links balance at every bead, which leaves sums of odd numbers.
pub fn deflection(links: f64) -> f64 {
    (2.0 * links * links * links + links) / 3.0
}

/// Squared angular frequencies in 1/s^2 of a ring of beads of radius r at a distance of 2 r, for all waves
/// that fit, in rising order.
pub fn ring(beads: usize, k: f64, mass: f64, inertia: f64, r: f64) -> Vec<f64> {
    let wave = |n: usize| branches(TAU * n as f64 / beads as f64, k, mass, inertia, r);
    let mut all: Vec<f64> = (0..beads).flat_map(wave).collect();
    all.sort_by(f64::total_cmp);
    all
}

/// The three branches at a phase per bead: along the line, and two of bending and turning.
pub fn branches(phase: f64, k: f64, mass: f64, inertia: f64, r: f64) -> [f64; 3] {
    let half = (0.5 * phase).sin();
    let along = 4.0 * k / mass * half * half;
    // A quarter of a period between displacement and turning makes the matrix real.
    let coupling = k * r * phase.sin() / (mass * inertia).sqrt();
    let across = Matrix2::new(
        2.0 * k * half * half / mass,
        coupling,
        coupling,
        2.0 * k * r * r / inertia,
    );
    let found = SymmetricEigen::new(across).eigenvalues;
    [along, found[0], found[1]]
}
