//! Kinematics and forces of all contacts and bonds of a state, for inspection.

use super::bond_pass::BondPass;
use super::contact_pass::ContactPass;
use super::ends::{Bodies, Columns};
use crate::bonds::{Bond, Bonds};
use crate::contacts::Contacts;
use crate::geometry::{Arm, PairFrame, overlap_factor};
use crate::laws::{BeamLaw, NormalLaw, TangentialLaw, YieldLaw};
use crate::particles::Particles;
use gouge_common::estimators::NetworkContact;
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;
use gouge_common::scalar::Real;

/// Kind of an interaction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InteractionKind {
    /// A contact: the weak link of the thesis.
    Contact,
    /// A bond: the strong link of the thesis.
    Bond,
}

/// Present kinematics and forces of a contact or bond, with the signs of the thesis.
#[doc(alias = "link")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interaction {
    /// The two particles i and j.
    pub pair: Pair,
    /// Whether it is a contact or a bond.
    pub kind: InteractionKind,
    /// Overlap factor of i, dimensionless.
    pub overlap_factor: f64,
    /// Focal point in m.
    pub focal_point: Vec2,
    /// Unit normal from i to j.
    pub normal: Vec2,
    /// Distance of the centres in m.
    pub distance: f64,
    /// Normal displacement in m, positive in overlap.
    pub normal_displacement: f64,
    /// Adjusted normal displacement of a bond in m, positive in compression; zero for a contact.
    pub adjusted_normal_displacement: f64,
    /// Tangential displacements of both ends in m.
    pub tangential_displacement: [f64; 2],
    /// Rate of the normal displacement in m/s, positive while the particles approach each other.
    pub normal_velocity: f64,
    /// Tangential velocities of both ends in m/s.
    pub tangential_velocity: [f64; 2],
    /// Normal force in N; a negative force is repulsive.
    pub normal_force: f64,
    /// Tangential force on i in N, along the normal rotated by +90 degrees.
    pub tangential_force: f64,
    /// Torques on both ends in N m, positive counter-clockwise.
    pub torque: [f64; 2],
}

impl Interaction {
    /// Force of j on i in N.
    pub fn force(&self) -> Vec2 {
        self.normal * self.normal_force + self.normal.perpendicular() * self.tangential_force
    }
}

impl From<&Interaction> for NetworkContact {
    fn from(one: &Interaction) -> Self {
        Self {
            pair: one.pair,
            branch: one.normal * one.distance,
            force: one.force(),
        }
    }
}

fn doubles<S: Lanes>(pair: [S; 2]) -> [f64; 2] {
    pair.map(Real::to_f64)
}

/// The part that contacts and bonds have in common.
fn common<S: Lanes>(
    kind: InteractionKind,
    pair: Pair,
    particles: &Particles<S>,
    frame: &PairFrame<S>,
) -> Interaction {
    let (i, j) = pair.indices();
    let radii = [particles.radius[i], particles.radius[j]];
    let factor = overlap_factor(radii, frame.distance);
    let focal_point = particles.position[i] + frame.normal * (frame.distance * factor);
    let double = |v: Vec2<S>| Vec2::new(v.x.to_f64(), v.y.to_f64());
    Interaction {
        pair,
        kind,
        overlap_factor: factor.to_f64(),
        focal_point: double(focal_point),
        normal: double(frame.normal),
        distance: frame.distance.to_f64(),
        normal_displacement: frame.normal_displacement(radii).to_f64(),
        adjusted_normal_displacement: 0.0,
        tangential_displacement: [0.0; 2],
        normal_velocity: 0.0,
        tangential_velocity: [0.0; 2],
        normal_force: 0.0,
        tangential_force: 0.0,
        torque: [0.0; 2],
    }
}

/// All contacts of a state.
pub(crate) fn contact_states<S: Lanes, M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw>(
    pass: ContactPass<M, A, N, T>,
    bodies: Bodies<S>,
    contacts: &Contacts<S>,
) -> Vec<Interaction> {
    let (particles, columns) = (bodies.particles, Columns::of(bodies));
    let state = |(position, &pair): (usize, &Pair)| {
        let ends = columns.ends(pair);
        if !pass.overlaps(&ends) {
            return None;
        }
        let mut memory = pass.memory_at(contacts, position, &ends);
        let state = pass.general_state(&ends, &mut memory);
        Some(Interaction {
            tangential_displacement: doubles(state.zeta),
            normal_velocity: state.motion.normal_velocity.to_f64(),
            tangential_velocity: doubles(state.d_zeta),
            normal_force: state.normal_force.to_f64(),
            tangential_force: state.tangential_force.to_f64(),
            torque: doubles(state.torques),
            ..common(InteractionKind::Contact, pair, particles, &state.frame)
        })
    };
    contacts
        .pairs
        .iter()
        .enumerate()
        .filter_map(state)
        .collect()
}

/// All bonds of a state.
pub(crate) fn bond_states<S: Lanes, M: Metric, B: BeamLaw, Y: YieldLaw>(
    pass: BondPass<M, B, Y>,
    bodies: Bodies<S>,
    bonds: &Bonds<S>,
) -> Vec<Interaction> {
    let state = |bond: Bond<S>| {
        let state = pass.state_of(bodies, bond.pair, bond.rest);
        Interaction {
            adjusted_normal_displacement: state.xi_adjusted.to_f64(),
            tangential_displacement: doubles(state.zeta),
            normal_velocity: state.motion.normal_velocity.to_f64(),
            tangential_velocity: doubles(state.d_zeta),
            normal_force: state.normal_force.to_f64(),
            tangential_force: state.tangential_force.to_f64(),
            torque: doubles(state.torques),
            ..common(
                InteractionKind::Bond,
                bond.pair,
                bodies.particles,
                &state.frame,
            )
        }
    };
    bonds.iter().map(state).collect()
}
