//! Displacements between points, in the open plane and in one that is periodic in x.

use super::Vec2;
use crate::scalar::Real;
use gouge_equations::rendered;

/// A rule for the displacement from one point to another.
pub trait Metric: Copy + Send + Sync {
    /// The shortest displacement for a difference of two representatives.
    fn nearest<S: Real>(self, difference: Vec2<S>) -> Vec2<S>;
    /// Displacement from `from` to `to`; its length is the distance.
    #[inline(always)]
    fn displacement<S: Real>(self, from: Vec2<S>, to: Vec2<S>) -> Vec2<S> {
        self.nearest(to - from)
    }
    /// Whether a point is its own representative.
    fn represents<S: Real>(self, point: Vec2<S>) -> bool;
    /// The representative of a point.
    fn wrap<S: Real>(self, point: Vec2<S>) -> Vec2<S>;
    /// Replace points by their representatives; most are their own, which is seen of many together.
    #[inline(always)]
    fn wrap_all<S: Real>(self, points: &mut [Vec2<S>]) {
        let all = (points.iter()).fold(true, |all, &point| all & self.represents(point));
        if !all {
            points
                .iter_mut()
                .for_each(|point| *point = self.wrap(*point));
        }
    }
}

/// The Euclidean plane, thesis eq. (63).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Open;

impl Metric for Open {
    #[inline(always)]
    fn nearest<S: Real>(self, difference: Vec2<S>) -> Vec2<S> {
        difference
    }
    #[inline(always)]
    fn represents<S: Real>(self, _: Vec2<S>) -> bool {
        true
    }
    #[inline(always)]
    fn wrap<S: Real>(self, point: Vec2<S>) -> Vec2<S> {
        point
    }
}

/// The plane rolled up along x: horizontal minimum image, thesis eq. (64).
///
/// $$ \Delta x = (x_j - x_i) - l \left\lfloor \frac{x_j - x_i}{l} + \frac12 \right\rfloor $$
///
/// The thesis prints the distance only; here the displacement itself is that of the nearest image,
/// so that normals, angles and velocities see the same neighbour (erratum E44 of the thesis). Points
/// are represented in [0, l], for which one comparison replaces the floor function.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeriodicX {
    /// Period l in m.
    pub length: f64,
}

impl Metric for PeriodicX {
    #[inline(always)]
    fn nearest<S: Real>(self, difference: Vec2<S>) -> Vec2<S> {
        let half = S::from_f64(0.5 * self.length);
        // Selected instead of branched upon, so that many links are looked at together.
        let period = if difference.x >= half {
            S::from_f64(self.length)
        } else if difference.x < -half {
            S::from_f64(-self.length)
        } else {
            S::zero()
        };
        Vec2::new(difference.x - period, difference.y)
    }
    #[inline(always)]
    fn represents<S: Real>(self, point: Vec2<S>) -> bool {
        (point.x >= S::zero()) & (point.x < S::from_f64(self.length))
    }
    #[inline(always)]
    fn wrap<S: Real>(self, mut point: Vec2<S>) -> Vec2<S> {
        if !self.represents(point) {
            let x = point.x - (point.x * (1.0 / self.length)).floor() * self.length;
            // Rounding may put the representative of an edge just outside.
            point.x = x.max(S::zero()).min(S::from_f64(self.length));
        }
        point
    }
}
