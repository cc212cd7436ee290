//! The longest stable time steps.

use crate::bonds::Bonds;
use crate::grain::Grains;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Most products with the matrix of bonds.
const PRODUCTS: usize = 200;
/// Relative change of the largest eigenvalue over five products at which it counts as found.
const CONVERGED: f64 = 1e-10;
/// Products between two tests of convergence.
const TEST_INTERVAL: usize = 5;

/// Longest steps in s for which the bonds of grains at rest are stable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondLimits {
    /// From the largest frequency of the grains: exact. Infinite without bonds.
    pub exact: f64,
    /// From the bound on it by row sums, which is up to half of the exact one.
    pub row_sum: f64,
}

/// A bond at rest: its nodes, its direction, and its stiffness in N/m per metre of depth.
struct Spring {
    ends: [usize; 2],
    direction: Vec2,
    stiffness: f64,
}

/// The matrix of the linearised bonds, scaled by the masses, without the rows of clamped nodes. It is not stored: it would
/// need more room than the bonds themselves.
struct Vibration<'a> {
    grains: &'a Grains,
    bonds: &'a Bonds,
    /// Inverse square roots of the masses; zero for clamped nodes.
    scale: Vec<f64>,
}

impl<'a> Vibration<'a> {
    fn new(grains: &'a Grains, bonds: &'a Bonds) -> Self {
        let mut scale: Vec<_> = (0..grains.nodes())
            .map(|node| 1.0 / grains.mass(node).sqrt())
            .collect();
        for &node in &grains.clamped {
            scale[node as usize] = 0.0;
        }
        Self {
            grains,
            bonds,
            scale,
        }
    }

    fn springs(&self) -> impl Iterator<Item = Spring> + '_ {
        let grains = self.grains;
        self.bonds.all().map(|(earlier, later, length)| {
            let constants = &grains.of(later).constants;
            let weight = constants.weight.at(length, constants.horizon);
            let areas = grains.area[earlier] * grains.area[later];
            Spring {
                ends: [earlier, later],
                direction: (grains.position[later] - grains.position[earlier]) * (1.0 / length),
                stiffness: constants.stiffness * weight * areas / length,
            }
        })
    }

    fn product(&self, vector: &[Vec2]) -> Vec<Vec2> {
        let mut result = vec![Vec2::zero(); vector.len()];
        for spring in self.springs() {
            let [i, j] = spring.ends;
            let change = vector[j] * self.scale[j] - vector[i] * self.scale[i];
            let force = spring.direction * (spring.stiffness * change.dot(spring.direction));
            result[i] += -force * self.scale[i];
            result[j] += force * self.scale[j];
        }
        result
    }

    /// Largest eigenvalue in 1/s^2, by the method of Lanczos.
    fn largest_eigenvalue(&self) -> f64 {
        let mut matrix = Tridiagonal::default();
        let mut vector: Vec<_> = (0..self.scale.len()).map(start).collect();
        let mut before = vec![Vec2::zero(); vector.len()];
        let mut found = 0.0;
        normalise(&mut vector);
        for step in 1..=PRODUCTS {
            let mut next = self.product(&vector);
            let diagonal = dot(&next, &vector);
            let last = matrix.off_diagonal.last().copied().unwrap_or(0.0);
            for ((next, own), before) in next.iter_mut().zip(&vector).zip(&before) {
                *next += -*own * diagonal - *before * last;
            }
            matrix.diagonal.push(diagonal);
            let norm = normalise(&mut next);
            let is_exhausted = norm <= f64::EPSILON * diagonal;
            if step % TEST_INTERVAL == 0 || is_exhausted {
                let now = matrix.largest_eigenvalue();
                if is_exhausted || now - found <= CONVERGED * now {
                    return now;
                }
                found = now;
            }
            matrix.off_diagonal.push(norm);
            before = core::mem::replace(&mut vector, next);
        }
        found
    }
}

/// A vector that has a part of every mode: sines of an irrational number of turns.
fn start(node: usize) -> Vec2 {
    let turn = node as f64;
    Vec2::new(
        libm::sin(1.0 + 2.236_067_977 * turn),
        libm::cos(2.0 + 2.645_751_311 * turn),
    )
}

fn dot(a: &[Vec2], b: &[Vec2]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

/// Divide a vector by its norm, unless it is zero, and return the norm.
fn normalise(vector: &mut [Vec2]) -> f64 {
    let norm = dot(vector, vector).sqrt();
    if norm > 0.0 {
        for value in vector {
            *value = *value * (1.0 / norm);
        }
    }
    norm
}

/// A symmetric tridiagonal matrix.
#[derive(Default)]
struct Tridiagonal {
    diagonal: Vec<f64>,
    off_diagonal: Vec<f64>,
}

impl Tridiagonal {
    /// Largest eigenvalue by bisection, with the signs of the pivots of a shifted factorisation.
    fn largest_eigenvalue(&self) -> f64 {
        let mut above: f64 = 0.0;
        for (row, diagonal) in self.diagonal.iter().enumerate() {
            let side = |at: Option<usize>| at.and_then(|at| self.off_diagonal.get(at));
            let sides = side(row.checked_sub(1)).map_or(0.0, |b| b.abs())
                + side(Some(row))
                    .filter(|_| row + 1 < self.diagonal.len())
                    .map_or(0.0, |b| b.abs());
            above = above.max(diagonal + sides);
        }
        let mut below = 0.0;
        loop {
            let middle = 0.5 * (below + above);
            if middle <= below || middle >= above {
                return above;
            }
            if self.is_above_all(middle) {
                above = middle;
            } else {
                below = middle;
            }
        }
    }

    fn is_above_all(&self, shift: f64) -> bool {
        let mut pivot = 1.0;
        self.diagonal.iter().enumerate().all(|(row, diagonal)| {
            let side = row
                .checked_sub(1)
                .map_or(0.0, |before| self.off_diagonal[before]);
            pivot = shift - diagonal - side * side / pivot;
            pivot > 0.0
        })
    }
}

#[rendered]
impl BondLimits {
    /// Limits of grains in their reference positions.
    ///
    /// $$ \Delta t = \frac{2}{\omega_{max}}, \qquad \omega_{max}^2 \le \max_x \frac{2}{\rho} \sum_y \frac{c w V_y}{r} $$
    ///
    /// where $\omega_{max}$ is the largest frequency of small vibrations about them. Clamped nodes do not move.
    pub fn of(grains: &Grains, bonds: &Bonds) -> Self {
        let vibration = Vibration::new(grains, bonds);
        let mut sums = vec![0.0; grains.nodes()];
        for spring in vibration.springs() {
            for node in spring.ends {
                sums[node] += spring.stiffness * vibration.scale[node] * vibration.scale[node];
            }
        }
        let bound = 2.0 * sums.iter().copied().fold(0.0, f64::max);
        Self {
            exact: 2.0 / vibration.largest_eigenvalue().sqrt(),
            row_sum: 2.0 / bound.sqrt(),
        }
    }
}
