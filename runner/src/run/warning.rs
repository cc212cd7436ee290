//! Problems that do not stop a run.

use std::fmt;

/// A problem that does not stop a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Warning<'a> {
    /// The time step may be unstable.
    TimeStep {
        /// Name of the scene file.
        scene: &'a str,
        /// The phase.
        phase: &'a str,
        /// The time step in s.
        step: f64,
        /// Stability bound in s.
        bound: f64,
        /// What sets the bound.
        meaning: &'static str,
    },
    /// The energy balance does not close.
    Balance {
        /// Time of the sample in s.
        time: f64,
        /// The largest residual of the balance until then in J.
        residual: f64,
        /// The energy in J with which it is compared.
        scale: f64,
        /// What that energy is.
        what: &'static str,
    },
    /// Particles are driven, but the scene has no driving.
    NothingDrives,
    /// The pressure is negative, so that the driven particles are pulled away; in Pa.
    Tension(f64),
    /// No particle can move.
    NothingMoves,
    /// Two particles are at the same place, where the direction of their force is undefined.
    SamePlace([usize; 2]),
    /// The set-up bonds nothing.
    NothingBonded,
    /// The grains cover little of the area for which masses are corrected.
    Sparse {
        /// By how much masses were multiplied.
        factor: f64,
    },
    /// The lattice is higher than the box.
    HighLattice {
        /// Height of the highest grain in m.
        top: f64,
        /// Height of the box in m.
        height: f64,
    },
    /// Bodies or walls overlap from the beginning, by up to this in m.
    Overlapping(f64),
    /// The sweeps of many steps did not converge.
    Unconverged {
        /// Number of such steps.
        number: u64,
        /// Number of all steps.
        steps: u64,
    },
    /// In many steps an overlap was large.
    LargeOverlaps {
        /// Number of such steps.
        number: u64,
        /// Number of all steps.
        steps: u64,
    },
    /// The balance of energy, which is exact, is off by this part of what was exchanged.
    Imbalance(f64),
    /// Nodes of different grains touch from the beginning, and store this energy in J per metre of depth.
    Touching(f64),
    /// Grains are in walls from the beginning, which push them with this force in N per metre of depth.
    InWalls(f64),
    /// A grain, of this index, has no bonds.
    WithoutBonds(usize),
    /// Bonds do not have Poisson's ratio of their material.
    PoissonRatio {
        /// Name of the material.
        material: &'a str,
        /// Its Poisson's ratio.
        given: f64,
        /// That of the bonds.
        of_bonds: f64,
        /// Young's modulus in Pa of the bonds.
        young_modulus: f64,
    },
    /// Walls have lost this number of nodes.
    BehindWalls(usize),
    /// The residual of the balance of energy is this part of the energy exchanged.
    Residual(f64),
    /// Damping and friction have given this part of the energy exchanged instead of taking it.
    Gained(f64),
    /// Positions are so large that overlaps lose their digits.
    FarOut {
        /// The particle.
        particle: usize,
        /// Its largest coordinate in m.
        coordinate: f64,
        /// Difference between neighbouring floating-point numbers there in m.
        spacing: f64,
    },
}

/// How a warning about the step names a phase.
pub fn in_phase(name: &str) -> String {
    format!("in phase '{name}'")
}

/// How a step is above a bound in s.
fn above(bound: f64) -> String {
    match bound > 0.0 {
        true => format!("above the estimated stability bound, {bound:.3e} s"),
        false => "no step is stable with this integrator".to_owned(),
    }
}

/// How masses were multiplied by a factor.
fn sparse(factor: f64) -> String {
    format!(
        "setup.correct_density multiplies masses by {factor:.2}, because the grains cover only {:.0} % of the box, \
         or of setup.cut: the packing is smaller or looser than that",
        100.0 / factor
    )
}

impl Warning<'_> {
    /// Problems of runs of contact dynamics.
    fn of_rigid_bodies(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overlapping(overlap) => write!(
                f,
                "bodies or walls overlap by up to {overlap:.3e} m at the beginning; contacts do not push them apart unless \
                 contact.gap.law is \"stabilized\""
            ),
            Self::Unconverged { number, steps } => write!(
                f,
                "the sweeps of {number} of {steps} steps did not converge; give solver.max_sweeps or solver.tolerance \
                 another value"
            ),
            Self::LargeOverlaps { number, steps } => write!(
                f,
                "in {number} of {steps} steps an overlap exceeds a hundredth of the mean diameter; a smaller \
                 solver.tolerance, a smaller step or contact.gap.law = \"stabilized\" may help"
            ),
            Self::Imbalance(error) => write!(
                f,
                "the balance of energy is off by {error:.1e} of what was exchanged, more than rounding"
            ),
            _ => self.of_nodes(f),
        }
    }
}

impl Warning<'_> {
    /// Problems of runs of peridynamic grains.
    fn of_nodes(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Touching(energy) => write!(
                f,
                "grains are nearer than contact.radius at the beginning: they store {energy:.3e} J/m and push each other \
                 apart"
            ),
            Self::InWalls(force) => write!(
                f,
                "grains are nearer to walls than contact.radius from the beginning: they are pushed away with up to {force:.3e} N/m"
            ),
            Self::WithoutBonds(grain) => write!(
                f,
                "grains[{grain}] has no bonds, so that nothing holds its nodes together: bonds.horizon must exceed the \
                 distances of nodes, and mesh.size be a part of the size of the grain"
            ),
            Self::PoissonRatio {
                material,
                given,
                of_bonds,
                young_modulus,
            } => write!(
                f,
                "materials.{material}.poisson_ratio = {given:?}: bonds have {of_bonds:.4}, whatever is given; they have the \
                 given stiffness against an equal stretch in all directions, so that Young's modulus is {young_modulus:.4e} Pa"
            ),
            Self::BehindWalls(number) => write!(
                f,
                "{number} nodes are farther behind a wall than contact.radius: the results cannot be trusted; walls.law = \
                 \"paper\" would have stopped the run"
            ),
            Self::Gained(gain) => write!(
                f,
                "damping and friction have given energy to the grains, {:.1} % of the energy exchanged, instead of taking it: \
                 the results cannot be trusted; the signs that mode = \"paper\" repeats are wrong",
                100.0 * gain
            ),
            Self::Residual(error) if error.is_nan() => f.write_str(
                "energies are not finite, so that their balance says nothing: the results cannot be trusted",
            ),
            Self::Residual(error) => write!(
                f,
                "the energy balance is off by {:.1} % of the energy exchanged: the results cannot be trusted; try a \
                 smaller time step (run `gouge stability` for the limits)",
                100.0 * error
            ),
            _ => Ok(()),
        }
    }
}

impl fmt::Display for Warning<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TimeStep {
                scene,
                phase,
                step,
                bound,
                meaning,
            } => write!(
                f,
                "{scene}: time.step = {step:?}: {}, {} ({meaning}; run `gouge stability` for all bounds)",
                above(*bound),
                in_phase(phase)
            ),
            Self::Balance {
                time,
                residual,
                scale,
                what,
            } => write!(
                f,
                "the energy balance is off by {residual:.3e} J at {time:.6e} s, {:.1} % of {what}; \
                 the results cannot be trusted: try a smaller time step",
                100.0 * (residual / scale).abs()
            ),
            Self::NothingDrives => write!(
                f,
                "particles have the role \"driven\", but there is no [driving]: they move like free ones"
            ),
            Self::Tension(pressure) => write!(
                f,
                "driving.pressure = {pressure:?} is negative: it pulls the driven particles upwards"
            ),
            Self::NothingMoves => write!(f, "all particles are fixed: nothing can move"),
            Self::SamePlace([i, j]) => write!(
                f,
                "particles {i} and {j} are at the same place, where the direction of their force is undefined"
            ),
            Self::NothingBonded => write!(
                f,
                "setup.bonding bonds nothing: no two grains are within setup.bonding.reach"
            ),
            Self::Sparse { factor } => f.write_str(&sparse(*factor)),
            Self::HighLattice { top, height } => write!(
                f,
                "setup.lattice reaches up to {top:?} m, above box.height = {height:?}"
            ),
            Self::FarOut {
                particle,
                coordinate,
                spacing,
            } => write!(
                f,
                "particle {particle} is at {coordinate:?} m, where positions are {spacing:.1e} m apart: \
                 move the origin closer to the particles"
            ),
            _ => self.of_rigid_bodies(f),
        }
    }
}
