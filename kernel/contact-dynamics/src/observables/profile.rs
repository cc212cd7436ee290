//! The profile of horizontal velocities between two walls.

use super::sums::ratio;
use crate::assembly::{Assembly, Configuration};
use core::ops::AddAssign;
use gouge_equations::rendered;

/// Sums of horizontal velocities in layers of equal height between floor and roof, over one or more steps. Bodies count
/// with their areas.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Profile {
    /// Areas of the bodies whose centres lie in each layer, in m².
    pub area: [f64; Self::LAYERS],
    /// Area times horizontal velocity over that of the roof.
    pub flow: [f64; Self::LAYERS],
}

impl AddAssign for Profile {
    fn add_assign(&mut self, other: Self) {
        for layer in 0..Self::LAYERS {
            self.area[layer] += other.area[layer];
            self.flow[layer] += other.flow[layer];
        }
    }
}

#[rendered]
impl Profile {
    /// Number of layers.
    pub const LAYERS: usize = 10;

    /// Nothing.
    pub fn new() -> Self {
        Self::default()
    }

    /// Add the bodies of a cell of a height in m whose roof moves with a velocity in m/s, which is not zero.
    pub fn add(
        &mut self,
        assembly: &Assembly,
        configuration: &Configuration,
        height: f64,
        speed: f64,
    ) {
        for (body, &unit) in assembly.unit.iter().enumerate() {
            let place = configuration.position[body].y / height * Self::LAYERS as f64;
            let layer = (place.max(0.0) as usize).min(Self::LAYERS - 1);
            let area = assembly.area(body);
            self.area[layer] += area;
            self.flow[layer] += area * configuration.velocity[unit as usize].linear.x / speed;
        }
    }

    /// Mean velocity of each layer over that of the roof.
    pub fn means(&self) -> [f64; Self::LAYERS] {
        core::array::from_fn(|layer| ratio(self.flow[layer], self.area[layer]))
    }

    /// Largest difference in the bulk, all layers but the lowest and the highest, between the mean velocity and that of
    /// homogeneous shear, over the velocity of the roof.
    ///
    /// $$ \max_k \left| \frac{\langle v_x \rangle_k}{v_{wall}} - \frac{k + 1/2}{10} \right| $$
    pub fn deviation(&self) -> f64 {
        let means = self.means().into_iter().enumerate();
        let bulk = means.skip(1).take(Self::LAYERS - 2);
        let middle = |layer: usize| (layer as f64 + 0.5) / Self::LAYERS as f64;
        bulk.fold(0.0, |most, (layer, mean)| {
            let difference = (mean - middle(layer)).abs();
            if difference > most { difference } else { most }
        })
    }
}
