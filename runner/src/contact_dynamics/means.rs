//! Means over the contact networks of a run, from `network.csv`.

use super::run::Statistics;
use crate::run::columns::Columns;
use crate::run::folder::{NETWORK, PARTICLES};
use gouge_contact_dynamics::observables::{
    AngularSums, Anisotropies, Connectivity, ContactKind, MOST_CONTACTS, Profile, Sums,
};
use std::path::Path;

/// Means over the samples of a run in an interval of time.
#[derive(Clone, Debug)]
pub struct Means {
    /// Sums over all contacts in the slab away from the walls.
    pub slab: Sums,
    /// Sums over all contacts between bodies.
    pub cell: Sums,
    /// Numbers of contacts per free body.
    pub connectivity: Connectivity,
    /// Velocities between the walls.
    pub profile: Profile,
    /// Contacts in the slab by the directions of their normals.
    pub directions: AngularSums,
    /// Number of contacts between bodies at which two vertices meet.
    pub vertex_vertex: f64,
    /// Solid fractions of the slab and of the cell.
    pub solid_fractions: [f64; 2],
    /// Mean diameter of the circumscribed circles in m.
    pub diameter: f64,
}

/// The kinds of contacts, with the endings of names.
const KINDS: [(ContactKind, &str); 2] = [
    (ContactKind::SideVertex, "sv"),
    (ContactKind::SideSide, "ss"),
];
/// Names of the anisotropies, in the order of the fields.
const ANISOTROPIES: [&str; 5] = ["a_c", "a_fn", "a_ft", "a_ln", "a_lt"];

impl Means {
    /// The means over the samples of a run later than one time and not later than another, in s; none if it has no
    /// such samples.
    pub fn between(folder: &Path, after: f64, until: f64) -> Option<Self> {
        let network = Columns::read(&folder.join(NETWORK));
        let times = network.get("time")?;
        let is_in = |&row: &usize| times[row] > after && times[row] <= until;
        let rows: Vec<usize> = (0..times.len()).filter(is_in).collect();
        let sum = |name: &String| {
            let column = network.get(name)?;
            Some(rows.iter().map(|&row| column[row]).sum::<f64>())
        };
        let sums: Vec<f64> = Statistics::names().iter().map(sum).collect::<Option<_>>()?;
        let statistics = Statistics::from_values(&sums).filter(|_| !rows.is_empty())?;
        let particles = Columns::read(&folder.join(PARTICLES));
        let radii = particles.get("radius")?;
        let [slab, cell, slab_area, cell_area] = statistics.areas;
        Some(Self {
            slab: statistics.slab,
            cell: statistics.cell,
            connectivity: statistics.connectivity,
            profile: statistics.profile,
            directions: statistics.directions,
            vertex_vertex: statistics.vertex_vertex,
            solid_fractions: [slab / slab_area, cell / cell_area],
            diameter: 2.0 * radii.iter().sum::<f64>() / radii.len() as f64,
        })
    }

    /// Names of all means.
    pub fn names() -> Vec<String> {
        Self::empty()
            .all()
            .into_iter()
            .map(|(name, _)| name)
            .collect()
    }

    /// A mean by its name.
    pub fn get(&self, name: &str) -> Option<f64> {
        let all = self.all().into_iter();
        all.clone()
            .find(|(own, _)| own == name)
            .map(|(_, mean)| mean)
    }

    fn empty() -> Self {
        Self {
            slab: Sums::new(),
            cell: Sums::new(),
            connectivity: Connectivity::new(),
            profile: Profile::new(),
            directions: AngularSums::new(),
            vertex_vertex: 0.0,
            solid_fractions: [0.0; 2],
            diameter: 0.0,
        }
    }

    /// All means by their names: those of the slab unless they say otherwise.
    pub fn all(&self) -> Vec<(String, f64)> {
        let slab = &self.slab;
        let [of_slab, of_cell] = self.solid_fractions;
        let stress = slab.stress();
        let contacts = self.cell.total().contacts.sum;
        let named = [
            ("stress_ratio", slab.stress_ratio()),
            ("stress_ratio_cell", self.cell.stress_ratio()),
            (
                "antisymmetric_stress",
                stress.antisymmetric() / stress.mean(),
            ),
            ("solid_fraction", of_slab),
            ("solid_fraction_cell", of_cell),
            ("connected", self.connectivity.connected_share()),
            ("coordination", self.connectivity.coordination()),
            ("side_side", slab.share(ContactKind::SideSide)),
            ("side_vertex", slab.share(ContactKind::SideVertex)),
            ("sliding", slab.sliding_share()),
            ("unequal_points", slab.unequal_share()),
            ("normal_force", slab.relative_normal_force(self.diameter)),
            ("tangential_force", slab.relative_friction(self.diameter)),
            ("half_sum", slab.anisotropies().half_sum()),
            ("profile_deviation", self.profile.deviation()),
            ("vertex_vertex", self.vertex_vertex / contacts.max(1.0)),
        ];
        let mut all: Vec<(String, f64)> = named
            .into_iter()
            .map(|(name, mean)| (name.to_owned(), mean))
            .collect();
        all.extend(anisotropies("", &slab.anisotropies()));
        for (kind, ending) in KINDS {
            let part = slab.anisotropies_of(kind);
            let ratio = slab.stress_ratio_of(kind);
            all.push((format!("stress_ratio_{ending}"), ratio));
            all.push((format!("half_sum_{ending}"), part.half_sum()));
            all.extend(anisotropies(&format!("_{ending}"), &part));
        }
        for contacts in 2..=MOST_CONTACTS {
            let share = self.connectivity.share_with(contacts);
            all.push((format!("share_with_{contacts}"), share));
        }
        all
    }
}

fn anisotropies(ending: &str, of: &Anisotropies) -> [(String, f64); 5] {
    let numbers = [
        of.contacts,
        of.normal_force,
        of.tangential_force,
        of.normal_branch,
        of.tangential_branch,
    ];
    std::array::from_fn(|k| (format!("{}{ending}", ANISOTROPIES[k]), numbers[k]))
}
