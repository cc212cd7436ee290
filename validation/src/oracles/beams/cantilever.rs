//! A straight chain of equal beams, clamped at one end: statically determinate, so solved by hand.
//!
//! Beam n = 1 ... M connects body n - 1 to body n; body 0 is clamped. A transverse load P on body m is
//! carried by every beam up to m: k_t r^2 (a_n + b_n) = P D, where a_n and b_n are the rotations of its
//! first and last body relative to its line. No torque acts on a free body: b_n + a_{n+1} = 0 and b_m =
//! 0. Hence, with s = P D / (k_t r^2), a_n = (m - n + 1) s and b_n = -(m - n) s. By summation, body m
//! has the rotation m^2 s and the deflection s D (2 m^3 + m) / 3; beyond it the chain is straight.

/// A chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chain {
    /// Number of beams M.
    pub beams: usize,
    /// Distance of neighbours D in m.
    pub distance: f64,
    /// Radius r in m.
    pub radius: f64,
    /// Stiffnesses in N/m.
    pub springs: super::Springs,
}

/// Displacement of the last body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tip {
    /// Along the chain, outwards, in m.
    pub stretch: f64,
    /// Across the chain, along the load, in m.
    pub deflection: f64,
    /// Rotation in rad, in the sense of the deflection.
    pub turn: f64,
}

impl Chain {
    fn length(&self) -> f64 {
        self.beams as f64 * self.distance
    }
    /// Rotation of a beam in rad per N of transverse load.
    fn turn_per_force(&self) -> f64 {
        self.distance / (self.springs.tangential * self.radius * self.radius)
    }
    /// The tip under a force in N on the last body, along and across the chain.
    pub fn under_end_load(&self, along: f64, across: f64) -> Tip {
        let (m, s) = (self.beams as f64, across * self.turn_per_force());
        Tip {
            stretch: m * along / self.springs.normal,
            deflection: s * self.distance * (2.0 * m * m * m + m) / 3.0,
            turn: s * m * m,
        }
    }
    /// The tip under equal forces in N on every body except the clamped one: the sums over the loaded
    /// body m of (2 m^3 + m) / 3 + m^2 (M - m), of m^2, and of m.
    pub fn under_own_weight(&self, along: f64, across: f64) -> Tip {
        let (m, s) = (self.beams as f64, across * self.turn_per_force());
        let deflection = m.powi(4) / 4.0 + m.powi(3) / 3.0 + m * m / 4.0 + m / 6.0;
        Tip {
            stretch: 0.5 * m * (m + 1.0) * along / self.springs.normal,
            deflection: s * self.distance * deflection,
            turn: s * m * (m + 1.0) * (2.0 * m + 1.0) / 6.0,
        }
    }
    /// Bending stiffness E I = k_t r^2 D / 2 in N m^2 of the continuous beam with the same deflections.
    pub fn bending_stiffness(&self) -> f64 {
        0.5 * self.springs.tangential * self.radius * self.radius * self.distance
    }
    /// Shear stiffness kappa G A = 3 k_t r^2 / D in N of the same beam.
    pub fn shear_stiffness(&self) -> f64 {
        3.0 * self.springs.tangential * self.radius * self.radius / self.distance
    }
    /// Deflection in m of the end of an Euler-Bernoulli beam under an end load in N.
    pub fn euler_bernoulli(&self, across: f64) -> f64 {
        across * self.length().powi(3) / (3.0 * self.bending_stiffness())
    }
    /// Deflection in m of the end of a Timoshenko beam under an end load in N.
    pub fn timoshenko(&self, across: f64) -> f64 {
        self.euler_bernoulli(across) + across * self.length() / self.shear_stiffness()
    }
    /// Deflection in m of the end of a Timoshenko beam under a uniform load in N per distance D.
    pub fn timoshenko_uniform(&self, across: f64) -> f64 {
        let (length, load) = (self.length(), across / self.distance);
        load * length.powi(4) / (8.0 * self.bending_stiffness())
            + load * length.powi(2) / (2.0 * self.shear_stiffness())
    }
}

/// Relative deviation from linear theory of the deflection of a slender inextensible beam under a small
/// dead load P at its end, over (P L^2 / E I)^2.
///
/// theta'' = -beta cos(theta), theta(0) = theta'(1) = 0 with beta = P L^2 / (E I): to third order in
/// beta the deflection of the end is beta / 3 - 4 beta^3 / 105.
pub const ELASTICA: f64 = -4.0 / 35.0;

#[cfg(test)]
mod tests {
    use super::super::Springs;
    use super::super::network::{Beam, stiffness};
    use super::Chain;
    use approx::abs_diff_eq;
    use nalgebra::DVector;

    const CHAIN: Chain = Chain {
        beams: 7,
        distance: 0.7,
        radius: 0.3,
        springs: Springs {
            normal: 3.0,
            tangential: 5.0,
        },
    };

    #[test]
    fn the_assembled_network_gives_the_same() {
        let beams: Vec<Beam> = (0..CHAIN.beams)
            .map(|n| Beam {
                between: [n, n + 1],
                apart: [CHAIN.distance, 0.0],
                radii: [CHAIN.radius; 2],
            })
            .collect();
        let full = stiffness(CHAIN.beams + 1, &beams, CHAIN.springs);
        let free = 3 * CHAIN.beams;
        let inner = full.view((3, 3), (free, free)).into_owned();
        let mut load = DVector::zeros(free);
        for body in 0..CHAIN.beams {
            load[3 * body] = 2.0;
            load[3 * body + 1] = 1.5;
        }
        let solved = inner.cholesky().map(|factors| factors.solve(&load));
        let tip = CHAIN.under_own_weight(2.0, 1.5);
        let expected = [tip.stretch, tip.deflection, tip.turn];
        for (n, exact) in expected.iter().enumerate() {
            let value = solved.as_ref().map_or(f64::NAN, |u| u[free - 3 + n]);
            assert!(
                abs_diff_eq!(value / exact, 1.0, epsilon = 1e-11),
                "{n}: {value} {exact}"
            );
        }
    }
}
