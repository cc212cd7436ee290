//! Square lattices with cells clipped to a shape, and rectangles of whole cells.

use super::{MOST_NODES, Mesh};
use crate::error::{SetupError, require};
use crate::shape::Outline;
use crate::shape::predicates::edges;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Neighbours of a cell with a common side, then those with a common corner.
const NEIGHBOURS: [(isize, isize); 8] = [
    (-1, 0),
    (1, 0),
    (0, -1),
    (0, 1),
    (-1, -1),
    (1, -1),
    (-1, 1),
    (1, 1),
];

#[rendered]
impl Mesh {
    /// Rectangle of square cells of a side h in m, with nodes at the centres and areas $h^2$, row by row from below.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for no cells, a side that is not positive or a corner that is not finite,
    /// [`SetupError::Mesh`] for more than four million nodes.
    pub fn rectangle(
        columns: usize,
        rows: usize,
        spacing: f64,
        lower_left: Vec2,
    ) -> Result<Self, SetupError> {
        require("spacing", spacing, "positive", spacing > 0.0)?;
        let finite = lower_left.is_finite();
        require("lower left corner", lower_left.norm(), "finite", finite)?;
        let count = columns as f64 * rows as f64;
        require("number of cells", count, "at least 1", count >= 1.0)?;
        if count > MOST_NODES {
            let reason = "there would be too many nodes";
            return Err(SetupError::Mesh {
                size: spacing,
                reason,
            });
        }
        let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
        // From the centre, so that coordinates of a rectangle about the origin are exactly symmetric.
        let centre = lower_left + Vec2::new(columns as f64, rows as f64) * (0.5 * spacing);
        let from_centre =
            |index: usize, cells: usize| (index as f64 - 0.5 * (cells as f64 - 1.0)) * spacing;
        let place = |(column, row)| {
            centre + Vec2::new(from_centre(column, columns), from_centre(row, rows))
        };
        let outermost =
            |(column, row)| column == 0 || row == 0 || column + 1 == columns || row + 1 == rows;
        Ok(Self {
            position: cells.clone().map(place).collect(),
            area: vec![spacing * spacing; columns * rows],
            triangles: Vec::new(),
            on_rim: cells.map(outermost).collect(),
        })
    }

    /// Points of a square lattice inside a shape or on its boundary, row by row from below.
    ///
    /// $$ x_{ij} = o + h \, (i, j) $$
    ///
    /// with a spacing h and an origin o in m. The area of a node is that of its square cell inside the shape. Areas in
    /// cells whose point lies outside go to the nodes next to them in equal shares: to those of the cells with a common
    /// side, else to those with a common corner, else to the nearest node. The sum is therefore the area of the shape.
    /// That a part of a cell may lie across a pocket, a hole or a cut is not considered.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a spacing that is not positive or an origin that is not finite,
    /// [`SetupError::Mesh`] if no point lies in the shape or there would be more than four million cells;
    /// [`SetupError::MeshArea`] for a shape so thin that rounding changes its area by more than a billionth.
    pub fn lattice(outline: &Outline, spacing: f64, origin: Vec2) -> Result<Self, SetupError> {
        require("spacing", spacing, "positive", spacing > 0.0)?;
        require("origin", origin.norm(), "finite", origin.is_finite())?;
        let failed = |reason| SetupError::Mesh {
            size: spacing,
            reason,
        };
        let grid = Grid::new(outline, spacing, origin);
        let grid = grid.ok_or_else(|| failed("there would be too many cells"))?;
        let cell_areas = grid.cell_areas(outline);
        let is_node: Vec<_> = (0..cell_areas.len())
            .map(|cell| outline.contains(grid.point(cell)))
            .collect();
        if !is_node.contains(&true) {
            return Err(failed("no point of the lattice lies in the shape"));
        }
        let area = grid.gather(&cell_areas, &is_node);
        let whole = (1.0 - 1e-9) * spacing * spacing;
        let on_rim = |cell: &usize| {
            let around = grid.neighbours(*cell, &NEIGHBOURS);
            let missing = |cell: usize| !is_node[cell] || cell_areas[cell] < whole;
            cell_areas[*cell] < whole || around.len() < 8 || around.into_iter().any(missing)
        };
        let nodes: Vec<_> = (0..is_node.len()).filter(|&cell| is_node[cell]).collect();
        let mesh = Self {
            position: nodes.iter().map(|&cell| grid.point(cell)).collect(),
            area: nodes.iter().map(|&cell| area[cell]).collect(),
            triangles: Vec::new(),
            on_rim: nodes.iter().map(on_rim).collect(),
        };
        mesh.covering(outline, spacing)
    }
}

/// Square cells that cover a shape.
struct Grid {
    origin: Vec2,
    spacing: f64,
    /// Indices of the first column and row, counted from the origin.
    first: [f64; 2],
    columns: usize,
    rows: usize,
}

impl Grid {
    fn new(outline: &Outline, spacing: f64, origin: Vec2) -> Option<Self> {
        let bounds = outline.bounds();
        let index = |offset: f64| (offset / spacing).round();
        let [lower, upper] = [bounds.lower - origin, bounds.upper - origin];
        let first = [index(lower.x) - 1.0, index(lower.y) - 1.0];
        let columns = index(upper.x) + 2.0 - first[0];
        let rows = index(upper.y) + 2.0 - first[1];
        (columns * rows <= MOST_NODES).then_some(Self {
            origin,
            spacing,
            first,
            columns: columns as usize,
            rows: rows as usize,
        })
    }

    /// Coordinates of a point between lattice points, in spacings from the first one.
    fn at(&self, column: f64, row: f64) -> Vec2 {
        let index = Vec2::new(self.first[0] + column, self.first[1] + row);
        self.origin + index * self.spacing
    }

    fn point(&self, cell: usize) -> Vec2 {
        let (column, row) = (cell % self.columns, cell / self.columns);
        self.at(column as f64, row as f64)
    }

    /// Areas of all cells inside the shape, in m^2.
    fn cell_areas(&self, outline: &Outline) -> Vec<f64> {
        let mut areas = vec![0.0; self.columns * self.rows];
        for (row, areas) in areas.chunks_mut(self.columns).enumerate() {
            let middle = row as f64;
            let below = self.at(0.0, middle - 0.5).y;
            let above = self.at(0.0, middle + 0.5).y;
            for ring in outline.rings() {
                let strip = clip(ring, |p| p.y - below);
                let strip = clip(&strip, |p| above - p.y);
                self.add_strip(&strip, row, areas);
            }
        }
        areas
    }

    /// Add the signed areas of the cells of one row inside the part of a ring in that row.
    fn add_strip(&self, strip: &[Vec2], row: usize, areas: &mut [f64]) {
        for (column, area) in areas.iter_mut().enumerate() {
            let middle = column as f64;
            let left = self.at(middle - 0.5, 0.0).x;
            let right = self.at(middle + 0.5, 0.0).x;
            let part = clip(strip, |p| p.x - left);
            let part = clip(&part, |p| right - p.x);
            let centre = self.at(middle, row as f64);
            let triangle = |[a, b]: [Vec2; 2]| 0.5 * (a - centre).cross(b - centre);
            *area += edges(&part).map(triangle).sum::<f64>();
        }
    }

    /// Existing cells at given offsets from a cell.
    fn neighbours(&self, cell: usize, offsets: &[(isize, isize)]) -> Vec<usize> {
        let (column, row) = (cell % self.columns, cell / self.columns);
        let shifted = |&(dx, dy): &(isize, isize)| {
            let column = column
                .checked_add_signed(dx)
                .filter(|&c| c < self.columns)?;
            let row = row.checked_add_signed(dy).filter(|&r| r < self.rows)?;
            Some(row * self.columns + column)
        };
        offsets.iter().filter_map(shifted).collect()
    }

    /// Areas of cells, with those of cells without a node added to nodes.
    fn gather(&self, cell_areas: &[f64], is_node: &[bool]) -> Vec<f64> {
        let mut gathered = cell_areas.to_vec();
        for (cell, &area) in cell_areas.iter().enumerate() {
            if is_node[cell] || area == 0.0 {
                continue;
            }
            gathered[cell] = 0.0;
            let receivers = self.receivers(cell, is_node);
            let share = area / receivers.len() as f64;
            receivers.iter().for_each(|&node| gathered[node] += share);
        }
        gathered
    }

    /// Nodes that receive the area of a cell without a node.
    fn receivers(&self, cell: usize, is_node: &[bool]) -> Vec<usize> {
        for offsets in [&NEIGHBOURS[..4], &NEIGHBOURS[4..]] {
            let mut around = self.neighbours(cell, offsets);
            around.retain(|&neighbour| is_node[neighbour]);
            if !around.is_empty() {
                return around;
            }
        }
        let place = self.point(cell);
        let distance = |node: &usize| (self.point(*node) - place).norm_squared();
        let nodes = (0..is_node.len()).filter(|&node| is_node[node]);
        let nearest = nodes.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.into_iter().collect()
    }
}

/// Part of a polygon where a linear function of position is not negative.
///
/// Parts outside are projected on the line where the function is zero, so that signed areas inside are right for any
/// polygon.
fn clip(polygon: &[Vec2], value: impl Fn(Vec2) -> f64) -> Vec<Vec2> {
    let mut kept = Vec::with_capacity(polygon.len() + 2);
    for [a, b] in edges(polygon) {
        let (at_a, at_b) = (value(a), value(b));
        if at_a >= 0.0 {
            kept.push(a);
        }
        if (at_a >= 0.0) != (at_b >= 0.0) {
            kept.push(a + (b - a) * (at_a / (at_a - at_b)));
        }
    }
    kept
}
