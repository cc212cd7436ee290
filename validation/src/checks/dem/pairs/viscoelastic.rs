//! Viscoelastic and elastic spheres.

use super::collision::{Collision, Figures, Refinement, Sample};
use crate::checks::{Axis, Curve, Exhibit, Failure, Figure, Measurement, Outcome, Table};
use crate::oracles::head_on::{Rebound, viscoelastic};
use crate::oracles::quadrature::limit;
use statrs::function::beta::beta;

/// Young's modulus in Pa and Poisson's ratio.
const SOLID: [f64; 2] = [50e9, 0.22];
const RADII: [f64; 2] = [10e-3, 17e-3];
const SPEEDS: [f64; 5] = [0.01, 0.1, 1.0, 10.0, 100.0];
/// Values of the dissipation b at 1 m/s.
const DISSIPATIONS: [f64; 3] = [0.05, 0.25, 1.2];
/// The value of Riemann's zeta function at -1/2.
const ZETA_OF_MINUS_HALF: f64 = -0.207_886_224_977_354_57;

/// Hertz's prefactor (4/3) E* sqrt(R*), with E* half of the modulus over 1 - nu^2 and R* the reduced
/// radius.
fn prefactor() -> f64 {
    let [modulus, ratio] = SOLID;
    let [a, b] = RADII;
    4.0 / 3.0 * (modulus / (2.0 * (1.0 - ratio * ratio))) * (1.0 / (1.0 / a + 1.0 / b)).sqrt()
}

fn spheres(constant: f64, speed: f64) -> Collision {
    Collision::viscoelastic(SOLID, constant, RADII, speed)
}

/// Hertz's prefactor over the reduced mass, in m^(-1/2) s^-2.
fn kappa() -> f64 {
    prefactor() / spheres(0.0, 1.0).reduced_mass()
}

/// Dissipative constant in s that gives the dissipation b at the given speed.
fn constant(b: f64, speed: f64) -> f64 {
    b / (kappa().powf(0.4) * speed.powf(0.2))
}

/// Unit of length in m at the given speed.
fn length(speed: f64) -> f64 {
    (speed * speed / kappa()).powf(0.4)
}

/// Refinement for a force that begins like the square root of time.
const ROUGH: Refinement = Refinement {
    steps: 100.0,
    powers: &[1.5, 2.0, 2.5, 3.0, 3.5],
};
/// Refinement without damping: the motion is smooth except at the end of the force.
const SMOOTH: Refinement = Refinement {
    steps: 100.0,
    powers: &[2.0, 2.5, 3.0, 3.5, 4.0],
};

/// Force over the square root of the overlap: smooth in that root, with a simple zero at the end.
fn viscous(one: &Sample) -> f64 {
    one.force / one.overlap.max(f64::MIN_POSITIVE).sqrt()
}

/// Square root of the overlap, for elastic contacts, whose force ends where the overlap does.
fn root(one: &Sample) -> f64 {
    one.overlap.max(0.0).sqrt()
}

/// The figures of a dimensionless rebound in SI units.
fn dimensional(rebound: &Rebound<f64>, speed: f64) -> Figures {
    let depth = rebound.depth * length(speed);
    [
        rebound.restitution,
        rebound.duration * length(speed) / speed,
        depth,
        prefactor() * depth * depth.sqrt(),
    ]
}

/// The figures of Hertz's theory in closed form.
fn hertzian(speed: f64) -> Figures {
    let depth = 1.25_f64.powf(0.4) * length(speed);
    let duration = 0.8 * beta(0.4, 0.5) * depth / speed;
    [1.0, duration, depth, prefactor() * depth.powf(1.5)]
}

fn compare(expected: &Figures, measured: &Figures, tolerance: f64) -> Vec<Measurement> {
    let each = expected.iter().zip(measured);
    each.map(|(&expected, &measured)| Measurement::relative(expected, measured, tolerance))
        .collect()
}

fn elastic_figures() -> Result<Vec<(f64, Figures)>, Failure> {
    let figures = |&speed: &f64| {
        let duration = hertzian(speed)[1];
        Ok((speed, spheres(0.0, speed).limit(duration, &SMOOTH, root)?))
    };
    SPEEDS.iter().map(figures).collect()
}

pub fn hertz() -> Outcome {
    let mut all = Vec::new();
    let found = elastic_figures()?;
    let mut table = Table::new(
        "Elastic spheres of 10 and 17 mm radius: depth, force and duration from the kernel, and exponents between neighbouring speeds",
        &[
            "v in m/s",
            "depth in m",
            "force in N",
            "duration in s",
            "v t / depth",
            "exponents",
        ],
    );
    let mut before: Option<(f64, Figures)> = None;
    for (speed, figures) in found {
        all.extend(compare(&hertzian(speed), &figures, 1e-8).split_off(1));
        let [_, duration, depth, force] = figures;
        let exponents = before.map_or(String::new(), |(slower, old)| {
            let slope = |k: usize| (figures[k] / old[k]).ln() / (speed / slower).ln();
            format!("{:.9}, {:.9}, {:.9}", slope(2), slope(3), slope(1))
        });
        table.push([
            format!("{speed}"),
            format!("{depth:.9e}"),
            format!("{force:.9e}"),
            format!("{duration:.9e}"),
            format!("{:.10}", speed * duration / depth),
            exponents,
        ]);
        before = Some((speed, figures));
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

pub fn elastic() -> Outcome {
    let mut all: Vec<Measurement> = elastic_figures()?
        .iter()
        .map(|(_, figures)| Measurement::absolute(1.0, figures[0], 1e-8))
        .collect();
    for speed in SPEEDS {
        let spheres = Collision::kelvin_voigt(1e9, 0.0, RADII, speed);
        let duration = std::f64::consts::PI * (spheres.reduced_mass() / 1e9).sqrt();
        let found = spheres.limit(duration, &SMOOTH, |one| one.force)?;
        all.push(Measurement::absolute(1.0, found[0], 1e-8));
    }
    Ok(Measurement::worst(all).into())
}

pub fn curve() -> Outcome {
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    for dissipation in DISSIPATIONS {
        let constant = constant(dissipation, 1.0);
        let mut marks = Vec::new();
        for speed in SPEEDS {
            let b = dissipation * speed.powf(0.2);
            let expected = dimensional(&viscoelastic(b, 1e-14), speed);
            let found = spheres(constant, speed).limit(expected[1], &ROUGH, viscous)?;
            all.extend(compare(&expected, &found, 5e-9));
            marks.push([speed, found[0]]);
        }
        let label = format!("dissipative constant {constant:.2e} s");
        let line = (0..=60).map(|k| {
            let speed = 10.0_f64.powf(f64::from(k) / 15.0 - 2.0);
            let b = dissipation * speed.powf(0.2);
            [speed, viscoelastic(b, 1e-10).restitution]
        });
        curves.push(Curve::line(&label, line));
        curves.push(Curve::marks("kernel", marks));
    }
    let plot = Figure::new(
        "Restitution of viscoelastic spheres falls slowly with speed over four decades",
        Axis::logarithmic("relative impact speed", "m/s"),
        Axis::linear("restitution", ""),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}

/// Coefficient of dt^(3/2) in the relative error of the restitution, dimensionless.
fn predicted(b: f64) -> f64 {
    let at = |b: f64| viscoelastic(b, 1e-14).restitution;
    let h = 1e-3 * b;
    let slope = (8.0 * (at(b + h) - at(b - h)) - (at(b + 2.0 * h) - at(b - 2.0 * h))) / (12.0 * h);
    // An extra speed at touch changes the final speed v e(b), where b grows as v^(1/5).
    -ZETA_OF_MINUS_HALF * b * (1.0 + 0.2 * b * slope / at(b))
}

pub fn onset() -> Outcome {
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    for b in [0.2, 1.0] {
        let speed = 1.0;
        let rebound = viscoelastic(b, 1e-14);
        let expected = dimensional(&rebound, speed);
        let results = spheres(constant(b, speed), speed).refined(expected[1], &ROUGH, viscous)?;
        let step = |level: usize| rebound.duration / (ROUGH.steps * (1_u32 << level) as f64 + 0.37);
        let errors: Vec<[f64; 2]> = results
            .iter()
            .enumerate()
            .map(|(level, found)| [step(level), found[0] / rebound.restitution - 1.0])
            .collect();
        let coefficients: Vec<[f64; 1]> = errors.iter().map(|[h, e]| [e / h.powf(1.5)]).collect();
        let [found] = limit(&coefficients, &[0.5, 1.0, 1.5, 2.0, 2.5]);
        all.push(Measurement::relative(predicted(b), found, 1e-3));
        let slope = errors.iter().map(|[h, _]| [*h, predicted(b) * h.powf(1.5)]);
        curves.push(Curve::line(&format!("leading term, b = {b}"), slope));
        curves.push(Curve::marks("kernel", errors));
    }
    let plot = Figure::new(
        "Viscoelastic collisions converge with the power 3/2 of the time step, towards the leading term of the error",
        Axis::logarithmic("time step in units of depth over speed", ""),
        Axis::logarithmic("relative error of the restitution", ""),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}
