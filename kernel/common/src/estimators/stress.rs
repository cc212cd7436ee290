//! Mean stress in a region.

use super::ContactNetwork;
use gouge_equations::rendered;

#[rendered]
impl ContactNetwork {
    /// Mean stress in a volume in Pa, positive in tension: `[[xx, xy], [yx, yy]]`.
    ///
    /// $$ \sigma_{ab} = \frac{1}{V} \sum_{i<j} F_{ij,a}\, (x_{j,b} - x_{i,b}) $$
    ///
    /// Force of j on i times the branch vector from i to j, summed over all contacts and bonds. `volume` is in m^3;
    /// for a slice of the plane, its area times its depth. Symmetric if every particle is in rotational
    /// equilibrium. The kinetic part is omitted: the estimate holds for slow motion.
    pub fn mean_stress(&self, volume: f64) -> [[f64; 2]; 2] {
        let mut sum = [[0.0; 2]; 2];
        for contact in &self.contacts {
            let (force, branch) = (contact.force, contact.branch);
            for (row, force) in sum.iter_mut().zip([force.x, force.y]) {
                row[0] += force * branch.x / volume;
                row[1] += force * branch.y / volume;
            }
        }
        sum
    }
}
