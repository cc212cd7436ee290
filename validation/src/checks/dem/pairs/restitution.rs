//! Pairs whose damping a scene leaves to the wanted restitution.

use super::collision::{Collision, Refinement, Sample};
use crate::checks::{Exhibit, Failure, Measurement, Outcome, Table};
use crate::oracles::head_on::viscoelastic;
use crate::oracles::oscillator::truncated_duration;
use crate::scenes::Draft;
use gouge_dem::calibration::{damping_ratio_for, dissipation_for};

const STIFFNESS: f64 = 1e7;
/// Young's modulus in Pa and Poisson's ratio.
const SOLID: [f64; 2] = [50e9, 0.22];
/// Radius of the smaller sphere in m.
const SMALL: f64 = 1e-3;
const RATIOS: [f64; 3] = [1.0, 10.0, 100.0];
const WANTED: [f64; 5] = [0.05, 0.2, 0.5, 0.8, 1.0];

fn pair(law: Draft, ratio: f64, speed: f64) -> Collision {
    Collision {
        law,
        radii: [SMALL, ratio * SMALL],
        speed,
        gap: 0.0,
    }
}

/// Measures the restitution of a pair that is to rebound with a wanted one, for a ratio of radii.
type Measure = fn(f64, f64) -> Result<f64, Failure>;

/// Restitution of truncated Kelvin-Voigt spheres, extrapolated to zero time step.
fn linear(wanted: f64, ratio: f64) -> Result<f64, Failure> {
    let law = Draft::empty()
        .with("contact.normal.law", "kelvin-voigt")
        .with("contact.normal.stiffness", STIFFNESS)
        .with("contact.normal.restitution", wanted);
    let mass = pair(law.clone(), ratio, 0.0).reduced_mass();
    let (w, zeta) = ((STIFFNESS / mass).sqrt(), damping_ratio_for(wanted));
    let refinement = Refinement {
        steps: 50.0 * (1.0 + zeta),
        powers: &[2.0, 3.0, 4.0, 5.0],
    };
    let speed = 0.02 * SMALL * w * (1.0 + zeta);
    let duration = truncated_duration(zeta) / w;
    let found = pair(law, ratio, speed).limit(duration, &refinement, |one| one.force)?;
    Ok(found[0])
}

/// Restitution of viscoelastic spheres at the speed for which it is given, extrapolated to zero time step.
fn hertzian(wanted: f64, ratio: f64) -> Result<f64, Failure> {
    let speed = 1.0;
    let law = Draft::empty()
        .with("contact.normal.law", "bshp")
        .with("contact.normal.youngs_modulus", SOLID[0])
        .with("contact.normal.poissons_ratio", SOLID[1])
        .with("contact.normal.restitution", wanted)
        .with("contact.normal.restitution_speed", speed);
    let spheres = pair(law, ratio, speed);
    let [r, s] = spheres.radii;
    let modulus = SOLID[0] / (2.0 * (1.0 - SOLID[1] * SOLID[1]));
    let prefactor = 4.0 / 3.0 * modulus * (r * s / (r + s)).sqrt();
    let length = (spheres.reduced_mass() * speed * speed / prefactor).powf(0.4);
    let rebound = viscoelastic(dissipation_for(wanted), 1e-12);
    let (steps, signal): (_, fn(&Sample) -> f64) = match wanted < 1.0 {
        true => (&[1.5, 2.0, 2.5, 3.0, 3.5], |one| {
            one.force / one.overlap.max(f64::MIN_POSITIVE).sqrt()
        }),
        false => (&[2.0, 2.5, 3.0, 3.5, 4.0], |one| {
            one.overlap.max(0.0).sqrt()
        }),
    };
    let refinement = Refinement {
        steps: 200.0,
        powers: steps,
    };
    let found = spheres.limit(rebound.duration * length / speed, &refinement, signal)?;
    Ok(found[0])
}

pub fn wanted() -> Outcome {
    let mut all = Vec::new();
    let mut table = Table::new(
        "Measured restitution, extrapolated to zero time step",
        &["wanted", "radii 1 : 1", "1 : 10", "1 : 100"],
    );
    let laws: [(&str, Measure, f64); 2] =
        [("Kelvin-Voigt", linear, 1e-8), ("BSHP", hertzian, 1e-7)];
    for (name, measure, tolerance) in laws {
        for wanted in WANTED {
            let mut row = vec![format!("{wanted}, {name}")];
            for ratio in RATIOS {
                let found = measure(wanted, ratio)?;
                all.push(Measurement::relative(wanted, found, tolerance));
                row.push(format!("{found:.10}"));
            }
            table.push(row);
        }
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}
