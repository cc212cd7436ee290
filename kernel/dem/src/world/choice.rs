//! The normal law of a world: a choice of the kernel's laws, or a law of a program's own.

use super::simulation::{Number, World};
use crate::balance::Energy;
use crate::error::StepError;
use crate::forces::Interaction;
use crate::laws::NormalLaw;
use crate::model::ContactNormal;

/// The normal law of the contacts of a world: [`ContactNormal`], the choice of a scene, or any [`NormalLaw`].
///
/// A law of your own is compiled into the same loops as those of the kernel.
pub trait NormalChoice<S: Number>: Chosen<S> {}

impl<S: Number, N: Chosen<S>> NormalChoice<S> for N {}

/// What worlds need of such a law. It can be implemented only here.
pub trait Chosen<S: Number>: Copy {
    /// Call an operation with the law.
    fn with_law<A: WithNormalLaw>(self, action: A) -> A::Output;
    /// As [`NormalLaw::linearised`].
    fn linearised(self, radii: [f64; 2], reduced_mass: f64) -> [f64; 2];
    /// As [`Number::step`].
    fn step(world: &mut World<S, Self>) -> Result<(), StepError>;
    /// As [`Number::evaluate`].
    fn evaluate(world: &mut World<S, Self>) -> Result<(), StepError>;
    /// As [`Number::interactions`].
    fn interactions(world: &World<S, Self>) -> Vec<Interaction>;
    /// As [`Number::state_energy`].
    fn state_energy(world: &World<S, Self>) -> Energy<S>;
}

/// An operation with the normal law of contacts.
pub trait WithNormalLaw {
    /// What it returns.
    type Output;
    /// The operation.
    fn call<L: NormalLaw>(self, law: L) -> Self::Output;
}

impl<S: Number> Chosen<S> for ContactNormal {
    fn with_law<A: WithNormalLaw>(self, action: A) -> A::Output {
        match self {
            Self::KelvinVoigt(law) => action.call(law),
            Self::Bshp(law) => action.call(law),
            Self::ReboundingKelvinVoigt(law) => action.call(law),
            Self::ReboundingBshp(law) => action.call(law),
        }
    }
    fn linearised(self, radii: [f64; 2], reduced_mass: f64) -> [f64; 2] {
        Self::linearised(self, radii, reduced_mass)
    }
    fn step(world: &mut World<S>) -> Result<(), StepError> {
        S::step(world)
    }
    fn evaluate(world: &mut World<S>) -> Result<(), StepError> {
        S::evaluate(world)
    }
    fn interactions(world: &World<S>) -> Vec<Interaction> {
        S::interactions(world)
    }
    fn state_energy(world: &World<S>) -> Energy<S> {
        S::state_energy(world)
    }
}

impl<S: Number, L: NormalLaw> Chosen<S> for L {
    fn with_law<A: WithNormalLaw>(self, action: A) -> A::Output {
        action.call(self)
    }
    fn linearised(self, radii: [f64; 2], reduced_mass: f64) -> [f64; 2] {
        NormalLaw::linearised(self, radii, reduced_mass)
    }
    fn step(world: &mut World<S, L>) -> Result<(), StepError> {
        world.take_step()
    }
    fn evaluate(world: &mut World<S, L>) -> Result<(), StepError> {
        world.evaluate_first()
    }
    fn interactions(world: &World<S, L>) -> Vec<Interaction> {
        world.find_interactions()
    }
    fn state_energy(world: &World<S, L>) -> Energy<S> {
        world.sum_state_energy()
    }
}
