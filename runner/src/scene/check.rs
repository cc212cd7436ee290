//! Checks that involve more than one table of a scene.

use super::table::Table;
use super::{Place, Scene};
use crate::error::SceneError;
use gouge_common::pair::Pair;
use gouge_dem::ModelError;
use gouge_dem::bonds::BondStart;
use gouge_dem::contacts::ContactStart;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::model::ContactLaws;
use gouge_dem::particles::Role;

type Result<T> = std::result::Result<T, SceneError>;

impl Scene {
    /// Check what no single table determines: that the parts of the scene fit together.
    pub(super) fn check(&self, root: &Table) -> Result<()> {
        if self.start.is_some() {
            // What is left to check depends on the state, which is read when the run begins.
            return Ok(());
        }
        if self.particles.is_empty() && self.setup.is_none() {
            return Err(no_particles(root));
        }
        let bonds_made = self
            .setup
            .as_ref()
            .is_some_and(|setup| setup.bonding.is_some());
        if self.bond.is_none() && (!self.bonds.is_empty() || bonds_made) {
            return Err(root.error(
                "bond",
                "missing; a scene with bonds needs the laws in [bond]",
            ));
        }
        let yields = self.bond.is_some_and(|bond| bond.yielding.is_some());
        let listed = !self.bonds.is_empty() || root.has("bonds_file");
        if yields && !listed && !bonds_made {
            let accepted = "yielding needs bonds: [[bonds]], bonds_file or [setup.bonding]";
            return Err(root.table("bond")?.error("yielding", accepted));
        }
        if self.contact.is_none() && !self.contacts.is_empty() {
            return Err(root.error(
                "contact",
                "missing; [[contacts]] need the laws in [contact]",
            ));
        }
        let sums = |contact: ContactLaws| matches!(contact.distance, ContactDistance::Mixed(_));
        let begin_by_angles = self.history.memories.is_none() && !self.contacts.is_empty();
        if self.contact.is_some_and(sums) && begin_by_angles {
            let accepted = "a table cannot be combined with [[contacts]]: it makes tangential displacements begin at zero";
            return Err(root.table("contact")?.error("distance", accepted));
        }
        if self.setup.is_some() && !self.history.inertia.is_empty() {
            let accepted =
                "cannot have the columns mass and moment_of_inertia in a scene with [setup]";
            return Err(root.error("particles_file", accepted));
        }
        self.check_pairs()?;
        self.check_driving(root)?;
        self.check_box(root)?;
        if self.setup.is_none() {
            self.initial_world()
                .map_err(|error| self.placed(root, &error))?;
        }
        Ok(())
    }

    fn check_pairs(&self) -> Result<()> {
        if self.setup.is_some() {
            let bonds = self.bonds.iter().map(|(bond, place)| (bond.between, place));
            let contacts = self
                .contacts
                .iter()
                .map(|(contact, place)| (contact.between, place));
            return match bonds.chain(contacts).next() {
                Some((between, place)) => Err(place.error(
                    format!("{between:?}"),
                    "cannot be listed in a scene with [setup], which makes its own contacts and bonds".to_owned(),
                )),
                None => Ok(()),
            };
        }
        let number = self.particles.len();
        check_pairs(
            number,
            self.bonds.iter().map(|(bond, place)| (bond.between, place)),
        )?;
        check_pairs(
            number,
            self.contacts
                .iter()
                .map(|(contact, place)| (contact.between, place)),
        )?;
        self.check_unbonded()
    }

    /// Check that no pair is listed both as a bond and as a contact.
    fn check_unbonded(&self) -> Result<()> {
        let pair = |between: [usize; 2]| Pair::new(between[0], between[1]);
        let bonded: std::collections::HashSet<Pair> = self
            .bonds
            .iter()
            .map(|(bond, _)| pair(bond.between))
            .collect();
        let both = |(contact, _): &&(ContactStart, Place)| bonded.contains(&pair(contact.between));
        match self.contacts.iter().find(both) {
            Some((contact, place)) => Err(place.error(
                format!("{:?}", contact.between),
                "names a pair that is bonded; a bonded pair has no contact".to_owned(),
            )),
            None => Ok(()),
        }
    }

    fn check_driving(&self, root: &Table) -> Result<()> {
        let Some(driving) = self.driving else {
            return Ok(());
        };
        let table = root.table("driving")?;
        let listed = self.particles.iter().any(|p| p.role == Role::Driven);
        let roles = self.setup.as_ref().and_then(|setup| setup.roles);
        if !listed && roles.is_none_or(|roles| roles.driven_above.is_none()) {
            let accepted = "needs a particle whose role is \"driven\"";
            return Err(root.error("driving", accepted));
        }
        if driving.area.is_none() && self.domain.width.is_none() {
            let accepted = "missing; required if box.width is absent; must be an area in m^2";
            return Err(table.error("area", accepted));
        }
        Ok(())
    }

    fn check_box(&self, root: &Table) -> Result<()> {
        let Some(width) = self.domain.period() else {
            return Ok(());
        };
        let listed = self.particles.iter().map(|p| p.radius).fold(0.0, f64::max);
        let made = self.setup.as_ref().map_or(0.0, |setup| setup.sizes.maximum);
        let cell = 2.0 * listed.max(made);
        if width < 2.0 * cell {
            let accepted = format!(
                "must be at least two cells wide, {} m (four times the largest radius)",
                2.0 * cell
            );
            return Err(root.table("box")?.error("width", &accepted));
        }
        Ok(())
    }

    /// An error of the kernel as an error of the scene, at the line of the bond or contact if known.
    fn placed(&self, root: &Table, error: &ModelError) -> SceneError {
        let bond = |(bond, place): &(BondStart, Place)| (bond.between, place.clone());
        let contact = |(contact, place): &(ContactStart, Place)| (contact.between, place.clone());
        let place = match error {
            ModelError::LongBond { index, .. } => self.bonds.get(*index).map(bond),
            ModelError::NoOverlap { index, .. } => self.contacts.get(*index).map(contact),
            _ => None,
        };
        match place {
            Some((between, place)) => place.error(format!("{between:?}"), error.to_string()),
            None => root.source().error(0, "", "", &error.to_string()),
        }
    }
}

fn check_pairs<'a>(
    particles: usize,
    pairs: impl Iterator<Item = ([usize; 2], &'a Place)>,
) -> Result<()> {
    let mut seen = std::collections::HashSet::new();
    for ([i, j], place) in pairs {
        let problem = if i >= particles || j >= particles {
            let last = particles.saturating_sub(1);
            Some(format!(
                "names a particle that does not exist; indices go from 0 to {last}"
            ))
        } else if i == j {
            Some("connects a particle with itself; must name two different particles".to_owned())
        } else if !seen.insert(Pair::new(i, j)) {
            Some("repeats a pair; each pair may be listed only once".to_owned())
        } else {
            None
        };
        if let Some(accepted) = problem {
            return Err(place.error(format!("[{i}, {j}]"), accepted));
        }
    }
    Ok(())
}

fn no_particles(root: &Table) -> SceneError {
    if root.has("particles_file") {
        return root.error("particles_file", "must list at least one particle");
    }
    let accepted = "a scene needs [[particles]], particles_file or [setup]";
    match root.has("particles") {
        true => root.error("particles", accepted),
        false => root.error("particles", &format!("missing; {accepted}")),
    }
}
