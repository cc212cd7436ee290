//! Truncated Kelvin-Voigt collisions.

use super::collision::{Collision, Refinement};
use crate::checks::{Axis, Curve, Exhibit, Failure, Figure, Measurement, Outcome, Table, largest};
use crate::oracles::head_on::spring;
use crate::oracles::oscillator::{truncated_duration, truncated_restitution};
use std::f64::consts::FRAC_1_SQRT_2;
use xprec::Df64;

const STIFFNESS: f64 = 1e7;
/// Damping ratio of the thesis's grains: radius 1 mm, damping 10 kg/s.
const THESIS: f64 = 0.664_903_801;

/// Damping ratios, including values on both sides of the points where the formula changes its branch.
fn ratios() -> Vec<f64> {
    let mut all: Vec<f64> = (0..=24).map(|k| 0.05 * f64::from(k)).collect();
    all.extend([0.01, 0.061_616_358, THESIS]);
    for change in [FRAC_1_SQRT_2, 1.0] {
        all.extend([-1e-3, -1e-9, 0.0, 1e-9, 1e-3].map(|offset| change + offset));
    }
    all.extend([1.5, 2.0, 3.0, 4.5, 6.0, 8.0, 10.0, 13.0, 16.0, 20.0]);
    all.sort_by(f64::total_cmp);
    all
}

/// Spheres with the given damping ratio, fast enough to overlap by about a tenth of the smaller radius.
fn spheres(zeta: f64, radii: [f64; 2]) -> Collision {
    let mass = Collision::kelvin_voigt(STIFFNESS, 0.0, radii, 0.0).reduced_mass();
    let depth: f64 = truncated_restitution(0.5 * zeta.min(1.0));
    let speed = 0.05 * radii[0] / depth * (STIFFNESS / mass).sqrt() * (1.0 + zeta);
    let damping = 2.0 * zeta * (STIFFNESS * mass).sqrt();
    Collision::kelvin_voigt(STIFFNESS, damping, radii, speed)
}

fn frequency(spheres: &Collision) -> f64 {
    (STIFFNESS / spheres.reduced_mass()).sqrt()
}

pub fn closed_form() -> Outcome {
    let mut all = Vec::new();
    let mut table = Table::new(
        "Restitution and duration of a truncated Kelvin-Voigt collision; two derivations agree to all digits shown",
        &[
            "damping ratio",
            "restitution",
            "duration in 1/w",
            "difference",
        ],
    );
    let named = [
        0.0, 0.05, 0.1, 0.3, 0.5, 0.7, 0.71, 0.9, 0.99, 1.0, 1.01, 2.0, 5.0, 20.0,
    ];
    for ratio in named {
        let zeta = Df64::from(ratio);
        let found = spring(zeta, Df64::from(1e-27));
        let (restitution, duration) = (truncated_restitution(zeta), truncated_duration(zeta));
        let errors = [
            found.restitution / restitution,
            found.duration / duration,
            found.depth * found.depth / restitution,
        ]
        .map(|quotient| f64::from((quotient - 1.0).abs()));
        let worst = largest(errors);
        table.push([
            format!("{ratio}"),
            format!("{:.15}", f64::from(restitution)),
            format!("{:.15}", f64::from(duration)),
            format!("{worst:.0e}"),
        ]);
        all.push(Measurement::absolute(0.0, worst, 1e-21));
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

/// The expected and the measured figures for a damping ratio.
fn compared(zeta: f64, radii: [f64; 2]) -> Result<[[f64; 4]; 2], Failure> {
    let spheres = spheres(zeta, radii);
    let w = frequency(&spheres);
    let restitution: f64 = truncated_restitution(zeta);
    let duration = truncated_duration(zeta) / w;
    let depth = restitution.sqrt() * spheres.speed / w;
    let refinement = Refinement {
        steps: 50.0 * (1.0 + zeta),
        powers: &[2.0, 3.0, 4.0, 5.0],
    };
    let found = spheres.limit(duration, &refinement, |one| one.force)?;
    Ok([[restitution, duration, depth, STIFFNESS * depth], found])
}

pub fn curve() -> Outcome {
    let radii = [[1e-3, 1e-3], [1e-3, 1.7e-3], [1e-3, 10e-3]];
    let mut all = Vec::new();
    let (mut found, mut errors) = ([Vec::new(), Vec::new()], Vec::new());
    for (k, &zeta) in ratios().iter().enumerate() {
        let radii = radii[k % 3];
        let [expected, measured] = compared(zeta, radii)?;
        let each = expected.iter().zip(measured);
        let each: Vec<Measurement> = each
            .map(|(&expected, measured)| Measurement::relative(expected, measured, 2e-9))
            .collect();
        let w = frequency(&spheres(zeta, radii));
        found[0].push([zeta, measured[0]]);
        found[1].push([zeta, measured[1] * w]);
        errors.push([zeta, Measurement::worst(each.clone()).error.max(1e-16)]);
        all.extend(each);
    }
    let [restitution, duration] = found;
    let of_errors = "Error of the kernel (largest of restitution, duration, depth and force), extrapolated to zero time step";
    Ok(Measurement::worst(all).showing([
        against(
            "Restitution falls monotonically with damping and tends to 1 / (4 zeta^2)",
            "restitution",
            truncated_restitution,
            restitution,
        ),
        against(
            "The duration is longest without damping and shrinks as the force ends earlier",
            "duration in units of 1/w",
            truncated_duration,
            duration,
        ),
        Exhibit::Figure(Figure::new(
            of_errors,
            Axis::linear("damping ratio", ""),
            Axis::logarithmic("relative error", ""),
            vec![Curve::marks("velocity Verlet", errors)],
        )),
    ]))
}

/// A figure with the closed form as a line and the results of the kernel as marks.
fn against(title: &str, label: &str, form: fn(f64) -> f64, marks: Vec<[f64; 2]>) -> Exhibit {
    let line = (0..=200).map(|k| 20.0 * (f64::from(k) / 200.0).powi(2));
    Exhibit::Figure(Figure::new(
        title.to_owned(),
        Axis::linear("damping ratio", ""),
        Axis::logarithmic(label, ""),
        vec![
            Curve::line("closed form", line.map(|zeta| [zeta, form(zeta)])),
            Curve::marks("kernel", marks),
        ],
    ))
}

pub fn truncation() -> Outcome {
    let mut all = Vec::new();
    let (mut raw, mut located) = (Vec::new(), Vec::new());
    for zeta in [0.0, 0.061_616_358, 0.3, THESIS, 1.0, 3.0] {
        let spheres = spheres(zeta, [1e-3, 1.7e-3]);
        let w = frequency(&spheres);
        let restitution: f64 = truncated_restitution(zeta);
        let duration = truncated_duration(zeta) / w;
        for k in 0..40 {
            let steps = 100.0 * 2.0_f64.powf(f64::from(k) / 10.0) + 0.1;
            let step = duration / steps;
            let track = spheres.follow(step, 10_000)?;
            let [end, time, ..] = track.figures(|one| one.force);
            let whole = (track.samples.len() - 1) as f64;
            let theta = time / step - whole;
            let left = -track.free.rate / spheres.speed;
            let cost = (left / end - 1.0) / (w * step).powi(2);
            let predicted = 0.5 * theta * (1.0 - theta);
            let rate = (1.0 + 2.0 * zeta) * w * step;
            all.push(Measurement::scaled(predicted, cost, 0.125, rate));
            if zeta == THESIS {
                raw.push([step, (left / restitution - 1.0).abs()]);
                located.push([step, (end / restitution - 1.0).abs()]);
            }
        }
    }
    let plot = Figure::new(
        "At the thesis's damping, the step in which the force ends adds a second-order error that depends on the phase",
        Axis::logarithmic("time step", "s"),
        Axis::logarithmic("relative error of the restitution", ""),
        vec![
            Curve::marks("speed after the last step", raw),
            Curve::line("speed at the located end", located),
        ],
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}

pub fn arrival() -> Outcome {
    let mut all = Vec::new();
    let (mut late, mut line) = (Vec::new(), Vec::new());
    let fraction = |k: u32| (f64::from(k) + 0.5) / 20.0;
    for (zeta, steps) in [
        (0.061_616_358, 1000.0),
        (0.3, 1000.0),
        (THESIS, 1000.0),
        (2.0, 4000.0),
    ] {
        let touching = spheres(zeta, [1e-3, 1.7e-3]);
        let w = frequency(&touching);
        let step = truncated_duration(zeta) / w / steps;
        let restitution: f64 = truncated_restitution(zeta);
        for fraction in (0..20).map(fraction) {
            let spheres = Collision {
                gap: fraction * step * touching.speed,
                ..touching.clone()
            };
            let [found, ..] = spheres.follow(step, 20_000)?.figures(|one| one.force);
            let error = (found / restitution - 1.0) / (2.0 * zeta * w * step);
            let rate = (1.0 + 2.0 * zeta) / (2.0 * zeta) * w * step;
            all.push(Measurement::scaled(0.5 - fraction, error, 0.5, rate));
            if zeta == THESIS {
                late.push([fraction, error]);
                line.push([fraction, 0.5 - fraction]);
            }
        }
    }
    let plot = Figure::new(
        "The position within the step at which a damped contact begins determines sign and size of the first-order error",
        Axis::linear("fraction of the step before touch", ""),
        Axis::linear("relative error of the restitution / (2 zeta w dt)", ""),
        vec![
            Curve::line("trapezoidal rule across the jump", line),
            Curve::marks("kernel", late),
        ],
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}
