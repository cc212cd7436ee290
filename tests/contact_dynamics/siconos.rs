//! Steps of many bodies against Siconos, whose problems and solutions are stored in `references/siconos`.

use crate::stored::{Table, number, read};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::delassus::PointKinematics;
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::sweep::{ContactInput, Solver, StopCriterion, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Load, Velocity};
use serde_json::Value;

const CASE: &str = "siconos/one-step";

/// Residual of a solution in units of the scale.
const CERTIFIED: f64 = 1e-11;

/// A step with the solution of Siconos.
struct Problem {
    name: String,
    law: ContactLaw,
    time_step: f64,
    masses: Vec<InverseMass>,
    before: Vec<Velocity>,
    free: Vec<Velocity>,
    points: Vec<ContactInput>,
    velocities: Vec<Velocity>,
    impulses: Vec<Components>,
    is_unique: Vec<bool>,
    /// Largest velocity to which the laws apply without impulses, in m/s.
    scale: f64,
    /// Residual of the stored impulses in units of the scale.
    residual: f64,
    /// Largest difference of velocities between certified solves of Siconos from nothing, in units of the scale.
    /// From large random impulses, some problems have further solutions, which are stresses without loads.
    spread: f64,
}

/// Our solution.
struct Found {
    velocities: Vec<Velocity>,
    impulses: Vec<Components>,
    residual: f64,
}

fn problems() -> Vec<Problem> {
    let result = read(&format!("{CASE}/result.json"));
    let runs = result["runs"].as_array().unwrap();
    let mut problems: Vec<_> = runs.iter().map(Problem::new).collect();
    problems.sort_by_key(|problem| problem.points.len());
    problems
}

fn point(table: &Table, row: usize) -> ContactInput {
    let cell = |column| table.cell(row, column);
    let angle = cell("normal");
    let arm = |n, t| Components {
        n: cell(n),
        t: cell(t),
    };
    ContactInput {
        kinematics: PointKinematics {
            units: [cell("first") as u32, cell("second") as u32],
            normal: Vec2::new(angle.cos(), angle.sin()),
            arms: [arm("first_n", "first_t"), arm("second_n", "second_t")],
        },
        gap: cell("gap"),
        impulse: Components::default(),
    }
}

fn velocities(table: &Table) -> Vec<Velocity> {
    let row = |row| Velocity {
        linear: Vec2::new(table.cell(row, "vx"), table.cell(row, "vy")),
        angular: table.cell(row, "omega"),
    };
    (0..table.len()).map(row).collect()
}

fn masses(table: &Table) -> Vec<InverseMass> {
    let row = |row| InverseMass {
        x: table.cell(row, "inverse_mass_x"),
        y: table.cell(row, "inverse_mass_y"),
        rotation: table.cell(row, "inverse_moment"),
    };
    (0..table.len()).map(row).collect()
}

fn loads(table: &Table) -> Vec<Load> {
    let row = |row| Load {
        force: Vec2::new(table.cell(row, "fx"), table.cell(row, "fy")),
        torque: table.cell(row, "torque"),
    };
    (0..table.len()).map(row).collect()
}

fn law(data: &Value) -> ContactLaw {
    ContactLaw {
        friction: number(data, "friction"),
        restitution: Components {
            n: number(data, "normal_restitution"),
            t: number(data, "tangential_restitution"),
        },
        gap: GapRule::Predicted,
    }
}

impl Problem {
    fn new(run: &Value) -> Self {
        let name = run["name"].as_str().unwrap();
        let data = read(&format!("{CASE}/problems/{name}.json"));
        let time_step = number(&data, "time_step");
        let [units, points] = ["units", "points"].map(|key| Table::new(&data[key]));
        let [after, impulses, solves] =
            ["velocities", "impulses", "solves"].map(|key| Table::new(&run[key]));
        let (masses, before) = (masses(&units), velocities(&units));
        let accelerate = |((mass, &velocity), load): ((&InverseMass, &Velocity), Load)| {
            mass.accelerated(velocity, load, time_step)
        };
        let loaded = masses.iter().zip(&before).zip(loads(&units));
        let differences = (0..solves.len())
            .filter(|&row| solves.text(row, "start") == "zero")
            .filter(|&row| solves.cell(row, "residual") < CERTIFIED)
            .map(|row| solves.cell(row, "velocity_difference"));
        let impulse = |row| Components {
            n: impulses.cell(row, "normal"),
            t: impulses.cell(row, "tangential"),
        };
        Self {
            name: name.to_owned(),
            law: law(&data),
            time_step,
            free: loaded.map(accelerate).collect(),
            points: (0..points.len()).map(|row| point(&points, row)).collect(),
            velocities: velocities(&after),
            impulses: (0..impulses.len()).map(impulse).collect(),
            is_unique: (0..impulses.len())
                .map(|row| impulses.cell(row, "unique") == 1.0)
                .collect(),
            scale: number(run, "scale"),
            residual: number(run, "residual"),
            spread: differences.fold(0.0, f64::max),
            masses,
            before,
        }
    }

    /// Sweeps from the given first guesses.
    fn solve(&self, points: &[ContactInput], most: usize) -> Found {
        let settings = SweepSettings {
            stop: StopCriterion::NaturalMap {
                velocity: 1e-13 * self.scale,
            },
            max_sweeps: most,
            ..SweepSettings::default()
        };
        let mut solver = Solver::new();
        let mut velocities = self.free.clone();
        solver.prepare(
            points,
            &self.law,
            self.time_step,
            &self.before,
            &self.masses,
        );
        solver.solve(&settings, &self.masses, &mut velocities);
        Found {
            residual: solver.residual(&velocities) / self.scale,
            impulses: solver.rows().iter().map(|row| row.impulse()).collect(),
            velocities,
        }
    }

    /// Largest difference of a velocity from that of Siconos, in units of the scale.
    fn difference(&self, found: &Found) -> f64 {
        let pairs = found.velocities.iter().zip(&self.velocities);
        let parts = pairs.flat_map(|(one, other)| {
            let linear = one.linear - other.linear;
            [linear.x, linear.y, one.angular - other.angular]
        });
        parts.fold(0.0, |largest: f64, part| largest.max(part.abs())) / self.scale
    }

    /// Largest difference of a unique impulse from that of Siconos, in units of the largest impulse.
    fn difference_of_impulses(&self, found: &Found) -> f64 {
        let size = |p: &Components| p.n.abs().max(p.t.abs());
        let largest = self.impulses.iter().map(size).fold(0.0, f64::max);
        let pairs = found.impulses.iter().zip(&self.impulses);
        let unique = pairs.zip(&self.is_unique).filter(|(_, is)| **is);
        let parts = unique.map(|((one, other), _)| {
            size(&Components {
                n: one.n - other.n,
                t: one.t - other.t,
            })
        });
        parts.fold(0.0, f64::max) / largest
    }

    /// The points with the impulses of Siconos as first guesses.
    fn guessed(&self) -> Vec<ContactInput> {
        let pairs = self.points.iter().zip(&self.impulses);
        let with_impulse = |(&point, &impulse)| ContactInput { impulse, ..point };
        pairs.map(with_impulse).collect()
    }

    /// Difference of the kinetic energies after the step, in units of the larger one with and without impulses.
    fn difference_of_energies(&self, found: &Found) -> f64 {
        let theirs = self.kinetic_energy(&self.velocities);
        let scale = theirs.max(self.kinetic_energy(&self.free));
        (self.kinetic_energy(&found.velocities) - theirs).abs() / scale
    }

    fn kinetic_energy(&self, velocities: &[Velocity]) -> f64 {
        let units = self.masses.iter().zip(velocities);
        units.map(|(mass, &v)| mass.kinetic_energy(v)).sum()
    }
}

/// Number of points up to which sweeps solve a problem from nothing in a test; larger ones need more than 1e5 sweeps.
const LARGEST_FROM_NOTHING: usize = 250;

/// The impulses of Siconos give its velocities, and leave the residual that was found for them without our code.
#[test]
fn impulses_of_siconos_satisfy_the_laws() {
    for problem in problems() {
        let found = problem.solve(&problem.guessed(), 0);
        let (name, difference) = (&problem.name, problem.difference(&found));
        // Rounding of velocities of 1e3 impulses, which are up to 1e3 times the largest momentum of the scale.
        assert!(difference < 1e-10, "{name}: {difference:e}");
        let excess = (found.residual - problem.residual).abs();
        assert!(excess < 1e-10, "{name}: {:e}", found.residual);
        assert!(
            problem.residual < CERTIFIED,
            "{name}: {:e}",
            problem.residual
        );
    }
}

/// Sweeps leave the solutions of Siconos where they are.
#[test]
fn solutions_of_siconos_are_fixed_points_of_sweeps() {
    for problem in problems() {
        let found = problem.solve(&problem.guessed(), 100);
        let (name, difference) = (&problem.name, problem.difference(&found));
        assert!(difference < 1e-9, "{name}: {difference:e}");
        let energy = problem.difference_of_energies(&found);
        assert!(energy < 1e-9, "{name}: {energy:e}");
    }
}

/// Sweeps from nothing find the velocities of Siconos, and its impulses where all its solves agree about them.
#[test]
fn sweeps_find_the_solutions_of_siconos() {
    for problem in problems() {
        if problem.points.len() > LARGEST_FROM_NOTHING {
            continue;
        }
        let found = problem.solve(&problem.points, 500_000);
        let name = &problem.name;
        // The solves of Siconos agree to 1e-9, and residuals of 1e-13 are amplified a thousandfold at most.
        assert!(problem.spread < 1e-9, "{name}: {:e}", problem.spread);
        assert!(found.residual < 1.01e-13, "{name}: {:e}", found.residual);
        let difference = problem.difference(&found);
        assert!(difference < 1e-7, "{name}: {difference:e}");
        let difference = problem.difference_of_impulses(&found);
        assert!(difference < 1e-7, "{name}: {difference:e}");
        let energy = problem.difference_of_energies(&found);
        assert!(energy < 1e-6, "{name}: {energy:e}");
    }
}
