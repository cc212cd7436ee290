//! Plane waves in regular lattices of equal spheres with beams between neighbours.

use super::{Sphere, Springs};

/// A lattice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    /// The spheres.
    pub sphere: Sphere,
    /// Distance of neighbours D in m.
    pub distance: f64,
    /// Stiffnesses in N/m.
    pub springs: Springs,
}

/// A wave of displacement and rotation: x_n = displacement cos(q x), phi_n = turn sin(q x).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// Angular frequency in rad/s.
    pub frequency: f64,
    /// Amplitude of the displacement in m.
    pub displacement: f64,
    /// Amplitude of the rotation in rad.
    pub turn: f64,
}

impl Lattice {
    /// k_t r^2 in N m.
    fn torsion(&self) -> f64 {
        self.springs.tangential * self.sphere.radius.powi(2)
    }
    /// Stiffness k_s = 2 k_t r^2 / D^2 in N/m with which a beam resists shear while both ends keep
    /// their orientation.
    pub fn shear(&self) -> f64 {
        2.0 * self.torsion() / self.distance.powi(2)
    }

    /// Longitudinal wave of a chain with the phase q D between neighbours.
    pub fn chain_longitudinal(&self, phase: f64) -> f64 {
        2.0 * (self.springs.normal / self.sphere.mass()).sqrt() * (0.5 * phase).sin().abs()
    }

    /// Both transverse waves of a chain, the slower first.
    ///
    /// ```text
    /// m w^2 Y   = 8 k_t r^2 / D^2 sin^2(q D / 2) Y + 2 k_t r^2 / D sin(q D) Phi
    /// J w^2 Phi = 2 k_t r^2 / D sin(q D) Y         + 2 k_t r^2 Phi
    /// ```
    pub fn chain_transverse(&self, phase: f64) -> [Wave; 2] {
        let k = self.torsion();
        let along = 8.0 * k / self.distance.powi(2) * (0.5 * phase).sin().powi(2);
        self.coupled(along, 2.0 * k / self.distance * phase.sin(), 2.0 * k)
    }

    /// Primary wave along a row of the hexagonal lattice, with the phase q D between neighbours in a row:
    /// m w^2 = 4 k_n sin^2(q D / 2) + 2 (k_n + 3 k_s) sin^2(q D / 4).
    pub fn hexagonal_primary(&self, phase: f64) -> f64 {
        let (k, s) = (self.springs.normal, self.shear());
        let row = 4.0 * k * (0.5 * phase).sin().powi(2);
        let slanted = 2.0 * (k + 3.0 * s) * (0.25 * phase).sin().powi(2);
        ((row + slanted) / self.sphere.mass()).sqrt()
    }

    /// Both waves with displacement across the row and rotation, the secondary wave first.
    ///
    /// ```text
    /// m w^2 Y   = [4 k_s sin^2(q D / 2) + 2 (3 k_n + k_s) sin^2(q D / 4)] Y + g Phi
    /// J w^2 Phi = g Y + 6 k_t r^2 Phi,    g = 2 k_t r^2 / D (sin(q D) + sin(q D / 2))
    /// ```
    pub fn hexagonal_secondary(&self, phase: f64) -> [Wave; 2] {
        let (k, s, t) = (self.springs.normal, self.shear(), self.torsion());
        let across = 4.0 * s * (0.5 * phase).sin().powi(2)
            + 2.0 * (3.0 * k + s) * (0.25 * phase).sin().powi(2);
        let coupling = 2.0 * t / self.distance * (phase.sin() + (0.5 * phase).sin());
        self.coupled(across, coupling, 6.0 * t)
    }

    /// Waves of two coupled oscillations with inertias m and J, the slower first.
    fn coupled(&self, a: f64, coupling: f64, b: f64) -> [Wave; 2] {
        let (m, j) = (self.sphere.mass(), self.sphere.inertia());
        let (a, g, b) = (a / m, coupling / (m * j).sqrt(), b / j);
        let angle = 0.5 * (2.0 * g).atan2(a - b);
        let (c, s) = (angle.cos(), angle.sin());
        let wave = |c: f64, s: f64| Wave {
            frequency: (a * c * c + 2.0 * g * c * s + b * s * s).max(0.0).sqrt(),
            displacement: c / m.sqrt(),
            turn: s / j.sqrt(),
        };
        [wave(-s, c), wave(c, s)]
    }

    /// Stiffnesses C11 and C12 in N/m of the hexagonal lattice as a sheet, which is isotropic.
    /// All beams of one direction deform alike, and the spheres rotate with the mean rotation: C11 =
    /// sqrt(3)/4 (3 k_n + k_s), C12 = sqrt(3)/4 (k_n - k_s).
    pub fn hexagonal_moduli(&self) -> [f64; 2] {
        let (k, s) = (self.springs.normal, self.shear());
        let quarter = 0.25 * 3.0_f64.sqrt();
        [quarter * (3.0 * k + s), quarter * (k - s)]
    }

    /// Speeds in m/s of long primary and secondary waves in the hexagonal lattice.
    pub fn hexagonal_speeds(&self) -> [f64; 2] {
        let [c11, c12] = self.hexagonal_moduli();
        let cell = 0.5 * 3.0_f64.sqrt() * self.distance.powi(2);
        [c11, 0.5 * (c11 - c12)].map(|modulus| (modulus * cell / self.sphere.mass()).sqrt())
    }
}

/// Young's modulus in N/m and Poisson's ratio of an isotropic sheet with the given C11 and C12.
pub fn technical([c11, c12]: [f64; 2]) -> [f64; 2] {
    [(c11 * c11 - c12 * c12) / c11, c12 / c11]
}

#[cfg(test)]
mod tests {
    use super::{Lattice, Sphere, Springs};
    use approx::{abs_diff_eq, assert_abs_diff_eq};

    fn lattice(distance: f64) -> Lattice {
        Lattice {
            sphere: Sphere {
                radius: 1e-3,
                density: 2700.0,
            },
            distance,
            springs: Springs {
                normal: 1e7,
                tangential: 0.6e7,
            },
        }
    }

    #[test]
    fn long_waves_have_the_speeds_of_the_moduli() {
        let lattice = lattice(1.9e-3);
        let phase = 1e-4;
        let waves = [
            lattice.hexagonal_primary(phase),
            lattice.hexagonal_secondary(phase)[0].frequency,
        ];
        for (wave, speed) in waves.iter().zip(lattice.hexagonal_speeds()) {
            let measured = wave * lattice.distance / phase;
            assert!(
                abs_diff_eq!(measured / speed, 1.0, epsilon = 1e-6),
                "{measured} {speed}"
            );
        }
    }

    #[test]
    fn long_transverse_waves_of_a_chain_are_those_of_a_beam() {
        // w^2 = E I q^4 / (m / D), with E I = k_t r^2 D / 2.
        let (lattice, phase) = (lattice(2e-3), 1e-2_f64);
        let [slow, _] = lattice.chain_transverse(phase);
        let bending = 0.5 * lattice.torsion() * lattice.distance;
        let exact =
            bending * (phase / lattice.distance).powi(4) * lattice.distance / lattice.sphere.mass();
        assert_abs_diff_eq!(slow.frequency.powi(2) / exact, 1.0, epsilon = 1e-4);
    }
}
