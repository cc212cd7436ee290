//! Chung and Ooi's tests 1, 2 and 3: head-on collisions.

use super::plane::{Material, linear, material};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    thesis,
};
use crate::oracles::impact::{
    Normal, damping_ratio, dissipative_constant, time_of_elastic_overlap,
};
use crate::scenes::{Draft, Grain};
use gouge_dem::World;
use gouge_dem::integrators::Integrator;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "benchmarks.chung-ooi.1-3-elastic",
            claim: "In tests 1, 2 and 3, elastic spheres have the overlap, force and duration of Hertz's theory.",
            equations: thesis("(28), (37), (40)"),
            scene: "Two spheres of glass and of limestone at 10 m/s each; spheres of aluminium and magnesium alloy at 0.2 m/s, and of aluminium oxide and cast iron at 3.9 m/s, on a rigid plane; BSHP without dissipation, 4000 and 8000 steps per collision",
            oracle: "Closed forms: xi = (5 m v^2 / 4 P)^(2/5), P xi^(3/2), (4/5) B(2/5, 1/2) xi / v",
            norm: "Relative error of largest overlap, largest force and duration, extrapolated to zero time step",
            origin: Origin::Convergent,
            reason: "The error of velocity Verlet is of order dt^2, which extrapolation removes, plus zeta(-3/2) = 0.0255 of the coefficient of t^(3/2) times dt^(5/2) at the beginning and at most as much at the end: relative to the speed 0.9 n^(-5/2) with n steps, 3e-9 after extrapolation. Duration and overlap have at most three times this error",
            effort: Effort::Quick,
            measure: elastic,
        },
        Check {
            id: "benchmarks.chung-ooi.1-2-history",
            claim: "During the collisions of tests 1 and 2, force and overlap follow Hertz's theory at every moment.",
            equations: thesis("(28), (37), (40)"),
            scene: "The collisions of tests 1 and 2 with 800 steps",
            oracle: "Conservation of energy, (F / F_max)^(5/3) + (v / v_0)^2 = 1, and the incomplete beta function for the time of an overlap, t v_0 / xi_max = (2/5) B((xi / xi_max)^(5/2); 2/5, 1/2)",
            norm: "Largest error of that sum, and of the time over the duration, at every step",
            origin: Origin::Convergent,
            reason: "Velocity Verlet conserves the energy plus dt^2 (v^2 U'' / 12 - U'^2 / (24 m)). In units of the energy the first term is at most 16.2 / 6 times 0.7 and the second 3.68^2 / 12, times n^-2, together 3.1 n^-2; the error of the time is no larger",
            effort: Effort::Quick,
            measure: history,
        },
        Check {
            id: "benchmarks.chung-ooi.3",
            claim: "Test 3: spheres rebound with the requested restitution, from 0.2 to 1.",
            equations: thesis("(35)-(37)"),
            scene: "Spheres of aluminium oxide and cast iron at 3.9 m/s on a rigid plane, BSHP and truncated Kelvin-Voigt, 4000 and 8000 steps per collision",
            oracle: "The requested restitution; dissipative constant and damping from inverting the integrated collision and its closed form",
            norm: "Largest error of the restitution, extrapolated to zero time step where it falls with dt^(3/2)",
            origin: Origin::Convergent,
            reason: "The force has a kink at its end, where the error of the trapezoidal rule is an eighth of the jump of its rate times dt^2, at most (pi / n)^2 / 8 of the speed with n steps; the slow error of the oscillation doubles that. The steeper force of viscoelastic spheres doubles it again, and so does the extrapolation of its onset, which is like the square root of time",
            effort: Effort::Quick,
            measure: restitutions,
        },
    ]
}

/// A head-on collision.
struct HeadOn {
    solid: Material,
    radius: f64,
    /// Relative approach speed in m/s.
    speed: f64,
    /// Whether the partner is an equal sphere; otherwise it is a rigid plane.
    free: bool,
}

/// Tests 1 to 3.
const CASES: [HeadOn; 6] = [
    case(
        material("glass", [4.8e10, 0.20], 2800.0),
        [0.01, 20.0],
        true,
    ),
    case(
        material("limestone", [2.0e10, 0.25], 2500.0),
        [0.01, 20.0],
        true,
    ),
    case(
        material("aluminium alloy", [7.0e10, 0.30], 2699.0),
        [0.1, 0.2],
        false,
    ),
    case(
        material("magnesium alloy", [4.0e10, 0.35], 1800.0),
        [0.1, 0.2],
        false,
    ),
    case(
        material("aluminium oxide", [3.8e11, 0.23], 4000.0),
        [0.0025, 3.9],
        false,
    ),
    case(
        material("cast iron", [1.0e11, 0.25], 7000.0),
        [0.0025, 3.9],
        false,
    ),
];

const fn case(solid: Material, [radius, speed]: [f64; 2], free: bool) -> HeadOn {
    HeadOn {
        solid,
        radius,
        speed,
        free,
    }
}

/// A moment of a collision, from the kernel.
#[derive(Clone, Copy, Debug, Default)]
struct Moment {
    time: f64,
    overlap: f64,
    rate: f64,
    force: f64,
}

impl HeadOn {
    fn reduced_mass(&self) -> f64 {
        let mass = self.solid.mass(self.radius);
        if self.free { 0.5 * mass } else { mass }
    }
    /// Factor of the Hertzian force: both spheres deform, or one on a rigid plane.
    fn factor(&self) -> f64 {
        let plane = self.solid.factor_on_plane(self.radius);
        if self.free {
            plane / 8.0_f64.sqrt()
        } else {
            plane
        }
    }
    fn hertzian(&self, dissipation: f64) -> Normal {
        Normal::Hertzian([self.factor(), dissipation])
    }
    /// Duration in s and depth in m of the elastic collision.
    fn elastic(&self) -> [f64; 2] {
        self.hertzian(0.0).elastic(self.reduced_mass(), self.speed)
    }
    /// The scene. A plane is represented by a fixed sphere of the same radius: on the line of centres
    /// only the product of the modulus and the square root of the reduced radius matters, and sqrt(8)
    /// restores it.
    fn scene(&self, law: Normal, steps: u64) -> Draft {
        let radius = self.radius;
        let law = match law {
            Normal::Linear([stiffness, damping]) => linear(stiffness, damping),
            Normal::Hertzian([_, dissipation]) => {
                let factor = if self.free { 1.0 } else { 8.0_f64.sqrt() };
                self.solid.hertzian(factor, dissipation)
            }
        };
        let density = self.solid.density;
        let speed = if self.free {
            0.5 * self.speed
        } else {
            self.speed
        };
        // The largest height at which the distance is just below the sum of the radii.
        let height = (2.0 * radius).next_down();
        let partner = if self.free {
            Grain::at([0.0; 2], radius).moving([0.0, speed])
        } else {
            Grain::at([0.0; 2], radius).fixed()
        };
        Draft::open_box(Integrator::VelocityVerlet, self.elastic()[0] / steps as f64)
            .grain(
                Grain::at([0.0, height], radius)
                    .moving([0.0, -speed])
                    .of_density(density),
            )
            .grain(partner.of_density(density))
            .and(&law)
    }
    fn moment(&self, world: &World) -> Moment {
        let p = world.particles();
        Moment {
            time: world.time(),
            overlap: 2.0 * self.radius - (p.position[0].y - p.position[1].y),
            rate: p.velocity[1].y - p.velocity[0].y,
            force: world.forces().force[0].y,
        }
    }
    /// The kernel's collision, up to the first moment after it.
    fn run(&self, law: Normal, steps: u64) -> Result<Vec<Moment>, Failure> {
        let mut world = self.scene(law, steps).world()?;
        world.evaluate_if_pending()?;
        let mut moments = vec![self.moment(&world)];
        for _ in 0..LONGEST * steps {
            world.step()?;
            let moment = self.moment(&world);
            moments.push(moment);
            if moment.overlap < 0.0 {
                return Ok(moments);
            }
        }
        Err(Failure::Oracle("the spheres do not part".to_owned()))
    }
}

/// Number of elastic durations after which spheres count as stuck.
const LONGEST: u64 = 50;

/// Largest overlap, largest force and duration of a collision of the kernel, interpolated between its
/// steps.
fn peak(moments: &[Moment]) -> [f64; 3] {
    let turn = moments.partition_point(|moment| moment.rate > 0.0);
    let around = |n: usize| moments.get(n).copied().unwrap_or_default();
    let [before, top, after] = [0, 1, 2].map(|n| around((turn + n).saturating_sub(2)));
    let last = around(moments.len() - 1);
    // The rate falls linearly through zero; the force is a parabola through three moments.
    let step = top.time - before.time;
    let wait = step * top.rate / (top.rate - after.rate);
    let slope = 0.5 * (after.force - before.force);
    let bend = after.force - 2.0 * top.force + before.force;
    [
        top.overlap + 0.5 * top.rate * wait,
        top.force - 0.5 * slope * slope / bend,
        last.time - last.overlap / last.rate,
    ]
}

fn elastic() -> Outcome {
    let mut table = Table::new(
        "Elastic collisions of tests 1, 2 and 3: expected, and extrapolated from the kernel",
        &[
            "material",
            "overlap (m)",
            "kernel",
            "force (N)",
            "kernel",
            "duration (s)",
            "kernel",
            "digits",
        ],
    );
    let mut all = Vec::new();
    for case in &CASES {
        let [duration, deepest] = case.elastic();
        let expected = [deepest, case.factor() * deepest.powf(1.5), duration];
        let law = case.hertzian(0.0);
        let coarse = peak(&case.run(law, 4000)?);
        let fine = peak(&case.run(law, 8000)?);
        let measured = [0, 1, 2].map(|n| fine[n] + (fine[n] - coarse[n]) / 3.0);
        let checks = [0, 1, 2].map(|n| Measurement::relative(expected[n], measured[n], 1e-8));
        let digits = Measurement::worst(checks).digits();
        let mut row = vec![case.solid.name.to_owned()];
        for n in 0..3 {
            row.push(format!("{:.10e}", expected[n]));
            row.push(format!("{:.10e}", measured[n]));
        }
        row.push(format!("{digits:.1}"));
        table.push(row);
        all.extend(checks);
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

/// Number of steps of the collisions whose course is compared.
const STEPS: u64 = 800;

fn history() -> Outcome {
    let (mut all, mut by_time, mut by_overlap) = (Vec::new(), Vec::new(), Vec::new());
    let tolerance = 3.1 / (STEPS * STEPS) as f64;
    for case in CASES.iter().take(4) {
        let [duration, deepest] = case.elastic();
        let force = case.factor() * deepest.powf(1.5);
        let kernel = case.run(case.hertzian(0.0), STEPS)?;
        let during = kernel.iter().filter(|moment| moment.overlap > 0.0);
        for moment in during {
            let speed = moment.rate / case.speed;
            let energy = (moment.force / force).powf(5.0 / 3.0) + speed * speed;
            all.push(Measurement::absolute(1.0, energy, tolerance));
            let overlap = moment.overlap / deepest;
            let time = time_of_elastic_overlap(overlap, speed) * deepest / case.speed;
            all.push(Measurement::scaled(time, moment.time, duration, tolerance));
        }
        let name = case.solid.name;
        let (oracle, mark) = (format!("oracle: {name}"), format!("kernel: {name}"));
        let curve = elastic_curve();
        let thin = || kernel.iter().step_by(20);
        by_time.push(Curve::line(&oracle, curve.iter().map(|&[t, _, f]| [t, f])));
        by_time.push(Curve::marks(
            &mark,
            thin().map(|m| [m.time / duration, m.force / force]),
        ));
        by_overlap.push(Curve::line(&oracle, curve.iter().map(|&[_, x, f]| [x, f])));
        by_overlap.push(Curve::marks(
            &mark,
            thin().map(|m| [m.overlap / deepest, m.force / force]),
        ));
    }
    let figure = |title: &str, x: &str, curves| {
        Exhibit::Figure(Figure::new(
            title.to_owned(),
            Axis::linear(x, ""),
            Axis::linear("force over largest force", ""),
            curves,
        ))
    };
    Ok(Measurement::worst(all).showing([
        figure(
            "In units of the collision the force histories of all elastic spheres coincide",
            "time over duration",
            by_time,
        ),
        figure(
            "The force is proportional to the overlap to the power 3/2, in loading and in unloading",
            "overlap over largest overlap",
            by_overlap,
        ),
    ]))
}

/// Time over duration, and overlap and force over their largest values, in an elastic collision.
fn elastic_curve() -> Vec<[f64; 3]> {
    let whole = time_of_elastic_overlap(0.0, -1.0);
    let row = |n: u32| {
        let speed = (std::f64::consts::PI * f64::from(n) / 60.0).cos();
        let overlap = (1.0 - speed * speed).powf(0.4);
        let time = time_of_elastic_overlap(overlap, speed) / whole;
        [time, overlap, overlap.powf(1.5)]
    };
    (0..=60).map(row).collect()
}

fn restitutions() -> Outcome {
    let mut table = Table::new(
        "Test 3: requested and measured restitution",
        &[
            "requested",
            "material",
            "BSHP",
            "Kelvin-Voigt",
            "BSHP constant (s)",
            "damping ratio",
        ],
    );
    let mut all = Vec::new();
    let mut marks = [Vec::new(), Vec::new()];
    let kink = (std::f64::consts::PI / (2 * MANY) as f64).powi(2) / 8.0;
    for wanted in (2..=10).map(|n| 0.1 * f64::from(n)) {
        let relative = dissipative_constant(wanted)
            .ok_or_else(|| Failure::Oracle("no dissipative constant".to_owned()))?;
        let zeta = damping_ratio(wanted);
        for case in &CASES[4..] {
            let [duration, _] = case.elastic();
            let mass = case.reduced_mass();
            let stiffness = mass * (std::f64::consts::PI / duration).powi(2);
            let law = case.hertzian(relative * duration);
            let e = |law, steps| Ok::<f64, Failure>(rebound(&case.run(law, steps)?) / case.speed);
            let (coarse, fine) = (e(law, MANY)?, e(law, 2 * MANY)?);
            let hertzian = fine + (fine - coarse) / (8.0_f64.sqrt() - 1.0);
            let damping = 2.0 * zeta * (stiffness * mass).sqrt();
            let linear = e(Normal::Linear([stiffness, damping]), 2 * MANY)?;
            all.push(Measurement::absolute(wanted, hertzian, 8.0 * kink));
            all.push(Measurement::absolute(wanted, linear, 2.0 * kink));
            marks[0].push([wanted, (hertzian - wanted).abs()]);
            marks[1].push([wanted, (linear - wanted).abs()]);
            table.push([
                format!("{wanted:.1}"),
                case.solid.name.to_owned(),
                format!("{hertzian:.10}"),
                format!("{linear:.10}"),
                format!("{:.9e}", relative * duration),
                format!("{zeta:.12}"),
            ]);
        }
    }
    let [viscoelastic, kelvin_voigt] = marks;
    let plot = Figure::new(
        "The error of the restitution is below the bound from the kink of the force",
        Axis::linear("requested restitution", ""),
        Axis::logarithmic("error of the restitution", ""),
        vec![
            Curve::marks("BSHP, extrapolated", viscoelastic),
            Curve::marks("Kelvin-Voigt", kelvin_voigt),
        ],
    );
    Ok(Measurement::worst(all).showing([Exhibit::Table(table), Exhibit::Figure(plot)]))
}

/// Number of steps of the collisions whose restitution is measured; the finer ones have twice as many.
const MANY: u64 = 4000;

/// Speed after the collision.
fn rebound(moments: &[Moment]) -> f64 {
    moments.last().map_or(f64::NAN, |moment| -moment.rate)
}
