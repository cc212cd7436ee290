//! Single precision.

use super::forward_arithmetic;
use gouge_common::lanes::Lanes;
use gouge_common::scalar::Real;
use gouge_dem::worlds_of;

/// A number of 24 bits, with all arithmetic in this precision.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Single(pub f32);

fn narrow(factor: f64) -> f32 {
    factor as f32
}

forward_arithmetic!(Single, narrow);

impl Lanes for Single {}
worlds_of!(Single);

impl Real for Single {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(value as f32)
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self.0)
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
        Self(libm::floorf(self.0))
    }
    fn asin_small(self) -> Self {
        self.asin()
    }
    fn atan2(self, other: Self) -> Self {
        Self(libm::atan2f(self.0, other.0))
    }
    fn asinh(self) -> Self {
        Self(libm::asinhf(self.0))
    }
    fn asin(self) -> Self {
        Self(libm::asinf(self.0))
    }
    fn acos(self) -> Self {
        Self(libm::acosf(self.0))
    }
    fn powf(self, exponent: f64) -> Self {
        Self(libm::powf(self.0, exponent as f32))
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
}
