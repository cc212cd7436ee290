//! The arithmetic that laws and integrators may use.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A real number.
///
/// Laws are generic over the number type: `f64` in production, other types to measure rounding errors or to
/// differentiate. Multiplication by `f64` keeps the literals of formulas readable.
///
/// Elementary functions come from `libm`, not from the platform, so that results have the same bits on every
/// machine. The square root may use the hardware, because it is correctly rounded everywhere.
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
    /// The nearest number of this type.
    fn from_f64(value: f64) -> Self;
    /// The nearest `f64`.
    fn to_f64(self) -> f64;
    /// Square root of a non-negative number.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// Largest integer not greater than the number.
    fn floor(self) -> Self;
    /// Inverse sine of a small number: relative truncation error below 2e-17 up to a sine of 0.0548.
    fn asin_small(self) -> Self;
    /// Angle of the vector (x, y) = (`other`, `self`), in (-pi, pi].
    fn atan2(self, other: Self) -> Self;
    /// Inverse hyperbolic sine.
    fn asinh(self) -> Self;
    /// Inverse sine.
    fn asin(self) -> Self;
    /// Inverse cosine.
    fn acos(self) -> Self;
    /// Power of a positive number.
    fn powf(self, exponent: f64) -> Self;
    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::default()
    }
    /// The smaller of two numbers; `self` if they are equal.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
    /// The larger of two numbers; `self` if they are equal.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
    /// Sign of the number: -1, 0 or 1.
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
    /// Sign of the number: -1 if negative, otherwise 1.
    #[inline(always)]
    fn signum_or_one(self) -> Self {
        Self::from_f64(if self < Self::zero() { -1.0 } else { 1.0 })
    }
}

/// Coefficients of s^(2k) in arcsin(s) / s: (2k)! / (4^k (k!)^2 (2k + 1)). The first omitted term is 1.3e-17 at
/// s = 0.0548.
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
    fn powf(self, exponent: f64) -> Self {
        libm::pow(self, exponent)
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }
}
