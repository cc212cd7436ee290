//! Collisions with calibrated parameters.

use crate::checks::dem::pairs::collision::{Collision, Refinement, Sample};
use crate::checks::{Exhibit, Failure, Measurement, Outcome, Table};
use crate::oracles::head_on::{dissipation_for, viscoelastic};
use crate::oracles::oscillator::{truncated_duration, truncated_restitution};
use crate::oracles::quadrature::root;
use crate::oracles::solid::Spheres;
use gouge_dem::calibration::{damping_ratio_for, dissipative_constant_from_restitution};
use gouge_dem::material::GRANITE;
use gouge_dem::setup::SizeRange;

/// Parameters of the thesis: stiffness in kg/s^2 and damping in kg/s.
const STIFFNESS: f64 = 1e7;
const DAMPING: f64 = 10.0;
/// Packing fraction; its inverse raises the density of the grains in a block.
const PACKING: f64 = 0.84;

/// Restitution of Kelvin-Voigt grains in the kernel.
fn restitution(damping: f64, radii: [f64; 2]) -> Result<f64, Failure> {
    let spheres = Collision::kelvin_voigt(STIFFNESS, damping, radii, 100.0);
    let critical = 2.0 * (STIFFNESS * spheres.reduced_mass()).sqrt();
    let zeta = damping / critical;
    let duration = truncated_duration(zeta) * (spheres.reduced_mass() / STIFFNESS).sqrt();
    let refinement = Refinement {
        steps: 50.0 * (1.0 + zeta),
        powers: &[2.0, 3.0, 4.0, 5.0],
    };
    let [found, ..] = spheres.limit(duration, &refinement, |one| one.force)?;
    Ok(found)
}

pub fn damping() -> Outcome {
    let wanted = GRANITE.restitution.value;
    let ratio = root(0.0, 1.0, |zeta| truncated_restitution(zeta) - wanted);
    let sizes = SizeRange::around(1e-3);
    let (small, large) = (sizes.minimum, sizes.maximum);
    // The mass grows with the cube of the radius, so a larger grain of the same density is equivalent.
    let heavy = 1e-3 * PACKING.cbrt().recip();
    let mut all = Vec::new();
    let mut table = Table::new(
        "Restitution at the printed damping of 10 kg/s, and the damping that gives the measured 0.83",
        &[
            "radii in mm",
            "damping ratio at 10 kg/s",
            "restitution at 10 kg/s",
            "kernel",
            "damping for 0.83 in kg/s",
            "kernel",
        ],
    );
    for (name, radii) in [
        ("0.828, 0.828", [small, small]),
        ("0.828, 1.172", [small, large]),
        ("1, 1", [1e-3, 1e-3]),
        ("1.172, 1.172", [large, large]),
        ("1, 1, density over 0.84", [heavy, heavy]),
    ] {
        let mass = Collision::kelvin_voigt(STIFFNESS, 0.0, radii, 1.0).reduced_mass();
        let critical = 2.0 * (STIFFNESS * mass).sqrt();
        let expected: f64 = truncated_restitution(DAMPING / critical);
        let printed = restitution(DAMPING, radii)?;
        let needed = damping_ratio_for(wanted) * critical;
        let reached = restitution(needed, radii)?;
        all.extend([
            Measurement::relative(expected, printed, 2e-9),
            Measurement::relative(ratio * critical, needed, 1e-12),
            Measurement::relative(wanted, reached, 2e-9),
        ]);
        table.push([
            name.to_owned(),
            format!("{:.5}", DAMPING / critical),
            format!("{expected:.9}"),
            format!("{printed:.9}"),
            format!("{needed:.6}"),
            format!("{reached:.9}"),
        ]);
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn viscous(one: &Sample) -> f64 {
    one.force / one.overlap.max(f64::MIN_POSITIVE).sqrt()
}

fn granite_spheres(radius: f64) -> Spheres {
    let solid = GRANITE.elastic();
    Spheres {
        modulus: solid.youngs_modulus,
        ratio: solid.poissons_ratio,
        radius,
    }
}

pub fn constant() -> Outcome {
    let (radius, speed) = (0.5, 1.0);
    let elastic = GRANITE.elastic();
    let (solid, density) = (
        [elastic.youngs_modulus, elastic.poissons_ratio],
        GRANITE.density.value,
    );
    let kappa = |radius: f64| {
        let spheres = granite_spheres(radius);
        2.0 * spheres.prefactor() / spheres.mass(density)
    };
    let wanted = GRANITE.restitution.value;
    let exact = dissipation_for(wanted) / kappa(radius).powf(0.4);
    let first = dissipative_constant_from_restitution(wanted, elastic, density, radius, speed);
    let mut all = Vec::new();
    let mut table = Table::new(
        "Restitution of granite spheres at 1 m/s for the candidate dissipative constants: the constant that suits spheres of 1 m stops grains of 1 mm",
        &[
            "constant",
            "in s",
            "radius in m",
            "b",
            "restitution, integrated",
            "kernel",
        ],
    );
    for (name, constant, radius) in [
        ("exact", exact, radius),
        ("first order, (93) corrected", first, radius),
        ("printed", 6e-3, radius),
        ("exact", exact, 1e-3),
    ] {
        let b = constant * kappa(radius).powf(0.4);
        let rebound = viscoelastic(b, 1e-14);
        let spheres = Collision::viscoelastic(solid, constant, [radius; 2], speed);
        let duration = rebound.duration * kappa(radius).powf(-0.4);
        let refinement = Refinement {
            steps: 100.0 * (1.0 + b / 5.0),
            powers: &[1.5, 2.0, 2.5, 3.0, 3.5],
        };
        let [found, ..] = spheres.limit(duration, &refinement, viscous)?;
        all.push(Measurement::relative(rebound.restitution, found, 2e-8));
        table.push([
            name.to_owned(),
            format!("{constant:.4e}"),
            format!("{radius}"),
            format!("{b:.5}"),
            format!("{:.9}", rebound.restitution),
            format!("{found:.9}"),
        ]);
    }
    all.push(Measurement::relative(
        wanted,
        viscoelastic(exact * kappa(radius).powf(0.4), 1e-14).restitution,
        1e-12,
    ));
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}
