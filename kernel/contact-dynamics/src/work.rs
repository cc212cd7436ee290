//! The work of everything that acts during a step.

use crate::assembly::Assembly;
use crate::local::Components;
use crate::step::{State, StepSettings, Workspace};
use crate::sweep::Row;
use crate::units::{InverseMass, Velocity};
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Work in J, which adds up exactly to the change of the kinetic energy of all motion that is not imposed.
///
/// An impulse that changes a velocity from $v^-$ to $v^+$ does the work $P \cdot (v^- + v^+)/2$.
///
/// $$ \Delta E_{kin} = W_n + W_t + W_g + W_F + W_v $$
///
/// | letter | field | work of |
/// |---|---|---|
/// | $W_n$ | `collision` | normal impulses at contacts, without $W_g$ |
/// | $W_t$ | `friction` | tangential impulses at contacts, not positive without restitution |
/// | $W_g$ | `correction` | what separates overlapping bodies, not negative |
/// | $W_F$ | `load` | forces and torques that do not come from contacts |
/// | $W_v$ | `drive` | what keeps imposed velocities, against the contacts |
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// Work of normal impulses in J, without that of the correction.
    pub collision: f64,
    /// Work of tangential impulses in J.
    pub friction: f64,
    /// Work in J of the correction of overlaps.
    pub correction: f64,
    /// Work of loads in J.
    pub load: f64,
    /// Work in J of imposed velocities.
    pub drive: f64,
}

impl Work {
    /// The work of the latest step, before anything changed its velocities.
    pub fn of_step(
        assembly: &Assembly,
        settings: &StepSettings,
        state: &State,
        workspace: &Workspace,
    ) -> Self {
        let mean = |unit: usize| {
            let (before, after) = (
                workspace.velocities_before()[unit],
                state.configuration.velocity[unit],
            );
            Velocity {
                linear: (before.linear + after.linear) * 0.5,
                angular: 0.5 * (before.angular + after.angular),
            }
        };
        let mut work = Self::default();
        for (point, row) in workspace.points().iter().zip(workspace.solver().rows()) {
            let [first, second] = row.kinematics().units;
            let means = [first, second].map(|unit| mean(unit as usize));
            let relative = row.kinematics().velocity_of(means);
            let gap = settings.law.gap.velocity(point.gap, settings.time_step);
            let correction = -0.5 * row.impulse().n * gap.correcting;
            work.correction += correction;
            work.collision += row.impulse().n * relative.n - correction;
            work.friction += row.impulse().t * relative.t;
            work.drive += drive(row, means, assembly);
        }
        for (unit, (inverse, load)) in assembly.inverse_mass.iter().zip(&assembly.load).enumerate()
        {
            let (v, free) = (mean(unit), is_free(*inverse));
            let power = [
                load.force.x * v.linear.x,
                load.force.y * v.linear.y,
                load.torque * v.angular,
            ];
            work.load += settings.time_step * masked(power, free);
        }
        work
    }

    /// The work in the order of the fields.
    pub fn values(&self) -> [f64; 5] {
        [
            self.collision,
            self.friction,
            self.correction,
            self.load,
            self.drive,
        ]
    }

    /// The work from its values in the order of the fields.
    pub fn from_values([collision, friction, correction, load, drive]: [f64; 5]) -> Self {
        Self {
            collision,
            friction,
            correction,
            load,
            drive,
        }
    }

    /// The sum of two works, term by term.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let (a, b) = (self.values(), other.values());
        Self::from_values(core::array::from_fn(|k| a[k] + b[k]))
    }

    /// The change of kinetic energy in J that follows.
    pub fn total(&self) -> f64 {
        self.values().iter().sum()
    }
}

/// Which directions of motion are not imposed: x, y, rotation.
fn is_free(inverse: InverseMass) -> [bool; 3] {
    [inverse.x, inverse.y, inverse.rotation].map(|one| one > 0.0)
}

fn masked(power: [f64; 3], mask: [bool; 3]) -> f64 {
    let terms = power.into_iter().zip(mask);
    terms
        .map(|(one, counts)| if counts { one } else { 0.0 })
        .sum()
}

/// Work of what keeps the imposed velocities of the two units of a point against its impulse.
fn drive(row: &Row, means: [Velocity; 2], assembly: &Assembly) -> f64 {
    let point = row.kinematics();
    let Components { n, t } = row.impulse();
    let impulse: Vec2 = point.normal * n + point.normal.perpendicular() * t;
    let mut work = 0.0;
    for (side, sign) in [(0, -1.0), (1, 1.0)] {
        let inverse = assembly.inverse_mass[point.units[side] as usize];
        let imposed = is_free(inverse).map(|free| !free);
        let (v, arm) = (means[side], point.arms[side]);
        let moment = arm.n * t - arm.t * n;
        let power = [
            impulse.x * v.linear.x,
            impulse.y * v.linear.y,
            moment * v.angular,
        ];
        work -= sign * masked(power, imposed);
    }
    work
}
