//! Dense packings between rough walls, made here so that the measurements need no other file.
//!
//! Mean diameter, density and normal stress are 1. Diameters lie between d and 4d, with equal areas for equal
//! intervals of diameters.

use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::assembly::{Assembly, Body, Configuration};
use gouge_contact_dynamics::detection::{DetectionSettings, HalfPlane};
use gouge_contact_dynamics::error::SetupError;
use gouge_contact_dynamics::law::ContactLaw;
use gouge_contact_dynamics::shape::{ShapeId, Shapes};
use gouge_contact_dynamics::step::{Scheme, State, StepReport, StepSettings, Workspace, step};
use gouge_contact_dynamics::sweep::{StopCriterion, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Velocity};

const UPPER: usize = 1;
const SPACING: f64 = 2.2;
const WALL_MASS: f64 = 15.0;

/// A packing as numbers.
#[derive(Clone)]
pub struct Packing {
    pub width: f64,
    pub height: f64,
    pub sides: usize,
    /// Circumradius, position and angle per body.
    pub bodies: Vec<(f64, Vec2, f64)>,
    /// Whether bodies that touch a wall are glued to it.
    pub is_glued: bool,
}

/// A system that can step.
#[derive(Clone)]
pub struct System {
    pub assembly: Assembly,
    pub state: State,
    pub settings: StepSettings,
    pub rate: f64,
}

struct Uniform(u64);

impl Uniform {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

impl Packing {
    /// Bodies on a wide lattice.
    fn loose(sides: usize, count: usize, width: f64) -> Self {
        let mut random = Uniform(0x9E37_79B9_7F4A_7C15);
        let smallest = 0.75 / 4f64.ln();
        let columns = (width / SPACING) as usize;
        let body = |k: usize| {
            let diameter = 1.0 / ((1.0 - 0.75 * random.next()) / smallest);
            let free = 0.5 * (SPACING - diameter) * (2.0 * random.next() - 1.0);
            let x = (k % columns) as f64 * (width / columns as f64) + free;
            let y = ((k / columns) as f64 + 0.5) * SPACING;
            (0.5 * diameter, Vec2::new(x, y), 6.0 * random.next())
        };
        Self {
            width,
            height: count.div_ceil(columns) as f64 * SPACING,
            sides,
            bodies: (0..count).map(body).collect(),
            is_glued: false,
        }
    }

    /// A dense packing, compacted without friction.
    pub fn dense(sides: usize, count: usize, width: f64) -> Result<Self, SetupError> {
        let mut packing = Self::loose(sides, count, width);
        let mut system = packing.system(0.0, 0.05)?;
        system.settings.sweeps.max_sweeps = 50;
        let mut workspace = Workspace::new(&system.assembly, &system.state, &system.settings);
        let limit = 0.02 / system.settings.time_step;
        for index in 0..6000 {
            let kept = if index < 5000 { 0.995 } else { 0.95 };
            let velocities = &mut system.state.configuration.velocity;
            for velocity in &mut velocities[UPPER + 1..] {
                velocity.linear = velocity.linear * kept;
                velocity.angular *= kept;
            }
            let wall = &mut velocities[UPPER].linear.y;
            *wall = wall.max(-limit);
            step(
                &system.assembly,
                &system.settings,
                &mut system.state,
                &mut workspace,
            );
        }
        let configuration = &system.state.configuration;
        let places = configuration.position.iter().zip(&configuration.angle);
        for (body, (&position, &angle)) in packing.bodies.iter_mut().zip(places) {
            (body.1, body.2) = (position, angle);
        }
        packing.height = configuration.wall[UPPER].position.y;
        packing.is_glued = true;
        Ok(packing)
    }

    /// Several copies side by side.
    pub fn repeated(&self, copies: usize) -> Self {
        let shifted = |copy: usize| {
            let shift = Vec2::new(copy as f64 * self.width, 0.0);
            self.bodies
                .iter()
                .map(move |&(r, p, angle)| (r, p + shift, angle))
        };
        Self {
            width: self.width * copies as f64,
            bodies: (0..copies).flat_map(shifted).collect(),
            ..self.clone()
        }
    }

    /// The packing with its walls, sheared at a rate with a strain per step of `rate` times the time step.
    pub fn system(&self, friction: f64, time_step: f64) -> Result<System, SetupError> {
        let domain = Domain {
            width: Some(self.width),
            height: None,
            periodic: true,
        };
        let mut assembly = Assembly::new(domain, Shapes::new());
        let mut state = State::default();
        let shape = match self.sides {
            0 => assembly.shapes.add_disc(),
            sides => assembly.shapes.add_regular(sides)?,
        };
        self.add_walls(&mut assembly, &mut state.configuration)?;
        self.add_bodies(&mut assembly, &mut state.configuration, shape)?;
        let settings = StepSettings {
            time_step,
            scheme: Scheme::Midpoint,
            detection: DetectionSettings::for_diameter(1.0),
            law: ContactLaw::inelastic(friction),
            sweeps: SweepSettings {
                stop: StopCriterion::Increment {
                    tolerance: 1e-3,
                    floor: 1e-12,
                },
                ..SweepSettings::default()
            },
            warm_start_distance: 0.3,
        };
        settings.validate()?;
        Ok(System {
            assembly,
            state,
            settings,
            rate: 1e-3,
        })
    }

    fn add_walls(&self, assembly: &mut Assembly, c: &mut Configuration) -> Result<(), SetupError> {
        let driven = InverseMass {
            y: 1.0 / (WALL_MASS * self.width / 20.0),
            ..InverseMass::IMPOSED
        };
        let walls = [
            (InverseMass::IMPOSED, 0.0, 1.0),
            (driven, self.height, -1.0),
        ];
        for (mass, y, normal) in walls {
            let unit = assembly.add_unit(c, mass, Velocity::default())?;
            let wall = HalfPlane {
                position: Vec2::new(0.0, y),
                normal: Vec2::new(0.0, normal),
            };
            assembly.add_wall(c, wall, unit)?;
        }
        assembly.load[UPPER].force = Vec2::new(0.0, -self.width);
        Ok(())
    }

    fn add_bodies(
        &self,
        assembly: &mut Assembly,
        c: &mut Configuration,
        shape: ShapeId,
    ) -> Result<(), SetupError> {
        for &(scale, position, angle) in &self.bodies {
            let body = Body {
                shape,
                scale,
                position,
                angle,
            };
            let [below, above] = [1.0, -1.0].map(|sign| self.extent(scale, angle, sign));
            if self.is_glued && position.y - below < 0.03 {
                assembly.add_body(c, body, 0)?;
            } else if self.is_glued && self.height - position.y - above < 0.03 {
                assembly.add_body(c, body, UPPER as u32)?;
            } else {
                assembly.add_free(c, body, 1.0, Velocity::default())?;
            }
        }
        Ok(())
    }

    /// How far a body reaches down (sign 1) or up (sign -1) from its centre.
    fn extent(&self, scale: f64, angle: f64, sign: f64) -> f64 {
        let turn = std::f64::consts::TAU / self.sides.max(1) as f64;
        let vertex = |k: usize| -sign * scale * (angle + k as f64 * turn).sin();
        let farthest = (0..self.sides).map(vertex).fold(0.0, f64::max);
        if self.sides == 0 { scale } else { farthest }
    }
}

impl System {
    /// Shear by some steps.
    pub fn shear(&mut self, steps: usize, workspace: &mut Workspace) {
        for _ in 0..steps {
            self.step(workspace);
        }
    }

    /// Advance by a step.
    pub fn step(&mut self, workspace: &mut Workspace) -> StepReport {
        self.drive();
        step(&self.assembly, &self.settings, &mut self.state, workspace)
    }

    /// Give the upper wall the velocity of the rate of shear.
    pub fn drive(&mut self) {
        let configuration = &mut self.state.configuration;
        configuration.velocity[UPPER].linear.x = self.rate * configuration.wall[UPPER].position.y;
    }
}
