//! The exact critical step of a whole bonded packing.

use super::amplification::integrator;
use super::block::Packing;
use super::modes::{Mode, integrator_name};
use super::network::Linearisation;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    largest, thesis,
};
use crate::oracles::amplification::{Method, boundary, closed_boundary, spectral_radius};
use gouge_dem::{network_step, stable_step_estimate};

const ORACLE: &str = "By faer: all eigenvalues of the mass-scaled stiffness if damping is proportional to it; otherwise positive definiteness of the matrix pencil at minus one";

/// The checks of this file.
pub fn checks() -> Vec<Check> {
    let mut checks = vec![symmetry()];
    checks.extend(boundaries());
    checks.extend(estimates());
    checks
}

fn symmetry() -> Check {
    Check {
        id: "time-step.packing.symmetric",
        claim: "Stiffness and damping of a bonded packing are symmetric matrices, and with the thesis's constants the damping matrix is 1e-6 s times the stiffness matrix.",
        equations: thesis("(43)-(45)"),
        scene: "The packing of granite-fault-small, bonded, before the fault is cut: 172 grains",
        oracle: "Derivatives of all forces by dual numbers; their transpose, and K gamma/k",
        norm: "Largest difference of an entry, in units of the largest entry",
        origin: Origin::Exact,
        reason: "Each entry is a sum over at most ten bonds with about twenty roundings",
        effort: Effort::Thorough,
        measure: symmetric,
    }
}

/// Checks of the stability limit of runs of the small packing.
fn boundaries() -> [Check; 2] {
    [
        Check {
            id: "time-step.packing.proportional",
            claim: "With the thesis's damping, the packing is unstable half a per cent above the exact critical step of every integrator and stable half a per cent below it.",
            equations: thesis("(43)-(45), (55)-(58)"),
            scene: "The same packing with random initial speeds of up to 1e-9 m/s",
            oracle: ORACLE,
            norm: "Number of runs on the wrong side",
            origin: Origin::Exact,
            reason: "The forces of a growing mode exceed all others within thousands of steps; below the limit the forces of every mode decay",
            effort: Effort::Thorough,
            measure: proportional,
        },
        Check {
            id: "time-step.packing.general",
            claim: "If bending is damped four times as strongly as stretching, damping is not proportional to stiffness. Half a per cent below the step at which 4 M - 2 dt C - dt^2 K (symplectic Euler) or 4 M - 4 dt C - dt^2 K (velocity Verlet) stops being positive definite, runs are stable; half a per cent above it they are unstable.",
            equations: thesis("(43)-(45)"),
            scene: "The same packing with stronger damping of bending",
            oracle: ORACLE,
            norm: "Number of runs on the wrong side",
            origin: Origin::Exact,
            reason: "As for proportional damping",
            effort: Effort::Thorough,
            measure: general,
        },
    ]
}

/// Checks of the kernel's estimate, and of the large packing.
fn estimates() -> [Check; 3] {
    [
        Check {
            id: "time-step.packing.mode",
            claim: "The critical step that the kernel finds by power iteration is within 5 % of the exact one of symplectic Euler and velocity Verlet; if damping is not proportional to stiffness, it is at most 5 % above.",
            equations: thesis("(43)-(45)"),
            scene: "The packing of time-step.packing.symmetric with both dampings",
            oracle: ORACLE,
            norm: "Relative difference of the steps; for the second damping only by how much the kernel's is larger",
            origin: Origin::Convergent,
            reason: "Power iteration approaches the largest eigenvalue from below and ends when it changes by 1e-4 per iteration; the levers of overlapping grains differ from their radii by a few per cent; the two matrices are bounded one by one",
            effort: Effort::Thorough,
            measure: mode,
        },
        Check {
            id: "time-step.packing.estimate",
            claim: "The kernel's estimate of the stable step is a lower bound of the exact critical step of symplectic Euler and velocity Verlet, for proportional and for non-proportional damping.",
            equations: thesis("(43)-(45)"),
            scene: "The packing of time-step.packing.symmetric with both dampings",
            oracle: ORACLE,
            norm: "Number of estimates above the exact step",
            origin: Origin::Exact,
            reason: "Gershgorin's theorem bounds both matrices from above, and a larger matrix of either kind lowers the critical step of both methods",
            effort: Effort::Thorough,
            measure: estimate,
        },
        Check {
            id: "time-step.packing.large",
            claim: "For the packing of granite-fault, with about eight thousand coordinates, runs of symplectic Euler and velocity Verlet are stable half a per cent below the exact critical step and unstable half a per cent above it, and the kernel's estimate is a lower bound.",
            equations: thesis("(43)-(45)"),
            scene: "The packing of granite-fault, bonded, before the fault is cut: 2900 grains",
            oracle: ORACLE,
            norm: "Number of runs on the wrong side and of estimates above the exact step",
            origin: Origin::Exact,
            reason: "As for the small packing",
            effort: Effort::Report,
            measure: large,
        },
    ]
}

fn small() -> Result<Packing, Failure> {
    Packing::new("granite-fault-small", 5)
}

/// Damping over stiffness of the thesis's bonds in s.
const RATIO: f64 = 1e-6;

fn symmetric() -> Outcome {
    let found = small()?.linearised()?;
    let tolerance = 200.0 * f64::EPSILON;
    let network = &found.network;
    let stiffest = largest(network.stiffness.iter().map(|entry| entry.2));
    let pairs = network.stiffness.iter().zip(&network.damping);
    let proportional = pairs.map(|(k, c)| (RATIO * k.2 - c.2).abs() / (RATIO * stiffest));
    let all = [
        found.asymmetry[0],
        found.asymmetry[1],
        largest(proportional),
    ];
    let text = format!(
        "{} forces and torques, each with respect to {} coordinates: all derivatives in {} evaluations, because grains without common neighbours share an evaluation.",
        network.inertia.len(),
        network.inertia.len(),
        found.evaluations
    );
    let worst = all.map(|error| Measurement::absolute(0.0, error, tolerance));
    Ok(Measurement::worst(worst).showing([Exhibit::Text(text)]))
}

/// Smallest critical step over modes of the given squared frequencies, without rigid modes.
fn smallest(method: Method, squares: &[f64], ratio: f64) -> f64 {
    let largest = squares.iter().copied().fold(0.0, f64::max);
    let moving = squares.iter().filter(|&&square| square > RIGID * largest);
    let critical = |&square: &f64| {
        let w = square.sqrt();
        match closed_boundary(method, 0.5 * ratio * w) {
            Some(scaled) => scaled / w,
            None => boundary(method, [square, ratio * square], 1e-12),
        }
    };
    moving.map(critical).fold(f64::INFINITY, f64::min)
}

/// Squared frequency, in units of the largest, below which a mode counts as rigid.
const RIGID: f64 = 1e-10;

fn proportional() -> Outcome {
    let packing = small()?;
    let squares = packing.linearised()?.network.squared_frequencies();
    let mut wrong = 0;
    let mut table = Table::new(
        "Exact critical steps of the packing and of a single bond, in ns",
        &[
            "integrator",
            "packing",
            "bond, axial",
            "bond, shearing",
            "runs on the wrong side",
        ],
    );
    for method in Method::ALL {
        let critical = smallest(method, &squares, RATIO);
        let misses = packing.wrong(method, critical)?;
        wrong += misses;
        let pair = |mode: Mode| boundary(method, mode.rates([1e7, 10.0]), 1e-12);
        let ns = |step: f64| format!("{:.1}", 1e9 * step);
        table.push([
            integrator_name(method).to_owned(),
            ns(critical),
            ns(pair(Mode::Axial)),
            ns(pair(Mode::Shearing)),
            misses.to_string(),
        ]);
    }
    let exhibits = [
        Exhibit::Table(table),
        Exhibit::Table(extremes(&squares)),
        Exhibit::Figure(spectrum(&squares)),
    ];
    Ok(Measurement::count(wrong).showing(exhibits))
}

/// The softest and the stiffest mode with the thesis's integrator and time step.
fn extremes(squares: &[f64]) -> Table {
    const STEP: f64 = 10e-9;
    let mut table = Table::new(
        "Damping proportional to stiffness stabilises explicit Euler: modes of the packing at 10 ns",
        &[
            "mode",
            "w in 1/s",
            "damping ratio",
            "critical step in ns",
            "factor per step",
        ],
    );
    let largest = squares.iter().copied().fold(0.0, f64::max);
    let moving = |square: &&f64| **square > RIGID * largest;
    let softest = squares.iter().find(moving).copied().unwrap_or(f64::NAN);
    for (name, square) in [("softest", softest), ("stiffest", largest)] {
        let factor = spectral_radius(Method::Euler, square * STEP * STEP, RATIO * square * STEP);
        table.push([
            name.to_owned(),
            format!("{:.4e}", square.sqrt()),
            format!("{:.4}", 0.5 * RATIO * square.sqrt()),
            format!("{:.1}", 1e9 * smallest(Method::Euler, &[square], RATIO)),
            format!("{factor:.8}"),
        ]);
    }
    table
}

fn spectrum(squares: &[f64]) -> Figure {
    let part = |n: usize| (n + 1) as f64 / squares.len() as f64;
    let points = squares.iter().enumerate();
    Figure::new(
        "Squared frequencies of the packing: half of all modes are stiffer than a pair",
        Axis::logarithmic("angular frequency", "1/s"),
        Axis::linear("fraction of modes below", ""),
        vec![Curve::line(
            "packing",
            points.map(|(n, square)| [square.max(0.0).sqrt(), part(n)]),
        )],
    )
}

/// Methods that lose stability only at an eigenvalue of minus one.
const SIMPLE: [Method; 2] = [Method::SymplecticEuler, Method::VelocityVerlet];

/// The exact critical step for any damping.
fn exact(found: &Linearisation, method: Method) -> Result<f64, Failure> {
    let step = found.network.critical_step(method);
    step.ok_or_else(|| Failure::Oracle("the method has no pencil".to_owned()))
}

fn general() -> Outcome {
    let packing = small()?.damped(4.0);
    let found = packing.linearised()?;
    let mut wrong = 0;
    for method in SIMPLE {
        wrong += packing.wrong(method, exact(&found, method)?)?;
    }
    Ok(Measurement::count(wrong).into())
}

/// Largest relative error of the critical step by power iteration.
const MODE: f64 = 0.05;

fn mode() -> Outcome {
    let mut measured = Vec::new();
    for (factor, is_proportional) in [(1.0, true), (4.0, false)] {
        let packing = small()?.damped(factor);
        let found = packing.linearised()?;
        for method in SIMPLE {
            let world = packing.set_off(integrator(method), 1e-9)?;
            let (ours, exact) = (network_step(&world), exact(&found, method)?);
            let ours = if is_proportional {
                ours
            } else {
                ours.max(exact)
            };
            measured.push(Measurement::relative(exact, ours, MODE));
        }
    }
    Ok(Measurement::worst(measured).into())
}

/// The kernel's estimate for a method.
fn estimated(packing: &Packing, method: Method) -> Result<f64, Failure> {
    let world = packing.set_off(integrator(method), 1e-9)?;
    Ok(stable_step_estimate(&world))
}

fn estimate() -> Outcome {
    let mut table = Table::new(
        "The kernel's estimate and the exact critical step, in ns",
        &[
            "damping of bending over that of stretching",
            "integrator",
            "estimate",
            "exact",
            "ratio",
        ],
    );
    let mut above = 0;
    for factor in [1.0, 4.0] {
        let packing = small()?.damped(factor);
        let found = packing.linearised()?;
        for method in SIMPLE {
            let (bound, exact) = (estimated(&packing, method)?, exact(&found, method)?);
            above += usize::from(bound > exact);
            table.push([
                format!("{factor}"),
                integrator_name(method).to_owned(),
                format!("{:.1}", 1e9 * bound),
                format!("{:.1}", 1e9 * exact),
                format!("{:.3}", bound / exact),
            ]);
        }
    }
    Ok(Measurement::count(above).showing([Exhibit::Table(table)]))
}

fn large() -> Outcome {
    let packing = Packing::new("granite-fault", 5)?;
    let found = packing.linearised()?;
    let mut wrong = 0;
    let mut table = Table::new(
        "Exact critical step of the large packing, in ns",
        &[
            "integrator",
            "exact",
            "estimate of the kernel",
            "runs on the wrong side",
        ],
    );
    for method in SIMPLE {
        let (bound, exact) = (estimated(&packing, method)?, exact(&found, method)?);
        let misses = packing.wrong(method, exact)?;
        wrong += misses + usize::from(bound > exact);
        table.push([
            integrator_name(method).to_owned(),
            format!("{:.1}", 1e9 * exact),
            format!("{:.1}", 1e9 * bound),
            misses.to_string(),
        ]);
    }
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table)]))
}
