//! Loads under which a bond breaks.

use super::modes::bond;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, thesis,
};
use crate::oracles::beams::Springs;
use crate::scenes::{Bond, Draft, Grain};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::ZhangEckert;
use std::f64::consts::{PI, TAU};

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "beams.breaking-load",
            claim: "A bond breaks where its load leaves the strength ellipse of its smallest cross-section, in every load direction.",
            equations: thesis("(33), (43)-(50)"),
            scene: "Bonded pairs in 16 prescribed states of stretch and rotation: spheres of 1 mm, of 1 and 0.7 mm, with strength factors 1, 0.9 and 1.1",
            oracle: "Semi-axes pi (s r_min)^2 times 280 and 168 MPa: 879.645943 N and 527.787566 N for 1 mm, independent of the stiffness",
            norm: "Relative error of the load at which the bond breaks, found by bisection",
            origin: Origin::Exact,
            reason: "The state loses four digits, because a displacement of 0.09 mm is the difference of distances of 2 mm: 2^-52 x 2 / 0.09. Forces add a few roundings: 32 units of that",
            effort: Effort::Quick,
            measure: loads,
        },
        Check {
            id: "beams.breaking-time",
            claim: "A bond pulled apart at constant rates breaks in the first step whose final load, including the viscous part, lies outside the ellipse.",
            equations: thesis("(33)-(34), (43)-(50)"),
            scene: "Two spheres of 1 mm, too heavy to be slowed down, move apart and rotate in 16 proportions until their bond breaks, with three time steps",
            oracle: "Root of the breaking condition along the prescribed motion, by bisection",
            norm: "Number of runs in which the bond breaks in another step",
            origin: Origin::Exact,
            reason: "In every run the moment of breaking differs from a multiple of the step by more than the rounding of the state",
            effort: Effort::Quick,
            measure: times,
        },
    ]
}

const SPRINGS: Springs = Springs {
    normal: 1e7,
    tangential: 0.9e7,
};
const STRENGTHS: [f64; 2] = [280e6, 168e6];
const DIRECTIONS: usize = 16;

fn direction(number: usize) -> [f64; 2] {
    // Slightly off the axes, so that no direction is special.
    let (s, c) = (TAU * number as f64 / DIRECTIONS as f64 + 1e-3).sin_cos();
    [c, s]
}

/// Semi-axes of the ellipse of forces in N.
fn axes(radii: [f64; 2], factor: f64) -> [f64; 2] {
    let area = PI * (factor * radii[0].min(radii[1])).powi(2);
    STRENGTHS.map(|strength| strength * area)
}

fn yielding() -> Draft {
    Draft::empty().law(ZhangEckert {
        normal_strength: STRENGTHS[0],
        tangential_strength: STRENGTHS[1],
    })
}

/// Whether a bond breaks under the given normal and tangential forces in N.
///
/// The state sets the forces: D = D_0 + F_n / k_n, and with both ends rotated by the same angle, F_t =
/// -(r_i^2 + r_j^2) k_t phi / D.
fn breaks(radii: [f64; 2], factor: f64, load: [f64; 2]) -> Result<bool, Failure> {
    let rest = radii[0] + radii[1];
    let distance = rest + load[0] / SPRINGS.normal;
    let lever = radii[0].powi(2) + radii[1].powi(2);
    let angle = -load[1] * distance / (lever * SPRINGS.tangential);
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
        .and(&bond(
            SPRINGS,
            Springs {
                normal: 10.0,
                tangential: 10.0,
            },
        ))
        .and(&yielding())
        .grain(Grain::at([0.0; 2], radii[0]).turned(angle))
        .grain(Grain::at([distance, 0.0], radii[1]).turned(angle))
        .bond(
            Bond::between(0, 1)
                .of_strength(factor)
                .of_length(rest)
                .since([0.0, -PI]),
        );
    let mut world = draft.world()?;
    world.evaluate_if_pending()?;
    Ok(world.bonds().is_some_and(|strong| strong.is_empty()))
}

fn loads() -> Outcome {
    let cases = [
        ([1e-3, 1e-3], 1.0),
        ([1e-3, 0.7e-3], 0.9),
        ([0.7e-3, 1e-3], 1.1),
    ];
    let (mut measured, mut marks) = (Vec::new(), Vec::new());
    for (radii, factor) in cases {
        let axes = axes(radii, factor);
        for number in 0..DIRECTIONS {
            let [c, s] = direction(number);
            let at = |scale: f64| [axes[0] * c * scale, axes[1] * s * scale];
            let (mut whole, mut broken) = (0.5, 1.5);
            for _ in 0..50 {
                let middle = 0.5 * (whole + broken);
                if breaks(radii, factor, at(middle))? {
                    broken = middle;
                } else {
                    whole = middle;
                }
            }
            let strain = axes[0] / SPRINGS.normal / (radii[0] + radii[1]);
            measured.push(Measurement::relative(
                1.0,
                broken,
                32.0 * f64::EPSILON / strain,
            ));
            if factor == 1.0 {
                marks.push(at(broken));
            }
        }
    }
    Ok(Measurement::worst(measured).showing([Exhibit::Figure(ellipse(marks))]))
}

fn ellipse(marks: Vec<[f64; 2]>) -> Figure {
    let axes = axes([1e-3; 2], 1.0);
    let point = |n: u32| {
        let (s, c) = (TAU * f64::from(n) / 120.0).sin_cos();
        [axes[0] * c, axes[1] * s]
    };
    Figure::new(
        "Bonds of spheres of 1 mm break on the strength ellipse",
        Axis::linear("normal force, positive in tension", "N"),
        Axis::linear("tangential force", "N"),
        vec![
            Curve::line("closed form", (0..=120).map(point)),
            Curve::marks("kernel", marks),
        ],
    )
}

const RADIUS: f64 = 1e-3;
const DASHPOTS: Springs = Springs {
    normal: 10.0,
    tangential: 7.0,
};
/// Time in s in which the elastic load alone would reach the ellipse.
const DURATION: f64 = 1e-4;

/// Rates of the distance in m/s and of both angles in rad/s that load a bond in the given direction.
fn rates(number: usize) -> [f64; 2] {
    let (axes, [c, s]) = (axes([RADIUS; 2], 1.0), direction(number));
    let stretch = axes[0] * c / SPRINGS.normal / DURATION;
    let turn = -axes[1] * s / (RADIUS * SPRINGS.tangential) / DURATION;
    [stretch, turn]
}

/// Time in s at which the load under constant rates leaves the ellipse.
fn instant([stretch, turn]: [f64; 2]) -> f64 {
    let axes = axes([RADIUS; 2], 1.0);
    let outside = |time: f64| {
        let normal = SPRINGS.normal * stretch * time + DASHPOTS.normal * stretch;
        let torque = RADIUS * RADIUS * turn * (SPRINGS.tangential * time + DASHPOTS.tangential);
        let tangential = 2.0 * torque / (2.0 * RADIUS + stretch * time);
        (normal / axes[0]).hypot(tangential / axes[1]) >= 1.0
    };
    let (mut low, mut high) = (0.0, 2.0 * DURATION);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if outside(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

/// Number of steps until the bond has broken.
fn breaking_step([stretch, turn]: [f64; 2], step: f64) -> Result<u64, Failure> {
    const HEAVY: f64 = 1e20;
    let draft = Draft::open_box(Integrator::VelocityVerlet, step)
        .and(&bond(SPRINGS, DASHPOTS))
        .and(&yielding())
        .grain(
            Grain::at([0.0; 2], RADIUS)
                .moving([-0.5 * stretch, 0.0])
                .spinning(turn)
                .of_density(HEAVY),
        )
        .grain(
            Grain::at([2.0 * RADIUS, 0.0], RADIUS)
                .moving([0.5 * stretch, 0.0])
                .spinning(turn)
                .of_density(HEAVY),
        )
        .bonded(0, 1);
    let mut world = draft.world()?;
    while world.bonds().is_some_and(|strong| !strong.is_empty()) {
        world.step()?;
        if world.time() > 2.0 * DURATION {
            return Err(Failure::Oracle("the bond does not break".to_owned()));
        }
    }
    Ok(world.steps())
}

fn times() -> Outcome {
    let mut wrong = 0;
    let mut late: [Vec<[f64; 2]>; 3] = Default::default();
    for number in 0..DIRECTIONS {
        let rates = rates(number);
        let exact = instant(rates);
        for (steps, late) in [1000.0, 3000.0, 9000.0].into_iter().zip(&mut late) {
            let step = DURATION / steps;
            let broken = breaking_step(rates, step)?;
            wrong += usize::from(broken != (exact / step).ceil() as u64);
            late.push([
                number as f64 / DIRECTIONS as f64,
                broken as f64 * step - exact,
            ]);
        }
    }
    let names = ["0.1 us", "0.033 us", "0.011 us"];
    let curve = |(points, name): (Vec<[f64; 2]>, &str)| Curve::marks(name, points);
    let plot = Figure::new(
        "A bond breaks at most one step after its load has left the ellipse",
        Axis::linear("direction of the load in turns", ""),
        Axis::linear("time from the exact moment to breaking", "s"),
        late.into_iter().zip(names).map(curve).collect(),
    );
    Ok(Measurement::count(wrong).showing([Exhibit::Figure(plot)]))
}
