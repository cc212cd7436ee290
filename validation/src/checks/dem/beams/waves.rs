//! Plane waves in a block on the hexagonal lattice.

use super::oscillation::turn_a_step;
use super::stiffness::{Rest, coordinates};
use super::tension::{hexagonal, thesis_lattice};
use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, thesis};
use crate::oracles::beams::waves::Lattice;
use gouge_dem::integrators::Integrator;
use gouge_scalars::Dual;
use std::f64::consts::{PI, TAU};

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "beams.lattice-waves",
        claim: "Primary, secondary and rotational plane waves in a bonded hexagonal block have the frequencies of the lattice, and long waves the speeds that follow from its moduli, 2154 and 1411 m/s.",
        equations: thesis("(43)-(45), (51)-(53), (64)"),
        scene: "Blocks of touching spheres of 1 mm, k = 1e7 kg/s^2, periodic along the rows with 8 to 32 columns, and so high that the edges do not affect the middle row during the run: a step carries information by one row",
        oracle: "Dispersion of the infinite lattice; sqrt(C11 / rho) and sqrt((C11 - C12) / (2 rho)) of its elastic sheet",
        norm: "Relative error of the frequencies, in units of 1e-12; of the speeds extrapolated from five wavelengths, in units of 1e-7",
        origin: Origin::Convergent,
        reason: "Frequencies are exact to rounding: about a hundred steps of 2^-52 and the rounding of positions. Speeds are even in q D; five wavelengths leave the term of tenth order, whose factor times the product of all (q D)^2, 7e-5, is below 1e-7",
        effort: Effort::Thorough,
        measure: waves,
    }]
}

/// Time step in units of sqrt(m / k).
const STEP: f64 = 0.35;

/// A plane wave: the axis and amplitude of its displacement, the amplitude of its rotation, and its
/// exact frequency, which only sets the duration of the run.
struct Launch {
    axis: usize,
    displacement: f64,
    turn: f64,
    frequency: f64,
}

impl Launch {
    fn run(&self, lattice: &Lattice, columns: usize) -> Result<f64, Failure> {
        let step = STEP * (lattice.sphere.mass() / lattice.springs.normal).sqrt();
        let steps = (1.5 * PI / (self.frequency * step)).ceil() as usize + 4;
        // The edges affect the middle after as many steps as there are rows in between.
        let rest = Rest::of(&hexagonal(lattice, columns, 2 * steps + 3, true)?);
        let phase = TAU / columns as f64 / lattice.distance;
        let rates = |x: f64| {
            let (s, c) = (phase * x).sin_cos();
            let mut rates = [0.0, 0.0, self.turn * s];
            rates[self.axis] = self.displacement * c;
            rates
        };
        let positions = &rest.particles().position;
        let rates: Vec<f64> = positions.iter().flat_map(|x| rates(x.x)).collect();
        let duals: Vec<Dual> = rates.iter().map(|&rate| Dual::new(0.0, rate)).collect();
        let mut world = rest.launched(&duals, Integrator::VelocityVerlet, step)?;
        let (inertia, row) = (rest.inertia(), 3 * columns * (steps + 1));
        let mut samples = vec![0.0];
        for _ in 0..steps {
            world.step()?;
            let now = coordinates(&world);
            let middle = row..row + 3 * columns;
            samples.push(middle.map(|n| now[n].slope() * rates[n] * inertia[n]).sum());
        }
        let turn = turn_a_step(&samples).unwrap_or(f64::NAN);
        Ok(2.0 * (0.5 * turn).sin() / step)
    }
}

/// The three waves with the given phase difference between neighbours in a row.
fn launches(lattice: &Lattice, phase: f64) -> [Launch; 3] {
    let primary = Launch {
        axis: 0,
        displacement: 1.0,
        turn: 0.0,
        frequency: lattice.hexagonal_primary(phase),
    };
    let [slow, fast] = lattice.hexagonal_secondary(phase).map(|wave| Launch {
        axis: 1,
        displacement: wave.displacement,
        turn: wave.turn,
        frequency: wave.frequency,
    });
    [primary, slow, fast]
}

const NAMES: [&str; 3] = ["primary", "secondary", "rotational"];

/// Columns of the blocks; each block is one wavelength wide.
const COLUMNS: [usize; 5] = [8, 12, 16, 24, 32];

/// Speed in the limit of long waves: value at zero of the polynomial in (q D)^2 through all speeds, by
/// Neville's scheme.
fn long_limit(speeds: &[f64]) -> f64 {
    let squares = COLUMNS.map(|columns| (TAU / columns as f64).powi(2));
    let mut values = speeds.to_vec();
    for level in 1..values.len() {
        for n in 0..values.len() - level {
            let (a, b) = (squares[n], squares[n + level]);
            values[n] = (a * values[n + 1] - b * values[n]) / (a - b);
        }
    }
    values[0]
}

fn waves() -> Outcome {
    let lattice = thesis_lattice(1e7);
    let mut table = Table::new(
        "Plane waves along the rows of a hexagonal lattice of spheres of 1 mm with k = 1e7 kg/s^2",
        &[
            "wave",
            "wavelength / D",
            "frequency of the lattice, rad/s",
            "kernel, rad/s",
            "phase speed, kernel, m/s",
        ],
    );
    let (mut measured, mut speeds) = (Vec::new(), [const { Vec::new() }; 3]);
    for columns in COLUMNS {
        let phase = TAU / columns as f64;
        for (n, launch) in launches(&lattice, phase).iter().enumerate() {
            let found = launch.run(&lattice, columns)?;
            measured.push(Measurement::relative(launch.frequency, found, 1e-12));
            let speed = found * lattice.distance / phase;
            speeds[n].push(speed);
            let numbers = [launch.frequency, found].map(|w| format!("{w:.9e}"));
            let [exact, found] = numbers;
            table.push([
                NAMES[n].to_owned(),
                columns.to_string(),
                exact,
                found,
                format!("{speed:.2}"),
            ]);
        }
    }
    let mut limits = Table::new(
        "Speeds of long waves in a hexagonal lattice of spheres of 1 mm with k = 1e7 kg/s^2; in granite of 50 GPa and Poisson's ratio 0.22 they are 4598 m/s (primary)",
        &[
            "wave",
            "bars, elasticity, m/s",
            "beams, elasticity, m/s",
            "beams, kernel, m/s",
        ],
    );
    let bars = thesis_lattice(0.0).hexagonal_speeds();
    for (n, exact) in lattice.hexagonal_speeds().into_iter().enumerate() {
        let found = long_limit(&speeds[n]);
        measured.push(Measurement::relative(exact, found, 1e-7));
        let numbers = [bars[n], exact, found].map(|speed| format!("{speed:.4}"));
        limits.push([NAMES[n].to_owned()].into_iter().chain(numbers));
    }
    Ok(Measurement::worst(measured).showing([Exhibit::Table(table), Exhibit::Table(limits)]))
}
