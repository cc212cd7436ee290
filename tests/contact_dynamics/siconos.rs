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
    /// Largest difference of velocities between the starts of Siconos, in units of the scale.
    spread: f64,
}

/// Our solution.
struct Found {
    velocities: Vec<Velocity>,
    impulses: Vec<Components>,
    residual: f64,
    sweeps: usize,
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

impl Problem {
    fn new(run: &Value) -> Self {
        let name = run["name"].as_str().unwrap();
        let data = read(&format!("{CASE}/problems/{name}.json"));
        let time_step = number(&data, "time_step");
        let units = Table::new(&data["units"]);
        let row = |row, columns: [&str; 3]| columns.map(|column| units.cell(row, column));
        let velocity = |[x, y, angular]: [f64; 3]| Velocity {
            linear: Vec2::new(x, y),
            angular,
        };
        let count = units.len();
        let masses: Vec<_> = (0..count)
            .map(|unit| row(unit, ["inverse_mass_x", "inverse_mass_y", "inverse_moment"]))
            .map(|[x, y, rotation]| InverseMass { x, y, rotation })
            .collect();
        let before: Vec<_> = (0..count)
            .map(|unit| velocity(row(unit, ["vx", "vy", "omega"])))
            .collect();
        let accelerated = |unit: usize| {
            let [x, y, torque] = row(unit, ["fx", "fy", "torque"]);
            let force = Vec2::new(x, y);
            masses[unit].accelerated(before[unit], Load { force, torque }, time_step)
        };
        let free = (0..count).map(accelerated).collect();
        let points = Table::new(&data["points"]);
        let after = Table::new(&run["velocities"]);
        let impulses = Table::new(&run["impulses"]);
        let solves = Table::new(&run["solves"]);
        let restitution = Components {
            n: number(&data, "normal_restitution"),
            t: number(&data, "tangential_restitution"),
        };
        let law = ContactLaw {
            friction: number(&data, "friction"),
            restitution,
            gap: GapRule::Predicted,
        };
        Self {
            name: name.to_owned(),
            law,
            time_step,
            free,
            points: (0..points.len()).map(|row| point(&points, row)).collect(),
            velocities: (0..after.len())
                .map(|unit| velocity(["vx", "vy", "omega"].map(|c| after.cell(unit, c))))
                .collect(),
            impulses: (0..impulses.len())
                .map(|row| Components {
                    n: impulses.cell(row, "normal"),
                    t: impulses.cell(row, "tangential"),
                })
                .collect(),
            is_unique: (0..impulses.len())
                .map(|row| impulses.cell(row, "unique") == 1.0)
                .collect(),
            scale: number(run, "scale"),
            residual: number(run, "residual"),
            spread: (0..solves.len())
                .map(|row| solves.cell(row, "velocity_difference"))
                .fold(0.0, f64::max),
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
        let report = solver.solve(&settings, &self.masses, &mut velocities);
        Found {
            residual: solver.residual(&velocities) / self.scale,
            sweeps: report.sweeps,
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

    fn kinetic_energy(&self, velocities: &[Velocity]) -> f64 {
        let units = self.masses.iter().zip(velocities);
        units.map(|(mass, &v)| mass.kinetic_energy(v)).sum()
    }
}

/// The impulses of Siconos give its velocities, and leave the residual that was found for them without our code.
#[test]
fn impulses_of_siconos_satisfy_the_laws() {
    for problem in problems() {
        let mut points = problem.points.clone();
        for (point, &impulse) in points.iter_mut().zip(&problem.impulses) {
            point.impulse = impulse;
        }
        let found = problem.solve(&points, 0);
        let (name, difference) = (&problem.name, problem.difference(&found));
        // Rounding: some 1000 impulses of some 1000 times the momentum of the scale.
        assert!(difference < 1e-11, "{name}: {difference:e}");
        let excess = (found.residual - problem.residual).abs();
        assert!(excess < 1e-11, "{name}: {:e}", found.residual);
        assert!(problem.residual < 1e-9, "{name}: {:e}", problem.residual);
    }
}

/// Sweeps from nothing find the velocities of Siconos, and its impulses where all its starts agree about them.
#[test]
fn sweeps_find_the_solutions_of_siconos() {
    for problem in problems() {
        let found = problem.solve(&problem.points, 200_000);
        let name = &problem.name;
        eprintln!(
            "{name}: {} points, sweeps {}, residual {:.1e} ({:.1e}), velocities {:.1e} (spread {:.1e}), impulses {:.1e}, energy {:.1e}",
            problem.points.len(),
            found.sweeps,
            found.residual,
            problem.residual,
            problem.difference(&found),
            problem.spread,
            problem.difference_of_impulses(&found),
            problem.kinetic_energy(&found.velocities) / problem.kinetic_energy(&problem.velocities) - 1.0,
        );
    }
}
