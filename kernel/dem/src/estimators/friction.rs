//! Coefficient of friction of the driven block, thesis eqs. (85)-(86).

use crate::world::Drive;
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Coefficient of friction from the driving force, dimensionless.
///
/// $$ \mu = -\frac{\sum_i F_i^{driv\,x}}{\sum_i F_i^{driv\,y}} $$
///
/// Thesis eq. (85), as a ratio of sums over the driven particles. Positive if friction opposes motion towards
/// positive x under compression (erratum E23 of the thesis). NaN without a normal load.
#[rendered]
pub fn friction_load<S: Real>(drive: &Drive<S>) -> f64 {
    coefficient(drive.applied)
}

/// Coefficient of friction from the reaction on the driven particles, dimensionless.
///
/// $$ \mu = -\frac{\sum_i (F_i^x - F_i^{driv\,x})}{\sum_i (F_i^y - F_i^{driv\,y})} $$
///
/// Thesis eq. (86); sums and sign as in [`friction_load`].
#[rendered]
pub fn friction_feedback<S: Real>(drive: &Drive<S>) -> f64 {
    coefficient(drive.reaction)
}

fn coefficient<S: Real>(force: Vec2<S>) -> f64 {
    let (shear, load) = (force.x.to_f64(), force.y.to_f64());
    if load == 0.0 { f64::NAN } else { -shear / load }
}
