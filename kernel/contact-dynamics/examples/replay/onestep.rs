//! One step of several bodies with given contact points.

use crate::{id, items, number, numbers};
use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::delassus::PointKinematics;
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::sweep::{ContactInput, Solver, StopCriterion, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Load, Velocity};
use serde_json::{Map, Value, json};

pub fn results(cases: &Value) -> Map<String, Value> {
    items(cases, "problems")
        .map(|case| (id(case), solve(case)))
        .collect()
}

fn vector(value: &Value) -> Vec2 {
    let parts = numbers(value);
    Vec2::new(parts[0], parts[1])
}

fn contact(case: &Value, point: &Value) -> ContactInput {
    let domain = Domain {
        width: case["period_x"].as_f64(),
        height: None,
        periodic: true,
    };
    let bodies = ["a", "b"].map(|key| &case["bodies"][number(point, key) as usize]);
    let place = vector(&point["p"]);
    let arm = |body: &Value| {
        let centre = Vec2::new(number(body, "x"), number(body, "y"));
        domain.displacement(centre, place)
    };
    let units = bodies.map(|body| number(body, "dof") as u32);
    ContactInput {
        kinematics: PointKinematics::new(units, vector(&point["n"]), bodies.map(arm)),
        gap: number(point, "g"),
        impulse: Components::default(),
    }
}

fn law(case: &Value) -> ContactLaw {
    ContactLaw {
        friction: number(case, "mu"),
        restitution: Components {
            n: number(case, "e_n"),
            t: number(case, "e_t"),
        },
        gap: match case["gap_mode"].as_str() {
            Some("closed") => GapRule::Closed,
            _ => GapRule::Predicted,
        },
    }
}

fn solve(case: &Value) -> Value {
    let time_step = number(case, "dt");
    let columns = |key: &'static str| items(case, "dofs").map(move |unit| numbers(&unit[key]));
    let before: Vec<_> = columns("velocity")
        .map(|v| Velocity {
            linear: Vec2::new(v[0], v[1]),
            angular: v[2],
        })
        .collect();
    let inverse_masses: Vec<_> = columns("inv_mass")
        .map(|w| InverseMass {
            x: w[0],
            y: w[1],
            rotation: w[2],
        })
        .collect();
    let loads: Vec<_> = columns("force")
        .map(|f| Load {
            force: Vec2::new(f[0], f[1]),
            torque: f[2],
        })
        .collect();
    let points: Vec<_> = items(case, "contacts")
        .map(|point| contact(case, point))
        .collect();
    let law = law(case);
    let mut solver = Solver::new();
    solver.prepare(&points, &law, time_step, &before, &inverse_masses);
    let accelerate =
        |unit: usize| inverse_masses[unit].accelerated(before[unit], loads[unit], time_step);
    let mut velocities: Vec<_> = (0..before.len()).map(accelerate).collect();
    let settings = SweepSettings {
        stop: StopCriterion::NaturalMap {
            velocity: 1e-13 * number(&case["solution"], "velocity_scale"),
        },
        max_sweeps: if case["hard"] == true {
            20_000
        } else {
            1_000_000
        },
        ..SweepSettings::default()
    };
    let report = solver.solve(&settings, &inverse_masses, &mut velocities);
    eprintln!(
        "{} {}: {report:?}, residual {:e}",
        id(case),
        case["kind"],
        solver.residual(&velocities)
    );
    let velocities: Vec<_> = velocities
        .iter()
        .map(|v| [v.linear.x, v.linear.y, v.angular])
        .collect();
    let impulses: Vec<_> = solver
        .rows()
        .iter()
        .map(|row| [row.impulse().n, row.impulse().t])
        .collect();
    json!({"velocities": velocities, "impulses": impulses})
}
