//! Forces between nodes that touch.

use crate::contact_law::{
    ContactForce, ContactReading, ContactSpring, FrictionStep, Node, NodePair,
};
use crate::contacts::{Candidates, Contact};
use crate::forces::Settings;
use crate::grain::Grains;
use crate::state::State;
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;

/// Two nodes that touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touching {
    /// The nodes.
    pub pair: Pair,
    /// Vector from the first to the second node in m.
    pub separation: Vec2,
    /// Distance in m below which they repel each other.
    pub rest_distance: f64,
    /// Forces on the first node, with friction that is not shared among contacts.
    pub on_first: ContactForce,
}

/// What a pass over contacts reads.
pub(super) struct ContactPass<'a> {
    pub(super) grains: &'a Grains,
    pub(super) contact: &'a Contact,
    pub(super) state: &'a State,
    pub(super) time_step: f64,
}

/// Power in W per metre of depth that contacts take.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Losses {
    pub(super) damping: f64,
    pub(super) friction: f64,
}

impl<'a> ContactPass<'a> {
    pub(super) fn new(
        grains: &'a Grains,
        contact: &'a Contact,
        settings: &Settings,
        state: &'a State,
    ) -> Self {
        Self {
            grains,
            contact,
            state,
            time_step: settings.time_step,
        }
    }

    /// Add the forces of all contacts to force densities in N/m^3. `partners` is a buffer.
    pub(super) fn add_forces(
        &self,
        candidates: &Candidates,
        partners: &mut Vec<u16>,
        force: &mut [Vec2],
    ) -> Losses {
        if self.contact.shares_sticking && self.contact.law.friction > 0.0 {
            self.count_partners(candidates, partners);
        } else {
            partners.clear();
        }
        let mut losses = Losses::default();
        for &pair in &candidates.pairs {
            let (i, j) = pair.indices();
            let separation = self.state.places[i].to(self.state.places[j]);
            if self.is_too_far(separation) {
                continue;
            }
            let spring = self.spring(pair);
            let share = |node: usize| partners.get(node).copied().unwrap_or(1);
            let step = FrictionStep {
                time_step: self.time_step,
                stick_share: f64::from(share(i).max(share(j)).max(1)),
            };
            let (on_i, on_j) = self.both(pair, separation, &spring, &step);
            let velocity = [i, j].map(|node| self.state.velocity[node]);
            losses.damping -= on_i.damping.dot(velocity[0]) + on_j.damping.dot(velocity[1]);
            losses.friction -= on_i.friction.dot(velocity[0]) + on_j.friction.dot(velocity[1]);
            for (node, own) in [(i, on_i), (j, on_j)] {
                force[node] += own.total() * (1.0 / self.grains.area[node]);
            }
        }
        losses
    }

    fn is_too_far(&self, separation: Vec2) -> bool {
        let radius = self.contact.law.radius;
        separation.norm_squared() >= radius * radius
    }

    /// Forces on both nodes of a pair.
    fn both(
        &self,
        pair: Pair,
        separation: Vec2,
        spring: &ContactSpring,
        step: &FrictionStep,
    ) -> (ContactForce, ContactForce) {
        let (i, j) = pair.indices();
        let velocity = self.state.velocity[i] - self.state.velocity[j];
        let [x, y] = [i, j].map(|node| Node {
            area: self.grains.area[node],
            density: self.grains.of(node).density,
        });
        let on_i = NodePair {
            separation,
            velocity,
            x,
            y,
        };
        let law = &self.contact.law;
        let on_i_force = law.force(&on_i, spring, step);
        if law.reading == ContactReading::Symmetric {
            return (on_i_force, on_i_force.reversed());
        }
        let on_j = NodePair {
            separation: -separation,
            velocity: -velocity,
            x: y,
            y: x,
        };
        (on_i_force, law.force(&on_j, spring, step))
    }

    fn spring(&self, pair: Pair) -> ContactSpring {
        let (i, j) = pair.indices();
        let (first, second) = (self.grains.of(i), self.grains.of(j));
        let law = &self.contact.law;
        if self.grains.grain_of[i] != self.grains.grain_of[j] {
            return law.between_grains(self.contact.stiffness[first.material][second.material]);
        }
        let reference = self.grains.position[j] - self.grains.position[i];
        law.within_grain(first.contact_stiffness, reference.norm())
    }

    /// Number of contacts of each node.
    fn count_partners(&self, candidates: &Candidates, partners: &mut Vec<u16>) {
        partners.clear();
        partners.resize(self.grains.nodes(), 0);
        for &pair in &candidates.pairs {
            let (i, j) = pair.indices();
            let separation = self.state.places[i].to(self.state.places[j]);
            if self.is_too_far(separation) {
                continue;
            }
            if separation.norm() < self.spring(pair).rest_distance {
                partners[i] = partners[i].saturating_add(1);
                partners[j] = partners[j].saturating_add(1);
            }
        }
    }

    /// All contacts, by second node and then by first.
    pub(super) fn touching(&self, candidates: &Candidates) -> Vec<Touching> {
        let step = FrictionStep {
            time_step: self.time_step,
            stick_share: 1.0,
        };
        let of_pair = |&pair: &Pair| {
            let (i, j) = pair.indices();
            let separation = self.state.places[i].to(self.state.places[j]);
            let spring = self.spring(pair);
            (separation.norm() < spring.rest_distance).then(|| Touching {
                pair,
                separation,
                rest_distance: spring.rest_distance,
                on_first: self.both(pair, separation, &spring, &step).0,
            })
        };
        candidates.pairs.iter().filter_map(of_pair).collect()
    }

    /// Energy in J per metre of depth stored in contacts.
    pub(super) fn energy(&self, candidates: &Candidates) -> f64 {
        let of_pair = |&pair: &Pair| {
            let (i, j) = pair.indices();
            let distance = self.state.places[i].to(self.state.places[j]).norm();
            let area = &self.grains.area;
            self.spring(pair).energy(distance, area[i], area[j])
        };
        candidates
            .pairs
            .iter()
            .map(of_pair)
            .fold(0.0, |sum, energy| sum + energy)
    }
}
