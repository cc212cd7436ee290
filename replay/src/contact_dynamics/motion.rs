//! A few bodies on a floor.

use super::geometry::regular;
use crate::error::Fault;
use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::assembly::{Assembly, Body};
use gouge_contact_dynamics::detection::{DetectionSettings, HalfPlane};
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::shape::Shapes;
use gouge_contact_dynamics::step::{Scheme, State, StepSettings, Workspace, step};
use gouge_contact_dynamics::sweep::{StopCriterion, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Load, Velocity};

/// A regular body to be added.
#[derive(Clone, Copy)]
pub struct Solid {
    /// Number of sides, 0 for a disc.
    pub sides: usize,
    /// Circumradius.
    pub radius: f64,
    /// Mass per area.
    pub density: f64,
    pub at: (f64, f64),
    pub angle: f64,
    /// Velocity in x and y, and angular velocity.
    pub velocity: [f64; 3],
}

/// Bodies with the settings of their steps.
pub struct Motion {
    assembly: Assembly,
    pub settings: StepSettings,
    state: State,
    workspace: Option<Workspace>,
}

/// A law with restitution.
pub fn law(friction: f64, normal: f64, tangential: f64, gap: GapRule) -> ContactLaw {
    ContactLaw {
        friction,
        restitution: Components {
            n: normal,
            t: tangential,
        },
        gap,
    }
}

impl Motion {
    /// No bodies yet. Lengths of detection follow `diameter`, and the residual of the sweeps follows `speed`.
    pub fn new(time_step: f64, law: ContactLaw, diameter: f64, speed: f64) -> Result<Self, Fault> {
        let domain = Domain {
            width: None,
            height: None,
            periodic: false,
        };
        let settings = StepSettings {
            time_step,
            scheme: Scheme::Midpoint,
            detection: DetectionSettings::for_diameter(diameter),
            law,
            sweeps: SweepSettings {
                stop: StopCriterion::NaturalMap {
                    velocity: 1e-15 * speed,
                },
                max_sweeps: 3000,
                ..SweepSettings::default()
            },
            warm_start_distance: 0.3 * diameter,
        };
        settings.validate()?;
        Ok(Self {
            assembly: Assembly::new(domain, Shapes::new()),
            settings,
            state: State::default(),
            workspace: None,
        })
    }

    /// The same, for a single instant: bodies touch where they are, and do not move.
    pub fn impact(law: ContactLaw, diameter: f64, speed: f64) -> Result<Self, Fault> {
        let mut motion = Self::new(1e-9 * diameter / speed, law, diameter, speed)?;
        motion.settings.scheme = Scheme::Beginning;
        motion.settings.detection.alert_distance = 1e-12 * diameter;
        Ok(motion)
    }

    pub fn add(&mut self, solid: Solid) -> Result<(), Fault> {
        let shape = regular(&mut self.assembly.shapes, solid.sides)?;
        let body = Body {
            shape,
            scale: solid.radius,
            position: Vec2::new(solid.at.0, solid.at.1),
            angle: solid.angle,
        };
        let [x, y, angular] = solid.velocity;
        let velocity = Velocity {
            linear: Vec2::new(x, y),
            angular,
        };
        let configuration = &mut self.state.configuration;
        self.assembly
            .add_free(configuration, body, solid.density, velocity)?;
        Ok(())
    }

    /// Add an immobile floor through the origin, inclined so that it falls to the left.
    pub fn add_floor(&mut self, angle: f64) -> Result<(), Fault> {
        let configuration = &mut self.state.configuration;
        let imposed = InverseMass::IMPOSED;
        let unit = self
            .assembly
            .add_unit(configuration, imposed, Velocity::default())?;
        let wall = HalfPlane {
            position: Vec2::zero(),
            normal: Vec2::new(-angle.sin(), angle.cos()),
        };
        self.assembly.add_wall(configuration, wall, unit)?;
        Ok(())
    }

    /// Load all free bodies with an acceleration.
    pub fn accelerate(&mut self, x: f64, y: f64) {
        let masses = &self.assembly.inverse_mass;
        let units = masses.iter().zip(&mut self.assembly.load);
        for (mass, load) in units.filter(|(mass, _)| mass.x > 0.0) {
            *load = Load {
                force: Vec2::new(x, y) * (1.0 / mass.x),
                torque: 0.0,
            };
        }
    }

    pub fn steps(&mut self, count: usize) {
        let make = || Workspace::new(&self.assembly, &self.state, &self.settings);
        let workspace = self.workspace.get_or_insert_with(make);
        for _ in 0..count {
            step(&self.assembly, &self.settings, &mut self.state, workspace);
        }
    }

    pub fn velocity(&self, unit: usize) -> [f64; 3] {
        let v = self.state.configuration.velocity[unit];
        [v.linear.x, v.linear.y, v.angular]
    }

    pub fn position(&self, body: usize) -> [f64; 2] {
        let r = self.state.configuration.position[body];
        [r.x, r.y]
    }

    pub fn angle(&self, body: usize) -> f64 {
        self.state.configuration.angle[body]
    }

    pub fn mass(&self, unit: usize) -> f64 {
        1.0 / self.assembly.inverse_mass[unit].x
    }

    pub fn energy(&self) -> f64 {
        self.assembly.kinetic_energy(&self.state.configuration)
    }

    /// Impulses of the latest step, normal and tangential.
    pub fn impulses(&self) -> Vec<[f64; 2]> {
        let rows = self.workspace.iter().flat_map(|w| w.solver().rows());
        rows.map(|row| [row.impulse().n, row.impulse().t]).collect()
    }

    /// The impulse of the only point of the latest step.
    pub fn impulse(&self) -> [f64; 2] {
        self.impulses().first().copied().unwrap_or_default()
    }

    /// Gaps of the points of the latest step.
    pub fn gaps(&self) -> Vec<f64> {
        let points = self.workspace.iter().flat_map(Workspace::points);
        points.map(|point| point.gap).collect()
    }
}
