//! A contact point as the sweep sees it.

use crate::delassus::{Delassus, PointKinematics};
use crate::law::ContactLaw;
use crate::local::{Components, LocalProblem, LocalRule, LocalStatus};
use crate::units::{InverseMass, Velocity};

/// A contact point to be solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactInput {
    /// Where the point lies on its units.
    pub kinematics: PointKinematics,
    /// Gap in m.
    pub gap: f64,
    /// First guess of the impulse in kg m/s.
    pub impulse: Components,
}

/// A contact point with what stays constant during the sweeps. Two cache lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    pub(super) kinematics: PointKinematics,
    pub(super) w: Delassus,
    /// What is added to the velocity after the step before the laws apply to it: restitution and gap.
    pub(super) shift: Components,
    pub(super) friction: f64,
    pub(super) impulse: Components,
    pub(super) status: LocalStatus,
}

impl Row {
    /// A point whose laws refer to the velocities before the step.
    pub(super) fn new(
        input: &ContactInput,
        law: &ContactLaw,
        time_step: f64,
        before: &[Velocity],
        inverse_masses: &[InverseMass],
    ) -> Self {
        let mut shift = Components::default();
        if law.gap.is_closed(input.gap) {
            let velocity = input.kinematics.relative_velocity(before);
            shift.n = law.restitution.n * velocity.n;
            shift.t = law.restitution.t * velocity.t;
        }
        let gap = law.gap.velocity(input.gap, time_step);
        shift.n += gap.closing + gap.correcting;
        Self {
            kinematics: input.kinematics,
            w: input.kinematics.delassus(inverse_masses),
            shift,
            friction: law.friction,
            impulse: input.impulse,
            status: LocalStatus::default(),
        }
    }

    /// Impulse on the second unit in kg m/s.
    pub fn impulse(&self) -> Components {
        self.impulse
    }

    /// Status of the point in the last sweep.
    pub fn status(&self) -> LocalStatus {
        self.status
    }

    /// Where the point lies on its units.
    pub fn kinematics(&self) -> &PointKinematics {
        &self.kinematics
    }

    /// The velocity to which the laws apply in m/s, u+ + e u- and the terms of the gap.
    #[inline]
    pub fn law_velocity(&self, velocities: &[Velocity]) -> Components {
        let after = self.kinematics.relative_velocity(velocities);
        Components {
            n: after.n + self.shift.n,
            t: after.t + self.shift.t,
        }
    }

    /// Solve the point with all other impulses frozen, and change the velocities. Returns the change of the impulse.
    #[inline]
    pub(super) fn update<R: LocalRule>(
        &mut self,
        rule: R,
        inverse_masses: &[InverseMass],
        velocities: &mut [Velocity],
    ) -> Components {
        let u = self.law_velocity(velocities);
        let (w, old) = (self.w, self.impulse);
        let problem = LocalProblem {
            w_nn: w.nn,
            w_tt: w.tt,
            w_nt: w.nt,
            a_n: w.nn * old.n + w.nt * old.t - u.n,
            a_t: w.nt * old.n + w.tt * old.t - u.t,
            friction: self.friction,
        };
        let solution = rule.solve(&problem);
        self.status = solution.status;
        self.impulse = solution.impulse;
        let change = Components {
            n: self.impulse.n - old.n,
            t: self.impulse.t - old.t,
        };
        if change != Components::default() {
            self.kinematics.apply(change, inverse_masses, velocities);
        }
        change
    }
}
