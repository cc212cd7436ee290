//! Small systems of rigid bodies that several checks build.

use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::assembly::{Assembly, Body};
use gouge_contact_dynamics::detection::{DetectionSettings, HalfPlane, PointLine};
use gouge_contact_dynamics::error::SetupError;
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::shape::{ShapeId, Shapes};
use gouge_contact_dynamics::step::{Scheme, State, StepReport, StepSettings, Workspace, step};
use gouge_contact_dynamics::sweep::{StopCriterion, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Load, Velocity};
use std::collections::BTreeMap;

/// Standard gravity in m/s^2.
pub const GRAVITY: f64 = 9.81;

/// Bodies of density 1 kg/m^2 and walls, with the settings of their steps.
pub struct System {
    pub assembly: Assembly,
    pub settings: StepSettings,
    pub state: State,
    workspace: Option<Workspace>,
    shapes: BTreeMap<usize, ShapeId>,
}

/// The law with a friction, a normal restitution and a rule of gaps.
pub fn law(friction: f64, restitution: f64, gap: GapRule) -> ContactLaw {
    let restitution = Components {
        n: restitution,
        t: 0.0,
    };
    ContactLaw {
        friction,
        restitution,
        gap,
    }
}

/// A velocity in m/s with an angular velocity in rad/s.
pub fn moving(x: f64, y: f64, angular: f64) -> Velocity {
    Velocity {
        linear: Vec2::new(x, y),
        angular,
    }
}

/// Lengths of detection for bodies of a diameter in m, without a preference for the first shape of a pair.
pub fn detection(diameter: f64) -> DetectionSettings {
    DetectionSettings {
        alert_distance: 0.02 * diameter,
        merge_distance: 1e-4 * diameter,
        tie_distance: 1e-6 * diameter,
        line: PointLine::Common,
    }
}

/// Steps in s that converge to rounding, for bodies of a diameter of 1 m.
pub fn exact_steps(time_step: f64, law: ContactLaw) -> StepSettings {
    StepSettings {
        time_step,
        scheme: Scheme::Midpoint,
        detection: detection(1.0),
        law,
        sweeps: SweepSettings {
            stop: StopCriterion::NaturalMap { velocity: 1e-14 },
            max_sweeps: 100_000,
            ..SweepSettings::default()
        },
        warm_start_distance: 0.3,
    }
}

impl System {
    /// No bodies in an open box.
    pub fn new(settings: StepSettings) -> Self {
        let domain = Domain {
            width: None,
            height: None,
            periodic: false,
        };
        Self {
            assembly: Assembly::new(domain, Shapes::new()),
            settings,
            state: State::default(),
            workspace: None,
            shapes: BTreeMap::new(),
        }
    }

    /// A regular polygon, or a disc for 0 sides, with the radius of its circumscribed circle in m.
    pub fn body(
        &mut self,
        sides: usize,
        radius: f64,
        at: [f64; 2],
        angle: f64,
        velocity: Velocity,
    ) -> Result<usize, SetupError> {
        self.dense_body((sides, 1.0), radius, at, angle, velocity)
    }

    /// As [`Self::body`], with a density in kg/m^2 beside the number of sides.
    pub fn dense_body(
        &mut self,
        (sides, density): (usize, f64),
        scale: f64,
        at: [f64; 2],
        angle: f64,
        velocity: Velocity,
    ) -> Result<usize, SetupError> {
        let shape = self.shape(sides)?;
        let body = Body {
            shape,
            scale,
            position: Vec2::new(at[0], at[1]),
            angle,
        };
        let configuration = &mut self.state.configuration;
        let unit = self
            .assembly
            .add_free(configuration, body, density, velocity)?;
        Ok(unit as usize)
    }

    /// An immobile disc of a radius in m.
    pub fn fixed_disc(&mut self, scale: f64, at: [f64; 2]) -> Result<(), SetupError> {
        let shape = self.shape(0)?;
        let configuration = &mut self.state.configuration;
        let imposed = InverseMass::IMPOSED;
        let unit = self
            .assembly
            .add_unit(configuration, imposed, Velocity::default())?;
        let body = Body {
            shape,
            scale,
            position: Vec2::new(at[0], at[1]),
            angle: 0.0,
        };
        self.assembly
            .add_body(configuration, body, unit)
            .map(|_| ())
    }

    fn shape(&mut self, sides: usize) -> Result<ShapeId, SetupError> {
        if let Some(&shape) = self.shapes.get(&sides) {
            return Ok(shape);
        }
        let shape = match sides {
            0 => self.assembly.shapes.add_disc(),
            _ => self.assembly.shapes.add_regular(sides)?,
        };
        self.shapes.insert(sides, shape);
        Ok(shape)
    }

    /// An immobile floor through the origin.
    pub fn floor(&mut self) -> Result<(), SetupError> {
        let configuration = &mut self.state.configuration;
        let imposed = InverseMass::IMPOSED;
        let unit = self
            .assembly
            .add_unit(configuration, imposed, Velocity::default())?;
        let wall = HalfPlane {
            position: Vec2::zero(),
            normal: Vec2::new(0.0, 1.0),
        };
        self.assembly.add_wall(configuration, wall, unit)
    }

    /// Gravity in m/s^2 on all bodies so far.
    pub fn gravity(&mut self, acceleration: [f64; 2]) {
        let masses = self.assembly.inverse_mass.iter();
        for (mass, load) in masses.zip(&mut self.assembly.load) {
            if mass.x > 0.0 {
                *load = Load {
                    force: Vec2::new(acceleration[0], acceleration[1]) * (1.0 / mass.x),
                    torque: 0.0,
                };
            }
        }
    }

    /// Gravity on all bodies so far, as seen in the frame of a floor that falls to the right by an angle in rad.
    pub fn tilted(&mut self, angle: f64) {
        self.gravity([GRAVITY * angle.sin(), -GRAVITY * angle.cos()]);
    }

    /// One step.
    pub fn step(&mut self) -> StepReport {
        let make = || Workspace::new(&self.assembly, &self.state, &self.settings);
        let workspace = self.workspace.get_or_insert_with(make);
        step(&self.assembly, &self.settings, &mut self.state, workspace)
    }

    /// Several steps; the report of the last one.
    pub fn steps(&mut self, count: usize) -> StepReport {
        let mut report = StepReport::default();
        for _ in 0..count {
            report = self.step();
        }
        report
    }

    /// Velocity of a unit.
    pub fn velocity(&self, unit: usize) -> Velocity {
        self.state.configuration.velocity[unit]
    }

    /// Position of a body in m.
    pub fn position(&self, body: usize) -> [f64; 2] {
        let position = self.state.configuration.position[body];
        [position.x, position.y]
    }

    /// Kinetic energy in J.
    pub fn energy(&self) -> f64 {
        self.assembly.kinetic_energy(&self.state.configuration)
    }

    /// Contact points of the latest step, if there was one.
    pub fn workspace(&self) -> Option<&Workspace> {
        self.workspace.as_ref()
    }

    /// Impulses of the latest step over the time step in N, in the order of the contact points.
    pub fn forces(&self) -> Vec<Components> {
        let step = self.settings.time_step;
        let rows = self.workspace().map_or(&[][..], |w| w.solver().rows());
        let force = |p: Components| Components {
            n: p.n / step,
            t: p.t / step,
        };
        rows.iter().map(|row| force(row.impulse())).collect()
    }
}
