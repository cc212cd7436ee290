//! Dual numbers.

use super::forward_arithmetic;
use core::cmp::Ordering;
use gouge_common::lanes::Lanes;
use gouge_common::scalar::Real;
use gouge_dem::worlds_of;
use num_dual::{Dual64, DualNum};

/// A number and its derivative: a law evaluated in this type returns its own derivative, exact to
/// rounding.
///
/// Comparisons use the value, so that at a kink the derivative is that of the branch taken.
#[derive(Clone, Copy, Debug)]
pub struct Dual(pub Dual64);

impl Dual {
    /// A number and its derivative.
    pub fn new(value: f64, slope: f64) -> Self {
        Self(Dual64::new(value, slope))
    }
    /// The independent variable, with derivative one.
    pub fn variable(value: f64) -> Self {
        Self::new(value, 1.0)
    }
    /// The value.
    pub fn value(self) -> f64 {
        self.0.re
    }
    /// The derivative.
    pub fn slope(self) -> f64 {
        self.0.eps
    }
}

impl Default for Dual {
    fn default() -> Self {
        Self::new(0.0, 0.0)
    }
}
impl PartialEq for Dual {
    fn eq(&self, other: &Self) -> bool {
        self.value() == other.value()
    }
}
impl PartialOrd for Dual {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value().partial_cmp(&other.value())
    }
}

forward_arithmetic!(Dual, core::convert::identity);

impl Lanes for Dual {}
worlds_of!(Dual);

impl Real for Dual {
    fn from_f64(value: f64) -> Self {
        Self::new(value, 0.0)
    }
    fn to_f64(self) -> f64 {
        self.value()
    }
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    fn abs(self) -> Self {
        if self.value() < 0.0 { -self } else { self }
    }
    fn floor(self) -> Self {
        Self::new(libm::floor(self.value()), 0.0)
    }
    fn asin_small(self) -> Self {
        self.asin()
    }
    fn atan2(self, other: Self) -> Self {
        // The derivative of the angle itself; that of a quotient of the arguments would be undefined at
        // x = 0.
        let (y, x) = (self.value(), other.value());
        let slope = (self.slope() * x - other.slope() * y) / (x * x + y * y);
        Self::new(y.atan2(x), slope)
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
        Self(self.0.powf(exponent))
    }
    fn is_finite(self) -> bool {
        self.value().is_finite() && self.slope().is_finite()
    }
}
