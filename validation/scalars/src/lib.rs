//! Number types for the kernel besides `f64`: lower and higher precision, and derivatives.
//!
//! Each wraps a type of a library, because the kernel's [`Real`](gouge_common::scalar::Real) can be
//! implemented only for types of this crate. What worlds do with them is compiled with this crate, once.

mod double_double;
mod dual;
mod single;

pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use single::Single;

/// Arithmetic of a wrapper type, forwarded to the number inside; products with `f64` convert the
/// factor.
macro_rules! forward_arithmetic {
    ($wrapper:ident, $factor:expr) => {
        impl ::core::ops::Add for $wrapper {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0)
            }
        }
        impl ::core::ops::Sub for $wrapper {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self(self.0 - other.0)
            }
        }
        impl ::core::ops::Mul for $wrapper {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                Self(self.0 * other.0)
            }
        }
        impl ::core::ops::Div for $wrapper {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: Self) -> Self {
                Self(self.0 / other.0)
            }
        }
        impl ::core::ops::Neg for $wrapper {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }
        impl ::core::ops::AddAssign for $wrapper {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }
        impl ::core::ops::SubAssign for $wrapper {
            #[inline(always)]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }
        impl ::core::ops::Mul<f64> for $wrapper {
            type Output = Self;
            #[inline(always)]
            fn mul(self, factor: f64) -> Self {
                Self(self.0 * $factor(factor))
            }
        }
    };
}
use forward_arithmetic;
