//! Forces on all nodes.

mod blocks;
mod bond_pass;
mod contact_pass;
mod lanes;
mod wall_pass;

use crate::bond_law::BreakOrder;
use crate::contacts::{Candidates, Contact};
use crate::grain::Grains;
use crate::state::{Place, State};
use blocks::Blocks;
use contact_pass::ContactPass;
use gouge_common::geometry::Vec2;
use gouge_common::instructions::Instructions;
use gouge_common::pair::Pair;
use wall_pass::WallPass;

pub use contact_pass::Touching;
pub use wall_pass::Walls;

/// What acts on nodes besides bonds, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Time step in s.
    pub time_step: f64,
    /// Acceleration of gravity in m/s^2.
    pub gravity: Vec2,
    /// Whether bonds act in the step in which they break.
    pub break_order: BreakOrder,
    /// Contact between nodes, if nodes touch.
    pub contact: Option<Contact>,
    /// Contact with walls, if there are any.
    pub walls: Option<Walls>,
}

/// Buffers of a pass over all forces, which can be thrown away.
#[derive(Clone, Debug)]
pub struct Workspace {
    blocks: Blocks,
    candidates: Option<Candidates>,
    /// Number of contacts of each node.
    partners: Vec<u16>,
    /// Elastic forces of walls on each node in N per metre of depth; empty without walls.
    wall_push: Vec<Vec2>,
    /// Forces in N per metre of depth of the grains on the left, right, top and bottom wall in the latest pass.
    pub reactions: [Vec2; 4],
    /// Whether a wall has lost a node in the latest pass.
    pub(crate) has_lost: bool,
    /// Force densities in N/m^3 of the latest pass.
    pub force: Vec<Vec2>,
    /// Bonds that broke in the latest pass, by later node and then by earlier one.
    pub broken: Vec<Pair>,
}

impl Workspace {
    /// Buffers for grains and their bonds.
    pub fn new(grains: &Grains, settings: &Settings, state: &State) -> Self {
        let contact = settings.contact.as_ref();
        let pass = settings.walls.as_ref().map(|walls| WallPass {
            grains,
            walls,
            time_step: settings.time_step,
        });
        let candidates = contact.map(|contact| {
            let mut candidates = Candidates::new(grains, contact.law.radius);
            candidates.update(grains, &state.bonds, positions(&state.places), &[]);
            candidates
        });
        Self {
            blocks: Blocks::new(grains, &state.bonds),
            candidates,
            partners: Vec::new(),
            wall_push: pass.map_or_else(Vec::new, |pass| pass.elastic(state)),
            reactions: [Vec2::zero(); 4],
            has_lost: false,
            force: vec![Vec2::zero(); grains.nodes()],
            broken: Vec::new(),
        }
    }

    /// Compute bonds with other instructions than the widest of the machine; the bits stay the same.
    pub fn use_instructions(&mut self, instructions: Instructions) {
        self.blocks.instructions = instructions;
    }

    /// The instructions that compute bonds.
    pub(crate) fn instructions(&self) -> Instructions {
        self.blocks.instructions
    }

    /// Force densities on all nodes. Some bonds may break, and losses are booked.
    pub fn evaluate(&mut self, grains: &Grains, settings: &Settings, state: &mut State) {
        self.force.fill(Vec2::zero());
        self.add_external(grains, settings);
        bond_pass::add_bond_forces(
            grains,
            settings,
            state,
            &mut self.blocks,
            &mut self.force,
            &mut self.broken,
        );
        if let (Some(contact), Some(candidates)) = (&settings.contact, &mut self.candidates) {
            candidates.update(grains, &state.bonds, positions(&state.places), &self.broken);
            let pass = ContactPass::new(grains, contact, settings, state);
            let losses = pass.add_forces(candidates, &mut self.partners, &mut self.force);
            state.work.damping += losses.damping * settings.time_step;
            state.work.friction += losses.friction * settings.time_step;
        }
        if let Some(walls) = &settings.walls {
            let pass = WallPass {
                grains,
                walls,
                time_step: settings.time_step,
            };
            (self.reactions, self.has_lost) =
                pass.add_forces(state, &mut self.wall_push, &mut self.force);
        }
    }

    /// Add gravity and loads, if there are any.
    fn add_external(&mut self, grains: &Grains, settings: &Settings) {
        if settings.gravity != Vec2::zero() {
            for row in &grains.rows {
                let weight = settings.gravity * row.density;
                for force in &mut self.force[row.nodes.clone()] {
                    *force += weight;
                }
            }
        }
        for (force, &load) in self.force.iter_mut().zip(&grains.load) {
            *force += load;
        }
    }

    /// Energy in J per metre of depth stored in contacts between nodes, at the latest pass.
    pub fn contact_energy(&self, grains: &Grains, settings: &Settings, state: &State) -> f64 {
        let (Some(contact), Some(candidates)) = (&settings.contact, &self.candidates) else {
            return 0.0;
        };
        ContactPass::new(grains, contact, settings, state).energy(candidates)
    }

    /// All contacts between nodes, at the latest pass.
    pub fn contacts(&self, grains: &Grains, settings: &Settings, state: &State) -> Vec<Touching> {
        let (Some(contact), Some(candidates)) = (&settings.contact, &self.candidates) else {
            return Vec::new();
        };
        ContactPass::new(grains, contact, settings, state).touching(candidates)
    }
}

/// Present positions of nodes in m.
pub fn positions(places: &[Place]) -> impl Iterator<Item = Vec2> + '_ {
    places.iter().map(|place| place.position())
}
