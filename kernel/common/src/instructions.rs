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
    /// All that this machine has, the widest last.
    pub fn available() -> Vec<Self> {
        let mut all = vec![Self::portable()];
        #[cfg(target_arch = "x86_64")]
        {
            all.extend(pulp::x86::V3::try_new().map(|set| Self(Arch::V3(set))));
            all.extend(pulp::x86::V4::try_new().map(|set| Self(Arch::V4(set))));
        }
        #[cfg(target_arch = "aarch64")]
        all.extend(pulp::aarch64::Neon::try_new().map(|set| Self(Arch::Neon(set))));
        all
    }
    /// Their name: that of their registers.
    pub fn name(self) -> &'static str {
        match self.0 {
            Arch::Scalar => "portable",
            #[cfg(target_arch = "x86_64")]
            Arch::V3(_) => "avx2",
            #[cfg(target_arch = "x86_64")]
            Arch::V4(_) => "avx512",
            #[cfg(target_arch = "aarch64")]
            Arch::Neon(_) => "neon",
            _ => "unnamed",
        }
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
