//! The moment of inertia, measured by the spin that friction causes.

use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, thesis};
use crate::scenes::{Draft, Grain};
use gouge_common::scalar::Real;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::KelvinVoigt;
use gouge_scalars::DoubleDouble;
use std::f64::consts::PI;

pub(super) fn checks() -> Vec<Check> {
    vec![Check {
        id: "laws.inertia",
        claim: "With J = c m r^2, an impact on a plane changes c r w by as much as the velocity along the plane. If the sphere slides throughout the impact, both change by mu (1 + e) V_n. The factor c is 2/5 by default, 3/5 in the reading \"thesis\", or the value given in the scene.",
        equations: thesis("(6)-(7), (51)-(53)"),
        scene: "A sphere of 1 mm hits a plane at a normal speed of 1 m/s. Its velocity along the plane is 20 m/s, so that it slides, or 0.3 m/s, so that it sticks. Kelvin-Voigt with two friction laws, 150 steps per collision; c = 2/5, 1/2, 3/5, and c not given, in both readings",
        oracle: "Balance of momentum and of angular momentum, with the normal restitution taken from the run",
        norm: "Largest error of the change of velocity along the plane and of the change of c r w, in units of the initial normal speed",
        origin: Origin::Exact,
        reason: "All impulses are sums over the same steps, so the time step does not matter. The tolerance is a hundred units of rounding of the largest velocity, plus the tilt of the plane: it is a sphere 1e12 times as large, which tilts by 1e-12 per radius travelled",
        effort: Effort::Quick,
        measure,
    }]
}

const RADIUS: f64 = 1e-3;
const STIFFNESS: f64 = 1e7;
const FRICTION: f64 = 0.3;
/// Radius of the sphere that represents the plane, in radii of the other sphere.
const FLATNESS: f64 = 1e12;

/// An impact of a sphere on a plane.
struct Impact {
    /// Lines of the scene that set the reading and the inertia factor.
    reading: &'static str,
    given: Option<f64>,
    /// The inertia factor that these keys imply.
    factor: f64,
    /// Tangential law.
    law: &'static str,
    /// Its damping in kg/s or stiffness in kg/s^2.
    constant: f64,
    /// Initial velocity along the plane in m/s; the initial normal speed is 1 m/s.
    along: f64,
}

/// Velocities after the impact: along the plane and away from it in m/s, angular velocity in rad/s.
struct After {
    along: f64,
    away: f64,
    spin: f64,
}

/// Lines that set the reading and the inertia factor, and the factor that they imply.
const BODIES: [(&str, Option<f64>, f64); 5] = [
    ("corrected", None, 2.0 / 5.0),
    ("corrected", Some(0.4), 2.0 / 5.0),
    ("corrected", Some(0.5), 1.0 / 2.0),
    ("corrected", Some(0.6), 3.0 / 5.0),
    ("thesis", None, 3.0 / 5.0),
];

/// Tangential law and velocity along the plane: the first impact slides throughout, the second sticks.
const MOTIONS: [(&str, f64, f64); 2] = [
    ("haff-werner", 1e3, 20.0),
    ("cundall-strack-truncated", 4e6, 0.3),
];

impl Impact {
    fn duration() -> f64 {
        PI * (2700.0 * 4.0 / 3.0 * PI * RADIUS.powi(3) / STIFFNESS).sqrt()
    }

    fn scene(&self, steps: u32) -> Draft {
        let draft = Draft::open_box(
            Integrator::VelocityVerlet,
            Self::duration() / f64::from(steps),
        )
        .reading(self.reading)
        .law(KelvinVoigt {
            stiffness: STIFFNESS,
            damping: 10.0,
        })
        .friction(self.law, FRICTION, self.constant)
        .grain(Grain::at([0.0, RADIUS.next_down()], RADIUS).moving([self.along, -1.0]))
        .grain(Grain::at([0.0, -FLATNESS * RADIUS], FLATNESS * RADIUS).fixed());
        match self.given {
            Some(factor) => draft.with("material.inertia_factor", factor),
            None => draft,
        }
    }

    fn after(&self, steps: u32) -> Result<After, Failure> {
        let mut world = self.scene(steps).world_in::<DoubleDouble>()?;
        for _ in 0..4 * steps {
            world.step()?;
        }
        let p = world.particles();
        Ok(After {
            along: p.velocity[0].x.to_f64(),
            away: p.velocity[0].y.to_f64(),
            spin: p.angular_velocity[0].to_f64(),
        })
    }

    fn slides(&self) -> bool {
        self.along > 1.0
    }

    /// Compares the changes of c r w and of the velocity along the plane with each other and, for a
    /// sliding impact, with the friction impulse.
    fn errors(&self, after: &After) -> Vec<Measurement> {
        let fast = 1.0 + self.along;
        let way = self.along * Self::duration() / RADIUS;
        let tolerance = 2e-14 * fast + 2.0 * way / FLATNESS * fast;
        let gained = self.factor * RADIUS * after.spin;
        let lost = after.along - self.along;
        let mut all = vec![Measurement::absolute(lost, gained, tolerance)];
        if self.slides() {
            let impulse = FRICTION * (1.0 + after.away);
            all.push(Measurement::absolute(-impulse, gained, tolerance));
            all.push(Measurement::absolute(-impulse, lost, tolerance));
        }
        all
    }
}

fn measure() -> Outcome {
    let mut all = Vec::new();
    let mut table = Table::new(
        "Spin after a sliding impact, and the fraction of the velocity that is left once sliding has become rolling",
        &[
            "scene",
            "J in m r^2",
            "spin in rad/s: mu (1 + e) V_n / (c r)",
            "kernel",
            "fraction left when rolling, 1 / (1 + c)",
        ],
    );
    for (reading, given, factor) in BODIES {
        for (law, constant, along) in MOTIONS {
            let impact = Impact {
                reading,
                given,
                factor,
                law,
                constant,
                along,
            };
            let after = impact.after(150)?;
            all.extend(impact.errors(&after));
            if impact.slides() {
                let spin = FRICTION * (1.0 + after.away) / (factor * RADIUS);
                table.push([
                    match given {
                        Some(factor) => format!("inertia_factor = {factor}"),
                        None if reading == "thesis" => format!("reading = {reading}"),
                        None => String::new(),
                    },
                    factor.to_string(),
                    format!("{spin:.9}"),
                    format!("{:.9}", -after.spin),
                    format!("{:.4}", 1.0 / (1.0 + factor)),
                ]);
            }
        }
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}
