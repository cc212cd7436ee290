//! Instruction set and threads with which a world is computed. The bits of the results do not depend on them.

use crate::forces::{Bookings, PartWorkspace};
use gouge_common::instructions::Instructions;
use gouge_common::lanes::Lanes;
use gouge_common::parts::{PartTask, Parts, Work};

/// Instruction set, and division into parts.
#[derive(Clone, Debug)]
pub(super) struct Execution {
    pub instructions: Instructions,
    pub parts: Parts,
}

impl Execution {
    /// The widest instruction set, in one thread.
    pub fn serial(particles: usize) -> Self {
        Self {
            instructions: Instructions::default(),
            parts: Parts::new(particles, 1),
        }
    }

    /// Run all parts of a work, each with its own buffer.
    pub fn run<W: Send, D: Work<W>>(&self, work: D, buffers: &mut [W]) {
        self.parts.run(work, buffers, self.instructions);
    }

    /// Run a loop over pairs. With `LEDGER` it runs as a single part, so that sums of heat keep their order.
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
