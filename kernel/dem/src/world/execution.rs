//! With which instructions and in how many threads a world is computed. No bit depends on it.

use crate::forces::{Bookings, PartWorkspace};
use gouge_common::instructions::Instructions;
use gouge_common::lanes::Lanes;
use gouge_common::parts::{PartTask, Parts, Work};

/// Instructions and the division into parts.
#[derive(Clone, Debug)]
pub(super) struct Execution {
    pub instructions: Instructions,
    pub parts: Parts,
}

impl Execution {
    /// The widest instructions, in one thread.
    pub fn serial(particles: usize) -> Self {
        Self {
            instructions: Instructions::default(),
            parts: Parts::new(particles, 1),
        }
    }

    /// Do all parts of a work, each with its own buffer.
    pub fn run<W: Send, D: Work<W>>(&self, work: D, buffers: &mut [W]) {
        self.parts.run(work, buffers, self.instructions);
    }

    /// Do a loop over pairs. With `LEDGER` it is done as a single part, so that sums keep their order, and adds
    /// to the bookings.
    pub fn run_pairs<S: Lanes, D: Work<PartWorkspace<S>>, const LEDGER: bool>(
        &self,
        work: D,
        parts: &mut [PartWorkspace<S>],
        bookings: &mut Bookings<S>,
    ) {
        if !LEDGER {
            return self.run(work, parts);
        }
        if let Some(buffer) = parts.first_mut() {
            buffer.bookings = *bookings;
            D::dispatch(PartTask {
                work,
                buffer,
                instructions: self.instructions,
            });
            *bookings = buffer.bookings;
        }
    }
}
