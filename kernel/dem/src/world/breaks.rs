//! What is kept of the bonds that broke.

use super::choice::NormalChoice;
use super::dispatch::{WithBondPass, with_bond_pass};
use super::simulation::{Number, World};
use crate::forces::{Bodies, BondPass};
use crate::geometry::overlap_factor;
use crate::laws::{BeamLaw, YieldLaw};
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::pair::Pair;
use gouge_common::scalar::Real;

/// A bond that broke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Break {
    /// Number of steps to the state in which the bond broke.
    pub steps: u64,
    /// The two particles.
    pub pair: Pair,
    /// Focal point of the bond in m.
    pub focal_point: Vec2,
    /// Normal force at that moment in N; a negative force is repulsive.
    pub normal_force: f64,
    /// Tangential force on i at that moment in N, along the normal rotated by +90 degrees.
    pub tangential_force: f64,
    /// The normal term of the yield criterion over the sum of both terms, dimensionless.
    pub normal_share: f64,
}

impl<S: Number, N: NormalChoice<S>> World<S, N> {
    /// The bonds that broke since the breaks were last forgotten, in the order of their breaking.
    pub fn breaks(&self) -> &[Break] {
        &self.workspace.breaks
    }

    /// Forget the breaks; their memory is kept.
    pub fn forget_breaks(&mut self) {
        self.workspace.breaks.clear();
    }

    /// Keep what the bonds that break in this evaluation carried. There is room for all bonds, so nothing is allocated.
    #[cold]
    pub(super) fn keep_breaks(&mut self, steps: u64) {
        let model = self.model;
        if let Some(laws) = model.bond {
            with_bond_pass(&model, laws, KeepBreaks { world: self, steps });
        }
    }
}

struct KeepBreaks<'a, S: Number, N> {
    world: &'a mut World<S, N>,
    steps: u64,
}

impl<S: Number, N: NormalChoice<S>> WithBondPass for KeepBreaks<'_, S, N> {
    type Output = ();
    fn call<M: Metric, B: BeamLaw, Y: YieldLaw>(self, pass: BondPass<M, B, Y>) {
        let World {
            state, workspace, ..
        } = self.world;
        let (Some(bonds), particles) = (&state.bonds, &state.particles) else {
            return;
        };
        let bodies = Bodies {
            particles,
            inverse_mass: &workspace.inverse_mass,
        };
        for &position in &bonds.broken {
            let bond = bonds.get(position as usize);
            let broken = pass.state_of(bodies, bond.pair, bond.rest);
            let (i, j) = bond.pair.indices();
            let factor = overlap_factor([i, j].map(|k| particles.radius[k]), broken.frame.distance);
            let lever = broken.frame.normal * (broken.frame.distance * factor);
            let place = particles.position[i] + lever;
            let (normal, tangential) = (broken.normal_force, broken.tangential_force);
            workspace.breaks.push(Break {
                steps: self.steps,
                pair: bond.pair,
                focal_point: Vec2::new(place.x.to_f64(), place.y.to_f64()),
                normal_force: normal.to_f64(),
                tangential_force: tangential.to_f64(),
                normal_share: normal_share(pass.yielding.terms(normal, tangential)),
            });
        }
    }
}

fn normal_share<S: Real>(terms: [S; 2]) -> f64 {
    let [normal, tangential] = terms.map(Real::to_f64);
    normal / (normal + tangential)
}
