//! The equations of the thesis author's program, implemented independently from their description.
//!
//! Every pair is tested in every step, every angle is an arctangent, and only the quantities named in
//! the equations are stored. Signs are those of that program: a positive normal force repels, and a
//! contact or bond pulls its first particle along minus the normal and minus the tangent.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Two particles, the lower index first.
pub type Ends = (usize, usize);

/// The role of a particle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Duty {
    /// Moves freely.
    Free,
    /// Moves and carries a share of the driving force.
    Driven,
    /// Is fixed.
    Fixed,
}

/// A sphere in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grain {
    /// Centre in m.
    pub x: [f64; 2],
    /// Velocity in m/s.
    pub v: [f64; 2],
    /// Angle in rad, never wrapped.
    pub phi: f64,
    /// Angular velocity in rad/s.
    pub omega: f64,
    /// Radius in m.
    pub r: f64,
    /// Density in kg/m^3.
    pub density: f64,
    /// Its role.
    pub duty: Duty,
}

/// A spring and a dashpot in parallel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Stiffness in N/m.
    pub k: f64,
    /// Damping in kg/s.
    pub gamma: f64,
}

/// Tangential force of contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rubbing {
    /// None.
    Zero,
    /// Viscous below the Coulomb limit.
    HaffWerner {
        /// Coefficient of friction.
        mu: f64,
        /// Damping in kg/s.
        gamma: f64,
    },
    /// A spring below the Coulomb limit.
    CundallStrack {
        /// Coefficient of friction.
        mu: f64,
        /// Stiffness in N/m.
        k: f64,
    },
}

/// Controllers of the total driving force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driver {
    /// Target mean horizontal velocity in m/s.
    pub speed: f64,
    /// Target vertical reaction in N.
    pub load: f64,
    /// Rate of the total force in N/s.
    pub rate: f64,
}

/// The parameters that do not change with time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rules {
    /// Time step in s.
    pub dt: f64,
    /// Horizontal period in m.
    pub period: Option<f64>,
    /// Normal force of contacts.
    pub touch: Spring,
    /// Tangential force of contacts.
    pub rubbing: Rubbing,
    /// Normal force of bonds.
    pub stretch: Spring,
    /// Bending force of bonds.
    pub bend: Spring,
    /// Normal and tangential strength of bonds in Pa; none if bonds never break.
    pub strength: Option<[f64; 2]>,
    /// Viscosity of the medium in Pa s.
    pub viscosity: Option<f64>,
    /// Stiffness in N/m and height in m of a well that pulls along y.
    pub well: Option<[f64; 2]>,
    /// Controllers.
    pub driver: Option<Driver>,
}

/// A bond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bond {
    /// Its initial distance in m.
    pub length: f64,
    /// Initial angles of both ends in the frame of the pair, in rad.
    pub psi: [f64; 2],
    /// Strength factor.
    pub factor: f64,
}

/// Geometry and motion of a pair.
struct Meeting {
    d: f64,
    normal: [f64; 2],
    tangent: [f64; 2],
    psi: [f64; 2],
    closing: f64,
    zeta_rate: [f64; 2],
}

/// Forces of a contact or bond: along the normal, along the tangent, and the force that rotates each
/// end.
struct Pull {
    normal: f64,
    tangent: f64,
    turning: [f64; 2],
}

/// A scene and its state.
#[derive(Clone, Debug)]
pub struct Original {
    /// The parameters.
    pub rules: Rules,
    /// The particles.
    pub grains: Vec<Grain>,
    /// The intact bonds.
    pub bonds: BTreeMap<Ends, Bond>,
    /// The contacts, with the initial angles of both ends.
    pub contacts: BTreeMap<Ends, [f64; 2]>,
    /// Total driving force in N.
    pub drive: [f64; 2],
    /// Sum of all other forces on the driven particles in N, in the latest step.
    pub reaction: [f64; 2],
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn subtract(total: &mut [f64; 3], part: [f64; 3]) {
    total
        .iter_mut()
        .zip(part)
        .for_each(|(sum, term)| *sum -= term);
}

/// The angle in [-pi, pi).
fn wrap(angle: f64) -> f64 {
    angle - TAU * ((angle + PI) / TAU).floor()
}

impl Grain {
    fn mass(&self) -> f64 {
        self.density * 4.0 / 3.0 * PI * self.r.powi(3)
    }
    /// The second moment about the centre as a point, which the program uses as the moment of inertia.
    fn inertia(&self) -> f64 {
        3.0 / 5.0 * self.mass() * self.r.powi(2)
    }
}

impl Original {
    /// A scene without bonds or contacts.
    pub fn new(rules: Rules, grains: Vec<Grain>) -> Self {
        Self {
            rules,
            grains,
            bonds: BTreeMap::new(),
            contacts: BTreeMap::new(),
            drive: [0.0; 2],
            reaction: [0.0; 2],
        }
    }

    /// Bonds two particles in their present state.
    pub fn bond(&mut self, ends: Ends, factor: f64) {
        let Meeting { d, psi, .. } = self.meet(ends);
        self.bonds.insert(
            ends,
            Bond {
                length: d,
                psi,
                factor,
            },
        );
    }

    /// Whether two particles overlap.
    pub fn overlap(&self, (i, j): Ends) -> bool {
        let reach = self.grains[i].r + self.grains[j].r;
        let apart = self.apart((i, j));
        dot(apart, apart) < reach * reach
    }

    /// Displacement from the first particle to the nearest image of the second.
    pub fn apart(&self, (i, j): Ends) -> [f64; 2] {
        let [mut x, y] = minus(self.grains[j].x, self.grains[i].x);
        if let Some(l) = self.rules.period {
            x -= l * (x / l + 0.5).floor();
        }
        [x, y]
    }

    fn meet(&self, ends: Ends) -> Meeting {
        let (a, b) = (&self.grains[ends.0], &self.grains[ends.1]);
        let apart = self.apart(ends);
        let d = dot(apart, apart).sqrt();
        let normal = [apart[0] / d, apart[1] / d];
        let tangent = [-normal[1], normal[0]];
        let lambda = apart[1].atan2(apart[0]);
        let away = minus(b.v, a.v);
        let turning = dot(away, tangent) / d;
        Meeting {
            d,
            normal,
            tangent,
            psi: [a.phi - lambda, b.phi - wrap(lambda + PI)],
            closing: -dot(away, normal),
            zeta_rate: [a.r * (a.omega - turning), b.r * (b.omega - turning)],
        }
    }

    /// Tangential displacements of both ends since they had the angles `start`.
    fn zeta(&self, (i, j): Ends, now: &Meeting, start: [f64; 2]) -> [f64; 2] {
        [
            self.grains[i].r * wrap(now.psi[0] - start[0]),
            self.grains[j].r * wrap(now.psi[1] - start[1]),
        ]
    }

    fn bond_pull(&self, ends: Ends, bond: &Bond) -> (Meeting, Pull) {
        let now = self.meet(ends);
        let Rules { stretch, bend, .. } = self.rules;
        let zeta = self.zeta(ends, &now, bond.psi);
        let turning = [0, 1].map(|end| bend.k * zeta[end] + bend.gamma * now.zeta_rate[end]);
        let torque = self.grains[ends.0].r * turning[0] + self.grains[ends.1].r * turning[1];
        let normal = stretch.k * (bond.length - now.d) + stretch.gamma * now.closing;
        let pull = Pull {
            normal,
            tangent: torque / now.d,
            turning,
        };
        (now, pull)
    }

    fn contact_pull(&self, ends: Ends, start: [f64; 2]) -> (Meeting, Pull) {
        let now = self.meet(ends);
        let touch = self.rules.touch;
        let overlap = self.grains[ends.0].r + self.grains[ends.1].r - now.d;
        let normal = (touch.k * overlap + touch.gamma * now.closing).max(0.0);
        let slip = now.zeta_rate[0] + now.zeta_rate[1];
        let tangent = match self.rules.rubbing {
            Rubbing::Zero => 0.0,
            Rubbing::HaffWerner { mu, gamma } => {
                (mu * normal).min(gamma * slip.abs()).copysign(slip)
            }
            Rubbing::CundallStrack { mu, k } => {
                let zeta = self.zeta(ends, &now, start);
                let spring = k * (zeta[0] + zeta[1]);
                if mu * normal <= spring.abs() {
                    (mu * normal).copysign(slip)
                } else {
                    spring
                }
            }
        };
        (
            now,
            Pull {
                normal,
                tangent,
                turning: [tangent; 2],
            },
        )
    }

    fn breaks(&self, ends: Ends, bond: &Bond) -> bool {
        let (a, b) = (&self.grains[ends.0], &self.grains[ends.1]);
        let Some([sigma, tau]) = self.rules.strength else {
            return false;
        };
        if a.duty != Duty::Free || b.duty != Duty::Free {
            return false;
        }
        let (_, pull) = self.bond_pull(ends, bond);
        let area = PI * (bond.factor * a.r.min(b.r)).powi(2);
        (pull.normal / (area * sigma)).powi(2) + (pull.tangent / (area * tau)).powi(2) > 1.0
    }

    /// Breaks bonds, then ends contacts, then begins new contacts.
    fn review_links(&mut self) {
        let mut bonds = std::mem::take(&mut self.bonds);
        bonds.retain(|&ends, bond| !self.breaks(ends, bond));
        self.bonds = bonds;
        let mut contacts = std::mem::take(&mut self.contacts);
        contacts.retain(|&ends, _| self.overlap(ends));
        for j in 0..self.grains.len() {
            for i in 0..j {
                if self.overlap((i, j)) && !self.bonds.contains_key(&(i, j)) {
                    contacts
                        .entry((i, j))
                        .or_insert_with(|| self.meet((i, j)).psi);
                }
            }
        }
        self.contacts = contacts;
    }

    /// Force and torque on every particle, without the driving force.
    fn forces(&self) -> Vec<[f64; 3]> {
        let mut total: Vec<[f64; 3]> = self.grains.iter().map(|grain| self.field(grain)).collect();
        let bonds = self
            .bonds
            .iter()
            .map(|(&ends, bond)| (ends, self.bond_pull(ends, bond)));
        let contacts = self
            .contacts
            .iter()
            .map(|(&ends, &psi)| (ends, self.contact_pull(ends, psi)));
        for ((i, j), (now, pull)) in contacts.chain(bonds) {
            let along =
                |axis: usize| pull.normal * now.normal[axis] + pull.tangent * now.tangent[axis];
            let [x, y] = [along(0), along(1)];
            subtract(&mut total[i], [x, y, self.grains[i].r * pull.turning[0]]);
            subtract(&mut total[j], [-x, -y, self.grains[j].r * pull.turning[1]]);
        }
        total
    }

    /// Drag and well. A particle with zero velocity has no drag torque, even if it spins.
    fn field(&self, grain: &Grain) -> [f64; 3] {
        let mut field = [0.0; 3];
        if let Some(eta) = self.rules.viscosity
            && grain.v != [0.0; 2]
        {
            let drag = -6.0 * PI * eta * grain.r;
            let torque = -8.0 * PI * eta * grain.r.powi(3) * grain.omega;
            field = [drag * grain.v[0], drag * grain.v[1], torque];
        }
        if let Some([k, height]) = self.rules.well {
            field[1] += k * (height - grain.x[1]);
        }
        field
    }

    /// Lets the controllers change the driving force and distributes it.
    fn add_drive(&mut self, forces: &mut [[f64; 3]]) {
        let Some(driver) = self.rules.driver else {
            return;
        };
        let driven: Vec<usize> = (0..self.grains.len())
            .filter(|&i| self.grains[i].duty == Duty::Driven)
            .collect();
        let number = driven.len() as f64;
        let sum = |axis: usize| driven.iter().map(|&i| forces[i][axis]).sum::<f64>();
        let mean_speed = driven.iter().map(|&i| self.grains[i].v[0]).sum::<f64>() / number;
        self.reaction = [sum(0), sum(1)];
        let change = driver.rate * self.rules.dt;
        self.drive[0] += change.copysign(driver.speed - mean_speed);
        self.drive[1] += change.copysign(self.reaction[1] - driver.load);
        for i in driven {
            forces[i][0] += self.drive[0] / number;
            forces[i][1] += self.drive[1] / number;
        }
    }

    /// One step: contacts and bonds, forces, driving, then explicit Euler.
    pub fn step(&mut self) {
        self.review_links();
        let mut forces = self.forces();
        self.add_drive(&mut forces);
        let Rules { dt, period, .. } = self.rules;
        for (grain, force) in self.grains.iter_mut().zip(forces) {
            if grain.duty == Duty::Fixed {
                continue;
            }
            let (mass, inertia) = (grain.mass(), grain.inertia());
            grain.x = [grain.x[0] + grain.v[0] * dt, grain.x[1] + grain.v[1] * dt];
            grain.v = [
                grain.v[0] + force[0] / mass * dt,
                grain.v[1] + force[1] / mass * dt,
            ];
            grain.phi += grain.omega * dt;
            grain.omega += force[2] / inertia * dt;
            if let Some(l) = period {
                grain.x[0] -= l * (grain.x[0] / l).floor();
            }
        }
    }
}
