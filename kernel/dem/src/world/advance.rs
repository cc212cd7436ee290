//! How a world advances by one step.

use super::choice::NormalChoice;
use super::dispatch::{WithMethod, with_method};
use super::simulation::{Number, World};
use crate::error::StepError;
use crate::integrators::{Advance, Motion, Stage};
use core::marker::PhantomData;
use gouge_common::geometry::{Metric, WithMetric};
use gouge_common::neighbors::Staleness;

impl<S: Number, N: NormalChoice<S>> World<S, N> {
    /// Advance by one time step.
    ///
    /// # Errors
    /// If a state is no longer finite, or if a particle moves too far for contacts to be found, see
    /// [`check`](Self::check). The world is then left in the failed state, not in that before the step.
    pub fn step(&mut self) -> Result<(), StepError> {
        N::step(self)
    }

    /// Implementation of [`Number::step`].
    #[doc(hidden)]
    pub fn take_step(&mut self) -> Result<(), StepError> {
        self.evaluate_if_pending()?;
        let before = self.state.bookings;
        with_method(self.model.integrator, MoveParticles { world: self })?;
        let state = &mut self.state;
        state.steps += 1;
        state.is_evaluated = !self.model.integrator.evaluates_first();
        if let Some(ledger) = &mut state.ledger {
            let after = if state.is_evaluated {
                state.bookings
            } else {
                before
            };
            ledger.advance(&before, &after, self.model.time_step);
        }
        Ok(())
    }

    /// Store the mean velocity of the driven particles before it is predicted.
    pub(super) fn store_drive_velocity(&mut self) {
        let driven = &self.workspace.driven;
        if !driven.is_empty() {
            let mut sum = S::zero();
            for &i in driven {
                sum += self.state.particles.velocity[i as usize].x;
            }
            self.state.drive.velocity_at_step_start = sum * (1.0 / driven.len() as f64);
        }
    }

    /// Advance all particles by one stage of a method; rotations only if something can rotate.
    fn advance<T: Stage>(&mut self) {
        let domain = self.model.domain;
        domain.with_metric(AdvanceAll {
            world: self,
            stage: PhantomData::<fn() -> T>,
        });
        let (forces, previous) = (&mut self.state.forces, &mut self.state.previous);
        if T::MOVES {
            self.workspace.is_stale = Some(self.workspace.stale_parts.contains(&true));
        }
        if T::KEEPS_FORCES {
            core::mem::swap(&mut forces.force, &mut previous.linear);
            core::mem::swap(&mut forces.torque, &mut previous.angular);
        }
    }
}

/// Moves the particles of a world by one step of its method.
struct MoveParticles<'a, S: Number, N> {
    world: &'a mut World<S, N>,
}

impl<S: Number, N: NormalChoice<S>> WithMethod for MoveParticles<'_, S, N> {
    type Output = Result<(), StepError>;

    fn one_stage<T: Stage>(self) -> Self::Output {
        self.world.advance::<T>();
        Ok(())
    }

    fn two_stages<T: Stage, U: Stage>(self) -> Self::Output {
        self.world.store_drive_velocity();
        self.world.advance::<T>();
        let outcome = self.world.evaluate(true, T::KEEPS_FORCES);
        self.world.advance::<U>();
        outcome
    }

    fn two_stages_with_start<B: Stage, T: Stage, U: Stage>(self) -> Self::Output {
        if !self.world.state.previous.is_set {
            self.world.advance::<B>();
            self.world.state.previous.is_set = true;
        }
        self.two_stages::<T, U>()
    }
}

/// Advances all particles by one stage.
struct AdvanceAll<'a, S: Number, N, T> {
    world: &'a mut World<S, N>,
    stage: PhantomData<fn() -> T>,
}

impl<S: Number, N: NormalChoice<S>, T: Stage> WithMetric for AdvanceAll<'_, S, N, T> {
    type Output = ();

    fn call<M: Metric>(self, metric: M) {
        let World {
            model,
            state,
            workspace,
            execution,
        } = self.world;
        let (p, forces, previous) = (&mut state.particles, &state.forces, &mut state.previous);
        let linear = Motion {
            coordinate: &mut p.position,
            velocity: &mut p.velocity,
            force: &forces.force,
            inverse_inertia: &workspace.inverse_mass,
            previous: &mut previous.linear,
            older: &mut previous.older_linear,
        };
        let angular = workspace.has_rotation.then_some(Motion {
            coordinate: &mut p.angle,
            velocity: &mut p.angular_velocity,
            force: &forces.torque,
            inverse_inertia: &workspace.inverse_inertia,
            previous: &mut previous.angular,
            older: &mut previous.older_angular,
        });
        let work = Advance {
            stage: self.stage,
            step: model.time_step,
            linear,
            angular,
            staleness: Staleness::new(workspace.neighbors.as_ref(), metric),
        };
        execution.run(work, &mut workspace.stale_parts);
    }
}
