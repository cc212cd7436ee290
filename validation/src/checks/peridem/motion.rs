//! Momentum, rotation, and the order of the energy error.

use super::grains::{balance, block, bonds_only, breakable, contact, disc, rough, world};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, peridem,
};
use gouge_common::geometry::Vec2;
use gouge_peridem::forces::{Settings, Workspace};
use gouge_peridem::grain::Grain;
use gouge_peridem::material::Weight;
use gouge_peridem::world::World;
use std::time::Instant;

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "peridem.motion.rotation",
            claim: "A grain that is moved and turned by a right angle has no force on any node.",
            equations: peridem("(3.1)-(3.2)"),
            scene: "A disc of 500 nodes, moved by 7 mm and turned by 90 degrees",
            oracle: "Bonds keep their lengths",
            norm: "Largest force density on a node, in units of the sum of the force densities of its bonds if each were stretched by one",
            origin: Origin::Exact,
            reason: "Squared lengths are compared with an error of 4e-16 of displacements that are up to 9000 times a bond squared",
            effort: Effort::Quick,
            measure: rotation,
        },
        Check {
            id: "peridem.motion.momentum",
            claim: "Momentum is kept at oblique contacts of unequal nodes with damping and friction; without friction angular momentum is kept, too.",
            equations: peridem("(4.1)-(4.6), P15, P17"),
            scene: "A rough grain hits a disc at rest off the centre at 20 m/s, with damping 0.5 and friction 0.8, and with damping alone; 1200 steps",
            oracle: "Newton's third law",
            norm: "Largest change, in units of the momentum of the moving grain, of angular momentum times the radius",
            origin: Origin::Exact,
            reason: "1200 steps round 200 velocities: 1200 times 1.1e-16 if all in one direction, 1.3e-13; a bound of 1e-12",
            effort: Effort::Quick,
            measure: momentum,
        },
        Check {
            id: "peridem.motion.energy-order",
            claim: "The error of the energy is of second order in the step: in an elastic collision, in free vibration, and while bonds break.",
            equations: peridem("section 6.1, (2.1), (4.1), Q6"),
            scene: "A disc hits a disc at 20 m/s; a bar that was stretched; a disc that is torn apart; each with 4 steps from 0.4 of the critical one down",
            oracle: "Conservation of energy, with the energy of broken bonds as part of it",
            norm: "Distance of the observed order from 2, by least squares over the steps",
            origin: Origin::Convergent,
            reason: "The next term is of fourth order in the step; contacts begin and bonds break between steps, which adds errors of alternating sign: 0.5 for these four steps",
            effort: Effort::Thorough,
            measure: energy_order,
        },
        Check {
            id: "peridem.motion.work-precision",
            claim: "Half the step costs twice the time and leaves a quarter of the energy error.",
            equations: peridem("section 6.1"),
            scene: "The three scenes of the order of the energy error, seven steps each",
            oracle: "Conservation of energy",
            norm: "Number of scenes whose error at the shortest step is not below 1e-3 of that at the longest one",
            origin: Origin::Convergent,
            reason: "The longest step is 64 times the shortest: 64^2 = 4096",
            effort: Effort::Report,
            measure: work_precision,
        },
    ]
}

fn rotation() -> Outcome {
    let grain = disc(8e-5, Vec2::zero(), Weight::Constant)?;
    let settings = bonds_only(1e-9);
    let world = world(&[grain], settings.clone(), |_, _| Vec2::zero())?;
    let mut state = world.state().clone();
    for place in &mut state.places {
        let turned = place.reference.perpendicular() + Vec2::new(7e-3, -3e-3);
        place.displacement = turned - place.reference;
    }
    let mut workspace = Workspace::new(world.grains(), &settings, &state);
    workspace.evaluate(world.grains(), &settings, &mut state);
    let grains = world.grains();
    let mut sums = vec![0.0; grains.nodes()];
    for (earlier, later, _) in state.bonds.all() {
        let stiffness = grains.of(later).constants.stiffness;
        sums[earlier] += stiffness * grains.area[later];
        sums[later] += stiffness * grains.area[earlier];
    }
    let all = workspace
        .force
        .iter()
        .zip(sums)
        .map(|(force, sum)| Measurement::scaled(0.0, force.norm(), sum, 1e-11));
    Ok(Measurement::worst(all).into())
}

fn momenta(world: &World) -> [f64; 3] {
    let (grains, state) = (world.grains(), world.state());
    let mut sums = [0.0; 3];
    for node in 0..grains.nodes() {
        let own = state.velocity[node] * grains.mass(node);
        let angular = state.places[node].position().cross(own);
        for (sum, part) in sums.iter_mut().zip([own.x, own.y, angular]) {
            *sum += part;
        }
    }
    sums
}

fn momentum() -> Outcome {
    const SIZE: f64 = 2e-4;
    let mut all = Vec::new();
    for (friction, kept) in [(0.8, 2), (0.0, 3)] {
        let grains = [
            disc(SIZE, Vec2::zero(), Weight::Constant)?,
            rough(SIZE, Vec2::new(0.7e-3, 2.2e-3), 281)?,
        ];
        let settings = Settings {
            contact: Some(contact(3e-4, 0.5, friction)?),
            ..bonds_only(5e-8)
        };
        let moving = |grain: usize, _| Vec2::new(0.0, if grain == 1 { -20.0 } else { 0.0 });
        let mut world = world(&grains, settings, moving)?;
        let before = momenta(&world);
        for _ in 0..1200 {
            world.step()?;
        }
        let after = momenta(&world);
        let unit = before[1].abs();
        for (k, scale) in [unit, unit, unit * 1e-3].into_iter().enumerate().take(kept) {
            all.push(Measurement::scaled(before[k], after[k], scale, 1e-12));
        }
        if world.state().work.damping <= 0.0 {
            return Err(Failure::Oracle("the grains did not meet".to_owned()));
        }
    }
    Ok(Measurement::worst(all).into())
}

/// A scene of the order of the energy error: its grains, contact radius, velocities, duration, longest step.
struct Scene {
    name: &'static str,
    grains: Vec<Grain>,
    radius: Option<f64>,
    velocity: fn(usize, Vec2) -> Vec2,
    duration: f64,
    longest_step: f64,
}

fn scenes() -> Result<[Scene; 3], Failure> {
    const SIZE: f64 = 2e-4;
    let bar = block([40, 8], SIZE, 3.015, Weight::Constant)?;
    Ok([
        Scene {
            name: "collision",
            grains: vec![
                disc(SIZE, Vec2::zero(), Weight::Constant)?,
                disc(SIZE, Vec2::new(0.1e-3, 2.32e-3), Weight::Constant)?,
            ],
            radius: Some(3e-4),
            velocity: |grain, _| Vec2::new(0.0, if grain == 1 { -20.0 } else { 0.0 }),
            duration: 2.4e-5,
            longest_step: 1e-7,
        },
        Scene {
            name: "stretched bar",
            grains: vec![bar],
            radius: None,
            velocity: |_, place| Vec2::new(5e3 * place.x, 0.0),
            duration: 2.4e-5,
            longest_step: 6e-8,
        },
        Scene {
            name: "torn disc",
            grains: vec![breakable(disc(SIZE, Vec2::zero(), Weight::Constant)?)],
            radius: None,
            velocity: |_, place| Vec2::new(if place.x > 0.0 { 12.0 } else { -12.0 }, 0.0),
            duration: 1.2e-5,
            longest_step: 1e-7,
        },
    ])
}

/// Largest relative error of the energy, and the time of the run in s.
fn run(scene: &Scene, step: f64) -> Result<[f64; 2], Failure> {
    let contact = scene.radius.map(|radius| contact(radius, 0.0, 0.0));
    let settings = Settings {
        contact: contact.transpose()?,
        ..bonds_only(step)
    };
    let mut world = world(&scene.grains, settings, scene.velocity)?;
    let start = balance(&world);
    let samples = (scene.duration / scene.longest_step).round() as usize;
    let each = (scene.longest_step / step).round() as usize;
    let (mut error, mut seconds) = (0.0_f64, 0.0);
    for _ in 0..samples {
        let begin = Instant::now();
        for _ in 0..each {
            world.step()?;
        }
        seconds += begin.elapsed().as_secs_f64();
        error = error.max((balance(&world) / start - 1.0).abs());
    }
    Ok([error, seconds])
}

/// Slope of the logarithms of errors over those of steps.
fn slope(points: &[[f64; 2]]) -> f64 {
    let number = points.len() as f64;
    let logs = || points.iter().map(|[step, error]| [step.ln(), error.ln()]);
    let [x, y] = [0, 1].map(|k| logs().map(|p| p[k]).sum::<f64>() / number);
    let above: f64 = logs().map(|p| (p[0] - x) * (p[1] - y)).sum();
    let below: f64 = logs().map(|p| (p[0] - x).powi(2)).sum();
    above / below
}

fn energy_order() -> Outcome {
    let mut all = Vec::new();
    for scene in scenes()? {
        let mut points = Vec::new();
        for halving in 0..4 {
            let step = scene.longest_step / f64::from(1 << halving);
            let [error, _] = run(&scene, step)?;
            points.push([step, error]);
        }
        all.push(Measurement::absolute(2.0, slope(&points), 0.5));
    }
    Ok(Measurement::worst(all).into())
}

fn work_precision() -> Outcome {
    let mut curves = Vec::new();
    let mut wrong = 0;
    for scene in scenes()? {
        let mut points = Vec::new();
        for halving in 0..7 {
            let step = scene.longest_step / f64::from(1 << halving);
            let [error, seconds] = run(&scene, step)?;
            points.push([seconds, error]);
        }
        let is_small = points[6][1] < 1e-3 * points[0][1];
        wrong += usize::from(!is_small);
        curves.push(Curve::marked_line(scene.name, points));
    }
    let figure = Figure::new(
        "Largest error of the energy against run time, steps from the longest down to a 64th of it",
        Axis::logarithmic("run time", "s"),
        Axis::logarithmic("energy error, relative", ""),
        curves,
    );
    Ok(Measurement::count(wrong).showing([Exhibit::Figure(figure)]))
}
