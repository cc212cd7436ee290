//! The index space of appendix G: cells that tile the box.

use crate::geometry::Vec2;
use gouge_equations::rendered;

/// Index of a cell: column and row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Index {
    /// Column.
    pub x: i64,
    /// Row.
    pub y: i64,
}

/// Rectangular cells over a box. Cells at an open edge extend to infinity.
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
    /// Cells with sides of at least `smallest_side` over the box, at most about `most` of them.
    ///
    /// Larger cells are chosen where the box would hold more than `most`, so that a sparse box costs
    /// no memory.
    pub fn new(
        origin: Vec2,
        extent: Vec2,
        periodic: bool,
        smallest_side: f64,
        most: usize,
    ) -> Self {
        let per_axis = (most as f64).sqrt().max(1.0);
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

    /// Number of cells.
    pub fn number(&self) -> usize {
        (self.columns * self.rows) as usize
    }

    /// The smaller side of a cell in m.
    pub fn smaller_side(&self) -> f64 {
        self.side.x.min(self.side.y)
    }

    /// Cell that contains a point.
    ///
    /// $$ \downarrow \vec x = \left( \lfloor x / l^x \rfloor, \lfloor y / l^y \rfloor \right) $$
    ///
    /// Thesis eq. (134), clamped to the cells at the edges.
    pub fn down(&self, point: Vec2) -> Index {
        let along = |x: f64, origin: f64, side: f64, cells: i64| {
            (libm::floor((x - origin) / side) as i64).clamp(0, cells - 1)
        };
        Index {
            x: along(point.x, self.origin.x, self.side.x, self.columns),
            y: along(point.y, self.origin.y, self.side.y, self.rows),
        }
    }

    /// Centre of a cell in m.
    ///
    /// $$ \uparrow (i, j) = \left( l^x (i + \tfrac12), l^y (j + \tfrac12) \right) $$
    ///
    /// Thesis eq. (135).
    pub fn up(&self, index: Index) -> Vec2 {
        Vec2::new(
            self.origin.x + self.side.x * (index.x as f64 + 0.5),
            self.origin.y + self.side.y * (index.y as f64 + 0.5),
        )
    }

    /// Chebyshev distance of two cells.
    ///
    /// $$ d = \max\{\lvert \Delta i \rvert, \lvert \Delta j \rvert\} $$
    ///
    /// Thesis eq. (136) with the absolute values it lacks and, in a periodic box, columns counted the
    /// short way round (erratum E33 of the thesis).
    pub fn distance(&self, a: Index, b: Index) -> i64 {
        let straight = (a.x - b.x).abs();
        let columns = if self.periodic {
            straight.min(self.columns - straight)
        } else {
            straight
        };
        columns.max((a.y - b.y).abs())
    }

    /// Position of a cell in the lexicographical order, row by row.
    pub fn rank(&self, index: Index) -> usize {
        (index.y * self.columns + index.x) as usize
    }

    /// The cells at distance one or zero that do not come before the cell in the order.
    ///
    /// Each unordered pair of adjacent cells appears once, also where a periodic box has so few
    /// columns that a neighbour is met from both sides.
    pub fn neighbors_from(&self, index: Index) -> impl Iterator<Item = Index> + use<> {
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

    fn shifted(&self, index: Index, dx: i64, dy: i64) -> Option<Index> {
        let y = index.y + dy;
        let x = index.x + dx;
        let x = if self.periodic {
            x.rem_euclid(self.columns)
        } else {
            x
        };
        let inside = (0..self.columns).contains(&x) && (0..self.rows).contains(&y);
        inside.then_some(Index { x, y })
    }
}

/// Whether particle `i` comes before particle `j`: by cell and within a cell by index, thesis eq. (137).
pub fn precedes(cells: &Cells, i: (Index, usize), j: (Index, usize)) -> bool {
    (cells.rank(i.0), i.1) < (cells.rank(j.0), j.1)
}
