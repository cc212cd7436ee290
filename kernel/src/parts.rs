//! Work on particles and links, divided into parts that are done side by side.
//!
//! A part owns consecutive particles and the links whose second particle is among them. It alone writes to
//! these; what its links do to earlier particles is added when all parts are done. A single part would add it
//! last, too, so that results do not depend on the number of parts.

use crate::instructions::Instructions;
use pulp::NullaryFnOnce;

/// Work that can be divided.
///
/// `W` is what a part needs for itself.
pub(crate) trait Work<W>: Sized + Send {
    /// The work on the particles before and from a position on, counted from the first of this work.
    fn split_at(self, particle: usize) -> (Self, Self);
    /// Do a part; inlined, so that it is compiled for the instructions it is run with.
    fn act(self, own: &mut W, instructions: Instructions);
    /// Do a part with its instructions, where that is worth the code.
    fn start(ready: Ready<Self, W>);
}

/// A part with what it needs.
pub(crate) struct Ready<'a, D, W> {
    pub work: D,
    pub own: &'a mut W,
    pub instructions: Instructions,
}

impl<W, D: Work<W>> NullaryFnOnce for Ready<'_, D, W> {
    type Output = ();
    #[inline(always)]
    fn call(self) {
        self.work.act(self.own, self.instructions);
    }
}

/// The parts of a world.
#[derive(Clone, Debug)]
pub(crate) struct Parts {
    /// First particle of each part, and the number of all.
    bounds: Vec<usize>,
}

impl Parts {
    /// Equal parts of so many particles.
    pub fn equal(particles: usize, number: usize) -> Self {
        let number = number.clamp(1, particles.max(1));
        Self {
            bounds: (0..=number).map(|k| k * particles / number).collect(),
        }
    }
    /// Number of parts.
    pub fn number(&self) -> usize {
        self.bounds.len() - 1
    }
    /// Do all parts of a work, each with its own of `owns`; a single one if there is only one.
    pub fn run<W: Send, D: Work<W>>(&self, work: D, owns: &mut [W], instructions: Instructions) {
        divide(work, owns, &self.bounds, instructions);
    }
}

fn divide<W: Send, D: Work<W>>(
    work: D,
    owns: &mut [W],
    bounds: &[usize],
    instructions: Instructions,
) {
    if let [own] = owns {
        return D::start(Ready {
            work,
            own,
            instructions,
        });
    }
    let half = owns.len() / 2;
    let (left, right) = work.split_at(bounds[half] - bounds[0]);
    let (own_left, own_right) = owns.split_at_mut(half);
    let (mut left, mut right) = (Some(left), Some(right));
    both(
        &mut || {
            if let Some(work) = left.take() {
                divide(work, own_left, &bounds[..=half], instructions);
            }
        },
        &mut || {
            if let Some(work) = right.take() {
                divide(work, own_right, &bounds[half..], instructions);
            }
        },
    );
}

/// Do both side by side. Compiled once for all kinds of work.
fn both(left: &mut (dyn FnMut() + Send), right: &mut (dyn FnMut() + Send)) {
    rayon::join(left, right);
}

/// Both sides of a column that may be empty.
pub(crate) fn halves<T>(column: &mut [T], at: usize) -> (&mut [T], &mut [T]) {
    column.split_at_mut(at.min(column.len()))
}
