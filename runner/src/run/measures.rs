//! Quantities that a scene asks for: columns of the series after all others.

use super::displacements::Displacements;
use super::series::{Sample, Value};
use crate::scene::{Measure, Rectangle, Scene};
use gouge_common::estimators::{ContactNetwork, displacement_gradient};
use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::estimators::{
    largest_overlap, rolling_and_slip, specimen_packing, specimen_stress, unbalanced_force,
};
use gouge_dem::forces::{Forces, Interaction};
use gouge_dem::laws::characteristic_length;
use gouge_dem::particles::Role;

/// Quantities that are functions of contacts and bonds.
const OF_INTERACTIONS: [Measure; 4] = [
    Measure::Stress,
    Measure::Coordination,
    Measure::UnbalancedForce,
    Measure::LargestOverlap,
];

/// The columns of all quantities that a scene asks for. `evaluated` is the world with the forces in its state. Strains are
/// left out if no displacements are given.
pub fn measured(
    scene: &Scene,
    world: &World,
    evaluated: &World,
    displacements: Option<&Displacements>,
) -> Sample {
    let measures = &scene.output.measure;
    let needs_interactions = measures.iter().any(|one| OF_INTERACTIONS.contains(one));
    let state = Measured {
        world,
        resultant: evaluated.forces(),
        interactions: match needs_interactions {
            true => world.interactions(),
            false => Vec::new(),
        },
        displacements,
        region: scene.output.strain_region,
    };
    let columns = measures.iter().flat_map(|&measure| state.columns(measure));
    let value = |(name, number)| (name, Value::Number(number));
    columns.map(value).collect()
}

/// What quantities are functions of.
struct Measured<'a> {
    world: &'a World,
    resultant: &'a Forces<f64>,
    interactions: Vec<Interaction>,
    displacements: Option<&'a Displacements>,
    /// Where the particles were whose strain is measured; everywhere if none.
    region: Option<Rectangle>,
}

impl Measured<'_> {
    fn columns(&self, measure: Measure) -> Vec<(&'static str, f64)> {
        let (world, interactions) = (self.world, &self.interactions);
        match measure {
            Measure::Rolling => {
                let [rolling, slip] = rolling_and_slip(world);
                vec![("rolling_speed", rolling), ("slip_speed", slip)]
            }
            Measure::Stress => self.stress(),
            Measure::Coordination => vec![("coordination", self.coordination())],
            Measure::PackingFraction => vec![("packing_fraction", specimen_packing(world))],
            Measure::UnbalancedForce => {
                let unbalanced = unbalanced_force(world.particles(), self.resultant, interactions);
                vec![("unbalanced_force", unbalanced)]
            }
            Measure::LargestOverlap => {
                vec![("largest_overlap", largest_overlap(world, interactions))]
            }
            Measure::Strain => self.strain(),
        }
    }

    fn stress(&self) -> Vec<(&'static str, f64)> {
        let thickness = characteristic_length(&self.world.particles().radius);
        let [[xx, xy], [yx, yy]] = specimen_stress(self.world, &self.interactions, thickness);
        vec![
            ("stress_xx", xx),
            ("stress_xy", xy),
            ("stress_yx", yx),
            ("stress_yy", yy),
        ]
    }

    fn coordination(&self) -> f64 {
        let network = ContactNetwork {
            particles: self.world.particles().len(),
            contacts: self.interactions.iter().map(Into::into).collect(),
        };
        network.coordination_number()
    }

    /// The strain of the free particles since t = 0.
    fn strain(&self) -> Vec<(&'static str, f64)> {
        let Some(displacements) = self.displacements else {
            return Vec::new();
        };
        let p = self.world.particles();
        let moved = displacements.to(&p.position, self.world.model().domain.period());
        let origin = displacements.origin();
        let counts = |i: &usize| self.region.is_none_or(|region| region.contains(origin[*i]));
        let of_counted = |all: &[Vec2]| -> Vec<Vec2> {
            let free = p.with_role(Role::Free).filter(counts);
            free.map(|i| all[i]).collect()
        };
        let [[xx, xy], [yx, yy]] = displacement_gradient(&of_counted(origin), &of_counted(&moved));
        vec![
            ("strain_xx", xx),
            ("strain_yy", yy),
            ("strain_xy", 0.5 * (xy + yx)),
        ]
    }
}
