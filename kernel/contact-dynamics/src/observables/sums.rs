//! Sums over the contacts of many steps, and the ratios of such sums.

use super::{Anisotropies, Contact, ContactKind, Network, Slab};
use core::ops::AddAssign;
use gouge_common::estimators::Tensor;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Sum of a quantity over contacts, alone and weighted by the direction of the normal.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Harmonic {
    /// $\sum x$
    pub sum: f64,
    /// $\sum x \cos 2\theta$
    pub cos: f64,
    /// $\sum x \sin 2\theta$
    pub sin: f64,
}

/// Sums over contacts of one kind.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct KindSums {
    /// Number of contacts.
    pub contacts: Harmonic,
    /// Normal forces in N.
    pub normal_force: Harmonic,
    /// Tangential forces in N.
    pub tangential_force: Harmonic,
    /// Normal components of branch vectors in m.
    pub normal_branch: Harmonic,
    /// Tangential components of branch vectors in m.
    pub tangential_branch: Harmonic,
    /// Magnitudes of the tangential forces in N.
    pub friction: f64,
    /// Number of sliding contacts.
    pub sliding: f64,
    /// Number of contacts of which one point slides and the other does not.
    pub unequal: f64,
    /// Stresses in Pa.
    pub stress: Tensor,
}

/// Sums over the contacts of one or more steps.
///
/// Sums of different steps may be added; every step has the same weight in the stress, and every contact the same
/// weight in everything else.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sums {
    /// Contacts with one point.
    pub side_vertex: KindSums,
    /// Contacts with two points.
    pub side_side: KindSums,
    /// Number of steps.
    pub steps: f64,
}

impl Harmonic {
    #[inline]
    fn add(&mut self, value: f64, axis: Vec2) {
        self.sum += value;
        self.cos += value * axis.x;
        self.sin += value * axis.y;
    }

    /// $\sum x \cos 2(\theta - \theta_s)$
    pub(super) fn even(&self, axis: Vec2) -> f64 {
        self.cos * axis.x + self.sin * axis.y
    }

    /// $\sum x \sin 2(\theta - \theta_s)$
    pub(super) fn odd(&self, axis: Vec2) -> f64 {
        self.sin * axis.x - self.cos * axis.y
    }
}

impl AddAssign for Harmonic {
    fn add_assign(&mut self, other: Self) {
        self.sum += other.sum;
        self.cos += other.cos;
        self.sin += other.sin;
    }
}

impl AddAssign for KindSums {
    fn add_assign(&mut self, other: Self) {
        self.contacts += other.contacts;
        self.normal_force += other.normal_force;
        self.tangential_force += other.tangential_force;
        self.normal_branch += other.normal_branch;
        self.tangential_branch += other.tangential_branch;
        self.friction += other.friction;
        self.sliding += other.sliding;
        self.unequal += other.unequal;
        self.stress += other.stress;
    }
}

impl AddAssign for Sums {
    fn add_assign(&mut self, other: Self) {
        self.side_vertex += other.side_vertex;
        self.side_side += other.side_side;
        self.steps += other.steps;
    }
}

impl KindSums {
    #[inline]
    fn add(&mut self, contact: &Contact, volume: f64) {
        let (axis, force, branch) = (contact.axis(), contact.force, contact.branch);
        self.contacts.add(1.0, axis);
        self.normal_force.add(force.n, axis);
        self.tangential_force.add(force.t, axis);
        self.normal_branch.add(branch.n, axis);
        self.tangential_branch.add(branch.t, axis);
        self.friction += force.t.abs();
        self.sliding += f64::from(u8::from(contact.is_sliding));
        self.unequal += f64::from(u8::from(contact.has_unequal_points));
        let moment = Tensor::outer(contact.vector(force), contact.vector(branch));
        self.stress += moment * (1.0 / volume);
    }
}

/// A ratio, or zero if there is nothing to compare with.
pub(super) fn ratio(part: f64, whole: f64) -> f64 {
    if whole == 0.0 { 0.0 } else { part / whole }
}

#[rendered]
impl Sums {
    /// Nothing.
    pub fn new() -> Self {
        Self::default()
    }

    /// Add the contacts of a step whose points lie in a slab of the given volume in m^2, or all without a slab.
    pub fn add(&mut self, network: &Network, slab: Option<Slab>, volume: f64) {
        self.add_contacts(network.contacts(), slab, volume);
    }

    /// As [`Self::add`], for contacts of any origin.
    pub fn add_contacts(&mut self, contacts: &[Contact], slab: Option<Slab>, volume: f64) {
        let is_inside = |contact: &&Contact| slab.is_none_or(|slab| slab.contains(contact.height));
        for contact in contacts.iter().filter(is_inside) {
            match contact.kind {
                ContactKind::SideVertex => self.side_vertex.add(contact, volume),
                ContactKind::SideSide => self.side_side.add(contact, volume),
            }
        }
        self.steps += 1.0;
    }

    /// The sums over contacts of a kind.
    pub fn of(&self, kind: ContactKind) -> &KindSums {
        match kind {
            ContactKind::SideVertex => &self.side_vertex,
            ContactKind::SideSide => &self.side_side,
        }
    }

    /// The sums over all contacts.
    pub fn total(&self) -> KindSums {
        let mut total = self.side_vertex;
        total += self.side_side;
        total
    }

    /// Mean stress in Pa, compression positive, azema (4).
    ///
    /// $$ \sigma_{ij} = \frac1V \sum_c f_i\, \ell_j $$
    ///
    /// with the force f on the second body in N, the branch vector from the first to the second centre in m, and the
    /// volume V in m^2 (per metre of depth). The mean over all steps; p, q and the principal direction are those of
    /// the mean.
    ///
    /// # Errata and departures
    /// (10) prints the indices in the opposite order: azema E15.
    pub fn stress(&self) -> Tensor {
        self.total().stress * ratio(1.0, self.steps)
    }

    /// Mean stress in Pa that contacts of a kind carry, azema (9)-(10).
    pub fn stress_of(&self, kind: ContactKind) -> Tensor {
        self.of(kind).stress * ratio(1.0, self.steps)
    }

    /// $\mu^* = q/p$ of the mean stress, azema (5).
    pub fn stress_ratio(&self) -> f64 {
        let stress = self.stress();
        ratio(stress.deviator(), stress.mean())
    }

    /// The part of q/p that contacts of a kind carry.
    ///
    /// The projection of the deviator of the partial stress on the principal direction of the whole, over the whole
    /// p. The two parts add up to [`Self::stress_ratio`].
    ///
    /// # Errata and departures
    /// The printed parts of pentagons do not add up: azema E17.
    pub fn stress_ratio_of(&self, kind: ContactKind) -> f64 {
        let stress = self.stress();
        let part = self.stress_of(kind).deviator_along(stress.axis());
        ratio(part, stress.mean())
    }

    /// The share of contacts of a kind, $k_{sv}$ or $k_{ss}$.
    pub fn share(&self, kind: ContactKind) -> f64 {
        ratio(self.of(kind).contacts.sum, self.total().contacts.sum)
    }

    /// The share of sliding contacts, $k_{slide}$.
    pub fn sliding_share(&self) -> f64 {
        let total = self.total();
        ratio(total.sliding, total.contacts.sum)
    }

    /// The share of double contacts of which one point slides and the other does not.
    pub fn unequal_share(&self) -> f64 {
        ratio(self.side_side.unequal, self.side_side.contacts.sum)
    }

    /// Mean normal force over $p\,d$, for a mean diameter d in m.
    pub fn relative_normal_force(&self, diameter: f64) -> f64 {
        let total = self.total();
        let mean = ratio(total.normal_force.sum, total.contacts.sum);
        ratio(mean, self.stress().mean() * diameter)
    }

    /// Mean magnitude of the tangential force over $p\,d$, for a mean diameter d in m.
    pub fn relative_friction(&self, diameter: f64) -> f64 {
        let total = self.total();
        let mean = ratio(total.friction, total.contacts.sum);
        ratio(mean, self.stress().mean() * diameter)
    }

    /// The anisotropies of all contacts.
    pub fn anisotropies(&self) -> Anisotropies {
        let total = self.total();
        Anisotropies::by_moments(&total, &total, self.stress().axis())
    }

    /// The partial anisotropies of contacts of a kind.
    ///
    /// Sums over the kind, divided by sums over all contacts, so that the two parts add up to
    /// [`Self::anisotropies`].
    pub fn anisotropies_of(&self, kind: ContactKind) -> Anisotropies {
        Anisotropies::by_moments(self.of(kind), &self.total(), self.stress().axis())
    }
}
