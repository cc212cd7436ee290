//! One step of several bodies with given contact points.

use super::Case;
use super::geometry::{centre, domain};
use crate::error::Fault;
use crate::fields::Fields;
use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::delassus::PointKinematics;
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::sweep::{ContactInput, Solver, StopCriterion, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Load, Velocity};
use serde_json::{Value, json};

/// Largest number of updates of points, so that a problem whose sweeps hardly converge ends.
const UPDATES: usize = 150_000_000;

/// Residual at which sweeps stop, relative to the largest velocity of the problem.
const RESIDUAL: f64 = 1e-14;

/// The units of a problem as columns.
struct Units {
    before: Vec<Velocity>,
    inverse_masses: Vec<InverseMass>,
    loads: Vec<Load>,
}

/// Velocities and impulses after the step, how many sweeps it took, and the remaining residual in m/s.
pub fn solve(case: &Case) -> Result<Value, Fault> {
    let fields = &case.fields;
    let time_step = fields.positive("dt")?;
    let units = units(fields)?;
    let points = contacts(fields, units.before.len())?;
    let law = law(fields)?;
    let masses = &units.inverse_masses;
    let mut solver = Solver::new();
    solver.prepare(&points, &law, time_step, &units.before, masses);
    let accelerate =
        |unit: usize| masses[unit].accelerated(units.before[unit], units.loads[unit], time_step);
    let mut velocities: Vec<_> = (0..masses.len()).map(accelerate).collect();
    let speeds = points.iter().flat_map(|point| {
        let [before, free] =
            [&units.before, &velocities].map(|v| point.kinematics.relative_velocity(v));
        [before.n, before.t, free.n, free.t]
    });
    let fastest = speeds.fold(0.0, |fastest: f64, speed| fastest.max(speed.abs()));
    let settings = SweepSettings {
        stop: StopCriterion::NaturalMap {
            velocity: RESIDUAL * fastest,
        },
        max_sweeps: UPDATES / points.len().max(1),
        ..SweepSettings::default()
    };
    let report = solver.solve(&settings, masses, &mut velocities);
    let triple = |v: &Velocity| [v.linear.x, v.linear.y, v.angular];
    let velocities_after: Vec<_> = velocities.iter().map(triple).collect();
    let rows = solver.rows().iter();
    let impulses: Vec<_> = rows.map(|row| [row.impulse().n, row.impulse().t]).collect();
    Ok(json!({
        "velocities": velocities_after,
        "impulses": impulses,
        "sweeps": report.sweeps,
        "residual": solver.residual(&velocities),
    }))
}

fn units(fields: &Fields) -> Result<Units, Fault> {
    let dofs = fields.list("dofs")?;
    let mut units = Units {
        before: Vec::with_capacity(dofs.len()),
        inverse_masses: Vec::with_capacity(dofs.len()),
        loads: Vec::with_capacity(dofs.len()),
    };
    for dof in &dofs {
        let v = dof.array::<3>("velocity")?;
        units.before.push(Velocity {
            linear: Vec2::new(v[0], v[1]),
            angular: v[2],
        });
        let f = dof.array::<3>("force")?;
        units.loads.push(Load {
            force: Vec2::new(f[0], f[1]),
            torque: f[2],
        });
        units.inverse_masses.push(inverse_mass(dof)?);
    }
    Ok(units)
}

fn inverse_mass(dof: &Fields) -> Result<InverseMass, Fault> {
    let [x, y, rotation] = dof.array::<3>("inv_mass")?;
    if [x, y, rotation].iter().any(|inverse| *inverse < 0.0) {
        return Err(dof.refuse("an object whose inv_mass is not negative"));
    }
    Ok(InverseMass { x, y, rotation })
}

fn contacts(fields: &Fields, units: usize) -> Result<Vec<ContactInput>, Fault> {
    let domain = domain(fields)?;
    let bodies = fields.list("bodies")?;
    let contacts = fields.list("contacts")?;
    let input = |point: &Fields| contact(point, &bodies, units, domain);
    contacts.iter().map(input).collect()
}

fn contact(
    point: &Fields,
    bodies: &[Fields],
    units: usize,
    domain: Domain,
) -> Result<ContactInput, Fault> {
    let place = point.vector("p")?;
    let side = |key: &str| -> Result<(u32, Vec2), Fault> {
        let body = &bodies[point.index(key, "bodies", bodies.len())?];
        let unit = body.index("dof", "dofs", units)?;
        Ok((unit as u32, domain.displacement(centre(body)?, place)))
    };
    let (first, second) = (side("a")?, side("b")?);
    if first.0 == second.0 {
        return Err(point.refuse("a contact of bodies with different dof"));
    }
    Ok(ContactInput {
        kinematics: PointKinematics::new([first.0, second.0], normal(point)?, [first.1, second.1]),
        gap: point.number("g")?,
        impulse: Components::default(),
    })
}

/// The unit normal of a contact.
pub fn normal(point: &Fields) -> Result<Vec2, Fault> {
    let normal = point.vector("n")?;
    match (normal.norm() - 1.0).abs() < 1e-9 {
        true => Ok(normal),
        false => Err(point.refuse("an object whose n is a unit vector")),
    }
}

fn law(fields: &Fields) -> Result<ContactLaw, Fault> {
    let mode = fields.word("gap_mode", &["closed", "alert"])?;
    let law = ContactLaw {
        friction: fields.not_negative("mu")?,
        restitution: Components {
            n: fields.number("e_n")?,
            t: fields.number("e_t")?,
        },
        gap: match mode {
            "closed" => GapRule::Closed,
            _ => GapRule::Predicted,
        },
    };
    law.validate()?;
    Ok(law)
}
