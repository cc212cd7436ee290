//! Quantities that a scene asks for: columns of the series after all others.

use super::displacements::Displacements;
use super::series::{Sample, Value};
use crate::error::SceneError;
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

/// Names of the columns of a quantity.
pub fn names(measure: Measure) -> &'static [&'static str] {
    match measure {
        Measure::Rolling => &["rolling_speed", "slip_speed"],
        Measure::Stress => &["stress_xx", "stress_xy", "stress_yx", "stress_yy"],
        Measure::Coordination => &["coordination"],
        Measure::PackingFraction => &["packing_fraction"],
        Measure::UnbalancedForce => &["unbalanced_force"],
        Measure::LargestOverlap => &["largest_overlap"],
        Measure::Strain => &["strain_xx", "strain_yy", "strain_xy"],
    }
}

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
    let columns = measures.iter().flat_map(|&measure| {
        let names = names(measure).iter().copied();
        names.zip(state.values(measure))
    });
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
    fn values(&self, measure: Measure) -> Vec<f64> {
        let (world, interactions) = (self.world, &self.interactions);
        match measure {
            Measure::Rolling => rolling_and_slip(world).to_vec(),
            Measure::Stress => self.stress(),
            Measure::Coordination => vec![self.coordination()],
            Measure::PackingFraction => vec![specimen_packing(world)],
            Measure::UnbalancedForce => vec![unbalanced_force(
                world.particles(),
                self.resultant,
                interactions,
            )],
            Measure::LargestOverlap => vec![largest_overlap(world, interactions)],
            Measure::Strain => self.strain(),
        }
    }

    fn stress(&self) -> Vec<f64> {
        let thickness = characteristic_length(&self.world.particles().radius);
        let [[xx, xy], [yx, yy]] = specimen_stress(self.world, &self.interactions, thickness);
        vec![xx, xy, yx, yy]
    }

    fn coordination(&self) -> f64 {
        let network = ContactNetwork {
            particles: self.world.particles().len(),
            contacts: self.interactions.iter().map(Into::into).collect(),
        };
        network.coordination_number()
    }

    /// The strain of the free particles since t = 0.
    fn strain(&self) -> Vec<f64> {
        let Some(displacements) = self.displacements else {
            return Vec::new();
        };
        let p = self.world.particles();
        let moved = displacements.to(&p.position, self.world.model().domain.period());
        let origin = displacements.origin();
        let counted = counted(self.world, origin, self.region);
        let of_counted = |all: &[Vec2]| -> Vec<Vec2> { counted.iter().map(|&i| all[i]).collect() };
        let [[xx, xy], [yx, yy]] = displacement_gradient(&of_counted(origin), &of_counted(&moved));
        vec![xx, yy, 0.5 * (xy + yx)]
    }
}

/// The free particles whose strain is measured: those that were in the region at t = 0, if there is one.
fn counted(world: &World, origin: &[Vec2], region: Option<Rectangle>) -> Vec<usize> {
    let counts = |i: &usize| region.is_none_or(|region| region.contains(origin[*i]));
    let free = world.particles().with_role(Role::Free);
    free.filter(counts).collect()
}

/// Check that the region whose strain a scene asks for has one in the world at t = 0.
///
/// # Errors
/// Too few free particles in the region.
pub fn check_strain(scene: &Scene, world: &World) -> Result<(), SceneError> {
    let Some(refusal) = &scene.output.region_refusal else {
        return Ok(());
    };
    let position = &world.particles().position;
    let counted = counted(world, position, scene.output.strain_region);
    let points: Vec<Vec2> = counted.iter().map(|&i| position[i]).collect();
    // A gradient is determined or not whatever the displacements are.
    match displacement_gradient(&points, &points)[0][0].is_finite() {
        true => Ok(()),
        false => Err(SceneError {
            accepted: format!(
                "needs at least three free grains that do not lie on a line, but there are {} at t = 0",
                counted.len()
            ),
            ..refusal.clone()
        }),
    }
}
