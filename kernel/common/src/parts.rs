//! Division of the work on particles and interactions into parts that run in parallel.
//!
//! A part owns consecutive particles and all interactions whose second particle is one of them. Only the part
//! itself writes to its particles. Forces of its interactions on particles of earlier parts are collected, and
//! added when all parts are finished. A single part adds them last, too, so the result does not depend on the
//! number of parts.

use crate::instructions::Instructions;
use pulp::NullaryFnOnce;

/// Number of doubles per cache line.
pub const NUMBERS_PER_LINE: usize = 8;
/// Parts per thread, if there are several threads.
const PARTS_PER_THREAD: usize = 7;

/// Work that can be divided into parts.
///
/// `B` is the buffer of a part.
pub trait Work<B>: Sized + Send {
    /// Split the work before a particle, counted from the first particle of this work.
    fn split_at(self, particle: usize) -> (Self, Self);
    /// Run a part. Inlined, so that it is compiled for the instruction set of its caller.
    fn run_part(self, buffer: &mut B, instructions: Instructions);
    /// Run a part with its instruction set, if the gain justifies the code size.
    fn dispatch(task: PartTask<Self, B>);
}

/// A part, with its buffer and its instruction set.
pub struct PartTask<'a, D, B> {
    /// The work of the part.
    pub work: D,
    /// The buffer of the part.
    pub buffer: &'a mut B,
    /// The instruction set.
    pub instructions: Instructions,
}

impl<B, D: Work<B>> NullaryFnOnce for PartTask<'_, D, B> {
    type Output = ();
    #[inline(always)]
    fn call(self) {
        self.work.run_part(self.buffer, self.instructions);
    }
}

/// Division of the particles of a world into parts.
#[derive(Clone, Debug)]
pub struct Parts {
    /// First particle of each part, then the number of particles.
    bounds: Vec<usize>,
}

impl Parts {
    /// Divide particles among threads; a single part for one thread.
    ///
    /// Several threads get equal shares, each divided into several parts. Each part takes half of what
    /// remains of the share, except the last one, which takes all of it. Large parts have little overhead; the small
    /// ones at the end let a thread that finishes early take work from another.
    ///
    /// Parts begin at cache lines of the columns, so that no vector instruction spans two parts. Few particles are
    /// divided into fewer parts.
    pub fn new(particles: usize, threads: usize) -> Self {
        const WHOLE: usize = 1 << PARTS_PER_THREAD;
        let threads = threads.max(1);
        let parts = if threads > 1 { PARTS_PER_THREAD } else { 1 };
        let begin = |share: usize, part: usize| {
            let before = share * WHOLE + (WHOLE - (WHOLE >> part));
            before * particles / (threads * WHOLE) / NUMBERS_PER_LINE * NUMBERS_PER_LINE
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
    /// Number of particles of each part.
    pub fn sizes(&self) -> impl Iterator<Item = usize> {
        self.bounds.windows(2).map(|ends| ends[1] - ends[0])
    }
    /// Run all parts of a work, each with its own buffer. A single buffer means a single part.
    pub fn run<B: Send, D: Work<B>>(&self, work: D, buffers: &mut [B], instructions: Instructions) {
        divide(work, buffers, &self.bounds, instructions);
    }
}

fn divide<B: Send, D: Work<B>>(
    work: D,
    buffers: &mut [B],
    bounds: &[usize],
    instructions: Instructions,
) {
    if let [buffer] = buffers {
        return D::dispatch(PartTask {
            work,
            buffer,
            instructions,
        });
    }
    let half = buffers.len() / 2;
    let (left, right) = work.split_at(bounds[half] - bounds[0]);
    let (buffers_left, buffers_right) = buffers.split_at_mut(half);
    let (mut left, mut right) = (Some(left), Some(right));
    join(
        &mut || {
            if let Some(work) = left.take() {
                divide(work, buffers_left, &bounds[..=half], instructions);
            }
        },
        &mut || {
            if let Some(work) = right.take() {
                divide(work, buffers_right, &bounds[half..], instructions);
            }
        },
    );
}

/// Run both in parallel. Not generic, so that it is compiled only once.
fn join(left: &mut (dyn FnMut() + Send), right: &mut (dyn FnMut() + Send)) {
    rayon::join(left, right);
}

/// Split a column that may be empty.
pub fn split_or_empty<T>(column: &mut [T], at: usize) -> (&mut [T], &mut [T]) {
    column.split_at_mut(at.min(column.len()))
}
