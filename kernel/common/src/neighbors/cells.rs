//! Cells that tile the box: the index space of thesis appendix G.

use crate::geometry::Vec2;
use gouge_equations::rendered;

/// Index of a cell: column and row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CellIndex {
    /// Column.
    pub x: i64,
    /// Row.
    pub y: i64,
}

/// A grid of rectangular cells over a box. Points outside an open edge belong to the cell at that edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cells {
    origin: Vec2,
    side: Vec2,
    columns: i64,
    rows: i64,
    periodic: bool,
}

#[rendered]
impl Cells {
    /// A grid over the box whose cells have sides of at least `smallest_side` in m.
    ///
    /// Cells are enlarged such that there are no more than about four times `number_scale` of them, however sparse
    /// the box: this bounds the memory.
    pub fn new(
        origin: Vec2,
        extent: Vec2,
        periodic: bool,
        smallest_side: f64,
        number_scale: usize,
    ) -> Self {
        let per_axis = (number_scale as f64).sqrt().max(1.0);
        let number = |length: f64| {
            let fits = libm::floor(length / smallest_side);
            if fits >= 1.0 {
                fits.min(per_axis * 8.0) as i64
            } else {
                1
            }
        };
        let (columns, mut rows) = (number(extent.x), number(extent.y));
        if (columns * rows) as f64 > 4.0 * per_axis * per_axis {
            rows = ((4.0 * per_axis * per_axis) as i64 / columns).max(1);
        }
        let side = Vec2::new(extent.x / columns as f64, extent.y / rows as f64);
        Self {
            origin,
            side,
            columns,
            rows,
            periodic,
        }
    }

    /// Number of cells of the grid.
    pub fn number(&self) -> usize {
        (self.columns * self.rows) as usize
    }

    /// The shorter side of a cell in m.
    pub fn smaller_side(&self) -> f64 {
        self.side.x.min(self.side.y)
    }

    /// The cell that contains a point.
    ///
    /// $$ \downarrow \vec x = \left( \lfloor x / l^x \rfloor, \lfloor y / l^y \rfloor \right) $$
    ///
    /// Thesis eq. (134). Points outside the grid belong to the nearest cell at its edge.
    pub fn cell_at(&self, point: Vec2) -> CellIndex {
        let along = |x: f64, origin: f64, side: f64, cells: i64| {
            (libm::floor((x - origin) / side) as i64).clamp(0, cells - 1)
        };
        CellIndex {
            x: along(point.x, self.origin.x, self.side.x, self.columns),
            y: along(point.y, self.origin.y, self.side.y, self.rows),
        }
    }

    /// Centre of a cell in m.
    ///
    /// $$ \uparrow (i, j) = \left( l^x (i + \tfrac12), l^y (j + \tfrac12) \right) $$
    ///
    /// Thesis eq. (135).
    pub fn centre(&self, index: CellIndex) -> Vec2 {
        Vec2::new(
            self.origin.x + self.side.x * (index.x as f64 + 0.5),
            self.origin.y + self.side.y * (index.y as f64 + 0.5),
        )
    }

    /// Chebyshev distance of two cells, as a number of cells.
    ///
    /// $$ d = \max\{\lvert \Delta i \rvert, \lvert \Delta j \rvert\} $$
    ///
    /// Thesis eq. (136), with the absolute values that the thesis omits. In a periodic box columns are counted
    /// across the seam if that is shorter (erratum E33 of the thesis).
    pub fn distance(&self, a: CellIndex, b: CellIndex) -> i64 {
        let straight = (a.x - b.x).abs();
        let columns = if self.periodic {
            straight.min(self.columns - straight)
        } else {
            straight
        };
        columns.max((a.y - b.y).abs())
    }

    /// Position of a cell in lexicographical order, row by row.
    pub fn rank(&self, index: CellIndex) -> usize {
        (index.y * self.columns + index.x) as usize
    }

    /// The cell itself and those adjacent cells that follow it in lexicographical order.
    ///
    /// Iterated over all cells, every unordered pair of adjacent cells appears exactly once, even if a periodic
    /// box has so few columns that a cell is adjacent on both sides.
    pub fn neighbors_from(&self, index: CellIndex) -> impl Iterator<Item = CellIndex> + use<> {
        let cells = *self;
        let mut found = [index; 9];
        let mut number = 1;
        for dy in -1..=1 {
            for dx in -1..=1 {
                let Some(other) = cells.shifted(index, dx, dy) else {
                    continue;
                };
                let later = cells.rank(other) > cells.rank(index);
                if later && !found[..number].contains(&other) {
                    found[number] = other;
                    number += 1;
                }
            }
        }
        found.into_iter().take(number)
    }

    fn shifted(&self, index: CellIndex, dx: i64, dy: i64) -> Option<CellIndex> {
        let y = index.y + dy;
        let x = index.x + dx;
        let x = if self.periodic {
            x.rem_euclid(self.columns)
        } else {
            x
        };
        let inside = (0..self.columns).contains(&x) && (0..self.rows).contains(&y);
        inside.then_some(CellIndex { x, y })
    }
}

/// Whether particle `i` precedes particle `j`: ordered by cell, then by index, thesis eq. (137).
pub fn precedes(cells: &Cells, i: (CellIndex, usize), j: (CellIndex, usize)) -> bool {
    (cells.rank(i.0), i.1) < (cells.rank(j.0), j.1)
}
