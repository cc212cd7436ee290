//! Small vibrations: the critical step, modes, and stability on both sides.

use super::grains::{WEIGHTS, block, bonds_only, cloud, disc};
use crate::checks::random::Random;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    largest, peridem,
};
use crate::oracles::peridem::WEIGHTS as FUNCTIONS;
use gouge_common::geometry::Vec2;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::limits::BondLimits;
use gouge_peridem::material::Weight;
use gouge_peridem::state::State;
use gouge_peridem::world::{Beginning, World};

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "peridem.linear.step",
            claim: "The critical step is that of the largest frequency of the grain; the bound by row sums is far below it.",
            equations: peridem("section 6.1, (2.1), (3.2)"),
            scene: "Blocks and discs of 60 to 250 nodes, three weights, horizons of 3.015 and 4.015 spacings",
            oracle: "All eigenvalues of the assembled matrix, by faer",
            norm: "Largest relative error of the step",
            origin: Origin::Convergent,
            reason: "The method of Lanczos ends when the eigenvalue changes by less than 1e-10 in five products",
            effort: Effort::Thorough,
            measure: critical_step,
        },
        Check {
            id: "peridem.linear.mode",
            claim: "A grain that starts in one of its modes vibrates in it, with the frequency of velocity Verlet.",
            equations: peridem("section 6.1, (2.1), (3.2)"),
            scene: "A bar of 24 x 4 cells; its fourth, 20th and fastest mode with an amplitude of 1e-10 of a cell, 400 steps at 0.3 of the critical step",
            oracle: "Eigenvectors of the assembled matrix, by nalgebra; sin(w' dt/2) = w dt/2",
            norm: "Largest error of a displacement after the last step, in units of the largest one",
            origin: Origin::Convergent,
            reason: "The motion is linear up to a relative error of the amplitude over a cell, 1e-10, and the eigenvectors are known to 1e-13 over the gaps of their frequencies; 100 periods",
            effort: Effort::Quick,
            measure: modes,
        },
        Check {
            id: "peridem.linear.both-sides",
            claim: "Below the critical step noise stays bounded; above it, it grows.",
            equations: peridem("section 6.1"),
            scene: "A disc of 120 nodes with random displacements of 1e-12 m, 3000 steps at 0.999 and at 1.001 of the critical step",
            oracle: "Amplification of velocity Verlet: 1 below, and at 1.001 exp(2 arcosh(1.001)) = 1.094 per step in the fastest mode",
            norm: "Number of runs that grow by more than 1000 below, or by less than 1e6 above",
            origin: Origin::Exact,
            reason: "Below, the amplitude is at most 1/sqrt(1 - 0.999^2) = 22 times the first one; above, 1.094^3000 exceeds any number",
            effort: Effort::Thorough,
            measure: both_sides,
        },
    ]
}

fn limits(grain: &Grain) -> Result<BondLimits, Failure> {
    let grains = Grains::new(std::slice::from_ref(grain))?;
    let bonds = Bonds::within_horizon(&grains, |_, _, _| true)?;
    Ok(BondLimits::of(&grains, &bonds))
}

fn critical_step() -> Outcome {
    let mut all = Vec::new();
    let mut table = Table::new(
        "Critical steps in ns",
        &["grain", "weight", "exact", "by row sums", "ratio"],
    );
    for (weight, (name, function)) in WEIGHTS.into_iter().zip(FUNCTIONS) {
        let grains = [
            ("block 12 x 8, 3.015", block([12, 8], 1e-3, 3.015, weight)?),
            ("block 16 x 6, 4.015", block([16, 6], 1e-3, 4.015, weight)?),
            ("disc, 4.015", disc(1.6e-4, Vec2::zero(), weight)?),
        ];
        for (shape, grain) in grains {
            let expected = 2.0 / cloud(&grain, function).largest_frequency();
            let found = limits(&grain)?;
            all.push(Measurement::relative(expected, found.exact, 1e-9));
            let is_bound = found.row_sum <= expected;
            all.push(Measurement::count(usize::from(!is_bound)));
            let [exact, sums] = [found.exact, found.row_sum].map(|s| format!("{:.2}", 1e9 * s));
            let ratio = format!("{:.3}", found.exact / found.row_sum);
            table.push([shape.to_owned(), name.to_owned(), exact, sums, ratio]);
        }
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn modes() -> Outcome {
    const SIDE: f64 = 1e-3;
    const STEPS: i32 = 400;
    let (_, function) = FUNCTIONS[1];
    let grain = block([24, 4], SIDE, 3.015, Weight::Conic)?;
    let modes = cloud(&grain, function).modes();
    let fastest = modes.len().saturating_sub(1);
    let step = 0.3 * limits(&grain)?.exact;
    let mut all = Vec::new();
    for number in [6, 22, fastest] {
        let Some(mode) = modes.get(number) else {
            return Err(Failure::Oracle("no eigenvectors".to_owned()));
        };
        let size = mode
            .shape
            .iter()
            .flatten()
            .fold(0.0, |a: f64, b| a.max(b.abs()));
        let amplitude = 1e-10 * SIDE / size;
        let mut world = displaced(&grain, step, |node| {
            let [x, y] = mode.shape[node];
            Vec2::new(x, y) * amplitude
        })?;
        for _ in 0..STEPS {
            world.step()?;
        }
        let frequency = mode.squared_frequency.sqrt();
        let turn = 2.0 * (0.5 * frequency * step).asin();
        let factor = (turn * f64::from(STEPS)).cos();
        for (place, shape) in world.state().places.iter().zip(&mode.shape) {
            let found = [place.displacement.x, place.displacement.y];
            for (found, part) in found.into_iter().zip(shape) {
                let expected = amplitude * part * factor;
                all.push(Measurement::scaled(expected, found, amplitude * size, 1e-7));
            }
        }
    }
    Ok(Measurement::worst(all).into())
}

/// A grain at rest with displacements.
fn displaced(grain: &Grain, step: f64, of: impl Fn(usize) -> Vec2) -> Result<World, Failure> {
    let grains = Grains::new(std::slice::from_ref(grain))?;
    let bonds = Bonds::within_horizon(&grains, |_, _, _| true)?;
    let mut state = State::at_rest(&grains, bonds);
    for (node, place) in state.places.iter_mut().enumerate() {
        place.displacement = of(node);
    }
    Ok(World::new(
        grains,
        bonds_only(step),
        state,
        Beginning::Forces,
    )?)
}

/// Amplitude of the noise in m with which a grain begins.
const NOISE: f64 = 1e-12;

/// Largest displacement in m of a grain that begins with noise, by the number of steps, every 20 of them; infinite in a step
/// that fails.
fn noise(grain: &Grain, step: f64) -> Result<Vec<[f64; 2]>, Failure> {
    let mut random = Random::new(271);
    let noise: Vec<_> = (0..grain.position.len())
        .map(|_| Vec2::new(random.between(-NOISE, NOISE), random.between(-NOISE, NOISE)))
        .collect();
    let mut world = displaced(grain, step, |node| noise[node])?;
    let mut sizes = Vec::new();
    for number in 1..=3000 {
        if world.step().is_err() {
            sizes.push([f64::from(number), f64::INFINITY]);
            break;
        }
        if number % 20 == 0 {
            let places = world.state().places.iter();
            let size = largest(places.map(|place| place.displacement.norm()));
            sizes.push([f64::from(number), size]);
        }
    }
    Ok(sizes)
}

fn both_sides() -> Outcome {
    let mut wrong = 0;
    let mut curves = Vec::new();
    for (weight, (name, _)) in WEIGHTS.into_iter().zip(FUNCTIONS) {
        let grain = disc(1.8e-4, Vec2::zero(), weight)?;
        let exact = limits(&grain)?.exact;
        for (factor, is_stable) in [(0.999, true), (1.001, false)] {
            let sizes = noise(&grain, factor * exact)?;
            let most = largest(sizes.iter().map(|point| point[1]));
            let is_right = if is_stable {
                most < 1e3 * NOISE
            } else {
                most.is_nan() || most > 1e6 * NOISE
            };
            wrong += usize::from(!is_right);
            // Bonds are no longer linear beyond 1e-5 m.
            let is_shown = |[step, size]: &[f64; 2]| *step <= 600.0 && *size < 1e-5;
            let shown = sizes.into_iter().take_while(is_shown);
            let label = format!("{name}, {factor} of the critical step");
            curves.push(Curve::line(&label, shown));
        }
    }
    let rate = 2.0 * 1.001_f64.acosh();
    let growth = (0..=160).map(|number| {
        let step = f64::from(number);
        [step, NOISE * (rate * step).exp()]
    });
    curves.push(Curve::dashed("exp(2 arcosh(1.001)) per step", growth));
    let figure = Figure::new(
        "Noise in a disc on both sides of the critical step of its matrix",
        Axis::linear("step", ""),
        Axis::logarithmic("largest displacement", "m"),
        curves,
    );
    Ok(Measurement::count(wrong).showing([Exhibit::Figure(figure)]))
}
