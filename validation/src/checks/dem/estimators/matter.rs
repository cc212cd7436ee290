//! Spheres, the solid, and the decay of friction.

use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use crate::oracles::matter::{moduli, sphere};
use crate::scenes::{Draft, Grain};
use gouge_common::geometry::Vec2;
use gouge_dem::calibration::FrictionDecay;
use gouge_dem::integrators::Integrator;
use gouge_dem::material::{Elastic, GRANITE, Measured};
use gouge_dem::particles::{Particle, Particles, Role, SPHERE_INERTIA_FACTOR};

pub fn checks() -> Vec<Check> {
    vec![spheres(), energy(), solid(), granite(), decay()]
}

fn spheres() -> Check {
    Check {
        id: "estimators.matter.spheres",
        claim: "A particle has the mass and the moment of inertia of a homogeneous sphere and the state that it is given; scaling its mass scales both.",
        equations: thesis("(52)-(53)"),
        scene: "Spheres of 10 um, 1 mm and 7 m with three densities, one of each pair with four times the mass",
        oracle: "A stack of thin discs, integrated exactly by Boole's rule",
        norm: "Relative error",
        origin: Origin::Exact,
        reason: "Ten roundings of terms of the same sign",
        effort: Effort::Quick,
        measure: measure_spheres,
    }
}

fn measure_spheres() -> Outcome {
    let mut all = Vec::new();
    for (density, radius) in [(2700.0, 1e-3), (1000.0, 1e-5), (0.3, 7.0)] {
        let particle = Particle {
            position: Vec2::new(0.1, 0.2),
            velocity: Vec2::new(0.3, 0.4),
            angle: 0.5,
            angular_velocity: 0.6,
            radius,
            density,
            inertia_factor: SPHERE_INERTIA_FACTOR,
            role: Role::Free,
        };
        let mut p: Particles = [particle; 2].into_iter().collect();
        p.scale_mass(1, 4.0);
        let [mass, inertia] = sphere(density, radius);
        for (i, factor) in [(0, 4.0), (1, 1.0)] {
            all.push(Measurement::relative(factor * mass, p.mass[i], 4e-15));
            all.push(Measurement::relative(
                factor * inertia,
                p.moment_of_inertia[i],
                4e-15,
            ));
        }
        let given = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, radius];
        let (x, v) = (p.position[1], p.velocity[1]);
        let kept = [
            x.x,
            x.y,
            v.x,
            v.y,
            p.angle[1],
            p.angular_velocity[1],
            p.radius[1],
        ];
        let pairs = given.into_iter().zip(kept);
        all.extend(pairs.map(|(given, kept)| Measurement::absolute(given, kept, 0.0)));
    }
    Ok(Measurement::worst(all).into())
}

fn energy() -> Check {
    Check {
        id: "estimators.matter.energy",
        claim: "The kinetic energy of a grain is that of its translation and spin; its potential energy is that of its height, or of its distance from the centre of a well.",
        equations: thesis("(10), (67), (74)"),
        scene: "Two grains that move and spin, under gravity or in a well",
        oracle: "Masses and moments of inertia from stacks of discs",
        norm: "Relative error",
        origin: Origin::Exact,
        reason: "About ten roundings of terms of the same sign",
        effort: Effort::Quick,
        measure: measure_energy,
    }
}

fn measure_energy() -> Outcome {
    let grains = [
        ([0.0, 0.3], [0.4, -0.2], 300.0, 1e-3),
        ([1.0, 0.9], [-0.1, 0.3], -700.0, 2e-3),
    ];
    let [mut kinetic, mut lifted, mut stretched] = [0.0; 3];
    let mut draft = Draft::open_box(Integrator::Euler, 1e-9);
    for (x, v, spin, radius) in grains {
        let [mass, inertia] = sphere(2700.0, radius);
        kinetic += 0.5 * (mass * (v[0] * v[0] + v[1] * v[1]) + inertia * spin * spin);
        lifted += 9.81 * mass * x[1];
        stretched += 0.5 * 7.0 * (x[1] - 0.1) * (x[1] - 0.1);
        draft = draft.grain(Grain::at(x, radius).moving(v).spinning(spin));
    }
    let gravity = Draft::empty().gravity(9.81);
    let well = Draft::empty().with("box.height", 0.2).harmonic_well(7.0);
    let mut all = Vec::new();
    for (law, potential) in [(gravity, lifted), (well, stretched)] {
        let found = draft.clone().and(&law).world()?.energy();
        all.push(Measurement::relative(kinetic, found.kinetic, 5e-15));
        all.push(Measurement::relative(potential, found.external, 5e-15));
        all.push(Measurement::relative(
            kinetic + potential,
            found.mechanical(),
            5e-15,
        ));
    }
    Ok(Measurement::worst(all).into())
}

fn solid() -> Check {
    Check {
        id: "estimators.matter.moduli",
        claim: "Shear, bulk and P-wave modulus are the responses of Hooke's solid to shear, pressure and uniaxial strain, and wave speeds are the square roots of modulus over density.",
        equations: thesis("(39), (59)-(60)"),
        scene: "Young's moduli of 50 GPa and 3 kPa, Poisson's ratios from -0.8 to 0.49, densities of 2700 and 40 kg/m^3",
        oracle: "Inverse of the compliance matrix",
        norm: "Relative error of three moduli and two speeds",
        origin: Origin::Exact,
        reason: "Inverting a matrix with a condition number of up to 75 loses as many units in the last place",
        effort: Effort::Quick,
        measure: measure_solid,
    }
}

fn measure_solid() -> Outcome {
    let mut all = Vec::new();
    for (youngs_modulus, density) in [(50e9, 2700.0), (3e3, 40.0)] {
        for poissons_ratio in [-0.8, -0.3, 0.0, 0.22, 0.4, 0.49] {
            let elastic = Elastic {
                youngs_modulus,
                poissons_ratio,
            };
            let expected = moduli(youngs_modulus, poissons_ratio)
                .ok_or_else(|| Failure::Oracle("a singular solid".to_owned()))?;
            let pairs = [
                (expected.shear, elastic.shear_modulus()),
                (expected.bulk, elastic.bulk_modulus()),
                (expected.uniaxial, elastic.p_wave_modulus()),
                (
                    (expected.uniaxial / density).sqrt(),
                    elastic.primary_wave_speed(density),
                ),
                (
                    (expected.shear / density).sqrt(),
                    elastic.secondary_wave_speed(density),
                ),
            ];
            all.extend(pairs.map(|(oracle, found)| Measurement::relative(oracle, found, 5e-14)));
        }
    }
    Ok(Measurement::worst(all).into())
}

fn granite() -> Check {
    Check {
        id: "estimators.matter.granite",
        claim: "The kernel's granite has the values and uncertainties chosen in the thesis.",
        equations: thesis("section 4.1"),
        scene: "None: nine constants of the kernel",
        oracle: "The list in the thesis",
        norm: "Largest error in units in the last place",
        origin: Origin::Exact,
        reason: "The values are copied",
        effort: Effort::Quick,
        measure: measure_granite,
    }
}

fn measure_granite() -> Outcome {
    let pairs: [(Measured, [f64; 2]); 9] = [
        (GRANITE.density, [2700.0, 100.0]),
        (GRANITE.youngs_modulus, [5e10, 2e10]),
        (GRANITE.poissons_ratio, [0.22, 0.12]),
        (GRANITE.strength_normal, [2.8e8, 3e7]),
        (GRANITE.friction_coefficient, [0.7, 0.1]),
        (GRANITE.axial_ratio, [0.6, 0.1]),
        (GRANITE.weibull_modulus, [15.0, 10.0]),
        (GRANITE.restitution, [0.83, 0.06]),
        (GRANITE.air_viscosity, [1.8e-5, 3e-6]),
    ];
    let mut all = Vec::new();
    for (quantity, [value, uncertainty]) in pairs {
        all.push(Measurement::ulp(value, quantity.value, 0.0));
        all.push(Measurement::ulp(uncertainty, quantity.uncertainty, 0.0));
    }
    let elastic = GRANITE.elastic();
    all.push(Measurement::ulp(5e10, elastic.youngs_modulus, 0.0));
    all.push(Measurement::ulp(0.22, elastic.poissons_ratio, 0.0));
    Ok(Measurement::worst(all).into())
}

fn decay() -> Check {
    Check {
        id: "estimators.friction.decay",
        claim: "The friction model rises in proportion to time up to its peak, is continuous there, and then loses equal fractions of its excess over the residual in equal times.",
        equations: thesis("(100)-(101)"),
        scene: "A peak of 0.9 at 2 s, a residual of 0.3, a rate of 5/s; times from 0 to 6 s, and 1 us after the peak",
        oracle: "Proportionality before the peak; after it, the excess halves in each time ln 2 over the rate",
        norm: "Largest absolute error of the friction coefficient",
        origin: Origin::Exact,
        reason: "A few roundings of numbers below one; rounding of the times by 1e-16, times the rate and their size",
        effort: Effort::Quick,
        measure: measure_decay,
    }
}

fn measure_decay() -> Outcome {
    let decay = FrictionDecay {
        peak_time: 2.0,
        peak: 0.9,
        residual: 0.3,
        rate: 5.0,
    };
    let mut all: Vec<Measurement> = (0..=20)
        .map(|k| f64::from(k) / 20.0)
        .map(|share| Measurement::absolute(0.9 * share, decay.at(2.0 * share), 1e-15))
        .collect();
    let half_life = 2.0_f64.ln() / 5.0;
    let mut excess = 0.6;
    for halvings in 0..30 {
        let found = decay.at(2.0 + f64::from(halvings) * half_life);
        all.push(Measurement::absolute(0.3 + excess, found, 5e-15));
        excess *= 0.5;
    }
    // Just after the peak the excess has fallen by the rate times the time.
    let after = decay.at(2.0 + 1e-6);
    all.push(Measurement::absolute(
        0.9 - 0.6 * 5e-6 * (1.0 - 2.5e-6),
        after,
        1e-15,
    ));
    Ok(Measurement::worst(all).into())
}
