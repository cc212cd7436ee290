//! Cells that tile the plane: the index space of thesis appendix G.

use crate::geometry::Vec2;
use core::cmp::Ordering;
use gouge_equations::rendered;

/// Index of a cell; cells are ordered row by row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct CellIndex {
    /// Row.
    pub y: i64,
    /// Column.
    pub x: i64,
}

/// Adjacent cells of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// The first cell.
    pub first: CellIndex,
    /// Number of cells.
    pub number: i64,
}

impl Run {
    /// Whether a cell is one of them.
    #[inline]
    pub fn contains(self, cell: CellIndex) -> bool {
        cell.y == self.first.y && (0..self.number).contains(&(cell.x - self.first.x))
    }

    /// The cells that do not precede a given one.
    #[inline]
    pub fn from(self, cell: CellIndex) -> Self {
        let skipped = match self.first.y.cmp(&cell.y) {
            Ordering::Less => self.number,
            Ordering::Equal => (cell.x - self.first.x).clamp(0, self.number),
            Ordering::Greater => 0,
        };
        Self {
            first: CellIndex {
                x: self.first.x + skipped,
                ..self.first
            },
            number: self.number - skipped,
        }
    }
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
        let columns = period.map(|length| ((length / smallest_side) as i64).clamp(1, FARTHEST));
        let width = period.zip(columns).map(|(length, all)| length / all as f64);
        Self {
            side: Vec2::new(width.unwrap_or(smallest_side), smallest_side),
            columns,
        }
    }

    /// Width and height of a cell in m.
    pub fn side(&self) -> Vec2 {
        self.side
    }

    /// The cell that contains a point.
    ///
    /// $$ \downarrow \vec x = \left( \lfloor x / l^x \rfloor, \lfloor y / l^y \rfloor \right) $$
    ///
    /// Thesis eq. (134). Points farther than 2^44 cells from the origin belong to the farthest cell.
    #[inline]
    pub fn cell_at(&self, point: Vec2) -> CellIndex {
        let along = |x: f64, side: f64| {
            let limit = FARTHEST as f64;
            let number = (x / side).clamp(-limit, limit);
            let towards_zero = number as i64;
            towards_zero - i64::from(number < towards_zero as f64)
        };
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
    #[inline]
    pub fn around(&self, index: CellIndex) -> impl Iterator<Item = Run> + use<> {
        let columns = match self.columns {
            Some(all) if all < 3 => [(0, all), (0, 0)],
            Some(all) if index.x == 0 => [(0, 2), (all - 1, 1)],
            Some(all) if index.x == all - 1 => [(index.x - 1, 2), (0, 1)],
            _ => [(index.x - 1, 3), (0, 0)],
        };
        (index.y - 1..=index.y + 1).flat_map(move |y| {
            let run = move |(x, number)| Run {
                first: CellIndex { y, x },
                number,
            };
            columns.into_iter().map(run).filter(|run| run.number > 0)
        })
    }

    #[inline]
    fn wrapped(&self, x: i64) -> i64 {
        match self.columns {
            Some(columns) if x < 0 || x >= columns => x.rem_euclid(columns),
            _ => x,
        }
    }
}

/// Whether particle `i` precedes particle `j`: ordered by cell, then by index, thesis eq. (137).
#[inline]
pub fn precedes(i: (CellIndex, usize), j: (CellIndex, usize)) -> bool {
    i < j
}
