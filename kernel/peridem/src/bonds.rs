//! Which nodes are bonded.

use crate::error::SetupError;
use crate::grain::Grains;
use core::ops::Range;
use gouge_common::geometry::Vec2;
use gouge_common::neighbors::{CellIndex, Cells};
use gouge_common::pair::Pair;

/// Ratio of the side of a cell to the horizon. The excess absorbs the rounding of positions.
const ROOM: f64 = 17.0 / 16.0;

/// The bonds of all grains in compressed rows: each node owns its bonds with earlier nodes of its grain, in ascending
/// order. Broken bonds leave their row, and the room they had stays free.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bonds {
    /// First place of each row, then the number of places.
    start: Vec<u32>,
    /// Number of bonds in each row.
    held: Vec<u16>,
    /// The earlier node of each bond.
    earlier: Vec<u32>,
    /// Reference length of each bond in m.
    length: Vec<f64>,
    /// Number of bonds of each node, in its own row and in those of others.
    number: Vec<u16>,
    /// The same before any bond broke.
    initial: Vec<u16>,
}

/// Rows of consecutive nodes that a part of a pass may change.
pub struct BondRows<'a> {
    /// First place of each row, counted from the beginning of all rows.
    pub(crate) start: &'a [u32],
    pub(crate) held: &'a mut [u16],
    pub(crate) earlier: &'a mut [u32],
    pub(crate) length: &'a mut [f64],
}

fn too_many(grains: &Grains, node: usize) -> SetupError {
    let grain = grains.grain_of[node] as usize;
    let local = node - grains.rows[grain].nodes.start;
    SetupError::Bond {
        grain,
        i: local,
        j: local,
        what: "too many bonds",
    }
}

/// Nodes of a grain in the order of their cells, to find those within a horizon.
struct Vicinity<'a> {
    positions: &'a [Vec2],
    horizon: f64,
    cells: Cells,
    sorted: Vec<(CellIndex, usize)>,
}

impl<'a> Vicinity<'a> {
    fn new(positions: &'a [Vec2], horizon: f64) -> Self {
        let cells = Cells::new(ROOM * horizon, None);
        let mut sorted: Vec<_> = positions
            .iter()
            .enumerate()
            .map(|(node, &position)| (cells.cell_at(position), node))
            .collect();
        sorted.sort_unstable();
        Self {
            positions,
            horizon,
            cells,
            sorted,
        }
    }

    /// Earlier nodes within the horizon of a node, with their distances in m; those of a cell in ascending order.
    fn earlier(&self, node: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let own = self.positions[node];
        let runs = self.cells.around(self.cells.cell_at(own));
        runs.flat_map(move |run| {
            let begin = self.sorted.partition_point(|&(cell, _)| cell < run.first);
            let rest = &self.sorted[begin..];
            let members = rest.iter().take_while(move |(cell, _)| run.contains(*cell));
            members.filter_map(move |&(_, other)| {
                let distance = (own - self.positions[other]).norm();
                (other < node && distance <= self.horizon).then_some((other, distance))
            })
        })
    }
}

impl Bonds {
    /// Bonds between all nodes of a grain at most the horizon apart, if the rule of the grain admits them.
    ///
    /// A bond exists if $|\vec\xi| \le \epsilon$, as section 5 of peridem says; (3.2) has a strict sign there.
    ///
    /// # Errors
    /// [`SetupError::Bond`] if two nodes are at the same place.
    pub fn within_horizon(
        grains: &Grains,
        mut admits: impl FnMut(usize, Vec2, Vec2) -> bool,
    ) -> Result<Self, SetupError> {
        let mut bonds = Self::empty(grains.nodes());
        let mut row = Vec::new();
        for (grain, of) in grains.rows.iter().enumerate() {
            let positions = &grains.position[of.nodes.clone()];
            let vicinity = Vicinity::new(positions, of.constants.horizon);
            let most = (0..positions.len()).map(|node| vicinity.earlier(node).count());
            bonds.reserve(most.sum());
            for node in 0..positions.len() {
                row.clear();
                row.extend(
                    vicinity
                        .earlier(node)
                        .filter(|&(other, _)| admits(grain, positions[other], positions[node])),
                );
                row.sort_unstable_by_key(|&(other, _)| other);
                bonds.push_row(grain, of.nodes.start, &row)?;
            }
        }
        bonds.with_numbers().map_err(|node| too_many(grains, node))
    }

    /// Given bonds of each grain, whose nodes are counted from the first of the grain.
    ///
    /// # Errors
    /// [`SetupError::Bond`] for bonds of a node with itself, bonds that are listed twice, and nodes at the same place;
    /// [`SetupError::MissingNode`] for nodes that do not exist.
    pub fn from_pairs(grains: &Grains, pairs: &[Vec<[usize; 2]>]) -> Result<Self, SetupError> {
        let mut bonds = Self::empty(grains.nodes());
        for (grain, row) in grains.rows.iter().enumerate() {
            let given: &[[usize; 2]] = pairs.get(grain).map_or(&[], |pairs| pairs);
            let nodes = row.nodes.len();
            if let Some(&node) = given.as_flattened().iter().find(|&&node| node >= nodes) {
                return Err(SetupError::MissingNode { grain, node, nodes });
            }
            let mut sorted: Vec<_> = given.iter().map(|&[i, j]| Pair::new(i, j)).collect();
            sorted.sort_unstable();
            bonds.reserve(sorted.len());
            for own in sorted.chunk_by(|a, b| a.j == b.j) {
                let later = own[0].j as usize;
                bonds.fill_to(row.nodes.start + later);
                let length = |pair: &Pair| {
                    let (i, j) = (row.nodes.start + pair.i as usize, row.nodes.start + later);
                    (
                        pair.i as usize,
                        (grains.position[j] - grains.position[i]).norm(),
                    )
                };
                let of_node: Vec<_> = own.iter().map(length).collect();
                bonds.push_row(grain, row.nodes.start, &of_node)?;
            }
            bonds.fill_to(row.nodes.end);
        }
        bonds.with_numbers().map_err(|node| too_many(grains, node))
    }

    fn empty(nodes: usize) -> Self {
        let mut start = Vec::with_capacity(nodes + 1);
        start.push(0);
        Self {
            start,
            held: Vec::with_capacity(nodes),
            ..Self::default()
        }
    }

    fn reserve(&mut self, more: usize) {
        self.earlier.reserve_exact(more);
        self.length.reserve_exact(more);
    }

    /// Append empty rows up to a node, which is not included.
    fn fill_to(&mut self, node: usize) {
        self.held.resize(node, 0);
        self.start.resize(node + 1, self.earlier.len() as u32);
    }

    /// Append the row of the next node: earlier nodes, counted from `first`, and lengths, in ascending order.
    fn push_row(
        &mut self,
        grain: usize,
        first: usize,
        row: &[(usize, f64)],
    ) -> Result<(), SetupError> {
        let j = self.held.len() - first;
        let wrong = |i, what| SetupError::Bond { grain, i, j, what };
        let mut before = None;
        for &(i, length) in row {
            let what = match () {
                () if i == j => "a bond of one node with itself",
                () if before == Some(i) => "two bonds",
                () if !(length > 0.0 && length.is_finite()) => "no distance",
                () => "",
            };
            if !what.is_empty() {
                return Err(wrong(i, what));
            }
            before = Some(i);
            self.earlier.push((first + i) as u32);
            self.length.push(length);
        }
        let sizes = (u16::try_from(row.len()), u32::try_from(self.earlier.len()));
        let (Ok(held), Ok(end)) = sizes else {
            return Err(wrong(j, "too many bonds"));
        };
        self.held.push(held);
        self.start.push(end);
        Ok(())
    }

    /// Count the bonds of each node, or return a node that has too many.
    fn with_numbers(mut self) -> Result<Self, usize> {
        let mut numbers = vec![0_u32; self.held.len()];
        for node in 0..self.held.len() {
            numbers[node] += u32::from(self.held[node]);
            for place in self.row(node) {
                numbers[self.earlier[place] as usize] += 1;
            }
        }
        let numbers = numbers.into_iter().enumerate();
        let counted = numbers.map(|(node, number)| u16::try_from(number).map_err(|_| node));
        self.number = counted.collect::<Result<_, _>>()?;
        self.initial = self.number.clone();
        Ok(self)
    }

    /// Places of the bonds of a node with earlier ones.
    fn row(&self, node: usize) -> Range<usize> {
        let first = self.start[node] as usize;
        first..first + self.held[node] as usize
    }

    /// Earlier nodes to which a node is bonded, with the reference lengths in m.
    pub fn with_earlier(&self, node: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.row(node)
            .map(|place| (self.earlier[place] as usize, self.length[place]))
    }

    /// All bonds: the earlier node, the later one, and the reference length in m.
    pub fn all(&self) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        (0..self.held.len()).flat_map(|later| {
            self.with_earlier(later)
                .map(move |(earlier, length)| (earlier, later, length))
        })
    }

    /// Number of bonds.
    pub fn count(&self) -> usize {
        self.held.iter().map(|&held| held as usize).sum()
    }

    /// Number of bonds of a range of nodes with earlier ones.
    pub fn count_of(&self, nodes: Range<usize>) -> usize {
        self.held[nodes].iter().map(|&held| held as usize).sum()
    }

    /// Number of bonds of each node.
    pub fn numbers(&self) -> &[u16] {
        &self.number
    }

    /// Number of bonds of each node before any broke.
    pub fn initial_numbers(&self) -> &[u16] {
        &self.initial
    }

    /// Whether two different nodes are bonded.
    pub fn are_bonded(&self, pair: Pair) -> bool {
        let (i, j) = pair.indices();
        self.earlier[self.row(j)].binary_search(&(i as u32)).is_ok()
    }

    /// Damage of a node: the fraction of its bonds that broke; zero without bonds.
    ///
    /// $$ D = 1 - \frac{n}{n_0} $$
    ///
    /// Section 3.1 of peridem.
    pub fn damage(&self, node: usize) -> f64 {
        match self.initial[node] {
            0 => 0.0,
            initial => 1.0 - f64::from(self.number[node]) / f64::from(initial),
        }
    }

    /// All columns, for a checkpoint.
    pub(crate) fn columns(&self) -> BondColumns<'_> {
        BondColumns {
            start: &self.start,
            held: &self.held,
            earlier: &self.earlier,
            length: &self.length,
            initial: &self.initial,
        }
    }

    /// Bonds from columns; `None` if they are not those of such grains.
    pub(crate) fn from_columns(grains: &Grains, columns: BondColumns<'_>) -> Option<Self> {
        let (nodes, room) = (grains.nodes(), columns.earlier.len());
        let has_lengths = columns.start.len() == nodes + 1
            && columns.held.len() == nodes
            && columns.initial.len() == nodes
            && columns.length.len() == room;
        let is_full = has_lengths
            && columns.start.first() == Some(&0)
            && columns.start.last().map(|&end| end as usize) == Some(room)
            && columns.start.is_sorted();
        if !is_full {
            return None;
        }
        let fits = |node: usize| columns.has_valid_row(node, grains.of(node).nodes.start);
        if !(0..nodes).all(fits) {
            return None;
        }
        let bonds = Self {
            start: columns.start.to_vec(),
            held: columns.held.to_vec(),
            earlier: columns.earlier.to_vec(),
            length: columns.length.to_vec(),
            ..Self::default()
        };
        let mut bonds = bonds.with_numbers().ok()?;
        let mut numbers = bonds.number.iter().zip(columns.initial);
        if !numbers.all(|(number, initial)| number <= initial) {
            return None;
        }
        bonds.initial = columns.initial.to_vec();
        Some(bonds)
    }

    /// All rows, for a pass.
    pub(crate) fn rows_mut(&mut self) -> BondRows<'_> {
        BondRows {
            start: &self.start,
            held: &mut self.held,
            earlier: &mut self.earlier,
            length: &mut self.length,
        }
    }

    /// Count bonds that a pass has removed from their rows.
    pub(crate) fn forget(&mut self, broken: &[Pair]) {
        for pair in broken {
            let (i, j) = pair.indices();
            self.number[i] -= 1;
            self.number[j] -= 1;
        }
    }
}

/// The bonds of all grains as columns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BondColumns<'a> {
    pub(crate) start: &'a [u32],
    pub(crate) held: &'a [u16],
    pub(crate) earlier: &'a [u32],
    pub(crate) length: &'a [f64],
    pub(crate) initial: &'a [u16],
}

impl BondColumns<'_> {
    /// Whether the bonds of a node lead to earlier nodes of its grain, the first of which is given, in ascending order.
    fn has_valid_row(&self, node: usize, first: usize) -> bool {
        let begin = self.start[node] as usize;
        let end = begin + usize::from(self.held[node]);
        if end > self.start[node + 1] as usize {
            return false;
        }
        let (earlier, length) = (&self.earlier[begin..end], &self.length[begin..end]);
        earlier.is_sorted_by(|a, b| a < b)
            && (earlier.iter()).all(|&other| (first..node).contains(&(other as usize)))
            && (length.iter()).all(|&length| length > 0.0 && length.is_finite())
    }
}

impl<'a> BondRows<'a> {
    /// Split before a row, counted from the first of these.
    pub(crate) fn split_at(self, row: usize) -> (Self, Self) {
        let places = (self.start[row] - self.start[0]) as usize;
        let (held, held_after) = self.held.split_at_mut(row);
        let (earlier, earlier_after) = self.earlier.split_at_mut(places);
        let (length, length_after) = self.length.split_at_mut(places);
        let before = BondRows {
            start: &self.start[..=row],
            held,
            earlier,
            length,
        };
        let after = BondRows {
            start: &self.start[row..],
            held: held_after,
            earlier: earlier_after,
            length: length_after,
        };
        (before, after)
    }

    /// Places of a row within these rows.
    #[inline(always)]
    pub(crate) fn places(&self, row: usize) -> Range<usize> {
        let first = (self.start[row] - self.start[0]) as usize;
        first..first + self.held[row] as usize
    }
}
