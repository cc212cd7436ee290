//! How much a step amplifies vibrations of bonds and of damped contacts.

use super::grains::{MATERIAL, block, bonds_only, cloud, grain, world};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, peridem,
};
use crate::oracles::peridem::WEIGHTS as FUNCTIONS;
use gouge_common::geometry::Vec2;
use gouge_page::Guide;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::contact_law::{ContactLaw, ContactReading};
use gouge_peridem::contacts::Contact;
use gouge_peridem::forces::Settings;
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::Weight;
use gouge_peridem::state::State;
use gouge_peridem::world::{Beginning, World};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::SQRT_2;

pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "peridem.linear.amplification",
        claim: "A step amplifies the fastest mode of a grain, and a contact with and without damping, as the recursion of velocity Verlet with the damping of the previous velocity does: without damping up to w dt = 2 not at all, with the weakest damping from sqrt 2 on.",
        equations: peridem("section 6.1, (2.1), (4.1), (4.5), Q8"),
        scene: "A block of 12 x 6 cells in its fastest mode; two nodes of unequal areas that loads press together, damping ratios of 0, 0.05, 0.3 and 0.8; w dt from 0.3 to 2.2",
        oracle: "Largest root of z^3 + (a + q/2 - 2) z^2 + z - q/2 with a = (w dt)^2, q = 2 r_d w dt, w from areas and stiffness, or from the assembled matrix",
        norm: "Largest error of the amplification per step, which is that of the recursion that seven successive displacements obey",
        origin: Origin::Convergent,
        reason: "Distances are rounded by 1e-16 of the contact radius, 1e-10 of the amplitude; the equations for the recursion enlarge it by up to (w dt)^-4 = 123 and more where roots are close: 1e-7",
        effort: Effort::Thorough,
        measure: amplification,
    }]
}

/// Damping ratios with which contacts are measured.
const RATIOS: [f64; 4] = [0.0, 0.05, 0.3, 0.8];
/// Area of two nodes in m^2.
const AREAS: [f64; 2] = [4e-9, 3e-9];
/// Contact radius in m.
const RADIUS: f64 = 1e-4;
/// Stiffness in N/m^6.
const STIFFNESS: f64 = 2.8e23;
/// Amplitude in units of the contact radius, or of the side of a cell.
const AMPLITUDE: f64 = 1e-6;

/// Values of w dt. None is at a limit, where roots meet.
fn products() -> impl Iterator<Item = f64> {
    (0..20).map(|k| 0.3 + 0.1 * f64::from(k) + 0.013)
}

/// Largest modulus of the roots of a polynomial with the leading coefficient 1, given from the constant upwards.
fn largest_root(coefficients: &[f64]) -> f64 {
    let degree = coefficients.len();
    let companion = DMatrix::from_fn(degree, degree, |row, column| {
        let below = if row == column + 1 { 1.0 } else { 0.0 };
        let last = if column + 1 == degree {
            -coefficients[row]
        } else {
            0.0
        };
        below + last
    });
    let roots = companion.complex_eigenvalues();
    roots.iter().map(|root| root.norm()).fold(0.0, f64::max)
}

/// Amplification per step in closed form.
fn expected(product: f64, ratio: f64) -> f64 {
    let (a, q) = (product * product, 2.0 * ratio * product);
    if ratio > 0.0 {
        largest_root(&[-0.5 * q, 1.0, a + 0.5 * q - 2.0])
    } else {
        largest_root(&[1.0, a - 2.0])
    }
}

/// Amplification per step of the recursion of a degree that successive values obey.
fn found(values: &[f64], degree: usize) -> Result<f64, Failure> {
    let matrix = DMatrix::from_fn(degree, degree, |row, column| values[row + column]);
    let next = DVector::from_fn(degree, |row, _| -values[row + degree]);
    let solution = matrix.full_piv_lu().solve(&next);
    let unsolvable = || Failure::Oracle("the displacements obey several recursions".to_owned());
    Ok(largest_root(solution.ok_or_else(unsolvable)?.as_slice()))
}

/// Two nodes that loads press together, a tenth of the contact radius closer than it.
fn pressed(step: f64, ratio: f64, frequency: f64) -> Result<World, Failure> {
    let constants = MATERIAL.bond_constants(Weight::Constant, RADIUS)?;
    let depth = 0.1 * RADIUS;
    let node = |x: f64, own: f64, load: f64| Grain {
        load: vec![Vec2::new(load, 0.0)],
        ..grain(vec![Vec2::new(x, 0.0)], vec![own], constants)
    };
    let push = STIFFNESS * depth;
    let grains = [
        node(0.0, AREAS[0], push * AREAS[1]),
        node(RADIUS - depth, AREAS[1], -push * AREAS[0]),
    ];
    let law = ContactLaw {
        radius: RADIUS,
        damping_ratio: ratio,
        friction: 0.0,
        reading: ContactReading::Symmetric,
    };
    let settings = Settings {
        contact: Some(Contact {
            law,
            stiffness: vec![vec![STIFFNESS]],
            shares_sticking: false,
        }),
        ..bonds_only(step)
    };
    let speed = AMPLITUDE * RADIUS * frequency;
    world(&grains, settings, |grain, _| {
        Vec2::new(if grain == 0 { speed } else { 0.0 }, 0.0)
    })
}

/// Amplification of a contact.
fn of_contact(product: f64, ratio: f64) -> Result<f64, Failure> {
    let [x, y] = AREAS;
    let frequency = (STIFFNESS * (x + y) / MATERIAL.density).sqrt();
    let mut world = pressed(product / frequency, ratio, frequency)?;
    let mut values = Vec::new();
    for _ in 0..7 {
        let places = &world.state().places;
        values.push((places[1].displacement - places[0].displacement).x);
        world.step()?;
    }
    // The displacement is zero at first, and so tells nothing.
    found(&values[1..], if ratio > 0.0 { 3 } else { 2 })
}

/// A grain in its fastest mode.
struct FastestMode {
    grain: Grain,
    frequency: f64,
    shape: Vec<Vec2>,
}

impl FastestMode {
    fn new() -> Result<Self, Failure> {
        const SIDE: f64 = 1e-3;
        let grain = block([12, 6], SIDE, 3.015, Weight::Constant)?;
        let modes = cloud(&grain, FUNCTIONS[0].1).modes();
        let fastest = modes.last();
        let fastest = fastest.ok_or_else(|| Failure::Oracle("no eigenvectors".to_owned()))?;
        let shape = fastest.shape.iter().map(|&[x, y]| Vec2::new(x, y));
        let size = shape.clone().map(Vec2::norm).fold(0.0, f64::max);
        Ok(Self {
            frequency: fastest.squared_frequency.sqrt(),
            shape: shape
                .map(|part| part * (1e-4 * AMPLITUDE * SIDE / size))
                .collect(),
            grain,
        })
    }

    fn amplification(&self, product: f64) -> Result<f64, Failure> {
        let grains = Grains::new(std::slice::from_ref(&self.grain))?;
        let bonds = Bonds::within_horizon(&grains, |_, _, _| true)?;
        let mut state = State::at_rest(&grains, bonds);
        for (place, &part) in state.places.iter_mut().zip(&self.shape) {
            place.displacement = part;
        }
        let settings = bonds_only(product / self.frequency);
        let mut world = World::new(grains, settings, state, Beginning::Forces)?;
        let mut values = Vec::new();
        for _ in 0..4 {
            let places = world.state().places.iter().zip(&self.shape);
            values.push(
                places
                    .map(|(place, part)| place.displacement.dot(*part))
                    .sum(),
            );
            world.step()?;
        }
        found(&values, 2)
    }
}

fn amplification() -> Outcome {
    let mut all = Vec::new();
    let mut curves = Vec::new();
    for ratio in RATIOS {
        let fine = (0..200).map(|k| 0.3 + 0.01 * f64::from(k));
        let closed = fine.map(|product| [product, expected(product, ratio)]);
        curves.push(Curve::line(&format!("damping ratio {ratio}"), closed));
    }
    for ratio in RATIOS {
        let mut points = Vec::new();
        // Beyond w dt = 1.3 the strongest damping has passed all limits.
        for product in products().filter(|product| ratio < 0.5 || *product < 1.3) {
            let measured = of_contact(product, ratio)?;
            all.push(Measurement::absolute(
                expected(product, ratio),
                measured,
                1e-7,
            ));
            points.push([product, measured]);
        }
        curves.push(Curve::marks(&format!("contact, {ratio}"), points));
    }
    let mode = FastestMode::new()?;
    let mut points = Vec::new();
    for product in products() {
        let measured = mode.amplification(product)?;
        all.push(Measurement::absolute(
            expected(product, 0.0),
            measured,
            1e-7,
        ));
        points.push([product, measured]);
    }
    curves.push(Curve::marks("fastest mode of a block", points));
    let figure = Figure::new(
        "Amplification per step: runs, and the recursion of velocity Verlet with the damping of the previous velocity",
        Axis::linear("w dt", ""),
        Axis::linear("amplification", ""),
        curves,
    )
    .with_guide(Guide::vertical("sqrt 2, with damping", SQRT_2))
    .with_guide(Guide::vertical("2, without", 2.0));
    Ok(Measurement::worst(all).showing([Exhibit::Figure(figure)]))
}
