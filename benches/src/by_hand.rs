//! Loops written by hand, each for exactly one scene. They show whether a part that is absent costs time in the kernel.
//!
//! The code is plain and works on plain arrays, one pair after the other. As in the kernel, the integrator is velocity
//! Verlet with predicted velocities, and the same criterion decides when the neighbour list is stale. Positions are not
//! wrapped, and no energy balance is kept.

use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli};
use gouge_dem::model::{ContactLaws, ContactNormal, ContactTangential};

type Vector = [f64; 2];

/// A beam that never breaks.
struct Beam {
    ends: [usize; 2],
    length: f64,
    reference: Vector,
    unbent: [f64; 2],
}

/// Grains with repulsive contacts and, optionally, Haff-Werner friction or bonds that are beams.
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
    beams: Vec<Beam>,
    stretching: [f64; 2],
    bending: [f64; 2],
    step: f64,
}

fn vector(v: Vec2) -> Vector {
    [v.x, v.y]
}

/// Stiffness and damping in the normal direction, friction coefficient and damping in the tangential one; none for
/// other laws.
fn laws(contact: ContactLaws) -> Option<([f64; 2], Option<[f64; 2]>)> {
    let ContactNormal::KelvinVoigt(normal) = contact.normal else {
        return None;
    };
    let friction = match contact.tangential {
        None => None,
        Some(ContactTangential::HaffWerner(law)) => Some([law.friction, law.damping]),
        Some(_) => return None,
    };
    Some(([normal.stiffness, normal.damping], friction))
}

/// The beams of a world, with stiffness and damping of stretching and of bending; none for other laws.
fn beams(world: &World) -> Option<(Vec<Beam>, [f64; 2], [f64; 2])> {
    let (Some(bond), Some(links)) = (world.model().bond, world.bonds()) else {
        return Some((Vec::new(), [0.0; 2], [0.0; 2]));
    };
    let (None, Some(bending)) = (bond.yielding, bond.tangential) else {
        return None;
    };
    let beam = |link: gouge_dem::bonds::Bond<f64>| Beam {
        ends: link.pair.indices().into(),
        length: link.rest.distance,
        reference: vector(link.rest.reference),
        unbent: link.rest.angles,
    };
    let AdjustedKelvinVoigt { stiffness, damping } = bond.normal;
    let stretching = [stiffness, damping];
    let EulerBernoulli { stiffness, damping } = bending;
    Some((
        links.iter().map(beam).collect(),
        stretching,
        [stiffness, damping],
    ))
}

impl Grains {
    /// The grains and laws of a world in an open box; none for other boxes and laws.
    pub fn of(world: &World) -> Option<Self> {
        let (p, model) = (world.particles(), world.model());
        if model.period().is_some() {
            return None;
        }
        let (normal, friction) = laws(model.contact?)?;
        let (beams, stretching, bending) = beams(world)?;
        let inverse = |column: &[f64]| -> Vec<f64> {
            let of = |(i, x): (usize, &f64)| if p.is_fixed(i) { 0.0 } else { 1.0 / x };
            column.iter().enumerate().map(of).collect()
        };
        let vectors = |column: &[Vec2]| column.iter().copied().map(vector).collect::<Vec<_>>();
        let position = vectors(&p.position);
        let pairs = &world.contacts()?.pairs;
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
            normal,
            friction,
            beams,
            stretching,
            bending,
            step: model.time_step,
        })
    }

    /// Take a number of steps; return whether the list of pairs is still valid.
    pub fn advance(&mut self, steps: u64) -> bool {
        let mut is_good = true;
        for _ in 0..steps {
            is_good &= match (self.friction.is_some(), self.beams.is_empty()) {
                (false, true) => self.take::<false, false>(),
                (true, true) => self.take::<true, false>(),
                (false, false) => self.take::<false, true>(),
                (true, false) => self.take::<true, true>(),
            };
        }
        is_good
    }

    fn take<const RUBS: bool, const BENDS: bool>(&mut self) -> bool {
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
            if RUBS || BENDS {
                let a = self.torque[i] * self.inverse_inertia[i];
                self.angle[i] += (self.spin[i] + 0.5 * dt * a) * dt;
                self.spin[i] += a * dt;
                self.before_torque[i] = a;
                self.torque[i] = 0.0;
            }
        }
        if BENDS {
            self.add_beams();
        }
        self.add_contacts::<RUBS>();
        for i in 0..self.position.len() {
            for k in 0..2 {
                let a = self.force[i][k] * self.inverse_mass[i];
                self.velocity[i][k] += (a - self.before[i][k]) * (0.5 * dt);
            }
            if RUBS || BENDS {
                let a = self.torque[i] * self.inverse_inertia[i];
                self.spin[i] += (a - self.before_torque[i]) * (0.5 * dt);
            }
        }
        farthest < 1e-8
    }

    fn add_beams(&mut self) {
        let ([stiffness, damping], [bending, bending_damping]) = (self.stretching, self.bending);
        for beam in &self.beams {
            let [i, j] = beam.ends;
            let d = [0, 1].map(|k| self.position[j][k] - self.position[i][k]);
            let distance = (d[0] * d[0] + d[1] * d[1]).sqrt();
            let n = [d[0] / distance, d[1] / distance];
            let u = [0, 1].map(|k| self.velocity[j][k] - self.velocity[i][k]);
            let approach = -(u[0] * n[0] + u[1] * n[1]);
            let turning = (u[1] * n[0] - u[0] * n[1]) / distance;
            let turned = (beam.reference[0] * n[1] - beam.reference[1] * n[0]).asin();
            let normal = -(stiffness * (beam.length - distance) + damping * approach);
            let torques = [0, 1].map(|end| {
                let (at, radius) = (beam.ends[end], self.radius[beam.ends[end]]);
                let bent = radius * (self.angle[at] - beam.unbent[end] - turned);
                let rate = radius * (self.spin[at] - turning);
                -radius * (bending * bent + bending_damping * rate)
            });
            let shear = (torques[0] + torques[1]) / distance;
            let force = [n[0] * normal - n[1] * shear, n[1] * normal + n[0] * shear];
            for (k, force) in force.into_iter().enumerate() {
                self.force[i][k] += force;
                self.force[j][k] -= force;
            }
            self.torque[i] += torques[0];
            self.torque[j] += torques[1];
        }
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

    /// Largest distance in m between a grain here and the same grain of a world, after equal steps of both.
    pub fn distance(&self, world: &World) -> f64 {
        let apart = self.position.iter().zip(&world.particles().position);
        apart
            .map(|(a, b)| (a[0] - b.x).hypot(a[1] - b.y))
            .fold(0.0, f64::max)
    }
}
