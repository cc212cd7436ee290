//! Mean stress of a region.

use crate::world::{Number, World};
use gouge_equations::rendered;

/// Mean stress of a volume in Pa, positive in tension: `[[xx, xy], [yx, yy]]`.
///
/// $$ \sigma_{ab} = \frac{1}{V} \sum_{i<j} F_{ij,a}\, (x_{j,b} - x_{i,b}) $$
///
/// Force of j on i times the branch vector from i to j, over all links; volume in m^3, for a slice of
/// the plane its area times its depth. Symmetric where every particle is in rotational equilibrium.
/// Holds for slow motion: the kinetic part is left out.
#[rendered]
pub fn mean_stress<S: Number>(world: &World<S>, volume: f64) -> [[f64; 2]; 2] {
    let mut sum = [[0.0; 2]; 2];
    for link in world.links() {
        let (normal, tangent) = (link.normal, link.normal.perpendicular());
        let force = normal * link.normal_force + tangent * link.tangential_force;
        let branch = normal * link.distance;
        for (row, force) in sum.iter_mut().zip([force.x, force.y]) {
            row[0] += force * branch.x / volume;
            row[1] += force * branch.y / volume;
        }
    }
    sum
}
