//! Two equal spheres joined by a beam whose shearing moment grows with the square of its length.
//!
//! With D the distance of the centres, R the rest distance, and p and q the angles of the spheres
//! relative to the line, minus those at rest, the torques on the two spheres are
//!
//! -(S + B) and -(S - B), S = D^2/4 (s (p + q) + c (p' + q')), B = b (p - q) + d D/2 (p' - q').
//!
//! The force along the line is k (D - R) + g D', and the transverse force is the sum of the torques
//! over D. This is the bond of LAMMPS's `bpm/rotational` in the plane, derived from its description and
//! compared with its forces.

/// Constants of the beam, in SI units.
#[derive(Clone, Copy, Debug)]
pub struct Stretched {
    /// Mass and moment of inertia of each sphere.
    pub inertia: [f64; 2],
    /// Distance at rest.
    pub rest: f64,
    /// Stiffness k and damping g along the line.
    pub normal: [f64; 2],
    /// Stiffness s and damping c of shearing.
    pub shearing: [f64; 2],
    /// Stiffness b and damping d of bending.
    pub bending: [f64; 2],
}

/// Vector from the first to the second, its rate, angles and angular velocities of both; the centre of
/// mass is at rest.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    /// Vector between the centres in m.
    pub way: [f64; 2],
    /// Its rate in m/s.
    pub rate: [f64; 2],
    /// Angles in rad, relative to rest.
    pub angles: [f64; 2],
    /// Angular velocities in rad/s.
    pub spins: [f64; 2],
}

impl Stretched {
    /// Second derivative of the vector between the centres and angular accelerations; the line at rest
    /// is rotated from x by an angle.
    fn accelerations(&self, pair: &Pair, rest_angle: f64) -> ([f64; 2], [f64; 2]) {
        let [x, y] = pair.way;
        let distance = x.hypot(y);
        let normal = [x / distance, y / distance];
        let stretching = pair.rate[0] * normal[0] + pair.rate[1] * normal[1];
        let turning = (pair.rate[1] * normal[0] - pair.rate[0] * normal[1]) / distance;
        let (sine, cosine) = rest_angle.sin_cos();
        let turned =
            (normal[1] * cosine - normal[0] * sine).atan2(normal[0] * cosine + normal[1] * sine);
        let angles = pair.angles.map(|angle| angle - turned);
        let rates = pair.spins.map(|spin| spin - turning);
        let shear =
            self.shearing[0] * (angles[0] + angles[1]) + self.shearing[1] * (rates[0] + rates[1]);
        let shear = 0.25 * distance * distance * shear;
        let bend = self.bending[0] * (angles[0] - angles[1])
            + 0.5 * distance * self.bending[1] * (rates[0] - rates[1]);
        let torques = [-(shear + bend), -(shear - bend)];
        let pull = self.normal[0] * (distance - self.rest) + self.normal[1] * stretching;
        let across = (torques[0] + torques[1]) / distance;
        let force = [
            normal[0] * pull - normal[1] * across,
            normal[1] * pull + normal[0] * across,
        ];
        let [mass, moment] = self.inertia;
        (force.map(|f| -2.0 * f / mass), torques.map(|t| t / moment))
    }

    /// States after each step of kick, drift and kick, including the first. Forces use the velocities
    /// between two kicks, as in LAMMPS; the line at rest is the initial one.
    pub fn steps(self, mut pair: Pair, step: f64) -> impl Iterator<Item = Pair> {
        let rest_angle = pair.way[1].atan2(pair.way[0]);
        let mut forces = self.accelerations(&pair, rest_angle);
        let kick = move |pair: &mut Pair, (way, spins): ([f64; 2], [f64; 2])| {
            for n in 0..2 {
                pair.rate[n] += 0.5 * step * way[n];
                pair.spins[n] += 0.5 * step * spins[n];
            }
        };
        std::iter::once(pair).chain(std::iter::repeat_with(move || {
            kick(&mut pair, forces);
            for n in 0..2 {
                pair.way[n] += step * pair.rate[n];
                pair.angles[n] += step * pair.spins[n];
            }
            forces = self.accelerations(&pair, rest_angle);
            kick(&mut pair, forces);
            pair
        }))
    }
}
