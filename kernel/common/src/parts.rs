//! Work on particles and links, divided into parts that are done side by side.
//!
//! A part owns consecutive particles and the links whose second particle is among them. It alone writes to
//! these; what its links do to earlier particles is added when all parts are done. A single part would add it
//! last, too, so that results do not depend on the number of parts.

use crate::instructions::Instructions;
use pulp::NullaryFnOnce;

/// How many numbers a line of the cache holds.
pub const LINE: usize = 8;
/// Parts of a thread's share, where there are several threads.
const PARTS_OF_A_SHARE: usize = 7;

/// Work that can be divided.
///
/// `W` is what a part needs for itself.
pub trait Work<W>: Sized + Send {
    /// The work on the particles before and from a position on, counted from the first of this work.
    fn split_at(self, particle: usize) -> (Self, Self);
    /// Do a part; inlined, so that it is compiled for the instructions it is run with.
    fn act(self, own: &mut W, instructions: Instructions);
    /// Do a part with its instructions, where that is worth the code.
    fn start(ready: Ready<Self, W>);
}

/// A part with what it needs.
pub struct Ready<'a, D, W> {
    /// The work.
    pub work: D,
    /// What the part needs for itself.
    pub own: &'a mut W,
    /// The instructions to run it with.
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
pub struct Parts {
    /// First particle of each part, and the number of all.
    bounds: Vec<usize>,
}

impl Parts {
    /// Parts of so many particles for some threads: a single one for one thread. Each of several has an equal
    /// share, and each part of it takes half of what is left, but for the last: the large ones cost little, the
    /// small ones let a thread that is done early help the others.
    ///
    /// Parts begin where lines of columns do, so that no wide instruction needs two of them; few particles make
    /// fewer parts.
    pub fn of(particles: usize, threads: usize) -> Self {
        const WHOLE: usize = 1 << PARTS_OF_A_SHARE;
        let threads = threads.max(1);
        let parts = if threads > 1 { PARTS_OF_A_SHARE } else { 1 };
        let begin = |share: usize, part: usize| {
            let before = share * WHOLE + (WHOLE - (WHOLE >> part));
            before * particles / (threads * WHOLE) / LINE * LINE
        };
        let mut bounds: Vec<usize> = (0..threads)
            .flat_map(|share| (0..parts).map(move |part| begin(share, part)))
            .collect();
        bounds.dedup();
        bounds.push(particles);
        Self { bounds }
    }
    /// Number of parts.
    pub fn number(&self) -> usize {
        self.bounds.len() - 1
    }
    /// Sizes of the parts, in particles.
    pub fn sizes(&self) -> impl Iterator<Item = usize> {
        self.bounds.windows(2).map(|ends| ends[1] - ends[0])
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
pub fn halves<T>(column: &mut [T], at: usize) -> (&mut [T], &mut [T]) {
    column.split_at_mut(at.min(column.len()))
}
