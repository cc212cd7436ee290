//! The stability map, from individual runs.

use super::amplification::geometric;
use super::modes::{RADIUS, integrator_name, mass};
use super::running::grows;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Style,
    Table, thesis,
};
use crate::oracles::amplification::{Method, crossings, spectral_radius};
use crate::scenes::events::held;
use crate::scenes::{Draft, Grain};
use gouge_dem::laws::{CundallStrackTruncated, KelvinVoigt};
use rayon::prelude::*;
use std::f64::consts::PI;

/// The checks of this file.
pub fn checks() -> Vec<Check> {
    let oracle = "Largest eigenvalue of the one-step matrix";
    let map = |id, scene, effort, measure| Check {
        id,
        claim: "Over time steps and damping ratios, every run more than half a per cent from the theoretical stability limit grows or does not grow as predicted.",
        equations: thesis("(8), (17), (55)-(58), (67)"),
        scene,
        oracle,
        norm: "Number of runs on the wrong side",
        origin: Origin::Exact,
        reason: "The motion is linear; modes that change by less than 2 % in the longest blocks of 16384 steps lie within the excluded band",
        effort,
        measure,
    };
    let slipping = |id, scene, effort, measure| Check {
        id,
        claim: "A sticking contact grows exactly where theory predicts growth of its spring (Beeman: up to w dt = 1.096 and again above 1.309), for every stiffness ratio and friction coefficient, and slip limits the growth.",
        equations: thesis("(36), (42), (55)-(58)"),
        scene,
        oracle,
        norm: "Number of runs on the wrong side or beyond the bound",
        origin: Origin::Exact,
        reason: "The spin obeys the linear equation until the contact slips. A spin beyond 2/h + 5 h, in units of the spin at the friction limit, is reversed by the slipping contact with every method",
        effort,
        measure,
    };
    vec![
        map(
            "time-step.map.coarse",
            "A grain in a harmonic well with drag: 5 integrators, 12 damping ratios from 0.005 to 10, 12 steps",
            Effort::Thorough,
            coarse,
        ),
        map(
            "time-step.map.fine",
            "The same with 47 damping ratios from 0.005 to 10 and 47 steps: 11045 runs",
            Effort::Report,
            fine,
        ),
        slipping(
            "time-step.map.slip",
            "A spinning grain between two fixed ones: 5 integrators, 6 steps, 3 stiffness ratios, 2 friction coefficients",
            Effort::Thorough,
            few_slips,
        ),
        slipping(
            "time-step.map.slips",
            "The same with 16 steps, 5 stiffness ratios from 0.1 to 100 and 4 friction coefficients: 1600 runs",
            Effort::Report,
            slips,
        ),
    ]
}

/// Half-width of the band around the limit in which no run is judged.
const BAND: f64 = 0.005;
/// Growth per step that counts as none, because the longest runs cannot detect it.
const NEUTRAL: f64 = 1e-7;
/// Smallest and largest damping ratio, and longest step in units of 1/w.
const LEAST: f64 = 0.005;
const MOST: f64 = 10.0;
const LONGEST: f64 = 3.9;

/// Whether the motion of a grain of unit frequency in a well grows.
fn runs_away(method: Method, zeta: f64, step: f64) -> Result<bool, Failure> {
    let viscosity = 2.0 * zeta * mass() / (6.0 * PI * RADIUS);
    let draft = Draft::open_box(integrator_name(method), step)
        .with("box.height", 1e-300)
        .harmonic_well(mass())
        .creeping_drag(viscosity)
        .with("output.energy", false)
        .grain(Grain::at([0.0, 1.0], RADIUS));
    let mut world = draft.world()?;
    grows(|| {
        world.step()?;
        Ok(world.particles().position[0].y)
    })
}

/// A run: damping ratio, time step, and whether it grew.
type Run = (f64, f64, bool);

/// Runs over a grid, for one method.
fn grid(method: Method, number: usize) -> Result<Vec<Run>, Failure> {
    let points: Vec<(f64, f64)> = geometric(LEAST, MOST, number)
        .flat_map(|zeta| geometric(0.031, LONGEST, number).map(move |step| (zeta, step)))
        .collect();
    let run = |&(zeta, step): &(f64, f64)| Ok((zeta, step, runs_away(method, zeta, step)?));
    points.par_iter().map(run).collect()
}

/// Whether a mode grows by theory; none within the band around a limit.
fn verdict(method: Method, zeta: f64, step: f64) -> Option<bool> {
    let grows = |step: f64| spectral_radius(method, step * step, 2.0 * zeta * step) > 1.0 + NEUTRAL;
    let sides = [1.0 - BAND, 1.0, 1.0 + BAND].map(|factor| grows(step * factor));
    (sides[0] == sides[1] && sides[1] == sides[2]).then_some(sides[1])
}

fn map(number: usize) -> Outcome {
    let (mut wrong, mut exhibits) = (0, Vec::new());
    for method in Method::ALL {
        let runs = grid(method, number)?;
        let disagrees =
            |run: &&Run| verdict(method, run.0, run.1).is_some_and(|grows| grows != run.2);
        wrong += runs.iter().filter(disagrees).count();
        exhibits.push(Exhibit::Figure(picture(method, &runs)));
    }
    Ok(Measurement::count(wrong).showing(exhibits))
}

fn coarse() -> Outcome {
    map(12)
}

fn fine() -> Outcome {
    map(47)
}

/// Modes of the thesis at its time step of 10 ns: damping ratio and step in units of 1/w.
fn operating_points() -> [[f64; 2]; 3] {
    use super::modes::Mode;
    [Mode::Axial, Mode::Bending, Mode::Shearing].map(|mode| {
        let [k, c] = mode.rates([1e7, 10.0]);
        [0.5 * c / k.sqrt(), 10e-9 * k.sqrt()]
    })
}

fn picture(method: Method, runs: &[Run]) -> Figure {
    let cells = |grew| {
        let points = runs.iter().filter(move |run: &&Run| run.2 == grew);
        points.map(|run| [run.0, run.1])
    };
    let name = integrator_name(method);
    let mut curves = vec![
        Curve::new("does not grow", Style::Cells, cells(false)),
        Curve::new("grows", Style::Cells, cells(true)),
    ];
    let boundaries = boundaries(method);
    curves.extend(
        boundaries
            .into_iter()
            .map(|line| Curve::dashed("theory", line)),
    );
    let thesis = operating_points().to_vec();
    curves.push(Curve::marks("bonds of the thesis, 10 ns", thesis));
    Figure::new(
        format!("Runs with {name} grow beyond the theoretical limit and nowhere else"),
        Axis::logarithmic("damping ratio", ""),
        Axis::logarithmic("time step in units of 1/w", ""),
        curves,
    )
}

/// The first, second, ... step at which growth begins or ends, against the damping ratio.
fn boundaries(method: Method) -> Vec<Vec<[f64; 2]>> {
    let mut lines: Vec<Vec<[f64; 2]>> = Vec::new();
    for zeta in geometric(LEAST, MOST, 60) {
        for (n, step) in crossings(method, zeta, LONGEST).into_iter().enumerate() {
            if n == lines.len() {
                lines.push(Vec::new());
            }
            lines[n].push([zeta, step]);
        }
    }
    lines
}

/// A contact: stiffness ratio, friction coefficient, time step in units of 1/w.
type Contact = (f64, f64, f64);

/// A spinning grain between two fixed ones: whether its spin grows from far below the friction limit,
/// and its largest spin in units of the spin at the limit.
///
/// Two springs of lever arm r act on the moment of inertia 2/5 m r^2: w^2 = 5 k_t/m.
fn slip(method: Method, (ratio, friction, scaled): Contact) -> Result<(bool, f64), Failure> {
    let (k_n, gap) = (1e7, 1.999 * RADIUS);
    let k_t = ratio * k_n;
    let w = (5.0 * k_t / mass()).sqrt();
    let limit = friction * k_n * (2.0 * RADIUS - gap);
    // The initial amplitude of the spring is 1e-6 of the displacement at the limit.
    let spin = 1e-6 * limit / k_t / RADIUS * w;
    let draft = held(integrator_name(method), scaled / w, gap, spin)
        .law(KelvinVoigt {
            stiffness: k_n,
            damping: 0.0,
        })
        .law(CundallStrackTruncated {
            friction,
            stiffness: k_t,
        })
        .with("output.energy", false);
    let mut world = draft.world()?;
    let mut most: f64 = 0.0;
    for _ in 0..STEPS {
        world.step()?;
        most = most.max(world.particles().angular_velocity[0].abs());
    }
    Ok((most > 1e3 * spin, most / (1e6 * spin)))
}

/// Steps of a run with slip: the slowest growth, Beeman's at w dt = 0.4, is e-fold in 470 steps.
const STEPS: usize = 8000;

/// Bound of the largest spin, in units of the spin whose spring reaches the limit, for a step in units
/// of 1/w. A spin beyond 2/h takes the spring within one step from any stretch to the opposite limit,
/// up to 5/6 h for the acceleration; in the three steps until the force has changed its sign, no method
/// adds more than 4/3 h per step.
fn bound(scaled: f64) -> f64 {
    2.0 / scaled + 5.0 * scaled
}

fn slipping(scaled: &[f64], ratios: &[f64], frictions: &[f64]) -> Outcome {
    let contacts: Vec<Contact> = ratios
        .iter()
        .flat_map(|&ratio| frictions.iter().map(move |&friction| (ratio, friction)))
        .flat_map(|(ratio, friction)| scaled.iter().map(move |&h| (ratio, friction, h)))
        .collect();
    let (mut wrong, mut curves) = (0, Vec::new());
    let mut table = Table::new(
        "Runs of a sticking contact that grew, and the largest spin that slip allowed",
        &[
            "integrator",
            "runs",
            "grew",
            "largest spin in units of the spin at the limit",
        ],
    );
    for method in Method::ALL {
        let runs = contacts
            .par_iter()
            .map(|&contact| slip(method, contact))
            .collect::<Result<Vec<(bool, f64)>, Failure>>()?;
        let pairs = || contacts.iter().zip(&runs);
        wrong += pairs()
            .filter(|&(contact, &(grew, most))| {
                verdict(method, 0.0, contact.2) != Some(grew) || most > bound(contact.2)
            })
            .count();
        let largest = runs.iter().map(|run| run.1).fold(0.0, f64::max);
        table.push([
            integrator_name(method).to_owned(),
            runs.len().to_string(),
            runs.iter().filter(|run| run.0).count().to_string(),
            format!("{largest:.3e}"),
        ]);
        let points = pairs().map(|(contact, run)| [contact.2, run.1]);
        curves.push(Curve::marks(integrator_name(method), points));
    }
    let plot = Figure::new(
        "Growth in a sticking contact is limited by slip, for every stiffness ratio and friction coefficient",
        Axis::logarithmic("time step in units of 1/w", ""),
        Axis::logarithmic("largest spin in units of the spin at the limit", ""),
        curves,
    );
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table), Exhibit::Figure(plot)]))
}

fn few_slips() -> Outcome {
    slipping(
        &[0.4, 0.7, 1.2, 1.8, 1.95, 2.05],
        &[0.1, 10.0, 100.0],
        &[0.1, 0.7],
    )
}

fn slips() -> Outcome {
    let scaled: Vec<f64> = geometric(0.4, 1.98, 12)
        .chain(geometric(2.02, 3.0, 4))
        .collect();
    slipping(
        &scaled,
        &[0.1, 0.5, 1.0, 10.0, 100.0],
        &[0.1, 0.3, 0.7, 1.5],
    )
}
