//! MFiX DEM06: a sphere falls at its terminal speed.

use crate::checks::dem::scenes::advance;
use crate::checks::extrapolation::to_no_step;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    thesis,
};
use crate::oracles::settling::Settling;
use crate::scenes::{Draft, Grain};
use gouge_dem::World;
use gouge_dem::integrators::Integrator;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "benchmarks.mfix.06-creeping",
            claim: "DEM06 in creeping flow: speed, distance and spin of a settling sphere are exponentials with its relaxation times.",
            equations: thesis("(17)-(19)"),
            scene: "A sphere of 0.1 mm and 2000 kg/m^3 falls from rest, spinning, for 0.35 s in a medium of 1.8e-5 Pa s; 350 to 2800 steps, extrapolated",
            oracle: "Closed forms: exponentials with 2 rho r^2 / (9 eta) for the velocity and rho r^2 / (15 eta) for the spin",
            norm: "Largest error of speed, distance and spin, in units of the terminal speed, the distance covered at that speed in one relaxation time, and the initial spin, every 0.05 s",
            origin: Origin::Convergent,
            reason: "The error of velocity Verlet is a series in dt starting at dt^2. Extrapolation from four time steps leaves 1.04e-3 of its term in dt^5, which for the spin with the coarsest step, dt / tau = 0.054, is 4.8e-10 times a coefficient below a tenth, doubled for higher terms",
            effort: Effort::Quick,
            measure: creeping,
        },
        Check {
            id: "benchmarks.mfix.06-terminal",
            claim: "DEM06 with the drag correlation: the terminal speed balances drag and weight, with the constant 0.42 and with the printed 1.",
            equations: thesis("(11)-(13), (16)"),
            scene: "The same sphere in a medium of 1.2 kg/m^3, 4 s",
            oracle: "Root of the drag coefficient 24 / Re + 3 / sqrt(Re) + c against weight, by bisection",
            norm: "Relative error of the speed",
            origin: Origin::Exact,
            reason: "In equilibrium the time step does not matter; after 65 relaxation times the transient has vanished; rounding of the repeated sum leaves at most about a hundred units, 2e-14",
            effort: Effort::Quick,
            measure: terminal,
        },
        Check {
            id: "benchmarks.mfix.06-approach",
            claim: "DEM06 with the drag correlation: the sphere approaches its terminal speed as the drag law requires.",
            equations: thesis("(11)-(13), (16)"),
            scene: "The same sphere, 0.35 s, 7000 steps",
            oracle: "High-order integration in the square root of the speed",
            norm: "Largest error of the speed in units of the terminal speed, every 0.05 s",
            origin: Origin::Convergent,
            reason: "The rate of the drag is at most that at the terminal speed, 1.5 / tau. The error of a step of velocity Verlet is at most a'' dt^3 / 6, and errors decay: (1.5 dt / tau)^2 / 6 = 2.5e-7",
            effort: Effort::Quick,
            measure: approach,
        },
    ]
}

const SPHERE: Settling = Settling {
    radius: 5e-5,
    density: 2000.0,
    medium: 1.2,
    viscosity: 1.8e-5,
    gravity: 9.81,
};
const SPIN: f64 = 100.0;
const EVERY: f64 = 0.05;
const SAMPLES: u64 = 7;

/// The sphere with the given number of steps per twentieth of a second.
fn settling(ambient: &Draft, reading: &str, steps: u64) -> Result<World, Failure> {
    let draft = Draft::open_box(Integrator::VelocityVerlet, EVERY / steps as f64)
        .reading(reading)
        .grain(
            Grain::at([0.0; 2], SPHERE.radius)
                .spinning(SPIN)
                .of_density(SPHERE.density),
        )
        .and(ambient)
        .gravity(SPHERE.gravity);
    Ok(draft.world()?)
}

fn correlation(reading: &str, steps: u64) -> Result<World, Failure> {
    let law = Draft::empty().correlation_drag(SPHERE.viscosity, SPHERE.medium);
    settling(&law, reading, steps)
}

/// Distance, speed and spin at every sample.
fn course(steps: u64) -> Result<Vec<[f64; 3]>, Failure> {
    let law = Draft::empty().creeping_drag(SPHERE.viscosity);
    let mut world = settling(&law, "corrected", steps)?;
    let mut rows = Vec::new();
    for _ in 0..SAMPLES {
        advance(&mut world, steps)?;
        let p = world.particles();
        rows.push([-p.position[0].y, -p.velocity[0].y, p.angular_velocity[0]]);
    }
    Ok(rows)
}

fn creeping() -> Outcome {
    let steps = [50, 100, 200, 400];
    let levels = steps
        .iter()
        .map(|&steps| course(steps))
        .collect::<Result<Vec<_>, Failure>>()?;
    let best = to_no_step(levels, &[2, 3, 4]);
    let [tau, tau_spin] = SPHERE.relaxation();
    let fastest = SPHERE.gravity * tau;
    let mut all = Vec::new();
    let mut table = Table::new(
        "Settling in creeping flow: expected, and extrapolated from the kernel",
        &[
            "time (s)",
            "speed (m/s)",
            "kernel",
            "distance (m)",
            "kernel",
            "spin (rad/s)",
            "kernel",
        ],
    );
    for (n, measured) in best.iter().enumerate() {
        let time = EVERY * (n + 1) as f64;
        let [way, speed] = SPHERE.creeping(time);
        let spin = SPIN * (-time / tau_spin).exp();
        let expected = [way, speed, spin];
        for (at, scale) in [fastest * tau, fastest, SPIN].into_iter().enumerate() {
            all.push(Measurement::scaled(
                expected[at],
                measured[at],
                scale,
                1e-10,
            ));
        }
        table.push([
            format!("{time:.2}"),
            format!("{speed:.12}"),
            format!("{:.12}", measured[1]),
            format!("{way:.12}"),
            format!("{:.12}", measured[0]),
            format!("{spin:.10}"),
            format!("{:.10}", measured[2]),
        ]);
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

const READINGS: [(&str, f64); 2] = [("corrected", 0.42), ("thesis", 1.0)];

fn terminal() -> Outcome {
    let mut all = Vec::new();
    let mut table = Table::new(
        "Terminal speed, from the balance of forces and from the kernel",
        &["constant of (16)", "expected (m/s)", "kernel (m/s)"],
    );
    for (reading, constant) in READINGS {
        let mut world = correlation(reading, 50)?;
        advance(&mut world, 80 * 50)?;
        let measured = -world.particles().velocity[0].y;
        let expected = SPHERE.terminal(constant);
        all.push(Measurement::relative(expected, measured, 2e-14));
        table.push([
            format!("{constant}"),
            format!("{expected:.14}"),
            format!("{measured:.14}"),
        ]);
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn approach() -> Outcome {
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    for (reading, constant) in READINGS {
        let mut world = correlation(reading, 1000)?;
        let (mut line, mut marks) = (vec![[0.0, 0.0]], Vec::new());
        let terminal = SPHERE.terminal(constant);
        for n in 1..=SAMPLES {
            advance(&mut world, 1000)?;
            let time = EVERY * n as f64;
            let (expected, measured) = (
                SPHERE.speed(constant, time),
                -world.particles().velocity[0].y,
            );
            all.push(Measurement::scaled(expected, measured, terminal, 2.5e-7));
            for part in 0..5 {
                let earlier = time - EVERY * (0.8 - 0.2 * f64::from(part));
                line.push([earlier, SPHERE.speed(constant, earlier)]);
            }
            marks.push([time, measured]);
        }
        curves.push(Curve::line(&format!("oracle, constant {constant}"), line));
        curves.push(Curve::marks(&format!("kernel, constant {constant}"), marks));
    }
    let creeping = (0..=35).map(|n| {
        let time = 0.01 * f64::from(n);
        [time, SPHERE.creeping(time)[1]]
    });
    curves.push(Curve::line("creeping flow, closed form", creeping));
    let plot = Figure::new(
        "With the drag correlation, the sphere of DEM06 settles more slowly than in creeping flow",
        Axis::linear("time", "s"),
        Axis::linear("speed", "m/s"),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}
