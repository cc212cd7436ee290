//! Division of the units and points of a step into vertical strips.

use super::Row;
use super::places::{Grid, Places};
use crate::units::InverseMass;
use core::ops::Range;

/// Largest number of strips: eight threads find work, and strips stay wide.
const LARGEST_NUMBER: usize = 16;
/// With fewer strips, there is nothing to do at the same time.
const SMALLEST_NUMBER: usize = 4;
/// Points per strip at least, on average.
const POINTS_PER_STRIP: usize = 4;
/// Marks a copy of a unit.
const COPY: u32 = u32::MAX;

/// Where a unit belongs.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Home {
    /// To a strip.
    Strip(usize),
    /// To all strips: its motion is imposed, so that each may have a copy. The number of the unit among such units.
    Copied(usize),
    /// To no strip.
    Shared,
}

/// The order of units by strips: those that no strip owns; then strip by strip copies of imposed units and the units of
/// the strip.
///
/// A point of a strip touches only units of the strip and of the next one, so that among every other strip, no two have a
/// unit in common.
#[derive(Clone, Debug, Default)]
pub(super) struct Division {
    homes: Vec<Home>,
    /// Unit at each place.
    units: Vec<u32>,
    /// Place of each unit; of its first copy if there are several.
    slots: Vec<u32>,
    /// First place of each strip, and the end of the last one.
    starts: Vec<usize>,
    is_periodic: bool,
}

impl Division {
    /// Divide the points of a step. `false` if there are too few strips.
    pub fn divide(&mut self, rows: &[Row], masses: &[InverseMass], places: &Places) -> bool {
        if places.x.len() != masses.len() {
            return false;
        }
        let pairs = rows.iter().map(|row| row.kinematics.units);
        let Some(grid) = Grid::new(places, pairs.clone()) else {
            return false;
        };
        let most = grid
            .most_strips()
            .min(LARGEST_NUMBER)
            .min(rows.len() / POINTS_PER_STRIP);
        let number = most / 2 * 2;
        if number < SMALLEST_NUMBER {
            return false;
        }
        self.is_periodic = places.period.is_some();
        let strips = grid.strips(pairs, number);
        let mut copied = 0;
        self.homes.clear();
        for (&x, &mass) in places.x.iter().zip(masses) {
            self.homes.push(if x.is_finite() {
                Home::Strip(usize::from(strips[grid.bin(x)]))
            } else if mass == InverseMass::IMPOSED {
                copied += 1;
                Home::Copied(copied - 1)
            } else {
                Home::Shared
            });
        }
        self.place_units(number, copied);
        true
    }

    fn place_units(&mut self, number: usize, copied: usize) {
        let homes = &self.homes;
        let is_shared = |home: &&Home| **home == Home::Shared;
        self.starts.clear();
        self.starts.resize(number + 1, copied);
        self.starts[0] = homes.iter().filter(is_shared).count();
        for home in homes {
            if let Home::Strip(strip) = *home {
                self.starts[strip + 1] += 1;
            }
        }
        for strip in 0..number {
            self.starts[strip + 1] += self.starts[strip];
        }
        let mut ends = [0; LARGEST_NUMBER];
        for (end, start) in ends.iter_mut().zip(&self.starts) {
            *end = start + copied;
        }
        let mut shared = 0;
        self.units.clear();
        self.units.resize(self.starts[number], COPY);
        self.slots.clear();
        for (unit, home) in homes.iter().enumerate() {
            let slot = match *home {
                Home::Copied(rank) => self.starts[0] + rank,
                Home::Shared => {
                    shared += 1;
                    shared - 1
                }
                Home::Strip(strip) => {
                    ends[strip] += 1;
                    ends[strip] - 1
                }
            };
            self.slots.push(slot as u32);
            self.units[slot] = unit as u32;
        }
        self.copy_imposed(number, copied);
    }

    /// Repeat the imposed units, which stand at the beginning of the first strip, in all strips.
    fn copy_imposed(&mut self, number: usize, copied: usize) {
        let first = self.starts[0];
        for &start in &self.starts[1..number] {
            self.units.copy_within(first..first + copied, start);
        }
    }

    /// The strip of a point between two units, if it has one.
    pub fn strip_of(&self, units: [u32; 2]) -> Option<usize> {
        let number = self.number();
        let follows =
            |a: usize, b: usize| b == a + 1 || (self.is_periodic && a + 1 == number && b == 0);
        match units.map(|unit| self.homes[unit as usize]) {
            [Home::Strip(a), Home::Strip(b)] if a == b || follows(a, b) => Some(a),
            [Home::Strip(a), Home::Strip(b)] if follows(b, a) => Some(b),
            [Home::Strip(strip), Home::Copied(_)] | [Home::Copied(_), Home::Strip(strip)] => {
                Some(strip)
            }
            _ => None,
        }
    }

    /// Place of a unit for a point of a strip, or of none.
    pub fn place_of(&self, unit: usize, strip: Option<usize>) -> u32 {
        match (self.homes[unit], strip) {
            (Home::Copied(rank), Some(strip)) => (self.starts[strip] + rank) as u32,
            _ => self.slots[unit],
        }
    }

    /// Number of strips.
    pub fn number(&self) -> usize {
        self.starts.len() - 1
    }

    /// Places of the units of a strip, or after the last one of the units of none.
    pub fn units_of(&self, strip: usize) -> Range<usize> {
        match strip < self.number() {
            true => self.starts[strip]..self.starts[strip + 1],
            false => 0..self.starts[0],
        }
    }

    /// Unit at each place.
    pub fn units(&self) -> &[u32] {
        &self.units
    }

    /// Place of each unit.
    pub fn slots(&self) -> &[u32] {
        &self.slots
    }
}
