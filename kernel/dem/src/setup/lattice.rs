//! Lattices of particles, from which packings start (thesis section 3.7.3).

use gouge_common::geometry::Vec2;

/// How the rows of a lattice are stacked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrangement {
    /// Each point directly above another one.
    Square,
    /// Every second row shifted by half the pitch; rows are half the square root of three pitches apart.
    Hexagonal,
}

/// A lattice of points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    /// How the rows are stacked.
    pub arrangement: Arrangement,
    /// Distance between neighbouring points in m.
    pub pitch: f64,
    /// Number of points per row.
    pub columns: usize,
    /// Position of the first point in m.
    pub origin: Vec2,
}

impl Lattice {
    /// Position in m of a point; points are numbered row by row, from the bottom.
    pub fn point(&self, number: usize) -> Vec2 {
        let (row, column) = (number / self.columns, number % self.columns);
        let (shift, height) = match self.arrangement {
            Arrangement::Square => (0.0, 1.0),
            Arrangement::Hexagonal => (0.5 * (row % 2) as f64, 0.75_f64.sqrt()),
        };
        self.origin
            + Vec2::new(
                self.pitch * (column as f64 + shift),
                self.pitch * height * row as f64,
            )
    }

    /// Position of a point, displaced by up to `perturbation` in m, uniformly over a disc.
    pub fn perturbed_point(
        &self,
        number: usize,
        perturbation: f64,
        mut uniform: impl FnMut() -> f64,
    ) -> Vec2 {
        let radius = perturbation * uniform().sqrt();
        let angle = core::f64::consts::TAU * uniform();
        self.point(number) + Vec2::new(libm::cos(angle), libm::sin(angle)) * radius
    }
}
