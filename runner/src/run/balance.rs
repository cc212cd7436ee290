//! Watches the energy balance of a run.

use super::bytes::{Reader, put_words};
use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::estimators::Energy;
use gouge_dem::integrators::Integrator;
use gouge_dem::model::External;

/// Largest residual that is trusted, in units of the largest term of the balance.
const TRUSTED: f64 = 0.05;
/// Largest residual that is trusted at the end of a run, in units of what was exchanged. Larger, because a little energy
/// of a fast motion can be exchanged within few steps.
const TRUSTED_OF_EXCHANGE: f64 = 0.1;
/// Number of samples after which twice as much is tolerated as at the end. A method of first order that starts from
/// rest has a residual of 1 / n of its energy after n steps; before there is much energy, that says nothing.
const EARLY: f64 = 20.0;
/// Residual that rounding may cause, in units of the largest energy.
const ROUNDING: f64 = 1e-9;

/// What the samples so far say about the balance.
///
/// While a run goes on, its residual is compared with the largest term of the balance, of the potential energy with its
/// change. When it ends, the residual is also compared with what was exchanged: the largest energy of contacts, heat,
/// work, and the kinetic energy of each change of velocity between samples that gravity does not explain. That does not
/// depend on the frame of reference, and particles that fly or fall freely, however fast, do not add to it, so that they
/// do not hide an error in the contacts of others. A contact that has just begun has not exchanged much, so nothing is
/// said of it earlier.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Balance {
    /// Number of samples.
    samples: u64,
    /// The largest residual in J.
    pub residual: f64,
    /// The largest term in J.
    pub largest: f64,
    /// The largest absolute energy in J.
    magnitude: f64,
    /// The largest of all terms that are exchanged, added up, in J.
    exchanged: f64,
    /// Kinetic energy of each change of velocity, in J.
    changes: f64,
    /// Whether any sample was beyond trust.
    pub is_off: bool,
    /// Potential energy at t = 0 in J.
    external: f64,
    /// What the kinetic energy lacked at t = 0 in J.
    lag: f64,
    /// Time of the latest sample in s.
    time: f64,
    /// Velocities in m/s and angular velocities in rad/s of all particles in the latest sample.
    motions: Vec<[f64; 3]>,
}

impl Balance {
    /// The watch with which a run begins.
    pub fn new(world: &World) -> Self {
        Self {
            external: world.energy().external,
            lag: lag(world),
            motions: motions(world),
            ..Self::default()
        }
    }

    /// Look at a sample; whether this is the first one beyond trust.
    pub fn watch(&mut self, world: &World, energy: &Energy) -> bool {
        self.look_at_motions(world);
        let external = (energy.external - self.external).abs();
        let booked = [
            energy.contact,
            energy.ambient,
            energy.friction,
            energy.breaking,
            energy.bonding,
            energy.driving,
        ];
        let terms = booked.iter().chain([&energy.kinetic, &external]);
        self.largest = terms.fold(self.largest, |all, term| all.max(term.abs()));
        let field = if has_field_error(world) {
            external
        } else {
            0.0
        };
        let sum = booked.iter().map(|term| term.abs()).sum::<f64>() + field;
        self.exchanged = self.exchanged.max(sum);
        let absolute = energy.kinetic.max(energy.external.abs());
        self.magnitude = self.magnitude.max(self.largest).max(absolute);
        let residual = energy.residual + lag(world) - self.lag;
        self.residual = self.residual.max(residual.abs());
        let tolerated = TRUSTED * (1.0 + EARLY / self.samples as f64);
        self.samples += 1;
        let is_off = self.is_real() && self.residual > tolerated * self.largest;
        let is_first = is_off && !self.is_off;
        self.is_off |= is_off;
        is_first
    }

    /// Whether rounding does not explain the residual.
    fn is_real(&self) -> bool {
        self.residual > ROUNDING * self.magnitude
    }

    /// The largest residual in units of what was exchanged; zero if rounding explains it.
    pub fn ratio(&self) -> f64 {
        match self.is_real() {
            true => self.residual / self.scale(),
            false => 0.0,
        }
    }

    /// What was exchanged, in J.
    pub fn scale(&self) -> f64 {
        self.largest.min(self.exchanged + self.changes)
    }

    /// Look at the whole run; whether it is beyond trust although no sample was.
    pub fn conclude(&mut self) -> bool {
        let is_off = self.is_real()
            && (self.residual > TRUSTED * self.largest
                || self.residual > TRUSTED_OF_EXCHANGE * self.scale());
        let is_first = is_off && !self.is_off;
        self.is_off |= is_off;
        is_first
    }

    fn look_at_motions(&mut self, world: &World) {
        let p = world.particles();
        let fall = match world.model().external {
            Some(External::Gravity(law)) => law.acceleration * (world.time() - self.time),
            _ => 0.0,
        };
        let now = motions(world);
        for (i, (new, old)) in now.iter().zip(&self.motions).enumerate() {
            if p.is_fixed(i) {
                continue;
            }
            let change = Vec2::new(new[0] - old[0], new[1] - old[1] + fall);
            let turn = new[2] - old[2];
            self.changes +=
                0.5 * (p.mass[i] * change.norm_squared() + p.moment_of_inertia[i] * turn * turn);
        }
        (self.time, self.motions) = (world.time(), now);
    }

    /// Append the watch to the bytes of a checkpoint.
    pub fn put(&self, bytes: &mut Vec<u8>) {
        let numbers = [
            self.residual,
            self.largest,
            self.magnitude,
            self.exchanged,
            self.changes,
            self.external,
            self.lag,
            self.time,
        ];
        put_words(bytes, &[self.samples, u64::from(self.is_off)]);
        put_words(bytes, &numbers.map(f64::to_bits));
        put_words(bytes, &[self.motions.len() as u64]);
        for motion in &self.motions {
            put_words(bytes, &motion.map(f64::to_bits));
        }
    }

    /// Read the watch that [`Balance::put`] wrote.
    pub fn read(bytes: &mut Reader) -> Option<Self> {
        let (samples, is_off) = (bytes.word()?, bytes.word()? != 0);
        let numbers: [u64; 8] = bytes.words(8)?.try_into().ok()?;
        let [
            residual,
            largest,
            magnitude,
            exchanged,
            changes,
            external,
            lag,
            time,
        ] = numbers.map(f64::from_bits);
        let number = bytes.word()?;
        let words = bytes.words(number.checked_mul(3)?)?;
        let (motions, _) = words.as_chunks::<3>();
        Some(Self {
            samples,
            residual,
            largest,
            magnitude,
            exchanged,
            changes,
            is_off,
            external,
            lag,
            time,
            motions: motions
                .iter()
                .map(|motion| motion.map(f64::from_bits))
                .collect(),
        })
    }
}

fn motions(world: &World) -> Vec<[f64; 3]> {
    let p = world.particles();
    let motion = |i: usize| [p.velocity[i].x, p.velocity[i].y, p.angular_velocity[i]];
    (0..p.len()).map(motion).collect()
}

/// Whether the method makes an error in the external field. In uniform gravity only explicit Euler does.
fn has_field_error(world: &World) -> bool {
    match world.model().external {
        Some(External::Gravity(_)) => world.model().integrator == Integrator::Euler,
        external => external.is_some(),
    }
}

/// What the kinetic energy lacks in J because the velocities are those of another time.
///
/// The velocities of symplectic Euler are those of half a step earlier than the positions: seen as leapfrog, it is of
/// second order. Without this term its residual oscillates in every contact, although the motion is right.
fn lag(world: &World) -> f64 {
    if world.model().integrator != Integrator::SymplecticEuler {
        return 0.0;
    }
    // In a copy: the evaluation belongs to the next step.
    let mut ahead = world.clone();
    if ahead.evaluate_if_pending().is_err() {
        return 0.0;
    }
    let (p, forces) = (ahead.particles(), ahead.forces());
    let half = 0.5 * world.model().time_step;
    let gain = |i: usize| {
        let (push, turn) = (forces.force[i] * half, forces.torque[i] * half);
        push.dot(p.velocity[i])
            + turn * p.angular_velocity[i]
            + 0.5 * (push.norm_squared() / p.mass[i] + turn * turn / p.moment_of_inertia[i])
    };
    let mobile = (0..p.len()).filter(|&i| !p.is_fixed(i));
    mobile.map(gain).sum()
}
