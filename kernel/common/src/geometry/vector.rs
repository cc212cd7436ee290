//! Vectors in the plane.

use crate::scalar::Real;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// A vector in the plane, in a right-handed frame: x to the right, y up.
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
    /// The zero vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::default()
    }
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> S {
        self.x * other.x + self.y * other.y
    }
    /// Out-of-plane component of the cross product; positive if `other` points to the left of `self`.
    #[inline(always)]
    pub fn cross(self, other: Self) -> S {
        self.x * other.y - self.y * other.x
    }
    /// The vector rotated by +90 degrees: per (x, y) = (-y, x), thesis eq. (111).
    #[doc(alias = "per")]
    #[inline(always)]
    pub fn perpendicular(self) -> Self {
        Self::new(-self.y, self.x)
    }
    /// Squared length.
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
    /// The vector in another number type.
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
