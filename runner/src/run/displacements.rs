//! Displacements of all particles since t = 0, also across the periodic boundary.

use super::bytes::{Reader, put_words};
use gouge_common::geometry::Vec2;

/// Where particles were at t = 0, and how often each has crossed the periodic boundary since.
#[derive(Clone, Debug, PartialEq)]
pub struct Displacements {
    origin: Vec<Vec2>,
    /// Positions when they were last followed.
    last: Vec<Vec2>,
    /// Crossings towards positive x, less those towards negative x.
    crossings: Vec<i64>,
}

impl Displacements {
    /// No displacement yet.
    pub fn new(positions: &[Vec2]) -> Self {
        Self {
            origin: positions.to_vec(),
            last: positions.to_vec(),
            crossings: vec![0; positions.len()],
        }
    }

    /// Notice which particles have crossed the boundary. Between two calls no particle may move by half a period.
    pub fn follow(&mut self, positions: &[Vec2], period: f64) {
        for ((&now, last), crossings) in positions
            .iter()
            .zip(&mut self.last)
            .zip(&mut self.crossings)
        {
            let moved = now.x - last.x;
            if moved.abs() > 0.5 * period {
                *crossings -= moved.signum() as i64;
            }
            *last = now;
        }
    }

    /// Positions at t = 0.
    pub fn origin(&self) -> &[Vec2] {
        &self.origin
    }

    /// Displacements to positions, which were followed, in a box with this period, if any.
    pub fn to(&self, positions: &[Vec2], period: Option<f64>) -> Vec<Vec2> {
        let length = period.unwrap_or(0.0);
        let ends = positions.iter().zip(&self.crossings);
        let ends = ends.map(|(&now, &crossings)| now + Vec2::new(crossings as f64 * length, 0.0));
        ends.zip(&self.origin)
            .map(|(end, &origin)| end - origin)
            .collect()
    }

    /// Append to the bytes of a checkpoint, which also holds the positions to which particles were followed.
    pub fn put(this: Option<&Self>, bytes: &mut Vec<u8>) {
        let Some(this) = this else {
            return put_words(bytes, &[0]);
        };
        put_words(bytes, &[this.origin.len() as u64]);
        for (origin, &crossings) in this.origin.iter().zip(&this.crossings) {
            let [x, y] = [origin.x, origin.y].map(f64::to_bits);
            put_words(bytes, &[x, y, crossings as u64]);
        }
    }

    /// What [`Displacements::put`] appended, without the last positions; none within if there are no particles.
    pub fn read(rest: &mut Reader) -> Option<Option<Self>> {
        let number = rest.word()?;
        let words = rest.words(number.checked_mul(3)?)?;
        let (rows, _) = words.as_chunks();
        let origin = |&[x, y, _]: &[u64; 3]| Vec2::new(f64::from_bits(x), f64::from_bits(y));
        let read = Self {
            origin: rows.iter().map(origin).collect(),
            last: Vec::new(),
            crossings: rows.iter().map(|row| row[2] as i64).collect(),
        };
        Some((number > 0).then_some(read))
    }

    /// Continue to follow particles from the positions of a checkpoint; none if their number differs.
    pub fn continued(mut self, positions: &[Vec2]) -> Option<Self> {
        positions.clone_into(&mut self.last);
        (self.last.len() == self.origin.len()).then_some(self)
    }
}
