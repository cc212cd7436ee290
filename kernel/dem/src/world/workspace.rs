//! Buffers and constants that follow from the state and the model, and can be thrown away.

use crate::forces::PartWorkspace;
use crate::model::Model;
use crate::particles::{Particles, Role};
use gouge_common::lanes::Lanes;
use gouge_common::neighbors::Neighbors;
use gouge_common::scalar::Real;

/// What a step needs besides the state.
#[derive(Clone, Debug)]
pub(super) struct Workspace<S: Lanes> {
    /// Inverse masses in 1/kg, zero for fixed particles.
    pub inverse_mass: Vec<S>,
    /// Inverse moments of inertia in 1/(kg m^2), zero for fixed particles.
    pub inverse_inertia: Vec<S>,
    /// Indices of the driven particles.
    pub driven: Vec<u32>,
    /// Whether any particle can turn.
    pub has_rotation: bool,
    /// The neighbour search, if the model has contacts.
    pub neighbors: Option<Neighbors<S>>,
    /// Whether the neighbour list is stale, if that is known.
    pub is_stale: Option<bool>,
    /// A buffer per part.
    pub parts: Vec<PartWorkspace<S>>,
    /// Per part, whether its particles make the neighbour list stale.
    pub stale_parts: Vec<bool>,
}

impl<S: Lanes> Workspace<S> {
    /// The workspace of a single part.
    pub fn new(model: &Model, particles: &Particles<S>) -> Self {
        let neighbors = || Neighbors::new(particles.search_spheres(), &model.domain);
        let driven = particles.with_role(Role::Driven).map(|i| i as u32);
        Self {
            inverse_mass: inverse(&particles.mass, particles),
            inverse_inertia: inverse(&particles.moment_of_inertia, particles),
            driven: model.driving.map_or_else(Vec::new, |_| driven.collect()),
            has_rotation: has_rotation(model, particles),
            neighbors: model.contact.map(|_| neighbors()),
            is_stale: None,
            parts: vec![PartWorkspace::default()],
            stale_parts: vec![false],
        }
    }

    /// Reserve room for as many broken bonds as there are, so that a step allocates nothing; `sizes` are those
    /// of the parts, in particles.
    pub fn reserve(&mut self, bonds: usize, particles: usize, sizes: impl Iterator<Item = usize>) {
        for (part, size) in self.parts.iter_mut().zip(sizes) {
            part.broken.reserve(bonds * size / particles.max(1));
        }
    }
}

/// Inverses of masses or moments of inertia; zero for fixed particles.
fn inverse<S: Real>(column: &[S], particles: &Particles<S>) -> Vec<S> {
    let of = |(i, &x): (usize, &S)| match particles.is_fixed(i) {
        true => S::zero(),
        false => S::from_f64(1.0) / x,
    };
    column.iter().enumerate().map(of).collect()
}

/// Whether anything turns: a particle that spins already, or a law that exerts a torque.
fn has_rotation<S: Real>(model: &Model, particles: &Particles<S>) -> bool {
    let mut spins = particles.angular_velocity.iter();
    let has_friction = model.contact.is_some_and(|laws| laws.tangential.is_some());
    let has_beams = model.bond.is_some_and(|laws| laws.tangential.is_some());
    has_friction || has_beams || spins.any(|spin| *spin != S::zero())
}
