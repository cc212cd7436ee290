//! Double-double precision.

use super::forward_arithmetic;
use gouge_common::lanes::Lanes;
use gouge_common::scalar::Real;
use gouge_dem::worlds_of;
use xprec::Df64;

/// The unevaluated sum of two doubles: 106 bits, about 32 decimal digits.
///
/// A law evaluated in this type shows the rounding error of the law in `f64`.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble(pub Df64);

impl Default for DoubleDouble {
    fn default() -> Self {
        Self(Df64::from(0.0))
    }
}

forward_arithmetic!(DoubleDouble, core::convert::identity);

impl Lanes for DoubleDouble {}
worlds_of!(DoubleDouble);

impl Real for DoubleDouble {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(Df64::from(value))
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.0.hi()
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    fn floor(self) -> Self {
        Self(self.0.floor())
    }
    fn asin_small(self) -> Self {
        self.asin()
    }
    fn atan2(self, other: Self) -> Self {
        Self(self.0.atan2(other.0))
    }
    fn asinh(self) -> Self {
        Self(self.0.asinh())
    }
    fn asin(self) -> Self {
        Self(self.0.asin())
    }
    fn acos(self) -> Self {
        Self(self.0.acos())
    }
    fn powf(self, exponent: f64) -> Self {
        Self((self.0.ln() * exponent).exp())
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.0.hi().is_finite()
    }
}
