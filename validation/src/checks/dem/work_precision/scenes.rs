//! The scenes, from two bonded grains to a sheared fault.

use super::case::{Case, Origin, Truth};
use super::{extrapolation, fault};
use crate::checks::{Failure, largest};
use crate::oracles::grains::{self, Grains, Repulsion};
use crate::oracles::rolling::Rolling;
use crate::scenes::{Draft, Grain};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, Bshp, CundallStrackTruncated, EulerBernoulli, KelvinVoigt,
};
use gouge_dem::particles::Role;
use rand::RngExt;
use rand_pcg::Pcg64;
use std::f64::consts::PI;
use xprec::Df64;

/// Theoretical orders where the force is smooth or has at most kinks.
const SMOOTH: [f64; 5] = [1.0, 1.0, 1.0, 2.0, 2.0];
/// Orders where a force begins like the square root of time.
const ROOT: [f64; 5] = [1.0, 1.0, 1.0, 1.5, 1.5];
/// Orders where a force jumps.
const JUMP: [f64; 5] = [1.0; 5];

/// Largest change of an order by the next term of the error.
const NEXT_TERM: f64 = 0.05;
/// Half the distance between the orders 1, 3/2 and 2.
const HALF_WAY: f64 = 0.25;

const DENSITY: f64 = 2700.0;
const GRANITE_STIFFNESS: f64 = 1e7;
const GRANITE_STEP: f64 = 10e-9;

/// Every scene, from the smallest to the largest.
pub const CASES: [&Case; 7] = [
    &PAIR,
    &BOUNCING,
    &ROLLING,
    &BEAM,
    &PACKING,
    &VISCOELASTIC_PACKING,
    &FAULT,
];

/// Two bonded grains that oscillate, bend and rotate.
pub const PAIR: Case = Case {
    name: "smooth pair",
    orders: SMOOTH,
    margin: NEXT_TERM,
    thesis_step: GRANITE_STEP,
    thesis_steps: 2048,
    doublings: 6,
    rungs: 17,
    brief: 9..13,
    origin: pair,
    truth: |case, origin, _| extrapolation::limit(case, origin, 3..10),
};

/// Grains that each bounce between two fixed ones.
pub const BOUNCING: Case = Case {
    name: "bouncing",
    orders: ROOT,
    margin: HALF_WAY,
    thesis_step: GRANITE_STEP,
    thesis_steps: 4096,
    doublings: 6,
    rungs: 16,
    brief: 5..13,
    origin: bouncing,
    truth: |case, origin, _| {
        let fields = [0.0; 3];
        Ok(grains_truth::<48>(
            case,
            origin,
            viscoelastic(),
            fields,
            1e-20,
        ))
    },
};

/// A ball that rolls over a fixed one and begins to slip.
pub const ROLLING: Case = Case {
    name: "rolling to slip",
    orders: SMOOTH,
    margin: HALF_WAY,
    // The mass is 125 times that of a granite grain and the stiffness 500 times smaller: 250 times the
    // time scale.
    thesis_step: 250.0 * GRANITE_STEP,
    thesis_steps: 8192,
    doublings: 6,
    rungs: 15,
    brief: 8..13,
    origin: rolling,
    truth: rolling_truth,
};

/// A clamped row of bonded grains that oscillates.
pub const BEAM: Case = Case {
    name: "bonded beam",
    orders: SMOOTH,
    margin: NEXT_TERM,
    thesis_step: GRANITE_STEP,
    thesis_steps: 2048,
    doublings: 3,
    rungs: 12,
    brief: 1..5,
    origin: beam,
    truth: |case, origin, _| extrapolation::limit(case, origin, 1..6),
};

/// Grains that fall onto each other.
pub const PACKING: Case = Case {
    name: "small packing",
    orders: JUMP,
    margin: HALF_WAY,
    thesis_step: GRANITE_STEP,
    thesis_steps: 4096,
    doublings: 3,
    rungs: 11,
    brief: 0..8,
    origin: packing,
    truth: |case, origin, _| {
        Ok(grains_truth::<48>(
            case,
            origin,
            spring_dashpot(),
            FIELDS,
            1e-14,
        ))
    },
};

/// The same grains, viscoelastic, so that no force jumps and errors can fall over eight decades.
pub const VISCOELASTIC_PACKING: Case = Case {
    name: "viscoelastic packing",
    orders: ROOT,
    margin: HALF_WAY,
    thesis_step: GRANITE_STEP,
    thesis_steps: 4096,
    doublings: 5,
    rungs: 16,
    brief: 4..12,
    origin: viscoelastic_packing,
    truth: |case, origin, _| {
        Ok(grains_truth::<48>(
            case,
            origin,
            viscoelastic(),
            FIELDS,
            1e-18,
        ))
    },
};

/// Two bonded blocks under pressure, one sheared against the other.
pub const FAULT: Case = Case {
    name: "small sheared fault",
    orders: SMOOTH,
    margin: HALF_WAY,
    thesis_step: GRANITE_STEP,
    thesis_steps: 512,
    doublings: 2,
    rungs: 10,
    brief: 1..6,
    origin: fault::origin,
    truth: |case, origin, finest| extrapolation::limit(case, origin, finest - 3..finest + 1),
};

fn bonds(damping: f64) -> Draft {
    Draft::empty()
        .law(AdjustedKelvinVoigt {
            stiffness: GRANITE_STIFFNESS,
            damping,
        })
        .law(EulerBernoulli {
            stiffness: GRANITE_STIFFNESS,
            damping,
        })
}

/// Head of a scene; integrator and time step are set later.
fn start() -> Draft {
    Draft::open_box(Integrator::VelocityVerlet, GRANITE_STEP)
}

fn pair() -> Result<Origin, Failure> {
    let draft = start()
        .and(&bonds(1.0))
        .grain(
            Grain::at([0.0, 0.0], 1e-3)
                .moving([5.0, -20.0])
                .spinning(3e4),
        )
        .grain(
            Grain::at([1.8e-3, 0.0], 0.8e-3)
                .moving([-5.0, 20.0])
                .spinning(-1e4),
        )
        .bonded(0, 1);
    Origin::read(&draft)
}

fn beam() -> Result<Origin, Failure> {
    const NUMBER: usize = 8;
    let mut draft = start()
        .and(&bonds(10.0))
        .grain(Grain::at([0.0, 0.0], 1e-3).fixed());
    for i in 1..NUMBER {
        let along = i as f64 / (NUMBER - 1) as f64;
        let velocity = [0.0, 20.0 * along * along];
        draft = draft.grain(Grain::at([2e-3 * i as f64, 0.0], 1e-3).moving(velocity));
    }
    Origin::read(&(1..NUMBER).fold(draft, |draft, i| draft.bonded(i - 1, i)))
}

const YOUNG: f64 = 50e9;
const POISSON: f64 = 0.22;
const DISSIPATION: f64 = 1e-7;

fn viscoelastic_law() -> Draft {
    Draft::empty().law(Bshp {
        youngs_modulus: YOUNG,
        poissons_ratio: POISSON,
        dissipative_constant: DISSIPATION,
    })
}

/// Four grains in separate lanes, so that the largest error depends less on where within a step a
/// collision begins.
fn bouncing() -> Result<Origin, Failure> {
    let mut draft = start().and(&viscoelastic_law());
    for (lane, speed) in [10.0, 8.0, 12.0, 9.0].iter().enumerate() {
        let height = 3e-3 * lane as f64;
        draft = draft.grain(Grain::at([0.0, height], 1e-3).fixed());
        draft = draft.grain(Grain::at([4.05e-3, height], 1e-3).fixed());
        draft = draft.grain(Grain::at([2.02e-3, height], 1e-3).moving([*speed, 0.0]));
    }
    Origin::read(&draft)
}

fn number(value: f64) -> Df64 {
    Df64::from(value)
}

fn viscoelastic() -> Repulsion<Df64> {
    let nu = number(POISSON);
    Repulsion::Viscoelastic {
        modulus: number(YOUNG) / (number(1.0) - nu * nu),
        dissipation: number(DISSIPATION),
    }
}

const DAMPING: f64 = 10.0;
const VISCOSITY: f64 = 10.0;
const WELL: f64 = 1e3;
const HEIGHT: f64 = 10e-3;
/// Stokes drag over radius, and stiffness and centre of the well.
const FIELDS: [f64; 3] = [6.0 * PI * VISCOSITY, WELL, 0.5 * HEIGHT];

fn packing() -> Result<Origin, Failure> {
    falling(&Draft::empty().law(KelvinVoigt {
        stiffness: GRANITE_STIFFNESS,
        damping: DAMPING,
    }))
}

fn viscoelastic_packing() -> Result<Origin, Failure> {
    falling(&viscoelastic_law())
}

/// Twelve grains of different sizes on a perturbed square lattice, all moving towards its centre.
fn falling(law: &Draft) -> Result<Origin, Failure> {
    let mut draft = start()
        .and(law)
        .with("box.height", HEIGHT)
        .creeping_drag(VISCOSITY)
        .harmonic_well(WELL);
    let mut random = Pcg64::new(1, 0);
    for i in 0..12 {
        let place = [i % 4, 1 + i / 4].map(|k| {
            let jitter = random.random::<f64>() - 0.5;
            2.05e-3 * (f64::from(k) - 1.5) + 0.05e-3 * jitter
        });
        let velocity = place.map(|x| -1e4 * x);
        let radius = 0.8e-3 + 0.2e-3 * random.random::<f64>();
        draft =
            draft.grain(Grain::at([place[0], 0.5 * HEIGHT + place[1]], radius).moving(velocity));
    }
    Origin::read(&draft)
}

fn spring_dashpot() -> Repulsion<Df64> {
    Repulsion::SpringDashpot {
        stiffness: number(GRANITE_STIFFNESS),
        damping: number(DAMPING),
    }
}

/// Positions at the end, from an integration from event to event.
fn ending<const N: usize>(
    case: &Case,
    origin: &Origin,
    repulsion: Repulsion<Df64>,
    fields: [f64; 3],
    (slices, tolerance): (u32, f64),
) -> Vec<[Df64; 2]> {
    let p = &origin.particles;
    let grain = |i: usize| grains::Grain {
        radius: number(p.radius[i]),
        inverse_mass: if p.role[i] == Role::Fixed {
            number(0.0)
        } else {
            number(1.0) / (4.0 / 3.0 * PI * DENSITY * p.radius[i].powi(3))
        },
    };
    let [drag, stiffness, centre] = fields.map(number);
    let grains = Grains {
        grains: (0..p.len()).map(grain).collect(),
        repulsion,
        drag,
        well: [stiffness, centre],
    };
    let start: [Df64; N] = std::array::from_fn(|at| {
        let (x, v) = (p.position[at / 4], p.velocity[at / 4]);
        number([x.x, x.y, v.x, v.y][at % 4])
    });
    let end = grains.advance(start, number(case.end()), slices, number(tolerance));
    end.chunks_exact(4)
        .map(|grain| [grain[0], grain[1]])
        .collect()
}

/// The reference solution; its error is estimated by a second one with a looser tolerance and other
/// steps.
fn grains_truth<const N: usize>(
    case: &Case,
    origin: &Origin,
    repulsion: Repulsion<Df64>,
    fields: [f64; 3],
    tolerance: f64,
) -> Truth {
    let truth = ending::<N>(case, origin, repulsion, fields, (96, tolerance));
    let rough = ending::<N>(case, origin, repulsion, fields, (128, 1e3 * tolerance));
    compared(origin, truth, rough)
}

fn compared(origin: &Origin, truth: Vec<[Df64; 2]>, rough: Vec<[Df64; 2]>) -> Truth {
    let pairs = truth.iter().zip(rough);
    let off = largest(pairs.map(|(a, b)| origin.distance(*a, b)));
    origin.truth(truth, off)
}

const SOFT: f64 = 2e4;
const GRAVITY: f64 = 9.81;
const FRICTION: f64 = 0.35;
const BALL: f64 = 5e-3;

/// A ball near the top of a fixed one, rolling downhill.
fn rolling() -> Result<Origin, Failure> {
    let law = Draft::empty()
        .law(KelvinVoigt {
            stiffness: SOFT,
            damping: 2.0,
        })
        .law(CundallStrackTruncated {
            friction: FRICTION,
            stiffness: SOFT,
        })
        .gravity(GRAVITY);
    let (distance, speed) = (2.0 * BALL - 0.7e-6, 0.15);
    let (sine, cosine) = 0.3_f64.sin_cos();
    let draft = start()
        .and(&law)
        .grain(
            Grain::at([distance * sine, distance * cosine], BALL)
                .moving([speed * cosine, -speed * sine])
                .spinning(-speed / BALL),
        )
        .grain(Grain::at([0.0, 0.0], BALL).fixed());
    Origin::read(&draft)
}

fn rolled(case: &Case, origin: &Origin, (slices, tolerance): (u32, f64)) -> ([Df64; 2], u32) {
    let ball = Rolling {
        radius: number(BALL),
        fixed_radius: number(BALL),
        mass: number(4.0 / 3.0 * PI * DENSITY * BALL.powi(3)),
        gravity: number(GRAVITY),
        stiffness: number(SOFT),
        damping: number(2.0),
        tangential_stiffness: number(SOFT),
        friction: number(FRICTION),
    };
    let p = &origin.particles;
    let vector = |v: gouge_common::geometry::Vec2| [number(v.x), number(v.y)];
    ball.advance(
        vector(p.position[0]),
        (vector(p.velocity[0]), number(p.angular_velocity[0])),
        number(case.end()),
        slices,
        number(tolerance),
    )
}

fn rolling_truth(case: &Case, origin: &Origin, _: u32) -> Result<Truth, Failure> {
    let (truth, slips) = rolled(case, origin, (192, 1e-18));
    if slips == 0 {
        return Err(Failure::Oracle("the ball never slips".to_owned()));
    }
    let (rough, _) = rolled(case, origin, (256, 1e-16));
    let fixed = [number(0.0); 2];
    Ok(compared(origin, vec![truth, fixed], vec![rough, fixed]))
}
