//! A few bodies on a floor.

use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::assembly::{Assembly, Body};
use gouge_contact_dynamics::detection::{DetectionSettings, HalfPlane};
use gouge_contact_dynamics::law::ContactLaw;
use gouge_contact_dynamics::shape::Shapes;
use gouge_contact_dynamics::step::{Scheme, State, StepReport, StepSettings, Workspace, step};
use gouge_contact_dynamics::sweep::{StopCriterion, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Load, Velocity};

/// Number of sides (0 for a disc) and circumradius.
pub type Kind = (usize, f64);

pub fn disc(radius: f64) -> Kind {
    (0, radius)
}

pub fn polygon(sides: usize, radius: f64) -> Kind {
    (sides, radius)
}

pub struct Motion {
    assembly: Assembly,
    pub settings: StepSettings,
    state: State,
    workspace: Option<Workspace>,
}

impl Motion {
    pub fn new(time_step: f64, law: ContactLaw) -> Self {
        let domain = Domain {
            width: None,
            height: None,
            periodic: false,
        };
        Self {
            assembly: Assembly::new(domain, Shapes::new()),
            settings: StepSettings {
                time_step,
                scheme: Scheme::Midpoint,
                detection: DetectionSettings::for_diameter(1.0),
                law,
                sweeps: SweepSettings {
                    stop: StopCriterion::NaturalMap { velocity: 1e-15 },
                    max_sweeps: 3000,
                    ..SweepSettings::default()
                },
                warm_start_distance: 0.3,
            },
            state: State::default(),
            workspace: None,
        }
    }

    pub fn add(&mut self, kind: Kind, at: (f64, f64), angle: f64, v: [f64; 3], density: f64) {
        let shapes = &mut self.assembly.shapes;
        let shape = shapes
            .add_regular(kind.0)
            .unwrap_or_else(|_| shapes.add_disc());
        let body = Body {
            shape,
            scale: kind.1,
            position: Vec2::new(at.0, at.1),
            angle,
        };
        let velocity = Velocity {
            linear: Vec2::new(v[0], v[1]),
            angular: v[2],
        };
        let configuration = &mut self.state.configuration;
        let added = self
            .assembly
            .add_free(configuration, body, density, velocity);
        if let Err(error) = added {
            eprintln!("{error}");
        }
    }

    pub fn gravity(&mut self, x: f64, y: f64) {
        let units = self
            .assembly
            .inverse_mass
            .iter()
            .zip(&mut self.assembly.load);
        for (mass, load) in units.filter(|(mass, _)| mass.x > 0.0) {
            *load = Load {
                force: Vec2::new(x, y) * (1.0 / mass.x),
                torque: 0.0,
            };
        }
    }

    pub fn steps(&mut self, count: usize) -> StepReport {
        let make = || Workspace::new(&self.assembly, &self.state, &self.settings);
        let workspace = self.workspace.get_or_insert_with(make);
        let mut report = StepReport::default();
        for _ in 0..count {
            report = step(&self.assembly, &self.settings, &mut self.state, workspace);
        }
        report
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

    pub fn energy(&self) -> f64 {
        self.assembly.kinetic_energy(&self.state.configuration)
    }

    pub fn impulses(&self) -> Vec<[f64; 2]> {
        let rows = self.workspace.iter().flat_map(|w| w.solver().rows());
        rows.map(|row| [row.impulse().n, row.impulse().t]).collect()
    }

    pub fn gaps(&self) -> Vec<f64> {
        let points = self.workspace.iter().flat_map(Workspace::points);
        points.map(|point| point.gap).collect()
    }
}

/// An immobile floor through the origin, inclined so that it falls to the left.
pub fn floor(motion: &mut Motion, angle: f64) {
    let configuration = &mut motion.state.configuration;
    let unit = motion
        .assembly
        .add_unit(configuration, InverseMass::IMPOSED, Velocity::default());
    let wall = HalfPlane {
        position: Vec2::zero(),
        normal: Vec2::new(-angle.sin(), angle.cos()),
    };
    let added = unit.and_then(|unit| motion.assembly.add_wall(configuration, wall, unit));
    if let Err(error) = added {
        eprintln!("{error}");
    }
}
