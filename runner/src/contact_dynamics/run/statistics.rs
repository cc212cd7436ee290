//! Sums over the contact network at a sample.

use super::super::Scene;
use gouge_contact_dynamics::assembly::Assembly;
use gouge_contact_dynamics::cell::{UPPER, roof_height};
use gouge_contact_dynamics::observables::{
    AngularSums, Connectivity, Network, NetworkSettings, Profile, Slab, Sums, point_forces,
    solid_area, vertex_vertex_contacts,
};
use gouge_contact_dynamics::units::InverseMass;
use gouge_contact_dynamics::world::World;

/// Distance from each wall that the slab leaves out, in largest diameters.
const LEFT_OUT: f64 = 1.5;

/// What the network and the bodies of a cell show at one time.
#[derive(Clone, Debug)]
pub struct Statistics {
    /// Contacts in the slab.
    pub slab: Sums,
    /// All contacts between bodies.
    pub cell: Sums,
    /// Numbers of contacts per free body.
    pub connectivity: Connectivity,
    /// Velocities between the walls; nothing if the roof does not move sideways.
    pub profile: Profile,
    /// Contacts in the slab by the directions of their normals.
    pub directions: AngularSums,
    /// Number of contacts between bodies at which two vertices meet.
    pub vertex_vertex: f64,
    /// Areas in m² that bodies cover in the slab and in the cell, and those of slab and cell.
    pub areas: [f64; 4],
}

impl Statistics {
    /// Measure the network of the latest step of a cell.
    pub fn of(scene: &Scene, world: &World, network: &mut Network) -> Self {
        let (assembly, configuration) = (world.assembly(), &world.state().configuration);
        update(scene, world, network);
        let width = scene.domain.width.unwrap_or(0.0);
        let height = roof_height(world.state());
        let slab = slab(assembly, height);
        let cell = Slab {
            bottom: 0.0,
            top: height,
        };
        let areas = [slab, cell].map(|part| width * (part.top - part.bottom));
        let covered = [slab, cell].map(|part| solid_area(assembly, configuration, part));
        let mut statistics = Self {
            slab: Sums::new(),
            cell: Sums::new(),
            connectivity: Connectivity::new(),
            profile: Profile::new(),
            directions: AngularSums::new(),
            vertex_vertex: vertex_vertex_contacts(assembly, configuration, network.contacts())
                as f64,
            areas: [covered[0], covered[1], areas[0], areas[1]],
        };
        statistics.slab.add(network, Some(slab), areas[0]);
        statistics.cell.add(network, None, areas[1]);
        let contacts = network.contacts().iter();
        let inside = contacts.filter(|contact| slab.contains(contact.height));
        statistics.directions.add(inside);
        let is_free = |body: usize| is_free(assembly, body);
        statistics.connectivity.add(network.counts(), is_free);
        let speed = configuration.velocity[UPPER as usize].linear.x;
        if speed != 0.0 {
            let profile = &mut statistics.profile;
            profile.add(assembly, configuration, height, speed);
        }
        statistics
    }

    /// Names of all numbers.
    pub fn names() -> Vec<String> {
        let of = |part: &'static str| {
            let names = Sums::names().into_iter();
            names.map(move |name| format!("{part}_{name}"))
        };
        let areas = ["slab_solid", "cell_solid", "slab_area", "cell_area"].map(str::to_owned);
        of("slab")
            .chain(of("cell"))
            .chain(Connectivity::names())
            .chain(Profile::names())
            .chain(AngularSums::names())
            .chain(["vertex_vertex".to_owned()])
            .chain(areas)
            .collect()
    }

    /// The statistics, or sums of several, from their numbers; none if their number is wrong.
    pub fn from_values(numbers: &[f64]) -> Option<Self> {
        let length = Sums::names().len();
        let (slab, rest) = numbers.split_at_checked(length)?;
        let (cell, rest) = rest.split_at_checked(length)?;
        let (connectivity, rest) = rest.split_at_checked(Connectivity::names().len())?;
        let (profile, rest) = rest.split_at_checked(Profile::names().len())?;
        let (directions, rest) = rest.split_at_checked(AngularSums::names().len())?;
        let (&vertex_vertex, areas) = rest.split_first()?;
        Some(Self {
            slab: Sums::from_values(slab)?,
            cell: Sums::from_values(cell)?,
            connectivity: Connectivity::from_values(connectivity)?,
            profile: Profile::from_values(profile)?,
            directions: AngularSums::from_values(directions)?,
            vertex_vertex,
            areas: areas.try_into().ok()?,
        })
    }

    /// All numbers, in the order of their names.
    pub fn values(&self) -> Vec<f64> {
        let sums = self.slab.values().into_iter().chain(self.cell.values());
        sums.chain(self.connectivity.values())
            .chain(self.profile.values())
            .chain(self.directions.values())
            .chain([self.vertex_vertex])
            .chain(self.areas)
            .collect()
    }
}

/// Take the points of the latest step into a network.
pub fn update(scene: &Scene, world: &World, network: &mut Network) {
    let (assembly, configuration) = (world.assembly(), &world.state().configuration);
    let step = scene.settings.time_step;
    let points = point_forces(assembly, configuration, world.workspace(), step);
    let settings = NetworkSettings::for_friction(scene.settings.law.friction);
    network.update(points, assembly.unit.len(), &settings);
}

/// Whether a body moves freely.
pub fn is_free(assembly: &Assembly, body: usize) -> bool {
    let unit = assembly.unit[body] as usize;
    assembly.inverse_mass[unit] != InverseMass::IMPOSED
        && assembly.inverse_mass[unit].rotation > 0.0
}

/// The part of a cell away from its walls; all of a cell that is too low for one.
fn slab(assembly: &Assembly, height: f64) -> Slab {
    let diameters = (0..assembly.shape.len()).map(|body| diameter(assembly, body));
    let margin = LEFT_OUT * diameters.fold(0.0, f64::max);
    match height > 2.0 * margin {
        true => Slab {
            bottom: margin,
            top: height - margin,
        },
        false => Slab {
            bottom: 0.0,
            top: height,
        },
    }
}

/// Diameter in m of the circumscribed circle of a body.
pub fn diameter(assembly: &Assembly, body: usize) -> f64 {
    let measures = assembly.shapes.outline(assembly.shape[body]).measures;
    2.0 * measures.circumradius * assembly.scale[body]
}

/// Mean diameter in m of the circumscribed circles of all bodies.
pub fn mean_diameter(assembly: &Assembly) -> f64 {
    let number = assembly.shape.len();
    let sum: f64 = (0..number).map(|body| diameter(assembly, body)).sum();
    sum / number.max(1) as f64
}
