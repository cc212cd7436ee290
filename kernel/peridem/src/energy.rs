//! Energies of a state, and the work that changes their sum.

use crate::grain::Grains;
use crate::state::State;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Energies in J per metre of depth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// Of motion.
    pub kinetic: f64,
    /// Stored in bonds.
    pub bonds: f64,
    /// Stored in contacts between nodes.
    pub contacts: f64,
    /// Potential of gravity and of loads; zero in the reference positions.
    pub external: f64,
}

#[rendered]
impl Energies {
    /// Energies of a state, without those of contacts.
    ///
    /// $$ E = \sum_x \tfrac12 \rho V_x v^2 + \sum_{bonds} \tfrac12 c w s^2 r V_x V_y - \sum_x V_x (\rho \vec g + \vec b) \cdot \vec u $$
    ///
    /// with loads b, a force density in N/m^3. The energy of a bond is that of which (3.2) of peridem is the derivative.
    pub fn of(grains: &Grains, state: &State, gravity: Vec2) -> Self {
        let mut energies = Self::default();
        for node in 0..grains.nodes() {
            let mass = grains.mass(node);
            let displacement = state.places[node].displacement;
            energies.kinetic += 0.5 * mass * state.velocity[node].norm_squared();
            energies.external -= mass * gravity.dot(displacement);
            if let Some(load) = grains.load.get(node) {
                energies.external -= grains.area[node] * load.dot(displacement);
            }
        }
        energies.bonds = bond_energy(grains, state);
        energies
    }
}

fn bond_energy(grains: &Grains, state: &State) -> f64 {
    let mut sum = 0.0;
    for grain in &grains.rows {
        for later in grain.nodes.clone() {
            for (earlier, length) in state.bonds.with_earlier(later) {
                let (from, to) = (state.places[earlier], state.places[later]);
                let per_area = from.elongation_to(to, length).energy(&grain.constants);
                sum += per_area * grains.area[earlier] * grains.area[later];
            }
        }
    }
    sum
}
