//! The longest stable time steps.

use crate::bonds::Bonds;
use crate::contact_law::{Node, largest_step};
use crate::contacts::Contact;
use crate::error::SetupError;
use crate::forces::{Settings, Walls};
use crate::grain::{GrainRow, Grains};
use core::f64::consts::PI;
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

/// Longest steps in s by what limits them; infinite if it is absent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Of bonds.
    pub bonds: BondLimits,
    /// Of the repulsion between nodes.
    pub contact: f64,
    /// Of repulsion with damping between nodes.
    pub damping: f64,
    /// Of repulsion and damping at walls.
    pub walls: f64,
}

/// Square of a frequency in 1/s^2 and rate of damping in 1/s.
#[derive(Clone, Copy, Debug, Default)]
struct Oscillator {
    frequency_squared: f64,
    damping_rate: f64,
}

impl Oscillator {
    /// Longest step in s, if damping acts on vibrations of bonds too, whose largest frequency squared is given in 1/s^2.
    fn largest_step(self, of_bonds: f64) -> f64 {
        let frequency_squared = if self.damping_rate > 0.0 {
            self.frequency_squared.max(of_bonds)
        } else {
            self.frequency_squared
        };
        largest_step(frequency_squared, self.damping_rate)
    }
}

#[rendered]
impl Limits {
    /// Limits of grains in their reference positions, with valid settings.
    ///
    /// A node in contact is assumed to have equal partners in half a disc of the contact radius:
    ///
    /// $$ \omega^2 = \frac{2 K}{\rho} \frac{\pi R_c^2}{2}, \qquad \lambda = \frac{2 n c_d}{\rho V}, \qquad n = \frac{\pi R_c^2}{2 V} $$
    ///
    /// K is the largest stiffness of its material, or $c/R_c$ of self contact. Damping, however weak, also acts on the
    /// vibrations of bonds, which the velocities of the previous step feed above $\omega \Delta t = \sqrt 2$: with it,
    /// $\omega^2$ is at least that of bonds (peridem Q8). More partners, as in a sharp corner or under strong compression,
    /// lower the limits.
    pub fn of(grains: &Grains, bonds: &Bonds, settings: &Settings) -> Self {
        let of_bonds = BondLimits::of(grains, bonds);
        let frequency_squared = (2.0 / of_bonds.exact).powi(2);
        let smallest = |oscillator: &dyn Fn(&GrainRow, f64) -> Oscillator| {
            let rows = grains.rows.iter();
            let of_row = |row| oscillator(row, smallest_area(grains, row));
            let steps = rows.map(|row| of_row(row).largest_step(frequency_squared));
            steps.fold(f64::INFINITY, f64::min)
        };
        let mut limits = Self {
            bonds: of_bonds,
            contact: f64::INFINITY,
            damping: f64::INFINITY,
            walls: f64::INFINITY,
        };
        if let Some(contact) = &settings.contact {
            limits.contact = smallest(&|row, area| Oscillator {
                damping_rate: 0.0,
                ..between_nodes(contact, row, area)
            });
            limits.damping = smallest(&|row, area| between_nodes(contact, row, area));
        }
        if let Some(walls) = &settings.walls {
            limits.walls = smallest(&|row, area| at_wall(walls, row, area));
        }
        limits
    }

    /// The limits with their names, without the bound by row sums.
    pub fn named(&self) -> [(&'static str, f64); 4] {
        [
            ("bonds", self.bonds.exact),
            ("contact", self.contact),
            ("damping", self.damping),
            ("walls", self.walls),
        ]
    }

    /// The smallest limit in s with its name.
    pub fn smallest(&self) -> (&'static str, f64) {
        let [first, others @ ..] = self.named();
        others.into_iter().fold(
            first,
            |least, other| {
                if other.1 < least.1 { other } else { least }
            },
        )
    }

    /// Refuse a step in s above a limit.
    ///
    /// # Errors
    /// [`SetupError::TimeStep`] with the smallest limit.
    pub fn check(&self, step: f64) -> Result<(), SetupError> {
        let (limit, value) = self.smallest();
        if step <= value {
            return Ok(());
        }
        Err(SetupError::TimeStep { step, limit, value })
    }
}

fn smallest_area(grains: &Grains, row: &GrainRow) -> f64 {
    let areas = grains.area[row.nodes.clone()].iter().copied();
    areas.fold(f64::INFINITY, f64::min)
}

/// A node of a grain among partners in half a disc.
fn between_nodes(contact: &Contact, row: &GrainRow, area: f64) -> Oscillator {
    let law = &contact.law;
    let own = contact.stiffness.get(row.material);
    let mut stiffness = own.map_or(0.0, |own| own.iter().copied().fold(0.0, f64::max));
    if row.touches_itself {
        stiffness = stiffness.max(row.contact_stiffness / law.radius);
    }
    let node = Node {
        area,
        density: row.density,
    };
    let half_disc = 0.5 * PI * law.radius * law.radius;
    let damping = law.damping(&node, &node, stiffness);
    Oscillator {
        frequency_squared: 2.0 * stiffness * half_disc / row.density,
        damping_rate: 2.0 * half_disc * damping / (area * node.mass()),
    }
}

/// A node of a grain at a wall.
fn at_wall(walls: &Walls, row: &GrainRow, area: f64) -> Oscillator {
    let law = &walls.law;
    let node = Node {
        area,
        density: row.density,
    };
    let damping = [0.0, -law.radius].map(|distance| law.damping(distance, &node));
    Oscillator {
        frequency_squared: law.steepest(area) / node.mass(),
        damping_rate: damping[0].max(damping[1]) / node.mass(),
    }
}
