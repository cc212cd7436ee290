//! Stress of grains.

use crate::grain::Grains;
use crate::state::State;
use gouge_common::estimators::Tensor;
use gouge_equations::rendered;

/// Mean stress in Pa of a grain from its bonds, tension positive.
///
/// $$ \sigma_{ij} = \frac{1}{A} \sum_{bonds} F_i l_j $$
///
/// F is the force by which the bond pulls its earlier node towards the later one, l the vector from the earlier to the
/// later node, and A the area of the undeformed grain. The momentum of vibrations is not counted.
#[rendered]
pub fn grain_stress(grains: &Grains, state: &State, grain: usize) -> Tensor {
    let row = &grains.rows[grain];
    let constants = &row.constants;
    let mut sum = Tensor::default();
    for later in row.nodes.clone() {
        for (earlier, length) in state.bonds.with_earlier(later) {
            let (from, to) = (state.places[earlier], state.places[later]);
            let pull = (from.elongation_to(to, length)).pull(constants.weight, constants.horizon);
            let areas = grains.area[earlier] * grains.area[later];
            sum += Tensor::outer(pull * (constants.stiffness * areas), from.to(to));
        }
    }
    let area: f64 = grains.area[row.nodes.clone()].iter().sum();
    sum * (1.0 / area)
}
