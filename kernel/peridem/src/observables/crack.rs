//! Direction and length of a crack.

use crate::bonds::Bonds;
use crate::grain::Grains;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// A straight crack that begins at a tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crack {
    /// Angle in rad of its direction from the x axis, anticlockwise, in (-pi, pi].
    pub angle: f64,
    /// Largest distance in m from the tip along it.
    pub length: f64,
    /// Number of its nodes.
    pub nodes: usize,
}

#[rendered]
impl Crack {
    /// The line through a tip with the least sum of squared distances from damaged nodes; `None` without such nodes.
    ///
    /// $$ \tan 2 \alpha = \frac{2 \sum x y}{\sum x^2 - \sum y^2} $$
    ///
    /// with reference positions from the tip. Nodes count if their damage exceeds a threshold and `belongs` accepts them. The direction is that in which most of them lie.
    pub fn from_tip(
        grains: &Grains,
        bonds: &Bonds,
        tip: Vec2,
        threshold: f64,
        belongs: impl Fn(usize) -> bool,
    ) -> Option<Self> {
        let is_of_crack = |&node: &usize| bonds.damage(node) > threshold && belongs(node);
        let nodes = (0..grains.nodes()).filter(is_of_crack);
        let arms: Vec<Vec2> = nodes.map(|node| grains.position[node] - tip).collect();
        let mut sum = Vec2::zero();
        let mut moments = Vec2::zero();
        for &arm in &arms {
            sum += arm;
            moments += Vec2::new(arm.x * arm.x - arm.y * arm.y, 2.0 * arm.x * arm.y);
        }
        let half = 0.5 * libm::atan2(moments.y, moments.x);
        let axis = Vec2::new(libm::cos(half), libm::sin(half));
        let direction = if axis.dot(sum) < 0.0 { -axis } else { axis };
        let along = arms.iter().map(|arm| arm.dot(direction));
        Some(Self {
            length: along.reduce(f64::max)?,
            angle: libm::atan2(direction.y, direction.x),
            nodes: arms.len(),
        })
    }
}
