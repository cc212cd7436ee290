//! Small systems of bodies for tests.

use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::assembly::{Assembly, Body};
use gouge_contact_dynamics::detection::{DetectionSettings, HalfPlane};
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::shape::Shapes;
use gouge_contact_dynamics::step::{Scheme, State, StepReport, StepSettings, Workspace, step};
use gouge_contact_dynamics::sweep::{Rule, StopCriterion, SweepOrder, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Load, Velocity};

pub const OPEN: Domain = Domain {
    width: None,
    height: None,
    periodic: false,
};

/// Bodies with the settings of their steps.
pub struct System {
    pub assembly: Assembly,
    pub settings: StepSettings,
    pub state: State,
    workspace: Option<Workspace>,
}

pub fn law(friction: f64, restitution: f64, gap: GapRule) -> ContactLaw {
    ContactLaw {
        friction,
        restitution: Components {
            n: restitution,
            t: 0.0,
        },
        gap,
    }
}

pub fn moving(x: f64, y: f64, angular: f64) -> Velocity {
    Velocity {
        linear: Vec2::new(x, y),
        angular,
    }
}

impl System {
    pub fn new(time_step: f64, law: ContactLaw) -> Self {
        let settings = StepSettings {
            time_step,
            scheme: Scheme::Midpoint,
            detection: DetectionSettings::for_diameter(1.0),
            law,
            sweeps: SweepSettings {
                stop: StopCriterion::NaturalMap { velocity: 1e-14 },
                max_sweeps: 100_000,
                order: SweepOrder::Alternating,
                rule: Rule::Exact,
                ..SweepSettings::default()
            },
            warm_start_distance: 0.3,
        };
        Self {
            assembly: Assembly::new(OPEN, Shapes::new()),
            settings,
            state: State::default(),
            workspace: None,
        }
    }

    /// A free body of density 1; a disc for 0 sides.
    pub fn body(
        &mut self,
        sides: usize,
        scale: f64,
        at: (f64, f64),
        angle: f64,
        velocity: Velocity,
    ) -> usize {
        let shape = match sides {
            0 => self.assembly.shapes.add_disc(),
            _ => self.assembly.shapes.add_regular(sides).unwrap(),
        };
        let body = Body {
            shape,
            scale,
            position: Vec2::new(at.0, at.1),
            angle,
        };
        let configuration = &mut self.state.configuration;
        self.assembly
            .add_free(configuration, body, 1.0, velocity)
            .unwrap() as usize
    }

    /// An immobile floor through the origin with a normal at `angle` from the y axis.
    pub fn floor(&mut self, angle: f64) {
        let configuration = &mut self.state.configuration;
        let unit = self
            .assembly
            .add_unit(configuration, InverseMass::IMPOSED, Velocity::default())
            .unwrap();
        let wall = HalfPlane {
            position: Vec2::zero(),
            normal: Vec2::new(-angle.sin(), angle.cos()),
        };
        self.assembly.add_wall(configuration, wall, unit).unwrap();
    }

    pub fn gravity(&mut self, x: f64, y: f64) {
        for (mass, load) in self
            .assembly
            .inverse_mass
            .iter()
            .zip(&mut self.assembly.load)
        {
            if mass.x > 0.0 {
                *load = Load {
                    force: Vec2::new(x, y) * (1.0 / mass.x),
                    torque: 0.0,
                };
            }
        }
    }

    pub fn step(&mut self) -> StepReport {
        let make = || Workspace::new(&self.assembly, &self.state, &self.settings);
        let workspace = self.workspace.get_or_insert_with(make);
        step(&self.assembly, &self.settings, &mut self.state, workspace)
    }

    pub fn steps(&mut self, count: usize) -> StepReport {
        let mut report = StepReport::default();
        for _ in 0..count {
            report = self.step();
        }
        report
    }

    /// Throw away everything that is not the state.
    pub fn forget_buffers(&mut self) {
        self.workspace = None;
    }

    pub fn velocity(&self, unit: usize) -> Velocity {
        self.state.configuration.velocity[unit]
    }

    pub fn position(&self, body: usize) -> Vec2 {
        self.state.configuration.position[body]
    }

    pub fn energy(&self) -> f64 {
        self.assembly.kinetic_energy(&self.state.configuration)
    }

    pub fn workspace(&self) -> &Workspace {
        self.workspace.as_ref().unwrap()
    }

    /// Impulses of the latest step in the order of the contact points.
    pub fn impulses(&self) -> Vec<Components> {
        self.workspace()
            .solver()
            .rows()
            .iter()
            .map(|row| row.impulse())
            .collect()
    }
}
