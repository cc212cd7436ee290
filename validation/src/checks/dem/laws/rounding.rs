//! Laws in double precision against the same laws in double-double precision: their rounding error
//! alone.

use crate::checks::random::Random;
use crate::checks::{Check, Effort, Measurement, Origin, Outcome, thesis};
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, AmbientLaw, BeamLaw, Bshp, CorrelationDrag, CreepingDrag,
    CundallStrackTruncated, EulerBernoulli, HaffWerner, KelvinVoigt, NormalLaw, TangentialLaw,
    TangentialMotion,
};
use gouge_scalars::DoubleDouble;

pub(super) fn checks() -> Vec<Check> {
    vec![Check {
        id: "laws.rounding",
        claim: "The force laws of contacts, bonds and drag accumulate only a few units of rounding: their double-precision values agree with their double-double values.",
        equations: thesis("(11)-(19), (35)-(45)"),
        scene: "Kelvin-Voigt, BSHP, adjusted Kelvin-Voigt, Euler-Bernoulli, Haff-Werner, truncated Cundall-Strack and the two drag laws, each alone in 100 000 random states over many decades",
        oracle: "The same expression in double-double precision, whose rounding is negligible here",
        norm: "Largest error of a force, in units of rounding of its terms",
        origin: Origin::Exact,
        reason: "At most eight operations, each rounded once; for a sum of two terms the unit is that of the larger term",
        effort: Effort::Quick,
        measure: rounding,
    }]
}

const STATES: usize = 100_000;

fn wide(value: f64) -> DoubleDouble {
    DoubleDouble::from_f64(value)
}

fn units(found: f64, exact: DoubleDouble, scale: f64) -> Measurement {
    let difference = (wide(found) - exact).to_f64();
    Measurement::scaled(
        0.0,
        difference,
        f64::EPSILON * scale + f64::MIN_POSITIVE,
        8.0,
    )
}

fn rounding() -> Outcome {
    let mut random = Random::new(34);
    let mut worst = Vec::with_capacity(7 * STATES);
    for _ in 0..STATES {
        let (k, c) = (random.magnitude(1.0, 1e12), random.magnitude(1e-3, 1e4));
        let (xi, rate) = (random.magnitude(1e-12, 1e-2), random.signed(1e-6, 1e3));
        let radii = [random.magnitude(1e-4, 1e-1), random.magnitude(1e-4, 1e-1)];
        worst.extend(links(k, c, xi, rate, radii));
        worst.extend(friction(
            k,
            c,
            random.signed(1e-12, 1e-2),
            rate,
            random.magnitude(1e-3, 1e6),
        ));
        worst.extend(drag(random.magnitude(1e-6, 10.0), radii[0], rate));
    }
    Ok(Measurement::worst(worst).into())
}

fn links(k: f64, c: f64, xi: f64, rate: f64, radii: [f64; 2]) -> [Measurement; 4] {
    let kv = KelvinVoigt {
        stiffness: k,
        damping: c,
    };
    let bshp = Bshp {
        youngs_modulus: k,
        poissons_ratio: 0.22,
        dissipative_constant: 1e-6 * c,
    };
    let akv = AdjustedKelvinVoigt {
        stiffness: k,
        damping: c,
    };
    let eb = EulerBernoulli {
        stiffness: k,
        damping: c,
    };
    let terms = (k * xi).abs() + (c * rate).abs();
    let hertz = bshp.elastic_force(radii, xi).abs() * (1.0 + (1e-6 * c * rate / xi).abs());
    let (wide_radii, x, v) = (radii.map(wide), wide(xi), wide(rate));
    [
        units(kv.force(radii, xi, rate), kv.force(wide_radii, x, v), terms),
        units(
            bshp.force(radii, xi, rate),
            bshp.force(wide_radii, x, v),
            hertz,
        ),
        units(akv.force(xi, rate), akv.force(x, v), terms),
        units(eb.force(xi, rate), eb.force(x, v), terms),
    ]
}

fn friction(k: f64, c: f64, zeta: f64, rate: f64, load: f64) -> [Measurement; 2] {
    let viscous = HaffWerner {
        friction: 0.7,
        damping: c,
    };
    let cut = CundallStrackTruncated {
        friction: 0.7,
        stiffness: k,
    };
    let (slide, exact) = (
        TangentialMotion {
            displacement: zeta,
            velocity: rate,
        },
        TangentialMotion {
            displacement: wide(zeta),
            velocity: wide(rate),
        },
    );
    let of = |law: HaffWerner| law.friction(slide, -load, &mut 0.0).force;
    [
        units(
            of(viscous),
            viscous.friction(exact, wide(-load), &mut wide(0.0)).force,
            of(viscous).abs(),
        ),
        units(
            cut.friction(slide, -load, &mut 0.0).force,
            cut.friction(exact, wide(-load), &mut wide(0.0)).force,
            0.7 * load,
        ),
    ]
}

fn drag(viscosity: f64, radius: f64, speed: f64) -> [Measurement; 2] {
    let velocity = Vec2::new(0.6 * speed, -0.8 * speed);
    let wide_velocity = velocity.cast::<DoubleDouble>();
    let creeping = CreepingDrag { viscosity };
    let correlation = CorrelationDrag {
        viscosity,
        density: 1.2,
        constant: 0.42,
    };
    let (a, b) = (
        creeping.drag(radius, velocity, 0.0).force.y,
        correlation.drag(radius, velocity, 0.0).force.y,
    );
    [
        units(
            a,
            creeping
                .drag(wide(radius), wide_velocity, wide(0.0))
                .force
                .y,
            a.abs(),
        ),
        units(
            b,
            correlation
                .drag(wide(radius), wide_velocity, wide(0.0))
                .force
                .y,
            b.abs(),
        ),
    ]
}
