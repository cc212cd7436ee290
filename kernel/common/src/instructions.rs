//! The instruction sets for which loops over particles and interactions are compiled.

use pulp::{Arch, NullaryFnOnce};

/// An instruction set.
///
/// All of them give the same bits: each lane of a vector instruction rounds as a scalar operation does, and
/// multiplication and addition are never fused.
#[derive(Clone, Copy, Debug)]
pub struct Instructions(Arch);

impl Instructions {
    /// Names of the instruction sets for which loops are compiled, the widest last.
    pub const COMPILED_FOR: &[&'static str] = if cfg!(target_arch = "x86_64") {
        &["portable", "avx2", "avx512"]
    } else if cfg!(target_arch = "aarch64") {
        &["portable", "neon"]
    } else {
        &["portable"]
    };
    /// The instruction set that every machine of this architecture has.
    pub fn portable() -> Self {
        Self(Arch::Scalar)
    }
    /// The widest instruction set of this machine.
    pub fn widest() -> Self {
        Self(Arch::new())
    }
    /// All instruction sets of this machine, the widest last.
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
    /// Name of the instruction set.
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
    /// Run a loop compiled for this instruction set; all functions it calls must be inlined.
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
