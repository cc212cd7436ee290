//! The discs near the surface of a deposit, in bins.

use gouge_common::geometry::Vec2;

/// A deposited disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Disc {
    pub centre: Vec2,
    pub radius: f64,
}

/// All deposited discs, in square bins at least as wide as the largest diameter.
pub(super) struct Front {
    width: f64,
    bin: f64,
    columns: usize,
    bins: Vec<Vec<Disc>>,
}

impl Front {
    /// An empty box of a width in m, periodic in x.
    pub fn new(width: f64, largest_diameter: f64) -> Self {
        let columns = ((width / largest_diameter) as usize).max(1);
        Self {
            width,
            bin: width / columns as f64,
            columns,
            bins: Vec::new(),
        }
    }

    /// Put an x coordinate into the box.
    pub fn wrapped(&self, x: f64) -> f64 {
        let within = x - self.width * (x / self.width).floor();
        if within < self.width { within } else { 0.0 }
    }

    /// Shortest displacement between two points.
    pub fn displacement(&self, from: Vec2, to: Vec2) -> Vec2 {
        let d = to - from;
        Vec2::new(d.x - self.width * (d.x / self.width).round(), d.y)
    }

    fn place(&self, centre: Vec2) -> (usize, usize) {
        let column = (centre.x / self.bin) as usize;
        let row = (centre.y.max(0.0) / self.bin) as usize;
        (row, column.min(self.columns - 1))
    }

    pub fn add(&mut self, disc: Disc) {
        let (row, column) = self.place(disc.centre);
        let needed = (row + 1) * self.columns;
        if self.bins.len() < needed {
            self.bins.resize(needed, Vec::new());
        }
        self.bins[row * self.columns + column].push(disc);
    }

    /// Discs in the bins within a number of bins of a point.
    pub fn near(&self, centre: Vec2, bins: usize) -> impl Iterator<Item = &Disc> {
        let (row, column) = self.place(centre);
        let rows = row.saturating_sub(bins)..=row + bins;
        // Near a narrow box no column is visited twice.
        let span = (2 * bins + 1).min(self.columns);
        let first = column + self.columns - bins.min(self.columns);
        rows.flat_map(move |row| (0..span).map(move |k| (row, (first + k) % self.columns)))
            .filter_map(|(row, column)| self.bins.get(row * self.columns + column))
            .flatten()
    }

    /// Discs whose centres are above a height in m, and some below.
    pub fn above(&self, height: f64) -> impl Iterator<Item = &Disc> {
        let row = (height.max(0.0) / self.bin) as usize;
        let first = (row * self.columns).min(self.bins.len());
        self.bins[first..].iter().flatten()
    }

    /// Whether a disc may lie there without an overlap of more than a tolerance in m.
    pub fn is_free(&self, disc: Disc, tolerance: f64) -> bool {
        self.near(disc.centre, 1).all(|other| {
            let distance = self.displacement(disc.centre, other.centre).norm();
            distance >= disc.radius + other.radius - tolerance
        })
    }
}
