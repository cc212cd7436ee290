//! Displacements between points, in the open plane and in a plane that is periodic in x.

use super::Vec2;
use crate::scalar::Real;
use gouge_equations::rendered;

/// How the displacement between two points is measured.
pub trait Metric: Copy + Send + Sync {
    /// Displacement of the nearest image, from the difference of two positions inside the box.
    fn nearest<S: Real>(self, difference: Vec2<S>) -> Vec2<S>;
    /// Displacement from `from` to `to`; its length is the distance of the points.
    #[inline(always)]
    fn displacement<S: Real>(self, from: Vec2<S>, to: Vec2<S>) -> Vec2<S> {
        self.nearest(to - from)
    }
    /// Whether a point lies inside the box.
    fn represents<S: Real>(self, point: Vec2<S>) -> bool;
    /// The periodic image of a point inside the box.
    fn wrap<S: Real>(self, point: Vec2<S>) -> Vec2<S>;
    /// Replace points by their images inside the box.
    ///
    /// Usually no point has left the box, which one vectorised test finds.
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

/// The open plane, thesis eq. (63).
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

/// The plane with period l in x: minimum image convention, thesis eq. (64).
///
/// $$ \Delta x = (x_j - x_i) - l \left\lfloor \frac{x_j - x_i}{l} + \frac12 \right\rfloor $$
///
/// The thesis prints only the distance. Here the displacement itself is that of the nearest image, so that
/// normals, angles and velocities refer to the same neighbour (erratum E44 of the thesis). Positions are kept
/// in [0, l], so a comparison replaces the floor function.
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
        // A selection instead of a branch, so that loops over pairs are vectorised.
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
            // Rounding may put the image of an edge just outside.
            point.x = x.max(S::zero()).min(S::from_f64(self.length));
        }
        point
    }
}
