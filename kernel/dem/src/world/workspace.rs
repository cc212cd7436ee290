//! Buffers and constants of a world that follow from its model and state.

use super::breaks::Break;
use crate::forces::PartWorkspace;
use crate::model::Model;
use crate::particles::{Particles, Role};
use gouge_common::lanes::Lanes;
use gouge_common::neighbors::Neighbors;
use gouge_common::scalar::Real;

/// Buffers and constants that a step needs besides the state.
#[derive(Clone, Debug)]
pub(super) struct Workspace<S: Lanes> {
    /// Inverse masses in 1/kg, zero for particles that forces cannot move.
    pub inverse_mass: Vec<S>,
    /// Inverse moments of inertia in 1/(kg m^2), zero for these particles.
    pub inverse_inertia: Vec<S>,
    /// Indices of the driven particles.
    pub driven: Vec<u32>,
    /// Whether any particle can rotate.
    pub has_rotation: bool,
    /// The neighbour search, if the model has contacts.
    pub neighbors: Option<Neighbors<S>>,
    /// Whether the neighbour list is stale; `None` if unknown.
    pub is_stale: Option<bool>,
    /// Buffers, one per part.
    pub parts: Vec<PartWorkspace<S>>,
    /// Whether the neighbour list is stale, according to the particles of each part.
    pub stale_parts: Vec<bool>,
    /// The bonds that broke since they were last asked for.
    pub breaks: Vec<Break>,
}

impl<S: Lanes> Workspace<S> {
    /// The workspace for a single part.
    pub fn new<N>(model: &Model<N>, particles: &Particles<S>) -> Self {
        let neighbors = || Neighbors::new(particles.search_spheres(), &model.domain);
        let driven = particles.with_role(Role::Driven).map(|i| i as u32);
        Self {
            inverse_mass: inverse(&particles.mass, model, particles),
            inverse_inertia: inverse(&particles.moment_of_inertia, model, particles),
            driven: model.driving.map_or_else(Vec::new, |_| driven.collect()),
            has_rotation: has_rotation(model, particles),
            neighbors: model.contact.as_ref().map(|_| neighbors()),
            is_stale: None,
            parts: vec![PartWorkspace::default()],
            stale_parts: vec![false],
            breaks: Vec::new(),
        }
    }

    /// Reserve memory for bonds that may break, so that a step allocates nothing. `sizes` are the numbers of particles of
    /// the parts.
    pub fn reserve(&mut self, bonds: usize, particles: usize, sizes: impl Iterator<Item = usize>) {
        self.breaks.reserve(bonds);
        for (part, size) in self.parts.iter_mut().zip(sizes) {
            part.broken.reserve(bonds * size / particles.max(1));
        }
    }
}

/// Inverse masses or moments of inertia; zero for particles that forces cannot move.
fn inverse<S: Real, N>(column: &[S], model: &Model<N>, particles: &Particles<S>) -> Vec<S> {
    let prescribed = model.driving.and_then(|law| law.prescribed_velocity());
    let of = |(i, &x): (usize, &S)| match particles.role[i] {
        Role::Fixed => S::zero(),
        Role::Driven if prescribed.is_some() => S::zero(),
        Role::Free | Role::Driven => S::from_f64(1.0) / x,
    };
    column.iter().enumerate().map(of).collect()
}

/// Whether anything rotates: a law exerts torques, or a particle spins initially.
fn has_rotation<S: Real, N>(model: &Model<N>, particles: &Particles<S>) -> bool {
    let mut spins = particles.angular_velocity.iter();
    let contact = model.contact.as_ref();
    let has_friction = contact.is_some_and(|laws| laws.tangential.is_some());
    let has_beams = model.bond.is_some_and(|laws| laws.tangential.is_some());
    has_friction || has_beams || spins.any(|spin| *spin != S::zero())
}
