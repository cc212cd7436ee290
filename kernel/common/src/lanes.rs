//! Number types whose loops can use vector instructions.

use crate::instructions::Instructions;
use crate::scalar::Real;
use pulp::NullaryFnOnce;
use wide::f64x2;

/// A number type whose loops can be compiled for vector instructions.
///
/// The default methods are scalar; only `f64` is vectorised. The bits of the result are the same.
pub trait Lanes: Real {
    /// Whether loops are compiled for vector instructions. Only then is the code that loops share inlined into
    /// each of them; otherwise it is compiled once, not once per choice of laws.
    const IS_WIDE: bool = false;
    /// Two differences, `to` minus `from`.
    #[inline(always)]
    fn differences(to: [Self; 2], from: [Self; 2]) -> [Self; 2] {
        [to[0] - from[0], to[1] - from[1]]
    }
    /// Transpose of a 2x2 matrix.
    #[inline(always)]
    fn transposed([[a, b], [c, d]]: [[Self; 2]; 2]) -> [[Self; 2]; 2] {
        [[a, c], [b, d]]
    }
    /// Run a loop over numbers of this type with an instruction set.
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
