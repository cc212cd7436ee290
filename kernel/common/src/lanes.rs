//! Several numbers at a time, with the wide instructions of the machine.

use crate::instructions::Instructions;
use crate::scalar::Real;
use pulp::NullaryFnOnce;
use wide::f64x2;

/// A number whose loops may be compiled for wide instructions.
///
/// By default nothing is wide; only doubles are worth the code. Results have the same bits either way.
pub trait Lanes: Real {
    /// Whether loops are compiled for wide instructions. What loops share is inlined into each of them only
    /// if they are, since it would be compiled once per choice of laws.
    const IS_WIDE: bool = false;
    /// Two differences, `to` minus `from`.
    #[inline(always)]
    fn differences(to: [Self; 2], from: [Self; 2]) -> [Self; 2] {
        [to[0] - from[0], to[1] - from[1]]
    }
    /// Rows and columns exchanged.
    #[inline(always)]
    fn transposed([[a, b], [c, d]]: [[Self; 2]; 2]) -> [[Self; 2]; 2] {
        [[a, c], [b, d]]
    }
    /// Run a loop over numbers of this type with the given instructions.
    #[inline(never)]
    fn run<L: NullaryFnOnce>(_: Instructions, body: L) -> L::Output {
        body.call()
    }
}

impl Lanes for f64 {
    const IS_WIDE: bool = true;
    #[inline(always)]
    fn differences(to: [Self; 2], from: [Self; 2]) -> [Self; 2] {
        (f64x2::new(to) - f64x2::new(from)).to_array()
    }
    #[inline(always)]
    fn transposed([a, b]: [[Self; 2]; 2]) -> [[Self; 2]; 2] {
        let [a, b] = f64x2::transpose([f64x2::new(a), f64x2::new(b)]);
        [a.to_array(), b.to_array()]
    }
    #[inline(always)]
    fn run<L: NullaryFnOnce>(instructions: Instructions, body: L) -> L::Output {
        instructions.run(body)
    }
}
