//! Each term of the balance against a value known by other means.

use crate::checks::scenes::{advance, head, particle, world};
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome};
use crate::oracles::oscillator::truncated_restitution;
use gouge_kernel::World;
use std::f64::consts::PI;

pub(super) fn checks() -> Vec<Check> {
    let check = |id, claim, equations| Check {
        id,
        claim,
        equations,
        scene: "",
        oracle: "",
        norm: "Relative difference",
        origin: Origin::Convergent,
        reason: "",
        effort: Effort::Quick,
        measure: || Err(Failure::Oracle(String::new())),
    };
    vec![
        Check {
            scene: "Two spheres of 1 mm head on with k = 1e7 kg/s^2, from damping ratio 0.1 to 1.5, beginning with an overlap of 1e-14 m",
            oracle: "(1 - e^2) of the kinetic energy in the frame of the pair, with e in closed form",
            reason: "Velocity Verlet with w dt = 2e-4: the end of the force lies within a step, which leaves (w dt)^2 of the loss, and the trapezoidal rule as much",
            measure: collision_heat,
            ..check(
                "closure.collision-heat",
                "The heat of a collision is what its restitution leaves of the kinetic energy.",
                "(36), (74), (78)",
            )
        },
        Check {
            scene: "A spinning and moving sphere in creeping flow, without contacts, for three decay times",
            oracle: "Kinetic energies that decay as exp(-2 t / T), with T = m / (6 pi eta r) and J / (8 pi eta r^3)",
            reason: "Velocity Verlet with 20 000 steps: second order, C below one: (3 / 20 000)^2",
            measure: drag_heat,
            ..check(
                "closure.drag-heat",
                "The heat of the medium is the kinetic energy that creeping flow takes, of translation and of rotation.",
                "(17)-(19), (74)",
            )
        },
        Check {
            scene: "Two bonded spheres of granite, 1 mm, carried over their strength by one step: pulled, and pressed while they overlap by 0.1 mm",
            oracle: "F^2 / (2 k) with F = 280 MPa times pi mm^2: 3.868884925e-2 J; k xi^2 / 2 of the contact that takes over",
            reason: "The force is beyond the strength by what one step adds, 2e-13 m of 88 um, twice in the square",
            measure: breaking,
            ..check(
                "closure.breaking",
                "A bond that breaks books what it stored, and the contact that takes its place books what it begins with.",
                "(48), (75), (77), (79)",
            )
        },
        Check {
            scene: "A driven sphere without other forces under the rate-limited controller",
            oracle: "The gain of kinetic energy by integers: the force is known at each step",
            reason: "Symplectic Euler: booked with the velocity at the beginning of a step, the residual is half the sum of force squared times step squared over mass, which is subtracted; rounding remains",
            origin: Origin::Exact,
            measure: driving_work,
            ..check(
                "closure.driving-work",
                "The work of driving is the kinetic energy it gives, but for the first-order term of the method.",
                "(20)-(22), (79)",
            )
        },
    ]
}

const RADIUS: f64 = 1e-3;
const MASS: f64 = 4.0 / 3.0 * PI * 2700.0 * RADIUS * RADIUS * RADIUS;

fn collide(zeta: f64) -> Result<[f64; 2], Failure> {
    let k = 1e7_f64;
    let rate = (2.0 * k / MASS).sqrt();
    let damping = zeta * (2.0 * k * MASS).sqrt();
    let x = RADIUS - 0.5e-14;
    let text = head("velocity-verlet", 2e-4 / rate)
        + &format!(
            "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = {k:e}\ndamping = {damping:e}\n"
        )
        + &particle([-x, 0.0], [0.5, 0.0], 0.0, RADIUS)
        + &particle([x, 0.0], [-0.5, 0.0], 0.0, RADIUS);
    let mut world: World = world(&text)?;
    advance(&mut world, 20_000)?;
    let energy = world.energy();
    Ok([energy.friction, energy.contact])
}

fn collision_heat() -> Outcome {
    let kinetic = MASS * 0.25;
    let mut worst = Vec::new();
    for zeta in [0.1, 0.3, 0.66, 1.5] {
        let [heat, stored] = collide(zeta)?;
        let e = truncated_restitution(zeta);
        worst.push(Measurement::relative(
            (1.0 - e * e) * kinetic,
            heat + stored,
            4e-7,
        ));
    }
    Ok(Measurement::worst(worst).into())
}

fn drag_heat() -> Outcome {
    let (eta, steps) = (0.5, 20_000);
    let (linear, angular) = (
        MASS / (6.0 * PI * eta * RADIUS),
        0.4 * MASS / (8.0 * PI * eta * RADIUS),
    );
    let end = 3.0 * linear;
    let text = head("velocity-verlet", end / steps as f64)
        + &format!("[ambient]\nlaw = \"creeping\"\nviscosity = {eta:e}\n")
        + &particle([0.0, 0.0], [1.2, -0.5], 1500.0, RADIUS);
    let mut world = world(&text)?;
    advance(&mut world, steps)?;
    let lost = |energy: f64, decay: f64| energy * -(-2.0 * end / decay).exp_m1();
    let translation = lost(0.5 * MASS * (1.2 * 1.2 + 0.5 * 0.5), linear);
    let rotation = lost(0.2 * MASS * RADIUS * RADIUS * 1500.0 * 1500.0, angular);
    let energy = world.energy();
    let left =
        0.5 * MASS * 1.69 - translation + 0.2 * MASS * RADIUS * RADIUS * 1500.0 * 1500.0 - rotation;
    Ok(Measurement::worst([
        Measurement::relative(translation + rotation, energy.ambient, 5e-8),
        Measurement::scaled(left, energy.kinetic, translation, 5e-8),
    ])
    .into())
}

fn breaking() -> Outcome {
    let (k, step) = (1e7, 1e-12);
    let bond = format!(
        "[bond.normal]\nstiffness = {k:e}\ndamping = 0.0\n[bond.yielding]\nlaw = \"zhang-eckert\"\nnormal_strength = 280e6\ntangential_strength = 168e6\n"
    );
    let contact = "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 2e7\ndamping = 0.0\n";
    let force = 280e6 * PI * RADIUS * RADIUS;
    // The bond begins just below its strength, and the first step carries it just beyond.
    let short = 1e-13;
    let pull = |initial: f64, distance: f64, velocity: f64| {
        head("symplectic-euler", step)
            + contact
            + &bond
            + &particle([0.0, 0.0], [0.0, 0.0], 0.0, RADIUS)
            + &particle([distance, 0.0], [velocity, 0.0], 0.0, RADIUS)
            + &format!("[[bonds]]\nbetween = [0, 1]\ninitial_distance = {initial:e}\n")
    };
    let torn = pull(3e-3 - (force / k - short), 3e-3, 2.0 * short / step);
    let squeezed = 1.9e-3;
    let crushed = pull(squeezed + force / k - short, squeezed, -2.0 * short / step);
    let mut worst = Vec::new();
    for (text, overlap) in [(torn, 0.0), (crushed, 0.1e-3)] {
        let mut world: World = world(&text)?;
        advance(&mut world, 3)?;
        let energy = world.energy();
        worst.push(Measurement::relative(
            0.5 * force * force / k,
            energy.breaking,
            1e-8,
        ));
        let begun = 0.5 * 2e7 * overlap * overlap;
        worst.push(Measurement::scaled(
            begun,
            energy.bonding,
            0.5 * 2e7 * 1e-8,
            1e-7,
        ));
    }
    Ok(Measurement::worst(worst).into())
}

fn driving_work() -> Outcome {
    let (rate, step, steps) = (1e3, 1e-6, 1000_u64);
    let text = head("symplectic-euler", step)
        + &format!(
            "[driving]\ncontroller = \"rate-limited\"\nspeed = 1e9\npressure = -1.0\narea = 1e9\nforce_rate = {rate:e}\n"
        )
        + &format!(
            "[[particles]]\nposition = [0.0, 0.0]\nradius = {RADIUS:e}\nrole = \"driven\"\n"
        );
    let mut world = world(&text)?;
    advance(&mut world, steps)?;
    // The force at step n is n rate step along x and along y.
    let n = steps as f64;
    let impulse = rate * step * step * n * (n + 1.0) / 2.0;
    let kinetic = impulse * impulse / MASS;
    let squares = n * (n + 1.0) * (2.0 * n + 1.0) / 6.0;
    let first_order = (rate * step * step).powi(2) * squares / MASS;
    let energy = world.energy();
    Ok(Measurement::worst([
        Measurement::relative(kinetic, energy.kinetic, 1e-12),
        Measurement::relative(kinetic - first_order, energy.driving, 1e-12),
        Measurement::scaled(first_order, energy.residual, kinetic, 1e-12),
    ])
    .into())
}
