//! Modes of a few particles at rest, and their runs in dual numbers: the derivative part of such a run
//! is the linearised motion, without a finite amplitude.

use crate::checks::Failure;
use crate::oracles::amplification::Method;
use crate::scenes::{Draft, Grain};
use gouge_common::geometry::Vec2;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, CundallStrackTruncated, EulerBernoulli, HaffWerner, KelvinVoigt,
};
use gouge_dem::particles::{Particles, Role};
use gouge_dem::{Start, World};
use gouge_scalars::Dual;
use std::f64::consts::PI;

/// Radius of all particles in m; their density is 2700 kg/m^3.
pub const RADIUS: f64 = 1e-3;

/// Mass of one particle in kg.
pub fn mass() -> f64 {
    4.0 / 3.0 * PI * 2700.0 * RADIUS.powi(3)
}

/// A mode with one stiffness in kg/s^2 and one damping coefficient in kg/s.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// A particle in a harmonic well, with creeping drag.
    Well,
    /// A bonded pair that stretches.
    Axial,
    /// A bonded pair whose ends rotate against each other.
    Bending,
    /// A bonded pair whose ends rotate together, against the rotation of the pair.
    Shearing,
    /// A particle squeezed between two fixed ones.
    Squeezed,
    /// Two touching particles that stick and rotate together, without damping.
    Sticking,
    /// The same with Haff-Werner friction below its limit, without stiffness.
    Viscous,
}

impl Mode {
    /// Every mode.
    pub const ALL: [Self; 7] = [
        Self::Well,
        Self::Axial,
        Self::Bending,
        Self::Shearing,
        Self::Squeezed,
        Self::Sticking,
        Self::Viscous,
    ];

    /// Name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Well => "well with drag",
            Self::Axial => "bond, axial, 2 k/m",
            Self::Bending => "bond, bending, 5/2 k/m",
            Self::Shearing => "bond, shearing, 7/2 k/m",
            Self::Squeezed => "contact, squeezed between two, 2 k/m",
            Self::Sticking => "contact, sticking (Cundall-Strack), 7 k/m",
            Self::Viscous => "contact, viscous (Haff-Werner), 7 gamma/m",
        }
    }

    /// Mass of a particle over the inertia of the mode, from the reduced masses of pairs and the moment
    /// of inertia 2/5 m r^2.
    pub fn factor(self) -> f64 {
        match self {
            Self::Well => 1.0,
            Self::Axial | Self::Squeezed => 2.0,
            Self::Bending => 2.5,
            Self::Shearing => 3.5,
            Self::Sticking | Self::Viscous => 7.0,
        }
    }

    /// Stiffness in 1/s^2 and damping in 1/s of the mode, for the given constants.
    pub fn rates(self, [k, gamma]: [f64; 2]) -> [f64; 2] {
        let over_mass = self.factor() / mass();
        match self {
            Self::Sticking => [over_mass * k, 0.0],
            Self::Viscous => [0.0, over_mass * gamma],
            _ => [over_mass * k, over_mass * gamma],
        }
    }

    /// Constants for which the mode has an angular frequency of 1e6/s (viscous: that rate) and the
    /// given damping ratio.
    pub fn constants(self, zeta: f64) -> [f64; 2] {
        let (scale, rate) = (mass() / self.factor(), 1e6);
        match self {
            Self::Sticking => [scale * rate * rate, 0.0],
            Self::Viscous => [0.0, scale * rate],
            _ => [scale * rate * rate, 2.0 * zeta * scale * rate],
        }
    }

    /// Damping ratios at which to run the mode; a mode without stiffness or damping has a single one.
    pub fn ratios(self, wanted: &[f64]) -> Vec<f64> {
        match self {
            Self::Sticking => vec![0.0],
            Self::Viscous => vec![f64::INFINITY],
            _ => wanted.to_vec(),
        }
    }

    /// Positions of the particles in m; free particles come first.
    fn places(self) -> Vec<[f64; 2]> {
        match self {
            Self::Well => vec![[0.0, 0.5]],
            Self::Axial | Self::Bending | Self::Shearing => vec![[0.0, 0.0], [2.0 * RADIUS, 0.0]],
            Self::Squeezed => vec![[0.0, 0.0], [-1.999 * RADIUS, 0.0], [1.999 * RADIUS, 0.0]],
            // The overlap of 1e-17 m makes the pair touch without changing its lever arms or moving it.
            Self::Sticking | Self::Viscous => vec![[0.0, 0.0], [2.0 * RADIUS - 1e-17, 0.0]],
        }
    }

    fn laws(self, [stiffness, damping]: [f64; 2]) -> Draft {
        let draft = Draft::empty();
        let touching = KelvinVoigt {
            stiffness: 1e-8,
            damping: 0.0,
        };
        match self {
            Self::Well => draft
                .with("box.height", 1.0)
                .harmonic_well(stiffness)
                .creeping_drag(damping / (6.0 * PI * RADIUS)),
            Self::Axial | Self::Bending | Self::Shearing => draft
                .law(AdjustedKelvinVoigt { stiffness, damping })
                .law(EulerBernoulli { stiffness, damping })
                .bonded(0, 1),
            Self::Squeezed => draft.law(KelvinVoigt { stiffness, damping }),
            Self::Sticking => draft.law(touching).law(CundallStrackTruncated {
                friction: 0.7,
                stiffness,
            }),
            Self::Viscous => draft.law(touching).law(HaffWerner {
                friction: 0.7,
                damping,
            }),
        }
    }

    /// Shape of the mode for a unit of [`read`](Self::read): displacement in m and rotation of particle
    /// `i`.
    fn shape(self, i: usize) -> [f64; 3] {
        let sign = if i == 0 { 1.0 } else { -1.0 };
        // The angular momentum stays zero: while the ends rotate together, the pair rotates back by 2/5
        // of that.
        let together = |unit: f64| [0.0, 0.4 * RADIUS * unit * sign, unit];
        match self {
            Self::Well => [0.0, 1.0, 0.0],
            Self::Axial => [-0.5 * sign, 0.0, 0.0],
            Self::Bending => [0.0, 0.0, 0.5 * sign],
            Self::Squeezed if i == 0 => [1.0, 0.0, 0.0],
            Self::Squeezed => [0.0; 3],
            Self::Shearing | Self::Sticking | Self::Viscous => together(1.0 / 1.4),
        }
    }

    /// Amplitude of the mode, from displacements and rotations.
    fn read(self, at: impl Fn(usize) -> [f64; 3]) -> f64 {
        match self {
            Self::Well => at(0)[1],
            Self::Squeezed => at(0)[0],
            Self::Axial => at(1)[0] - at(0)[0],
            Self::Bending => at(0)[2] - at(1)[2],
            Self::Shearing | Self::Sticking | Self::Viscous => {
                0.5 * (at(0)[2] + at(1)[2]) - (at(1)[1] - at(0)[1]) / (2.0 * RADIUS)
            }
        }
    }

    /// The scene of the mode at rest.
    fn draft(self, method: Method, step: f64, constants: [f64; 2]) -> Draft {
        let free = if self == Self::Squeezed { 1 } else { 2 };
        let grains = self.places().into_iter().enumerate().map(|(i, place)| {
            let role = if i < free { Role::Free } else { Role::Fixed };
            Grain::at(place, RADIUS).with_role(role)
        });
        Draft::open_box(integrator_name(method), step)
            .and(&self.laws(constants))
            .with("output.energy", false)
            .grains(grains)
    }
}

/// Name of the kernel's integrator for a method of the oracle.
pub fn integrator_name(method: Method) -> &'static str {
    match method {
        Method::Euler => "euler",
        Method::SymplecticEuler => "symplectic-euler",
        Method::Taylor => "taylor",
        Method::VelocityVerlet => "velocity-verlet",
        Method::Beeman => "beeman",
    }
}

/// Initial speed of the values in units of their derivatives. Only signs and branches depend on it; a
/// friction force needs a direction.
const SPECK: f64 = 1e-40;

/// A run of the linearised motion of a mode, from zero displacement at unit speed.
pub struct Linearised {
    mode: Mode,
    step: f64,
    world: World<Dual>,
}

impl Linearised {
    /// The run of a mode with the given constants.
    ///
    /// # Errors
    /// States that the kernel refuses.
    pub fn new(
        mode: Mode,
        method: Method,
        step: f64,
        constants: [f64; 2],
    ) -> Result<Self, Failure> {
        let scene = mode.draft(method, step, constants).scene()?;
        let mut particles: Particles<Dual> = scene.particles.iter().copied().collect();
        let speck = if mode == Mode::Viscous { SPECK } else { 0.0 };
        for i in 0..particles.len() {
            let [x, y, turn] = mode.shape(i).map(|speed| Dual::new(speck * speed, speed));
            particles.velocity[i] = Vec2::new(x, y);
            particles.angular_velocity[i] = turn;
        }
        let radii = vec![RADIUS; particles.len()];
        let start = Start {
            bonds: scene.bonds.iter().map(|(bond, _)| *bond).collect(),
            ..Start::default()
        };
        let world = World::new(scene.model(&radii), particles, &start)?;
        Ok(Self { mode, step, world })
    }

    /// One step.
    ///
    /// # Errors
    /// States that are no longer finite.
    pub fn advance(&mut self) -> Result<(), Failure> {
        Ok(self.world.step()?)
    }

    /// Amplitude, and its rate times the step.
    pub fn state(&self) -> [f64; 2] {
        let p = self.world.particles();
        let displacement =
            |i: usize| [p.position[i].x, p.position[i].y, p.angle[i]].map(Dual::slope);
        let rate =
            |i: usize| [p.velocity[i].x, p.velocity[i].y, p.angular_velocity[i]].map(Dual::slope);
        [
            self.mode.read(displacement),
            self.step * self.mode.read(rate),
        ]
    }
}
