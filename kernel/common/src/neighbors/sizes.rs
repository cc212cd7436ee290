//! Particles of similar size, sorted into cells of their size.

use super::cells::{CellIndex, Cells, Run, precedes};
use crate::geometry::Vec2;
use crate::scalar::Real;

/// Ratio of the side of a cell to the largest reach of its particles. The excess absorbs the rounding of positions.
const ROOM: f64 = 17.0 / 16.0;
/// Binary logarithm of the ratio of reaches within a class. With less, a particle looks into the cells of more classes.
const SPREAD: f64 = 2.0;
/// Largest number of classes. The last one also contains all smaller particles.
const CLASSES: usize = 64;
/// Slots per particle.
const SPARSENESS: usize = 2;
/// Slots besides: more than the cells around a cell, so that even those of a few particles are mostly empty.
const SPARE: usize = 16;
/// Inverse of the golden ratio.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A particle in its cell.
type Member = (CellIndex, usize);

/// A size class: particles whose reaches differ by less than a factor of four, and the cells that they occupy.
///
/// Particles are sorted by slots, of which there are about as many as particles. A cell has the slot
///
/// column + stride * row, modulo the number of slots,
///
/// and shares it with others far away: empty cells cost nothing, wherever the particles are. The stride divides the
/// slots in the golden ratio, so that neither a block nor a row of cells meets itself in a slot; their number is
/// prime, so that particles at regular distances do not meet either.
#[derive(Clone, Debug)]
pub(super) struct SizeClass {
    cells: Cells,
    /// In the order of their indices.
    members: Vec<Member>,
    by_slot: Vec<Member>,
    starts: Vec<u32>,
    stride: i64,
}

impl SizeClass {
    /// The classes of particles with such reaches in m, from the largest to the smallest. The reach is the distance
    /// at which two particles of that size are still neighbours.
    pub fn all(reaches: &[f64], period: Option<f64>) -> Vec<Self> {
        let largest = reaches.iter().copied().fold(0.0, f64::max);
        let mut classes = vec![Vec::new(); CLASSES];
        for (particle, reach) in reaches.iter().enumerate() {
            let class = (libm::log2(largest / reach) / SPREAD) as usize;
            classes[class.min(CLASSES - 1)].push(particle);
        }
        let occupied = classes.iter().filter(|particles| !particles.is_empty());
        occupied
            .map(|particles| {
                let own = particles.iter().map(|&particle| reaches[particle]);
                let cells = Cells::new(ROOM * own.fold(0.0, f64::max), period);
                Self::new(cells, particles)
            })
            .collect()
    }

    fn new(cells: Cells, particles: &[usize]) -> Self {
        let nowhere = CellIndex { x: 0, y: 0 };
        let members: Vec<Member> = particles.iter().map(|&i| (nowhere, i)).collect();
        let slots = prime_from(SPARSENESS * particles.len() + SPARE);
        Self {
            cells,
            by_slot: members.clone(),
            members,
            starts: vec![0; slots + 1],
            stride: libm::round(GOLDEN * slots as f64) as i64,
        }
    }

    /// Sort the particles by their present positions.
    pub fn sort<S: Real>(&mut self, positions: &[Vec2<S>]) {
        self.starts.fill(0);
        for place in 0..self.members.len() {
            let cell = self.cell_at(positions[self.members[place].1]);
            self.members[place].0 = cell;
            let slot = self.slot(cell);
            self.starts[slot] += 1;
        }
        let mut end = 0;
        for start in &mut self.starts {
            end += *start;
            *start = end;
        }
        // Filled from the end: afterwards each start is that of its slot.
        for &member in self.members.iter().rev() {
            let slot = self.slot(member.0);
            self.starts[slot] -= 1;
            self.by_slot[self.starts[slot] as usize] = member;
        }
    }

    /// Visit each pair in the same cell or in adjacent ones once. Returns the number of particles looked at.
    pub fn pairs_within(&self, mut visit: impl FnMut(usize, usize)) -> usize {
        let mut examined = 0;
        for &own in &self.members {
            for run in self.cells.around(own.0) {
                examined += self.visit_cells(run.from(own.0), |other| {
                    if precedes(own, other) {
                        visit(own.1, other.1);
                    }
                });
            }
        }
        examined
    }

    /// Visit each pair of a smaller particle and one of this class in its cell or in an adjacent one. Returns the
    /// number of particles looked at.
    pub fn pairs_with<S: Real>(
        &self,
        smaller: &Self,
        positions: &[Vec2<S>],
        mut visit: impl FnMut(usize, usize),
    ) -> usize {
        let mut examined = 0;
        for &(_, i) in &smaller.members {
            for run in self.cells.around(self.cell_at(positions[i])) {
                examined += self.visit_cells(run, |(_, j)| visit(i, j));
            }
        }
        examined
    }

    /// Visit the particles in a run of cells. Returns the number of particles looked at: those that share slots.
    #[inline]
    fn visit_cells(&self, run: Run, mut visit: impl FnMut(Member)) -> usize {
        if run.number == 0 {
            return 0;
        }
        let (slots, first) = (self.starts.len() - 1, self.slot(run.first));
        let end = first + run.number as usize;
        let start = |slot: usize| self.starts[slot] as usize;
        // After the last slot follows the first one.
        let ranges = [
            start(first)..start(end.min(slots)),
            0..start(end.saturating_sub(slots)),
        ];
        let mut examined = 0;
        for range in ranges {
            examined += range.len();
            for &member in &self.by_slot[range] {
                if run.contains(member.0) {
                    visit(member);
                }
            }
        }
        examined
    }

    #[inline]
    fn cell_at<S: Real>(&self, point: Vec2<S>) -> CellIndex {
        self.cells
            .cell_at(Vec2::new(point.x.to_f64(), point.y.to_f64()))
    }

    #[inline]
    fn slot(&self, cell: CellIndex) -> usize {
        let slots = self.starts.len() as i64 - 1;
        let number = cell.x.wrapping_add(self.stride.wrapping_mul(cell.y));
        number.rem_euclid(slots) as usize
    }
}

/// The smallest prime that is not below a number of at least two.
fn prime_from(number: usize) -> usize {
    let is_prime = |n: usize| {
        let mut divisors = (2..).take_while(|d| d * d <= n);
        divisors.all(|d| !n.is_multiple_of(d))
    };
    let mut prime = number;
    while !is_prime(prime) {
        prime += 1;
    }
    prime
}
