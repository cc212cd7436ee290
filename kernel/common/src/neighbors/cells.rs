//! Cells that tile the plane: the index space of thesis appendix G.

use crate::geometry::Vec2;
use gouge_equations::rendered;

/// Index of a cell; cells are ordered row by row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct CellIndex {
    /// Row.
    pub y: i64,
    /// Column.
    pub x: i64,
}

/// Largest index of a cell. Beyond it, the rounding of a position would exceed the excess of a cell over the reach
/// of its particles.
const FARTHEST: i64 = 1 << 44;

/// Rectangular cells that tile the whole plane, or a strip that is periodic in x.
///
/// They have no edges but [the farthest](Cells::cell_at), so that it does not matter where particles are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cells {
    side: Vec2,
    /// Number of columns of a periodic strip.
    columns: Option<i64>,
}

#[rendered]
impl Cells {
    /// Cells with sides of `smallest_side` in m, or in a periodic strip with the shortest longer sides that divide
    /// the period.
    pub fn new(smallest_side: f64, period: Option<f64>) -> Self {
        let smallest_side = smallest_side.max(f64::MIN_POSITIVE);
        let columns = period.map(|length| {
            let fits = libm::floor(length / smallest_side) as i64;
            fits.clamp(1, FARTHEST)
        });
        let width = match (period, columns) {
            (Some(length), Some(columns)) => length / columns as f64,
            _ => smallest_side,
        };
        Self {
            side: Vec2::new(width, smallest_side),
            columns,
        }
    }

    /// Width and height of a cell in m.
    pub fn side(&self) -> Vec2 {
        self.side
    }

    /// Number of columns, if the cells tile a periodic strip.
    pub fn columns(&self) -> Option<i64> {
        self.columns
    }

    /// The cell that contains a point.
    ///
    /// $$ \downarrow \vec x = \left( \lfloor x / l^x \rfloor, \lfloor y / l^y \rfloor \right) $$
    ///
    /// Thesis eq. (134). Points farther than 2^44 cells from the origin belong to the farthest cell.
    pub fn cell_at(&self, point: Vec2) -> CellIndex {
        let along = |x: f64, side: f64| (libm::floor(x / side) as i64).clamp(-FARTHEST, FARTHEST);
        CellIndex {
            x: self.wrapped(along(point.x, self.side.x)),
            y: along(point.y, self.side.y),
        }
    }

    /// Centre of a cell in m.
    ///
    /// $$ \uparrow (i, j) = \left( l^x (i + \tfrac12), l^y (j + \tfrac12) \right) $$
    ///
    /// Thesis eq. (135).
    pub fn centre(&self, index: CellIndex) -> Vec2 {
        Vec2::new(
            self.side.x * (index.x as f64 + 0.5),
            self.side.y * (index.y as f64 + 0.5),
        )
    }

    /// Chebyshev distance of two cells, as a number of cells.
    ///
    /// $$ d = \max\{\lvert \Delta i \rvert, \lvert \Delta j \rvert\} $$
    ///
    /// Thesis eq. (136), with the absolute values that the thesis omits. In a periodic strip columns are counted
    /// across the seam if that is shorter (erratum E33 of the thesis).
    pub fn distance(&self, a: CellIndex, b: CellIndex) -> i64 {
        let straight = (a.x - b.x).abs();
        let across = self.columns.map_or(straight, |all| all - straight);
        straight.min(across).max((a.y - b.y).abs())
    }

    /// The cell itself and all cells at a distance of one, each once, even if a periodic strip has so few columns
    /// that a cell is adjacent on both sides.
    pub fn around(&self, index: CellIndex) -> impl Iterator<Item = CellIndex> + use<> {
        let cells = *self;
        // Of three columns or more, those to the left, in the middle and to the right differ.
        let steps = match cells.columns {
            Some(1) => 0..=0,
            Some(2) => 0..=1,
            _ => -1..=1,
        };
        (-1..=1).flat_map(move |dy| {
            steps.clone().map(move |dx| CellIndex {
                x: cells.wrapped(index.x + dx),
                y: index.y + dy,
            })
        })
    }

    fn wrapped(&self, x: i64) -> i64 {
        match self.columns {
            Some(columns) if x < 0 || x >= columns => x.rem_euclid(columns),
            _ => x,
        }
    }
}

/// Whether particle `i` precedes particle `j`: ordered by cell, then by index, thesis eq. (137).
pub fn precedes(i: (CellIndex, usize), j: (CellIndex, usize)) -> bool {
    i < j
}
