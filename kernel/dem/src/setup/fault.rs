//! The fault that parts a block, thesis eqs. (70)-(71).

use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// A jagged or, without height, straight fault.
///
/// $$ y = y_0 + \frac{h}{2} \sin \left( 2 \pi n \frac{x}{l} \right) $$
///
/// Thesis eq. (71); (70) for h = 0.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fault {
    /// Mean height of the fault in m.
    pub level: f64,
    /// Height of the jags from trough to crest in m.
    pub height: f64,
    /// Number of jags.
    pub jags: f64,
    /// Width over which the jags are counted in m.
    pub width: f64,
}

/// Whether a point belongs to the upper half.
pub fn is_above(fault: &Fault, point: Vec2) -> bool {
    let phase = core::f64::consts::TAU * fault.jags * point.x / fault.width;
    point.y >= fault.level + 0.5 * fault.height * libm::sin(phase)
}
