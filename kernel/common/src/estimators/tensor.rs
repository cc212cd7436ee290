//! A tensor in the plane and its principal direction.

use crate::geometry::Vec2;
use core::ops::{Add, AddAssign, Mul};
use gouge_equations::rendered;

/// A tensor in the plane, such as a stress. It need not be symmetric.
///
/// Sums and multiples of tensors are tensors, so that they can be averaged over time before ratios are taken.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tensor {
    /// Row x, column x.
    pub xx: f64,
    /// Row x, column y.
    pub xy: f64,
    /// Row y, column x.
    pub yx: f64,
    /// Row y, column y.
    pub yy: f64,
}

#[rendered]
impl Tensor {
    /// The product of two vectors, $a_i b_j$.
    #[inline]
    pub fn outer(a: Vec2, b: Vec2) -> Self {
        Self {
            xx: a.x * b.x,
            xy: a.x * b.y,
            yx: a.y * b.x,
            yy: a.y * b.y,
        }
    }

    /// Mean of the principal values, $p = (\sigma_1 + \sigma_2)/2 = (\sigma_{xx} + \sigma_{yy})/2$.
    pub fn mean(self) -> f64 {
        0.5 * (self.xx + self.yy)
    }

    /// Half the difference of the principal values of the symmetric part, $q = (\sigma_1 - \sigma_2)/2 \ge 0$.
    pub fn deviator(self) -> f64 {
        self.deviatoric().norm()
    }

    /// The antisymmetric part, $(\sigma_{xy} - \sigma_{yx})/2$.
    pub fn antisymmetric(self) -> f64 {
        0.5 * (self.xy - self.yx)
    }

    /// Twice the angle of the major principal direction of the symmetric part, as the unit vector
    /// $(\cos 2\theta_s, \sin 2\theta_s)$. It is (1, 0) if the principal values are equal.
    pub fn axis(self) -> Vec2 {
        let (deviatoric, size) = (self.deviatoric(), self.deviator());
        if size > 0.0 {
            deviatoric * (1.0 / size)
        } else {
            Vec2::new(1.0, 0.0)
        }
    }

    /// Angle $\theta_s$ of the major principal direction in rad from the x axis, in (-pi/2, pi/2].
    pub fn principal_angle(self) -> f64 {
        let axis = self.axis();
        0.5 * libm::atan2(axis.y, axis.x)
    }

    /// The projection of the deviator on a direction that is given by twice its angle,
    /// $\frac12 (\sigma_{xx} - \sigma_{yy}) \cos 2\theta + \frac12 (\sigma_{xy} + \sigma_{yx}) \sin 2\theta$.
    ///
    /// It is linear in the tensor, so that projections of parts add up to that of the whole, which is
    /// [`Self::deviator`] in the whole's own direction.
    pub fn deviator_along(self, axis: Vec2) -> f64 {
        self.deviatoric().dot(axis)
    }

    fn deviatoric(self) -> Vec2 {
        Vec2::new(0.5 * (self.xx - self.yy), 0.5 * (self.xy + self.yx))
    }
}

impl Add for Tensor {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            xx: self.xx + other.xx,
            xy: self.xy + other.xy,
            yx: self.yx + other.yx,
            yy: self.yy + other.yy,
        }
    }
}

impl AddAssign for Tensor {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Mul<f64> for Tensor {
    type Output = Self;
    #[inline]
    fn mul(self, factor: f64) -> Self {
        Self {
            xx: self.xx * factor,
            xy: self.xy * factor,
            yx: self.yx * factor,
            yy: self.yy * factor,
        }
    }
}
