//! Steps of many bodies that Siconos solved, as the solver takes them.

use crate::references::{OneStep, Point, Unit};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::delassus::PointKinematics;
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::sweep::{
    ContactInput, Solver, StopCriterion, SweepOrder, SweepReport, SweepSettings,
};
use gouge_contact_dynamics::units::{InverseMass, Load, Velocity};

/// A step in the terms of the solver.
pub struct Problem<'a> {
    /// The stored step.
    pub stored: &'a OneStep,
    law: ContactLaw,
    masses: Vec<InverseMass>,
    before: Vec<Velocity>,
    free: Vec<Velocity>,
}

/// What the solver found.
pub struct Found {
    /// Velocities of the units.
    pub velocities: Vec<Velocity>,
    /// Impulses of the points.
    pub impulses: Vec<Components>,
    /// Residual of the laws in units of the scale.
    pub residual: f64,
    /// The sweeps.
    pub report: SweepReport,
}

fn velocity([x, y, angular]: [f64; 3]) -> Velocity {
    Velocity {
        linear: Vec2::new(x, y),
        angular,
    }
}

impl<'a> Problem<'a> {
    /// The problem of a stored step.
    pub fn new(stored: &'a OneStep) -> Self {
        let mass = |unit: &Unit| {
            let [x, y, rotation] = unit.inverse;
            InverseMass { x, y, rotation }
        };
        let free = |unit: &Unit| {
            let [x, y, torque] = unit.load;
            let load = Load {
                force: Vec2::new(x, y),
                torque,
            };
            mass(unit).accelerated(velocity(unit.before), load, stored.time_step)
        };
        let [n, t] = stored.restitution;
        Self {
            stored,
            law: ContactLaw {
                friction: stored.friction,
                restitution: Components { n, t },
                gap: GapRule::Predicted,
            },
            masses: stored.units.iter().map(mass).collect(),
            before: stored.units.iter().map(|u| velocity(u.before)).collect(),
            free: stored.units.iter().map(free).collect(),
        }
    }

    fn input(point: &Point, is_warm: bool) -> ContactInput {
        let components = |[n, t]: [f64; 2]| Components { n, t };
        let (sin, cos) = point.normal.sin_cos();
        ContactInput {
            kinematics: PointKinematics {
                units: point.units,
                normal: Vec2::new(cos, sin),
                arms: point.arms.map(components),
            },
            gap: point.gap,
            impulse: match is_warm {
                true => components(point.impulse),
                false => Components::default(),
            },
        }
    }

    /// Sweeps from the impulses of Siconos or from nothing, until the residual is below a bound in units of the scale.
    pub fn solve(&self, is_warm: bool, bound: f64, most: usize, order: SweepOrder) -> Found {
        let settings = SweepSettings {
            stop: StopCriterion::NaturalMap {
                velocity: bound * self.stored.scale,
            },
            max_sweeps: most,
            order,
            ..SweepSettings::default()
        };
        let points = self.stored.points.iter();
        let points: Vec<_> = points.map(|point| Self::input(point, is_warm)).collect();
        let (mut solver, mut velocities) = (Solver::new(), self.free.clone());
        let step = self.stored.time_step;
        solver.prepare(&points, &self.law, step, &self.before, &self.masses);
        let report = solver.solve(&settings, &self.masses, &mut velocities);
        Found {
            residual: solver.residual(&velocities) / self.stored.scale,
            impulses: solver.rows().iter().map(|row| row.impulse()).collect(),
            velocities,
            report,
        }
    }

    /// Largest difference of a velocity from that of Siconos in units of the scale.
    pub fn velocity_error(&self, found: &Found) -> f64 {
        let pairs = found.velocities.iter().zip(&self.stored.units);
        let parts = pairs.flat_map(|(v, unit)| {
            let [x, y, angular] = unit.after;
            [v.linear.x - x, v.linear.y - y, v.angular - angular]
        });
        crate::checks::largest(parts.map(f64::abs)) / self.stored.scale
    }

    /// Largest difference of a unique impulse from that of Siconos in units of the largest impulse.
    pub fn impulse_error(&self, found: &Found) -> f64 {
        let points = &self.stored.points;
        let sizes = points.iter().flat_map(|point| point.impulse.map(f64::abs));
        let largest = sizes.fold(0.0, f64::max);
        let pairs = found.impulses.iter().zip(points);
        let unique = pairs.filter(|(_, point)| point.is_unique);
        let parts = unique.flat_map(|(p, point)| [p.n - point.impulse[0], p.t - point.impulse[1]]);
        crate::checks::largest(parts.map(f64::abs)) / largest
    }
}
