//! The fault that divides a block into two halves, thesis eqs. (70)-(71).

use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// A jagged fault; straight if its height is zero.
///
/// $$ y = y_0 + \frac{h}{2} \sin \left( 2 \pi n \frac{x}{l} \right) $$
///
/// Thesis eq. (71), or (70) for h = 0.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fault {
    /// Mean level $y_0$ of the fault in m.
    pub level: f64,
    /// Height $h$ of the jags, from trough to crest, in m.
    pub height: f64,
    /// Number $n$ of jags over the width.
    pub jags: f64,
    /// Width $l$ in m.
    pub width: f64,
}

/// Whether a point lies in the upper half of the block.
pub fn is_above(fault: &Fault, point: Vec2) -> bool {
    let phase = core::f64::consts::TAU * fault.jags * point.x / fault.width;
    point.y >= fault.level + 0.5 * fault.height * libm::sin(phase)
}
