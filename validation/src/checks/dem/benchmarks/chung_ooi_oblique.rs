//! Chung and Ooi's tests 4, 5 and 6: a sphere hits a plane obliquely or spinning.

use super::literature;
use super::plane::{FLATNESS, Flight};
use super::sweep::{Laws, Point, Run, Sweep, angles, spinning, tangential_speeds};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    thesis,
};

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "benchmarks.chung-ooi.4-6-slip",
            claim: "If the contact slides throughout, tests 4, 5 and 6 obey beta_t = 1 - mu (1 + e) V_n / V_t and r dw = -(5/2) mu (1 + e) V_n to rounding.",
            equations: thesis("(6)-(7), (37), (41), (51)-(53)"),
            scene: "A sphere on a plane; two materials per test; every impact of the sweeps that slides to the end; BSHP and Haff-Werner, 150 steps per collision",
            oracle: "Balance of momentum with friction = mu times normal force, with the normal restitution taken from the run",
            norm: "Largest error of tangential velocity and surface speed after the collision, in units of the initial normal speed",
            origin: Origin::Exact,
            reason: "Both impulses are sums over the same steps, so the time step does not matter. The tolerance is a hundred units of rounding of the largest velocity, plus the tilt of the plane: it is a sphere 1e12 times as large, which tilts by 1e-12 per radius travelled",
            effort: Effort::Quick,
            measure: slip,
        },
        Check {
            id: "benchmarks.chung-ooi.4",
            claim: "Test 4, oblique impact at constant speed: the whole curves of tangential restitution, spin and rebound follow from the laws.",
            equations: thesis("(35)-(37), (41)-(42), (51)-(53)"),
            scene: "Spheres of aluminium oxide and alloy at 3.9 m/s, 5 to 85 degrees, e = 0.98, mu = 0.092; three pairs of laws, 1500 steps per collision",
            oracle: ORACLE,
            norm: NORM,
            origin: Origin::Convergent,
            reason: REASON,
            effort: Effort::Thorough,
            measure: test_4,
        },
        Check {
            id: "benchmarks.chung-ooi.5",
            claim: "Test 5, oblique impact at constant normal speed: the whole curves of slip and spin after the collision follow from the laws.",
            equations: thesis("(35)-(37), (41)-(42), (51)-(53)"),
            scene: "Spheres of steel and polyethylene, normal speed 5 m/s, tangential speed 0.15 to 69 m/s, e = 1, mu = 0.3; three pairs of laws, 1500 steps per collision",
            oracle: ORACLE,
            norm: NORM,
            origin: Origin::Convergent,
            reason: REASON,
            effort: Effort::Thorough,
            measure: test_5,
        },
        Check {
            id: "benchmarks.chung-ooi.6",
            claim: "Test 6, a spinning sphere falls on a plane: the whole curve of the slip after the collision follows from the laws.",
            equations: thesis("(35)-(37), (41)-(42), (51)-(53)"),
            scene: "Spheres of aluminium alloy and nylon, normal speed 0.2 m/s, surface speed from spin 0.0175 to 2.3 m/s, e = 0.5, mu = 0.4; three pairs of laws, 1500 steps per collision",
            oracle: ORACLE,
            norm: NORM,
            origin: Origin::Convergent,
            reason: REASON,
            effort: Effort::Thorough,
            measure: test_6,
        },
    ]
}

const ORACLE: &str = "High-order integration between located events (stick, slide, end), with the square root of the overlap as variable where the contact is Hertzian";
const NORM: &str = "Error of normal and tangential velocity and surface speed after the collision, in units of the initial normal speed; the one closest to its tolerance";
const REASON: &str = "Sum of the errors of the trapezoidal rule: an eighth of the jump of the force's rate times dt^2 at each change between sticking and sliding and at the end, and 0.2079 of the coefficient times dt^(3/2) at the touch of viscoelastic spheres, whose force begins like the square root of time. The laws are not Mindlin's: where the contact does not slide throughout, the published curves differ from ours by more than the error of the time step";
const STEPS: u64 = 1500;

/// Relative error caused by rounding: a hundred units.
const ROUNDING: f64 = 2e-14;

fn slip() -> Outcome {
    let mut all = Vec::new();
    let mut table = Table::new(
        "Sliding contacts obey the balance of momentum to rounding: test 4, aluminium oxide",
        &[
            "angle (deg)",
            "beta_t",
            "kernel",
            "spin (rad/s)",
            "kernel",
            "rebound (deg)",
            "kernel",
        ],
    );
    for sweep in [angles(), tangential_speeds(), spinning()] {
        for solid in sweep.solids {
            let runs = sweep.runs(solid, Laws::HertzViscous, 150)?;
            for run in runs.iter().filter(|run| slides(&sweep, run)) {
                let (after, checks) = balance(&sweep, run);
                all.extend(checks);
                if solid.name == "aluminium oxide" {
                    table.push(row(run, after));
                }
            }
        }
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

/// Whether the contact slides until it ends, with a margin of 0.2 times friction times normal speed for
/// the viscous branch of the law.
fn slides(sweep: &Sweep, run: &Run) -> bool {
    let lost = 3.5 * (1.0 + sweep.restitution) + 0.2;
    run.slip(&run.before) > lost * sweep.friction * run.before.normal
}

/// Velocity along the plane and spin after sliding throughout, compared with the kernel.
fn balance(sweep: &Sweep, run: &Run) -> ([f64; 2], [Measurement; 2]) {
    let (before, after) = (run.before, run.measured);
    let impulse = sweep.friction * (before.normal + after.normal);
    let along = before.along - impulse;
    let spin = before.spin - 2.5 * impulse / run.contact.radius;
    let speed = before.normal;
    let way = before.along * run.contact.duration(speed) / run.contact.radius;
    let fast = 1.0 + before.along / speed;
    let tolerance = ROUNDING * fast + 2.0 * way / FLATNESS * fast;
    let checks = [
        Measurement::scaled(along, after.along, speed, tolerance),
        Measurement::scaled(
            spin,
            after.spin,
            speed / run.contact.radius,
            2.5 * tolerance,
        ),
    ];
    ([along, spin], checks)
}

fn row(run: &Run, [along, spin]: [f64; 2]) -> [String; 7] {
    let rebound = |along: f64, spin: f64| {
        let slip = along + run.contact.radius * spin;
        slip.atan2(run.measured.normal).to_degrees()
    };
    let (before, after) = (run.before, run.measured);
    [
        format!("{:.0}", run.abscissa),
        format!("{:.12}", along / before.along),
        format!("{:.12}", after.along / before.along),
        format!("{spin:.9}"),
        format!("{:.9}", after.spin),
        format!("{:.10}", rebound(along, spin)),
        format!("{:.10}", rebound(after.along, after.spin)),
    ]
}

/// The curves of a sweep for every material and pair of laws.
fn curves(sweep: &Sweep) -> Result<Vec<(String, Vec<Point>)>, Failure> {
    let mut all = Vec::new();
    for solid in sweep.solids {
        for laws in Laws::ALL {
            let label = format!("{}, {}", solid.name, laws.name());
            all.push((label, sweep.curve(solid, laws, STEPS)?));
        }
    }
    Ok(all)
}

fn worst(curves: &[(String, Vec<Point>)]) -> Measurement {
    let points = curves.iter().flat_map(|(_, points)| points);
    Measurement::worst(points.flat_map(Point::comparisons))
}

/// A figure for the first material: lines from the oracle, marks from the kernel, and published data.
fn figure(
    title: &str,
    [x, y]: [Axis; 2],
    curves: &[(String, Vec<Point>)],
    value: impl Fn(&Point, bool) -> [f64; 2],
    published: &[(&str, Vec<[f64; 2]>)],
) -> Exhibit {
    let mut drawn = Vec::new();
    for (label, points) in curves.iter().take(Laws::ALL.len()) {
        let line = points.iter().map(|point| value(point, false));
        drawn.push(Curve::line(&format!("oracle: {label}"), line));
        let marks = points.iter().map(|point| value(point, true));
        drawn.push(Curve::marks(&format!("kernel: {label}"), marks));
    }
    for (label, points) in published {
        drawn.push(Curve::marks(label, points.iter().copied()));
    }
    Exhibit::Figure(Figure::new(title.to_owned(), x, y, drawn))
}

fn test_4() -> Outcome {
    let curves = curves(&angles())?;
    let angle = || Axis::linear("angle of impact", "deg");
    let column = |n: usize| literature::OBLIQUE.iter().map(move |row| [row[0], row[n]]);
    let simulated = "literature: Chung and Ooi, Hertz-Mindlin, digitised";
    let restitution = figure(
        "The tangential restitution has a minimum where the contact sticks for part of the time",
        [angle(), Axis::linear("tangential restitution", "")],
        &curves,
        |point, kernel| {
            [
                point.run.abscissa,
                after(point, kernel).along / point.run.before.along,
            ]
        },
        &[
            (simulated, column(1).collect()),
            (
                "literature: experiment of Kharaz et al., digitised",
                literature::OBLIQUE_MEASURED.to_vec(),
            ),
        ],
    );
    let spin = figure(
        "The spin is largest at the smallest angle at which the contact slides throughout",
        [angle(), Axis::linear("angular velocity", "rad/s")],
        &curves,
        |point, kernel| [point.run.abscissa, after(point, kernel).spin],
        &[
            (simulated, column(2).collect()),
            (
                "literature: experiment of Kharaz et al., digitised",
                literature::SPIN_MEASURED
                    .iter()
                    .map(|&[x, y]| [x, -y])
                    .collect(),
            ),
        ],
    );
    let rebound = figure(
        "Tangential springs reverse the contact point's velocity at small angles; viscous friction does not",
        [
            angle(),
            Axis::linear("rebound angle of the contact point", "deg"),
        ],
        &curves,
        |point, kernel| {
            let after = after(point, kernel);
            let angle = point.run.slip(&after).atan2(after.normal);
            [point.run.abscissa, angle.to_degrees()]
        },
        &[(simulated, column(3).collect())],
    );
    Ok(worst(&curves).showing([restitution, spin, rebound]))
}

fn test_5() -> Outcome {
    let curves = curves(&tangential_speeds())?;
    let number = || {
        Axis::linear(
            "tangential speed over friction times normal speed, before",
            "",
        )
    };
    let unit = |point: &Point| 0.3 * point.run.before.normal;
    let shown: Vec<(String, Vec<Point>)> = curves
        .iter()
        .map(|(label, points)| {
            let near = points.iter().filter(|point| point.run.abscissa < 13.0);
            (label.clone(), near.copied().collect())
        })
        .collect();
    let slip = figure(
        "Above seven the sphere slides throughout, and the slip falls by exactly seven",
        [
            number(),
            Axis::linear("slip over friction times normal speed, after", ""),
        ],
        &shown,
        |point, kernel| {
            let after = after(point, kernel);
            [point.run.abscissa, point.run.slip(&after) / unit(point)]
        },
        &[(
            "literature: finite elements, digitised",
            literature::FINITE_ELEMENTS.to_vec(),
        )],
    );
    let spin = figure(
        "Above seven the surface speed is minus five",
        [
            number(),
            Axis::linear("surface speed over friction times normal speed, after", ""),
        ],
        &shown,
        |point, kernel| {
            let after = after(point, kernel);
            let surface = point.run.contact.radius * after.spin;
            [point.run.abscissa, surface / unit(point)]
        },
        &[(
            "literature: finite elements, digitised",
            literature::FINITE_ELEMENTS_SPIN.to_vec(),
        )],
    );
    Ok(worst(&curves).showing([slip, spin]))
}

fn test_6() -> Outcome {
    let curves = curves(&spinning())?;
    let number = |point: &Point| 2.1 * point.run.before.normal / point.run.slip(&point.run.before);
    let plot = figure(
        "Below one the sphere slides throughout; above, the rebound of the slip depends on the law",
        [
            Axis::linear("(7/2) mu (1 + e) V_n over the slip before", ""),
            Axis::linear("minus slip after over slip before", ""),
        ],
        &curves,
        |point, kernel| {
            let ratio = point.run.slip(&after(point, kernel)) / point.run.slip(&point.run.before);
            [number(point), -ratio]
        },
        &[(
            "literature: Chung and Ooi, Hertz-Mindlin, digitised",
            literature::SPINNING.to_vec(),
        )],
    );
    Ok(worst(&curves).showing([plot]))
}

/// The motion after the collision, from the kernel or the oracle.
fn after(point: &Point, kernel: bool) -> Flight {
    if kernel {
        point.run.measured
    } else {
        point.expected
    }
}
