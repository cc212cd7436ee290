//! A shape with size and direction.

use crate::shape::Outline;
use gouge_common::geometry::Vec2;

/// A shape in its direction, around its own centroid.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    /// The shape of unit scale.
    pub outline: Outline<'a>,
    /// Size: the factor on all lengths.
    pub scale: f64,
    /// Unit vector of the x axis of the body: (cos, sin) of its angle.
    pub axis: Vec2,
}

impl<'a> Placed<'a> {
    /// A shape turned by an angle in rad.
    pub fn new(outline: Outline<'a>, scale: f64, angle: f64) -> Self {
        let axis = Vec2::new(libm::cos(angle), libm::sin(angle));
        Self {
            outline,
            scale,
            axis,
        }
    }

    /// A vector of the body frame in the frame of space.
    #[inline]
    pub fn to_space(&self, v: Vec2) -> Vec2 {
        self.axis * v.x + self.axis.perpendicular() * v.y
    }

    /// A vector of the frame of space in the body frame.
    #[inline]
    pub fn to_body(&self, v: Vec2) -> Vec2 {
        Vec2::new(self.axis.dot(v), self.axis.cross(v))
    }

    /// Vector from the centroid to a vertex, in the body frame, in m.
    #[inline]
    pub fn vertex(&self, k: usize) -> Vec2 {
        self.outline.vertices[k] * self.scale
    }

    /// Distance from the centroid to the line of a side in m.
    #[inline]
    pub fn offset(&self, k: usize) -> f64 {
        self.outline.sides[k].offset * self.scale
    }

    /// Distance in m from the centroid to the farthest point in a direction, a unit vector.
    pub fn reach(&self, direction: Vec2) -> f64 {
        match self.disc_radius() {
            Some(radius) => radius,
            None => self.scale * self.outline.support(self.to_body(direction)).1,
        }
    }

    /// Radius of the circle that contains the shape, in m.
    #[inline]
    pub fn circumradius(&self) -> f64 {
        self.outline.measures.circumradius * self.scale
    }

    /// Radius of the circle that the shape contains, in m.
    #[inline]
    pub fn inradius(&self) -> f64 {
        self.outline.measures.inradius * self.scale
    }

    /// Radius in m, if the shape is a disc.
    #[inline]
    pub fn disc_radius(&self) -> Option<f64> {
        self.outline.is_disc().then_some(self.scale)
    }
}
