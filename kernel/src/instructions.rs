//! The instructions that the loops over links and particles are compiled for.

use pulp::{Arch, NullaryFnOnce};

/// A set of instructions. All of them give the same bits: each lane of a wide instruction rounds as a
/// single number does, and products are never fused with sums.
#[derive(Clone, Copy, Debug)]
pub struct Instructions(Arch);

impl Instructions {
    /// Those that every machine of the kind has.
    pub fn portable() -> Self {
        Self(Arch::Scalar)
    }
    /// The widest that this machine has.
    pub fn widest() -> Self {
        Self(Arch::new())
    }
    /// Run a loop compiled for these instructions; what it calls must be inlined.
    #[inline(always)]
    pub fn run<L: NullaryFnOnce>(self, body: L) -> L::Output {
        self.0.dispatch(body)
    }
}

impl Default for Instructions {
    fn default() -> Self {
        Self::widest()
    }
}
