//! Angles of vectors and of rotating pair frames.

use core::f64::consts::{PI, TAU};
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Angle of a vector in rad.
///
/// $$ \arctan (\cos x, \sin x) = x, \qquad \lvert x \rvert \le \pi $$
///
/// Thesis eqs. (106)-(107). The result is in (-pi, pi]. The zero vector, for which the thesis does not define the
/// function, gives zero.
#[rendered]
pub fn angle_of<S: Real>(vector: Vec2<S>) -> S {
    // Adding zero turns -0 into +0; atan2 of -0 would be -pi on the negative x axis.
    (vector.y + S::zero()).atan2(vector.x)
}

/// Angle of the opposite direction in rad: x - pi for positive x, otherwise x + pi; thesis eq. (109).
///
/// For x = 0 the thesis permits both signs; this function returns +pi, like [`angle_of`].
#[doc(alias = "rev")]
pub fn reversed<S: Real>(angle: S) -> S {
    if angle > S::zero() {
        angle - S::from_f64(PI)
    } else {
        angle + S::from_f64(PI)
    }
}

/// The angle wrapped to [-pi, pi), in rad.
#[inline(always)]
pub fn wrapped<S: Real>(angle: S) -> S {
    if angle >= S::from_f64(-PI) && angle < S::from_f64(PI) {
        angle
    } else {
        let turns = (angle * (1.0 / TAU) + S::from_f64(0.5)).floor();
        angle - turns * TAU
    }
}

/// Smallest cosine for which [`Real::asin_small`] is used; the sine is then at most 0.0548.
const NEAR_COSINE: f64 = 0.9985;

/// Angle in rad by which `reference` must rotate to point along `direction`, and whether that angle is small.
///
/// $$ \delta = \arcsin(\vec e_0 \times \vec e), \quad \vec e_0 \cdot \vec e \ge 0.9985 $$
///
/// Both vectors must be unit vectors. A small angle is computed by a short polynomial instead of an arctangent.
/// Otherwise it is the angle of the vector (cosine, sine), in (-pi, pi].
#[rendered]
#[inline(always)]
pub fn turn<S: Real>(reference: Vec2<S>, direction: Vec2<S>) -> (S, bool) {
    let (angle, is_small) = small_turn(reference, direction);
    if is_small {
        return (angle, true);
    }
    let sine = reference.cross(direction);
    // As in `angle_of`: a rotation by half a turn is +pi.
    ((sine + S::zero()).atan2(reference.dot(direction)), false)
}

/// The result of [`turn`] for a small angle, and whether the angle is small. If not, the number is meaningless.
#[inline(always)]
pub(crate) fn small_turn<S: Real>(reference: Vec2<S>, direction: Vec2<S>) -> (S, bool) {
    let is_near = reference.dot(direction) >= S::from_f64(NEAR_COSINE);
    (reference.cross(direction).asin_small(), is_near)
}
