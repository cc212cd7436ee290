//! Vectors of the plane.

use crate::scalar::Real;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// A vector of the plane, in the right-handed laboratory frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec2<S = f64> {
    /// Horizontal component.
    pub x: S,
    /// Vertical component.
    pub y: S,
}

impl<S: Real> Vec2<S> {
    /// The vector with the given components.
    #[inline(always)]
    pub fn new(x: S, y: S) -> Self {
        Self { x, y }
    }
    /// The null vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::default()
    }
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> S {
        self.x * other.x + self.y * other.y
    }
    /// Component of the vector product out of the plane; positive when `other` lies to the left.
    #[inline(always)]
    pub fn cross(self, other: Self) -> S {
        self.x * other.y - self.y * other.x
    }
    /// The vector turned by a quarter to the left: per (x, y) = (-y, x), thesis eq. (111).
    #[doc(alias = "per")]
    #[inline(always)]
    pub fn perpendicular(self) -> Self {
        Self::new(-self.y, self.x)
    }
    /// Square of the length.
    #[inline(always)]
    pub fn norm_squared(self) -> S {
        self.dot(self)
    }
    /// Length.
    #[inline(always)]
    pub fn norm(self) -> S {
        self.norm_squared().sqrt()
    }
    /// Whether both components are finite.
    #[inline(always)]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl Vec2<f64> {
    /// The same vector in another number type.
    pub fn cast<S: Real>(self) -> Vec2<S> {
        Vec2::new(S::from_f64(self.x), S::from_f64(self.y))
    }
}

impl<S: Real> Add for Vec2<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}
impl<S: Real> Sub for Vec2<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}
impl<S: Real> Neg for Vec2<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}
impl<S: Real> Mul<S> for Vec2<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: S) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }
}
impl<S: Real> AddAssign for Vec2<S> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.x += other.x;
        self.y += other.y;
    }
}
impl<S: Real> SubAssign for Vec2<S> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        self.x -= other.x;
        self.y -= other.y;
    }
}
