//! A head-on collision in the kernel, with its events located between the steps.

use crate::checks::Failure;
use crate::checks::dem::scenes::advance;
use crate::oracles::quadrature::limit;
use crate::scenes::{Draft, Grain};
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{Bshp, KelvinVoigt};
use std::f64::consts::PI;

/// Density of all spheres in kg/m^3, as set by [`head`].
pub const DENSITY: f64 = 2700.0;

/// Number of interpolation nodes.
const NODES: usize = 6;

/// Two spheres about to collide head on, with their centre of mass at rest.
#[derive(Clone, Debug)]
pub struct Collision {
    /// The normal law, as a part of the scene.
    pub law: Draft,
    /// Radii in m.
    pub radii: [f64; 2],
    /// Relative speed in m/s.
    pub speed: f64,
    /// Distance between the surfaces at the start, in m.
    pub gap: f64,
}

/// How the time steps of a collision are refined.
#[derive(Clone, Copy, Debug)]
pub struct Refinement<'a> {
    /// Steps of the coarsest run; each further run has twice as many.
    pub steps: f64,
    /// Powers of the time step in the error, one fewer than there are runs.
    pub powers: &'a [f64],
}

/// The state of the pair after a step, in m, m/s and N.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Time in s.
    pub time: f64,
    /// Overlap in m.
    pub overlap: f64,
    /// Rate of the overlap in m/s.
    pub rate: f64,
    /// Normal force in N, negative.
    pub force: f64,
}

/// A collision computed by the kernel, up to the last step with a force, and the state after it.
#[derive(Clone, Debug)]
pub struct Track {
    /// Relative speed before the collision in m/s.
    pub speed: f64,
    /// States from the start to the last one with a force.
    pub samples: Vec<Sample>,
    /// The first state without a force.
    pub free: Sample,
    /// The world in that state.
    pub world: World,
}

/// Restitution, duration in s, largest overlap in m and largest force in N.
pub type Figures = [f64; 4];

impl Collision {
    /// Truncated Kelvin-Voigt spheres.
    pub fn kelvin_voigt(stiffness: f64, damping: f64, radii: [f64; 2], speed: f64) -> Self {
        Self {
            law: Draft::empty().law(KelvinVoigt { stiffness, damping }),
            radii,
            speed,
            gap: 0.0,
        }
    }
    /// Viscoelastic spheres, from Young's modulus in Pa, Poisson's ratio and the dissipative constant
    /// in s.
    pub fn viscoelastic(solid: [f64; 2], constant: f64, radii: [f64; 2], speed: f64) -> Self {
        Self {
            law: Draft::empty().law(Bshp {
                youngs_modulus: solid[0],
                poissons_ratio: solid[1],
                dissipative_constant: constant,
            }),
            radii,
            speed,
            gap: 0.0,
        }
    }
    /// Masses in kg.
    pub fn masses(&self) -> [f64; 2] {
        self.radii.map(|r| 4.0 / 3.0 * PI * DENSITY * r.powi(3))
    }
    /// Reduced mass in kg.
    pub fn reduced_mass(&self) -> f64 {
        let [a, b] = self.masses();
        a * b / (a + b)
    }

    /// Follows the collision in steps of the given length. Without a gap, the run starts from an
    /// overlap of a few units in the last place of the distance, so that the force acts at once.
    ///
    /// # Errors
    /// Fails if the collision does not end within the given number of steps.
    pub fn follow(&self, step: f64, most: usize) -> Result<Track, Failure> {
        let [a, b] = self.masses();
        let shares = [b / (a + b), a / (a + b)].map(|share| share * self.speed);
        let [r, s] = self.radii;
        let start = s + self.gap - (r + s) * 4.0 * f64::EPSILON;
        let draft = Draft::open_box(Integrator::VelocityVerlet, step)
            .and(&self.law)
            .with("output.energy", false)
            .grain(Grain::at([-r, 0.0], r).moving([shares[0], 0.0]))
            .grain(Grain::at([start, 0.0], s).moving([-shares[1], 0.0]));
        let mut world = draft.world()?;
        world.evaluate_if_pending()?;
        let mut samples = vec![self.sample(&world)];
        for _ in 0..most {
            advance(&mut world, 1)?;
            let free = self.sample(&world);
            if free.force == 0.0 && free.rate < 0.0 {
                return Ok(Track {
                    speed: self.speed,
                    samples,
                    free,
                    world,
                });
            }
            samples.push(free);
        }
        Err(Failure::Oracle("the collision does not end".to_owned()))
    }

    /// Figures at each refinement, the coarsest first, for a collision of about the given duration in
    /// s.
    ///
    /// # Errors
    /// As [`follow`](Self::follow).
    pub fn refined(
        &self,
        duration: f64,
        refinement: &Refinement,
        signal: impl Fn(&Sample) -> f64 + Copy,
    ) -> Result<Vec<Figures>, Failure> {
        (0..=refinement.powers.len())
            .map(|level| {
                // The end of the collision must not coincide with the end of a step.
                let steps = refinement.steps * (1_u32 << level) as f64 + 0.37;
                let track = self.follow(duration / steps, 2 * steps as usize)?;
                Ok(track.figures(signal))
            })
            .collect()
    }

    /// Figures extrapolated to zero time step.
    ///
    /// # Errors
    /// As [`follow`](Self::follow).
    pub fn limit(
        &self,
        duration: f64,
        refinement: &Refinement,
        signal: impl Fn(&Sample) -> f64 + Copy,
    ) -> Result<Figures, Failure> {
        Ok(limit(
            &self.refined(duration, refinement, signal)?,
            refinement.powers,
        ))
    }

    fn sample(&self, world: &World) -> Sample {
        let p = world.particles();
        Sample {
            time: world.time(),
            overlap: (self.radii[0] + self.radii[1]) - (p.position[1].x - p.position[0].x),
            rate: p.velocity[0].x - p.velocity[1].x,
            force: world.forces().force[0].x,
        }
    }
}

impl Track {
    /// The figures of the collision, with both events located between the steps: the turning point is
    /// where the rate vanishes; the end is where the given signal vanishes, extrapolated from the last
    /// states with a force. The signal must be smooth with a simple zero at the end.
    pub fn figures(&self, signal: impl Fn(&Sample) -> f64) -> Figures {
        let all = &self.samples;
        let turn = all.partition_point(|sample| sample.rate > 0.0);
        let first = turn
            .saturating_sub(NODES / 2)
            .min(all.len().saturating_sub(NODES));
        let around = &all[first..(first + NODES).min(all.len())];
        let last = &all[all.len().saturating_sub(NODES)..];
        let turning = |value: fn(&Sample) -> f64| at_zero(around, |one| one.rate, value);
        let end = |value: fn(&Sample) -> f64| at_zero(last, &signal, value);
        [
            -end(|one| one.rate) / self.speed,
            end(|one| one.time),
            turning(|one| one.overlap),
            -turning(|one| one.force),
        ]
    }
}

/// Value of a quantity where another one vanishes: inverse interpolation by Neville's scheme.
fn at_zero(
    samples: &[Sample],
    node: impl Fn(&Sample) -> f64,
    value: impl Fn(&Sample) -> f64,
) -> f64 {
    let nodes: Vec<f64> = samples.iter().map(node).collect();
    let mut values: Vec<f64> = samples.iter().map(value).collect();
    for width in 1..nodes.len() {
        for k in 0..nodes.len() - width {
            let (low, high) = (nodes[k], nodes[k + width]);
            values[k] = (high * values[k] - low * values[k + 1]) / (high - low);
        }
    }
    values.first().copied().unwrap_or(f64::NAN)
}
