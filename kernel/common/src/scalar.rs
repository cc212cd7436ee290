//! The arithmetic that laws and integrators may use.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A real number.
///
/// One implementation of a law serves every number type: `f64` for production, others to measure
/// rounding error or to differentiate. Products with `f64` keep the literals of a formula plain.
///
/// Elementary functions come from `libm`, not from the platform, so that a result has the same bits
/// on every machine. The square root is exactly rounded everywhere and may use the hardware.
pub trait Real:
    Copy
    + Debug
    + Default
    + PartialOrd
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + Mul<f64, Output = Self>
{
    /// The nearest representable number.
    fn from_f64(value: f64) -> Self;
    /// The nearest double.
    fn to_f64(self) -> f64;
    /// Square root of a non-negative number.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// Largest integer not above the number.
    fn floor(self) -> Self;
    /// Inverse sine of a number in [-1, 1], for small angles.
    fn asin_small(self) -> Self;
    /// Angle of the vector (x, y) = (`other`, `self`), in (-pi, pi].
    fn atan2(self, other: Self) -> Self;
    /// Inverse hyperbolic sine.
    fn asinh(self) -> Self;
    /// Inverse sine.
    fn asin(self) -> Self;
    /// Inverse cosine.
    fn acos(self) -> Self;
    /// Whether neither infinite nor undefined.
    fn is_finite(self) -> bool;

    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::default()
    }
    /// The smaller of two numbers; the first where they are equal.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
    /// The larger of two numbers; the first where they are equal.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
    /// Sign of a number, zero for zero.
    #[inline(always)]
    fn signum_or_zero(self) -> Self {
        if self > Self::zero() {
            Self::from_f64(1.0)
        } else if self < Self::zero() {
            Self::from_f64(-1.0)
        } else {
            Self::zero()
        }
    }
    /// Sign of a number, one for zero.
    #[inline(always)]
    fn signum_or_one(self) -> Self {
        Self::from_f64(if self < Self::zero() { -1.0 } else { 1.0 })
    }
}

/// Coefficients of s^(2k) in arcsin(s) / s: (2k)! / (4^k (k!)^2 (2k + 1)). For a sine of 0.0548 the next term is
/// 1.3e-17.
const ASIN: [f64; 6] = [
    1.0,
    1.0 / 6.0,
    3.0 / 40.0,
    5.0 / 112.0,
    35.0 / 1152.0,
    63.0 / 2816.0,
];

impl Real for f64 {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn floor(self) -> Self {
        libm::floor(self)
    }
    #[inline(always)]
    fn asin_small(self) -> Self {
        let q = self * self;
        let q2 = q * q;
        let low = (ASIN[0] + ASIN[1] * q) + (ASIN[2] + ASIN[3] * q) * q2;
        self * (low + (ASIN[4] + ASIN[5] * q) * (q2 * q2))
    }
    #[inline]
    fn atan2(self, other: Self) -> Self {
        libm::atan2(self, other)
    }
    fn asinh(self) -> Self {
        libm::asinh(self)
    }
    fn asin(self) -> Self {
        libm::asin(self)
    }
    fn acos(self) -> Self {
        libm::acos(self)
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }
}
