//! Differences between the laws of other programs and of the thesis: their size and their origin.

use super::motion::{difference, recorded_motion};
use super::stored;
use crate::checks::dem::scenes::{advance, bits};
use crate::checks::{
    Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, largest, thesis,
};
use crate::oracles::oscillator::truncated_restitution;
use crate::references::{Case, RecordedRun, Run};
use crate::scenes::Draft;
use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::geometry::PairFrame;
use gouge_dem::model::ContactTangential;

/// The checks of this file.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "references.differences.cundall-strack",
            claim: "The printed spring of (42) and the truncated spring of LAMMPS and YADE give the same bits until a contact at the Coulomb limit should unload. Then the printed force stays at the limit, against the velocity, and the truncated force follows its spring.",
            equations: thesis("(42), E15"),
            scene: "The runs of lammps/cundall-strack with both laws",
            oracle: "In the first step that differs, the printed force is the Coulomb limit, and the truncated force is below it or has the opposite sign",
            norm: "Number of runs that diverge in another way",
            origin: Origin::Exact,
            reason: "The operations and numbers are the same before that step; magnitudes are compared to 1e-12",
            effort: Effort::Quick,
            measure: cundall_strack,
        },
        Check {
            id: "references.differences.inertia",
            claim: "If a contact slides throughout, discs with the inertia of cylinders move like spheres, and their spins change by four fifths as much; with an inertia factor of 1/2 the kernel reproduces these spins.",
            equations: thesis("(41), (53)"),
            scene: "The runs of lammps/disc-inertia",
            oracle: "LAMMPS with the moment of inertia of a disc; the spheres' change of spin is multiplied by (2/5) / (1/2)",
            norm: "Largest error of a position, velocity or spin after the impact, in units of the distance travelled, the speed and the spin",
            origin: Origin::Exact,
            reason: "Both programs make the same steps, and only the sign of the sliding velocity, which never changes, depends on the spins: rounding of 4000 steps",
            effort: Effort::Quick,
            measure: inertia,
        },
        Check {
            id: "references.differences.damping",
            claim: "A damping coefficient has three meanings: gamma itself or gamma over the effective mass in LAMMPS, and twice gamma in YADE, where two materials act in series. Interpreted accordingly, all rebounds have the restitution of (36).",
            equations: thesis("(35), (36)"),
            scene: "The runs of lammps/kelvin-voigt, lammps/mass-damping and yade/kelvin-voigt",
            oracle: "Closed form of the truncated Kelvin-Voigt collision",
            norm: "Error of the restitution in units of 2 zeta w dt + (w dt)^2",
            origin: Origin::Convergent,
            reason: "Forces from velocities half a step old change the damping by 2 zeta w dt, the step in which contact begins by as much, and Verlet changes the frequency by (w dt)^2 / 24: less than one unit in total",
            effort: Effort::Quick,
            measure: damping,
        },
        Check {
            id: "references.differences.arms",
            claim: "With the thesis's lever arms, all equal to the radius or all to the distance to the focal point, the motion differs from that of programs that mix them by at most eight overlaps, in units of the smallest radius.",
            equations: thesis("(7), (34), (45), (112)"),
            scene: "Oblique impacts of LAMMPS and YADE, with their time stepping but the thesis's lever arms",
            oracle: "The recorded motion",
            norm: "Largest error of a recorded quantity, in units of the largest of its kind and of the largest overlap over the smallest radius",
            origin: Origin::Convergent,
            reason: "Rotation, translation and torque each enter with a factor that differs by at most one overlap over the diameter of the smaller disc. Together they change the tangential force by less than two overlaps over the radius, and the phase of its oscillation by one per radian; a contact lasts pi sqrt(7 k_t / 2 k_n), at most 5.6 radians",
            effort: Effort::Quick,
            measure: arms,
        },
    ]
}

/// Cases of oblique impacts.
const OBLIQUE: [&str; 6] = [
    "lammps/haff-werner",
    "lammps/cundall-strack",
    "lammps/gran-hooke",
    "lammps/gran-hooke-history",
    "yade/cundall-strack",
    "yade/granular-ratcheting",
];

fn arms() -> Outcome {
    let mut table = Table::new(
        "Difference from the recorded motion, in units of the largest of its kind",
        &[
            "case",
            "run",
            "overlap / radius",
            "mixed, as recorded",
            "all radius",
            "all focal",
        ],
    );
    let mut measured = Vec::new();
    for path in OBLIQUE {
        let case = stored(path)?;
        for (run, recorded) in case.runs.iter().zip(&case.result.runs) {
            let draft = draft(case, run)?;
            let theirs = difference(&draft, recorded)?;
            let [radius, focal] = ["radius", "focal"].map(|distance| {
                let own = draft.clone().replacing("contact.distance", distance);
                difference(&own, recorded)
            });
            let (radius, focal) = (radius?.largest(), focal?.largest());
            measured.extend([radius, focal].map(|size| size / theirs.depth));
            table.push([
                path.to_owned(),
                run.name.clone(),
                format!("{:.2e}", theirs.depth),
                format!("{:.1e}", theirs.largest()),
                format!("{radius:.1e}"),
                format!("{focal:.1e}"),
            ]);
        }
    }
    let measurement = Measurement::absolute(0.0, largest(measured), 8.0);
    Ok(measurement.showing([Exhibit::Table(table)]))
}

/// The scene of a run.
fn draft(case: &Case, run: &Run) -> Result<Draft, Failure> {
    case.draft(run).map_err(Failure::Oracle)
}

/// Steps in a run of an impact.
const STEPS: u64 = 4000;

fn cundall_strack() -> Outcome {
    let case = stored("lammps/cundall-strack")?;
    let mut table = Table::new(
        "Spin of the first disc after the impact in rad/s, with the lever arms and time stepping of LAMMPS",
        &[
            "run",
            "laws diverge in step",
            "how",
            "LAMMPS",
            "truncated",
            "printed",
            "difference, % of the spin change",
        ],
    );
    let mut wrong = 0;
    for (run, recorded) in case.runs.iter().zip(&case.result.runs) {
        let parting = part(case, run)?;
        wrong += usize::from(parting.place == Place::Elsewhere);
        let motion = recorded_motion(recorded)?;
        let place = motion.column("omegaz").map_err(Failure::Oracle)?;
        let engine = motion.rows[motion.rows.len() - 2][place];
        let [began, truncated, printed] = parting.spins;
        let change = 100.0 * (printed - truncated) / (truncated - began).abs();
        table.push([
            run.name.clone(),
            parting
                .step
                .map_or_else(|| "never".to_owned(), |step| step.to_string()),
            parting.place.text().to_owned(),
            format!("{engine:.6}"),
            format!("{truncated:.6}"),
            format!("{printed:.6}"),
            format!("{change:+.4}"),
        ]);
    }
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table)]))
}

/// The state in which the two springs diverge.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    Nowhere,
    /// The truncated spring has fallen below the limit.
    Holds,
    /// The truncated spring, at the limit, points against the printed force.
    Turned,
    Elsewhere,
}

impl Place {
    fn text(self) -> &'static str {
        match self {
            Self::Nowhere => "",
            Self::Holds => "the contact sticks again",
            Self::Turned => "the limit falls below a spring that unloads",
            Self::Elsewhere => "otherwise",
        }
    }

    /// From the tangential forces of both laws, truncated and printed, and the Coulomb limit.
    fn of([truncated, printed]: [f64; 2], limit: f64) -> Self {
        let is_limit = (printed.abs() - limit).abs() <= 1e-12 * limit;
        if is_limit && truncated.abs() < limit * (1.0 - 1e-12) {
            Self::Holds
        } else if is_limit && truncated * printed < 0.0 {
            Self::Turned
        } else {
            Self::Elsewhere
        }
    }
}

/// How the two springs diverge in an impact.
struct Parting {
    step: Option<u64>,
    place: Place,
    /// Spins of the first disc: before, after with the truncated law, after with the printed law.
    spins: [f64; 3],
}

fn part(case: &Case, run: &Run) -> Result<Parting, Failure> {
    let draft = draft(case, run)?;
    let mut truncated = draft.world()?;
    let printed = draft.replacing("contact.tangential.law", "cundall-strack");
    let mut printed = printed.world()?;
    let spin = |world: &World| world.particles().angular_velocity[0];
    let began = spin(&truncated);
    let (mut step, mut place) = (None, Place::Nowhere);
    for _ in 0..STEPS {
        advance(&mut truncated, 1)?;
        advance(&mut printed, 1)?;
        if step.is_none() && bits(&truncated) != bits(&printed) {
            step = Some(truncated.steps());
            let [normal, spring] = components(&truncated);
            let forces = [spring, components(&printed)[1]];
            place = Place::of(forces, friction(&truncated)? * normal.abs());
        }
    }
    Ok(Parting {
        step,
        place,
        spins: [began, spin(&truncated), spin(&printed)],
    })
}

/// Normal and tangential force on the first of two discs in N.
fn components(world: &World) -> [f64; 2] {
    let p = world.particles();
    let frame = PairFrame::new(p.position[1] - p.position[0]);
    let force = world.forces().force[0];
    [force.dot(frame.normal), force.dot(frame.tangent())]
}

/// Coefficient of friction of the contacts.
fn friction(world: &World) -> Result<f64, Failure> {
    match world.model().contact.and_then(|contact| contact.tangential) {
        Some(ContactTangential::CundallStrackTruncated(law)) => Ok(law.friction),
        _ => Err(Failure::Oracle(
            "the scene has no truncated spring".to_owned(),
        )),
    }
}

fn inertia() -> Outcome {
    let case = stored("lammps/disc-inertia")?;
    let mut table = Table::new(
        "Change of the spin of the first disc in rad/s",
        &[
            "run",
            "sphere, kernel",
            "disc, kernel",
            "disc, LAMMPS",
            "ratio",
        ],
    );
    let mut measured = Vec::new();
    for (run, recorded) in case.runs.iter().zip(&case.result.runs) {
        let draft = draft(case, run)?;
        let mut world = draft.world()?;
        let mut disc = draft.with("material.inertia_factor", 0.5).world()?;
        let began = world.particles().angular_velocity.clone();
        advance(&mut world, STEPS)?;
        advance(&mut disc, STEPS)?;
        let (p, d) = (world.particles(), disc.particles());
        let motion = recorded_motion(recorded)?;
        let names = ["x", "y", "vx", "vy", "omegaz"];
        let [x, y, vx, vy, omegaz] = motion.places(names).map_err(Failure::Oracle)?;
        for (i, row) in motion.rows.iter().rev().take(2).rev().enumerate() {
            let place = Vec2::new(row[x], row[y]);
            let velocity = Vec2::new(row[vx], row[vy]);
            let expected = began[i] + 0.8 * (p.angular_velocity[i] - began[i]);
            let travelled = STEPS as f64 * world.model().time_step * p.velocity[i].norm();
            measured.push((p.position[i] - place).norm() / travelled);
            measured.push((p.velocity[i] - velocity).norm() / p.velocity[i].norm());
            measured.push((row[omegaz] - expected).abs() / expected.abs());
            measured.push((d.position[i] - place).norm() / travelled);
            measured.push((d.velocity[i] - velocity).norm() / d.velocity[i].norm());
            measured.push((row[omegaz] - d.angular_velocity[i]).abs() / expected.abs());
            if i == 0 {
                let spins = [p.angular_velocity[0], d.angular_velocity[0], row[omegaz]];
                let [sphere, ours, engine] = spins.map(|w| w - began[0]);
                table.push([
                    run.name.clone(),
                    format!("{sphere:.9}"),
                    format!("{ours:.9}"),
                    format!("{engine:.9}"),
                    format!("{:.12}", engine / sphere),
                ]);
            }
        }
    }
    let measurement = Measurement::absolute(0.0, largest(measured), 1e-12);
    Ok(measurement.showing([Exhibit::Table(table)]))
}

fn damping() -> Outcome {
    let mut table = Table::new(
        "Restitution of the recorded rebounds, and restitution if the engine's coefficient is taken as gamma in kg/s",
        &[
            "case",
            "run",
            "gamma in kg/s",
            "coefficient of the engine",
            "restitution",
            "closed form",
            "coefficient taken as gamma",
        ],
    );
    let mut measured = Vec::new();
    for (path, given) in [
        ("lammps/kelvin-voigt", Given::Itself),
        ("lammps/mass-damping", Given::OverMass),
        ("yade/kelvin-voigt", Given::Twice),
    ] {
        let case = stored(path)?;
        for (run, recorded) in case.runs.iter().zip(&case.result.runs) {
            let world = draft(case, run)?.world()?;
            let collision = Collision::of(&world)?;
            let found = restitution(recorded)?;
            let expected = truncated_restitution(collision.ratio);
            let number = given.number(&collision);
            let misread = truncated_restitution(collision.ratio * number / collision.damping);
            let step = collision.frequency * world.model().time_step;
            let unit = 2.0 * collision.ratio * step + step * step;
            measured.push(Measurement::scaled(expected, found, unit, 1.0));
            table.push([
                path.to_owned(),
                run.name.clone(),
                format!("{:.6}", collision.damping),
                format!("{number:.6e}"),
                format!("{found:.6}"),
                format!("{expected:.6}"),
                if collision.damping > 0.0 {
                    format!("{misread:.6}")
                } else {
                    "-".to_owned()
                },
            ]);
        }
    }
    Ok(Measurement::worst(measured).showing([Exhibit::Table(table)]))
}

/// The meaning of an engine's damping coefficient.
#[derive(Clone, Copy)]
enum Given {
    Itself,
    OverMass,
    Twice,
}

impl Given {
    fn number(self, collision: &Collision) -> f64 {
        match self {
            Self::Itself => collision.damping,
            Self::OverMass => collision.damping / collision.mass,
            Self::Twice => 2.0 * collision.damping,
        }
    }
}

/// Constants of a head-on collision.
struct Collision {
    /// Effective mass in kg.
    mass: f64,
    /// Damping in kg/s.
    damping: f64,
    /// Angular frequency in rad/s.
    frequency: f64,
    /// Damping ratio.
    ratio: f64,
}

impl Collision {
    fn of(world: &World) -> Result<Self, Failure> {
        let p = world.particles();
        let contact = world.model().contact;
        let contact = contact.ok_or_else(|| Failure::Oracle("no contacts".to_owned()))?;
        let mass = p.mass[0] * p.mass[1] / (p.mass[0] + p.mass[1]);
        let [stiffness, damping] = contact.normal.linearised([p.radius[0], p.radius[1]], mass);
        let frequency = (stiffness / mass).sqrt();
        Ok(Self {
            mass,
            damping,
            frequency,
            ratio: damping / (2.0 * mass * frequency),
        })
    }
}

/// Relative speed after a recorded collision over the relative speed before it.
fn restitution(recorded: &RecordedRun) -> Result<f64, Failure> {
    let motion = recorded_motion(recorded)?;
    let place = motion.column("vx").map_err(Failure::Oracle)?;
    let opening = |rows: &[Vec<f64>]| rows[1][place] - rows[0][place];
    let rows = &motion.rows;
    Ok(-opening(&rows[rows.len() - 2..]) / opening(&rows[..2]))
}
