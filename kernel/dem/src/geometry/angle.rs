//! Angles of vectors and of turning frames.

use core::f64::consts::{PI, TAU};
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Angle of a vector.
///
/// $$ \arctan (\cos x, \sin x) = x, \qquad \lvert x \rvert \le \pi $$
///
/// Thesis eqs. (106)-(107). Result in (-pi, pi]; the null vector, for which the thesis leaves the
/// function undefined, gives zero.
#[rendered]
pub fn angle_of<S: Real>(vector: Vec2<S>) -> S {
    // Adding zero makes a negative zero positive, whose arctangent would be -pi on the negative x axis.
    (vector.y + S::zero()).atan2(vector.x)
}

/// Angle of the opposite direction: x - pi for positive x, x + pi otherwise; thesis eq. (109).
///
/// At zero the thesis allows both signs; this returns +pi, the choice of [`angle_of`].
#[doc(alias = "rev")]
pub fn reversed<S: Real>(angle: S) -> S {
    if angle > S::zero() {
        angle - S::from_f64(PI)
    } else {
        angle + S::from_f64(PI)
    }
}

/// The angle's representative in [-pi, pi).
#[inline(always)]
pub fn wrapped<S: Real>(angle: S) -> S {
    if angle >= S::from_f64(-PI) && angle < S::from_f64(PI) {
        angle
    } else {
        let turns = (angle * (1.0 / TAU) + S::from_f64(0.5)).floor();
        angle - turns * TAU
    }
}

/// Smallest cosine for which [`Real::asin_small`] is used: sines up to 0.0548.
const NEAR_COSINE: f64 = 0.9985;

/// Angle by which `reference` has to be turned to point along `direction`, and whether it is small.
///
/// $$ \delta = \arcsin(\vec e_0 \times \vec e), \quad \vec e_0 \cdot \vec e \ge 0.9985 $$
///
/// Both vectors are of unit length. A small angle costs a short polynomial instead of an arctangent;
/// otherwise the angle is that of the vector (cosine, sine), in (-pi, pi].
#[rendered]
#[inline(always)]
pub fn turn<S: Real>(reference: Vec2<S>, direction: Vec2<S>) -> (S, bool) {
    let (angle, is_small) = small_turn(reference, direction);
    if is_small {
        return (angle, true);
    }
    let sine = reference.cross(direction);
    // As in `angle_of`: half a turn is +pi.
    ((sine + S::zero()).atan2(reference.dot(direction)), false)
}

/// The small angle of [`turn`], and whether it is the angle: without it, the number has no meaning.
#[inline(always)]
pub(crate) fn small_turn<S: Real>(reference: Vec2<S>, direction: Vec2<S>) -> (S, bool) {
    let is_near = reference.dot(direction) >= S::from_f64(NEAR_COSINE);
    (reference.cross(direction).asin_small(), is_near)
}
