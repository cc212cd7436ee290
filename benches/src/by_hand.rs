//! Loops written by hand for exactly one scene each: what a part that is absent is measured against.
//!
//! Plain code on plain arrays, one pair after the other, velocity Verlet with predicted velocities as in the
//! kernel, and the same watch over the neighbour list. Positions are not wrapped, nothing is booked.

use gouge_kernel::World;
use gouge_kernel::model::{ContactNormal, ContactTangential};

type Vector = [f64; 2];

/// Grains that only repel, or also rub as Haff and Werner have it.
pub struct Grains {
    position: Vec<Vector>,
    velocity: Vec<Vector>,
    spin: Vec<f64>,
    angle: Vec<f64>,
    radius: Vec<f64>,
    inverse_mass: Vec<f64>,
    inverse_inertia: Vec<f64>,
    force: Vec<Vector>,
    torque: Vec<f64>,
    before: Vec<Vector>,
    before_torque: Vec<f64>,
    pairs: Vec<[usize; 2]>,
    listed_at: Vec<Vector>,
    normal: [f64; 2],
    friction: Option<[f64; 2]>,
    step: f64,
}

impl Grains {
    /// The grains and laws of a world in an open box without bonds; nothing for other laws.
    pub fn of(world: &World) -> Option<Self> {
        let (p, model) = (world.particles(), world.model());
        let contact = model.contact?;
        let ContactNormal::KelvinVoigt(normal) = contact.normal else {
            return None;
        };
        let friction = match contact.tangential {
            None => None,
            Some(ContactTangential::HaffWerner(law)) => Some([law.friction, law.damping]),
            Some(_) => return None,
        };
        let inverse = |column: &[f64]| -> Vec<f64> {
            let of = |(i, x): (usize, &f64)| if p.is_fixed(i) { 0.0 } else { 1.0 / x };
            column.iter().enumerate().map(of).collect()
        };
        let vectors = |column: &[gouge_kernel::geometry::Vec2]| -> Vec<Vector> {
            column.iter().map(|v| [v.x, v.y]).collect()
        };
        let position = vectors(&p.position);
        let pairs = &world.weak_links()?.pairs;
        let number = p.len();
        Some(Self {
            listed_at: position.clone(),
            position,
            velocity: vectors(&p.velocity),
            spin: p.angular_velocity.clone(),
            angle: p.angle.clone(),
            radius: p.radius.clone(),
            inverse_mass: inverse(&p.mass),
            inverse_inertia: inverse(&p.moment_of_inertia),
            force: vectors(&world.forces().force),
            torque: world.forces().torque.clone(),
            before: vec![[0.0; 2]; number],
            before_torque: vec![0.0; number],
            pairs: pairs
                .iter()
                .map(|pair| [pair.i as usize, pair.j as usize])
                .collect(),
            normal: [normal.stiffness, normal.damping],
            friction,
            step: model.time_step,
        })
    }

    /// Take so many steps; tells whether the list of pairs would still be good.
    pub fn advance(&mut self, steps: u64) -> bool {
        let mut is_good = true;
        for _ in 0..steps {
            is_good &= if self.friction.is_some() {
                self.take::<true>()
            } else {
                self.take::<false>()
            };
        }
        is_good
    }

    fn take<const RUBS: bool>(&mut self) -> bool {
        let dt = self.step;
        let mut farthest = 0.0_f64;
        for i in 0..self.position.len() {
            for k in 0..2 {
                let a = self.force[i][k] * self.inverse_mass[i];
                self.position[i][k] += (self.velocity[i][k] + 0.5 * dt * a) * dt;
                self.velocity[i][k] += a * dt;
                self.before[i][k] = a;
            }
            let moved = [0, 1].map(|k| self.position[i][k] - self.listed_at[i][k]);
            farthest = farthest.max(moved[0] * moved[0] + moved[1] * moved[1]);
            self.force[i] = [0.0; 2];
            if RUBS {
                let a = self.torque[i] * self.inverse_inertia[i];
                self.angle[i] += (self.spin[i] + 0.5 * dt * a) * dt;
                self.spin[i] += a * dt;
                self.before_torque[i] = a;
                self.torque[i] = 0.0;
            }
        }
        self.add_contacts::<RUBS>();
        for i in 0..self.position.len() {
            for k in 0..2 {
                let a = self.force[i][k] * self.inverse_mass[i];
                self.velocity[i][k] += (a - self.before[i][k]) * (0.5 * dt);
            }
            if RUBS {
                let a = self.torque[i] * self.inverse_inertia[i];
                self.spin[i] += (a - self.before_torque[i]) * (0.5 * dt);
            }
        }
        farthest < 1e-8
    }

    fn add_contacts<const RUBS: bool>(&mut self) {
        let [stiffness, damping] = self.normal;
        for &[i, j] in &self.pairs {
            let (a, b) = (self.position[i], self.position[j]);
            let d = [b[0] - a[0], b[1] - a[1]];
            let squared = d[0] * d[0] + d[1] * d[1];
            let reach = self.radius[i] + self.radius[j];
            if squared >= reach * reach {
                continue;
            }
            let distance = squared.sqrt();
            let n = [d[0] / distance, d[1] / distance];
            let u = [0, 1].map(|k| self.velocity[j][k] - self.velocity[i][k]);
            let approach = -(u[0] * n[0] + u[1] * n[1]);
            let normal = -(stiffness * (reach - distance) + damping * approach).max(0.0);
            let mut force = [n[0] * normal, n[1] * normal];
            if RUBS && let Some([friction, viscosity]) = self.friction {
                let turning = (u[1] * n[0] - u[0] * n[1]) / distance;
                let slip = self.radius[i] * (self.spin[i] - turning)
                    + self.radius[j] * (self.spin[j] - turning);
                let limit = friction * normal.abs();
                let rub = -slip.signum() * limit.min(viscosity * slip.abs());
                let torques = [self.radius[i] * rub, self.radius[j] * rub];
                let shear = (torques[0] + torques[1]) / distance;
                force[0] -= n[1] * shear;
                force[1] += n[0] * shear;
                self.torque[i] += torques[0];
                self.torque[j] += torques[1];
            }
            for (k, force) in force.into_iter().enumerate() {
                self.force[i][k] += force;
                self.force[j][k] -= force;
            }
        }
    }

    /// Greatest distance of a grain from that of a world, in m: both must have done the same.
    pub fn distance(&self, world: &World) -> f64 {
        let apart = self.position.iter().zip(&world.particles().position);
        apart
            .map(|(a, b)| (a[0] - b.x).hypot(a[1] - b.y))
            .fold(0.0, f64::max)
    }
}
