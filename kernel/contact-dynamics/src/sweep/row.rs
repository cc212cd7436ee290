//! A contact point as the sweep sees it.

use super::unit::Units;
use crate::delassus::{Delassus, PointKinematics};
use crate::law::ContactLaw;
use crate::local::{Components, LocalInverses, LocalRule, LocalStatus};
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

/// A contact point with what stays constant during the sweeps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    pub(super) kinematics: PointKinematics,
    pub(super) w: Delassus,
    pub(super) inverses: LocalInverses,
    /// What is added to the velocity after the step before the laws apply to it: restitution and gap.
    pub(super) shift: Components,
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
        let w = input.kinematics.delassus(inverse_masses);
        Self {
            kinematics: input.kinematics,
            w,
            inverses: w.problem(Components::default(), law.friction).inverses(),
            shift,
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
        self.law_velocity_of(self.kinematics.units.map(|unit| velocities[unit as usize]))
    }

    /// The same from the velocities of the two units.
    #[inline]
    pub(super) fn law_velocity_of(&self, velocities: [Velocity; 2]) -> Components {
        let after = self.kinematics.velocity_of(velocities);
        Components {
            n: after.n + self.shift.n,
            t: after.t + self.shift.t,
        }
    }

    /// Solve the point with all other impulses frozen, and change the velocities. Returns the change of the impulse.
    #[inline(always)]
    pub(super) fn update<R: LocalRule>(
        &mut self,
        rule: R,
        friction: f64,
        units: &mut impl Units,
    ) -> Components {
        let [i, j] = self.kinematics.units;
        let (i, j) = (i as usize, j as usize);
        let (first, second) = (units.get(i), units.get(j));
        let u = self
            .kinematics
            .velocity_of([first.velocity, second.velocity]);
        let (w, old) = (self.w, self.impulse);
        let a = Components {
            n: (w.nn * old.n + w.nt * old.t - self.shift.n) - u.n,
            t: (w.nt * old.n + w.tt * old.t - self.shift.t) - u.t,
        };
        let solution = rule.solve_prepared(&w.problem(a, friction), &self.inverses);
        self.status = solution.status;
        self.impulse = solution.impulse;
        let change = Components {
            n: self.impulse.n - old.n,
            t: self.impulse.t - old.t,
        };
        if solution.status != LocalStatus::Separated || old != Components::default() {
            let velocities = self.kinematics.pushed(
                change,
                [first.inverse, second.inverse],
                [first.velocity, second.velocity],
            );
            units.set(i, velocities[0]);
            units.set(j, velocities[1]);
        }
        change
    }
}
