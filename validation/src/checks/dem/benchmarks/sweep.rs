//! Collisions of a sphere with a plane over a range of impacts: Chung and Ooi's tests 4, 5 and 6.

use super::plane::{Flight, Material, OnPlane, material};
use crate::checks::{Failure, Measurement};
use crate::oracles::impact::{Impact, Normal, Tangential, damping_ratio, dissipative_constant};
use std::f64::consts::PI;

/// The pair of laws of a collision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Laws {
    /// BSHP with friction that is viscous up to the Coulomb limit.
    HertzViscous,
    /// BSHP with a truncated tangential spring.
    HertzSpring,
    /// Truncated Kelvin-Voigt with a truncated tangential spring.
    LinearSpring,
}

impl Laws {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::HertzViscous, Self::HertzSpring, Self::LinearSpring];
    /// Name in legends.
    pub fn name(self) -> &'static str {
        match self {
            Self::HertzViscous => "BSHP and Haff-Werner",
            Self::HertzSpring => "BSHP and truncated Cundall-Strack",
            Self::LinearSpring => "Kelvin-Voigt and truncated Cundall-Strack",
        }
    }
}

/// A test: two materials, and impacts along an abscissa.
pub struct Sweep {
    /// Materials.
    pub solids: [Material; 2],
    /// Radius in m.
    pub radius: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Normal restitution.
    pub restitution: f64,
    /// Abscissas with the motion before the collision.
    pub impacts: Vec<(f64, Flight)>,
}

/// Test 4: angle of impact in degrees at constant speed.
pub fn angles() -> Sweep {
    let impact = |n: u32| {
        let degrees = 5.0 * f64::from(n);
        let (sin, cos) = degrees.to_radians().sin_cos();
        (degrees, flight(3.9 * sin, 3.9 * cos, 0.0))
    };
    Sweep {
        solids: [
            material("aluminium oxide", [3.8e11, 0.23], 4000.0),
            material("aluminium alloy", [7.0e10, 0.33], 2700.0),
        ],
        radius: 0.0025,
        friction: 0.092,
        restitution: 0.98,
        impacts: (1..=17).map(impact).collect(),
    }
}

/// Test 5: tangential speed over friction times a constant normal speed.
pub fn tangential_speeds() -> Sweep {
    let (normal, friction) = (5.0, 0.3);
    let numbers = [
        0.1, 0.3, 0.6, 0.9, 1.2, 1.6, 2.0, 2.4, 2.8, 3.3, 4.0, 4.8, 5.8, 6.5, 7.1, 8.0, 9.1, 12.4,
        20.0, 46.0,
    ];
    let impact = |&number: &f64| (number, flight(number * friction * normal, normal, 0.0));
    Sweep {
        solids: [
            material("steel", [2.08e11, 0.30], 7850.0),
            material("polyethylene", [1.0e9, 0.40], 1400.0),
        ],
        radius: 1e-5,
        friction,
        restitution: 1.0,
        impacts: numbers.iter().map(impact).collect(),
    }
}

/// Tests 6 and 8: angles of a = 5, 10, ... 85 degrees, and angular velocities V tan(a) / r.
pub fn spins(normal: f64, radius: f64) -> impl Iterator<Item = (f64, f64)> {
    (1..=17).map(move |n| {
        let degrees = 5.0 * f64::from(n);
        (degrees, normal / radius * degrees.to_radians().tan())
    })
}

/// Materials of tests 6 and 8.
pub const SPINNING_SOLIDS: [Material; 2] = [
    material("aluminium alloy", [7.0e10, 0.33], 2700.0),
    material("nylon", [2.5e9, 0.40], 1000.0),
];

/// Test 6: a spinning sphere falls; the abscissa is the angle of impact of the contact point in
/// degrees.
pub fn spinning() -> Sweep {
    let (normal, radius) = (0.2, 0.1);
    Sweep {
        solids: SPINNING_SOLIDS,
        radius,
        friction: 0.4,
        restitution: 0.5,
        impacts: spins(normal, radius)
            .map(|(degrees, spin)| (degrees, flight(0.0, normal, spin)))
            .collect(),
    }
}

fn flight(along: f64, normal: f64, spin: f64) -> Flight {
    Flight {
        along,
        normal,
        spin,
    }
}

/// Damping of the viscous law in units of mass over duration: so strong that the sliding velocity falls
/// by a factor of e within a seventieth of the collision.
const GRIP: f64 = 20.0;

/// Parameters shared by the impacts of a sweep.
pub struct Calibration {
    dissipation: f64,
    damping: f64,
}

impl Sweep {
    /// Constants of the normal laws for the restitution of the sweep.
    ///
    /// # Errors
    /// No such constants exist.
    pub fn calibrate(&self) -> Result<Calibration, Failure> {
        let dissipation = dissipative_constant(self.restitution);
        Ok(Calibration {
            dissipation: dissipation
                .ok_or_else(|| Failure::Oracle("no dissipative constant".to_owned()))?,
            damping: damping_ratio(self.restitution),
        })
    }

    /// The sphere and its contact, calibrated for a normal speed: collisions with both normal laws have
    /// the same duration, and the ratio of tangential to normal stiffness is Mindlin's, 2 (1 - nu) / (2
    /// - nu).
    pub fn contact(
        &self,
        solid: Material,
        laws: Laws,
        calibration: &Calibration,
        speed: f64,
    ) -> OnPlane {
        let mass = solid.mass(self.radius);
        let factor = solid.factor_on_plane(self.radius);
        let [duration, _] = Normal::Hertzian([factor, 0.0]).elastic(mass, speed);
        let stiffness = mass * (PI / duration).powi(2);
        let nu = solid.poissons_ratio;
        let spring = [self.friction, 2.0 * (1.0 - nu) / (2.0 - nu) * stiffness];
        let hertzian = Normal::Hertzian([factor, calibration.dissipation * duration]);
        let damping = 2.0 * calibration.damping * (stiffness * mass).sqrt();
        let (normal, tangential) = match laws {
            Laws::HertzViscous => {
                let grip = GRIP * mass / duration;
                (hertzian, Tangential::Viscous([self.friction, grip]))
            }
            Laws::HertzSpring => (hertzian, Tangential::Spring(spring)),
            Laws::LinearSpring => (
                Normal::Linear([stiffness, damping]),
                Tangential::Spring(spring),
            ),
        };
        OnPlane {
            material: solid,
            radius: self.radius,
            normal,
            tangential,
        }
    }

    /// The kernel's curve for one material with one pair of laws.
    ///
    /// # Errors
    /// Scenes that cannot be run.
    pub fn runs(&self, solid: Material, laws: Laws, steps: u64) -> Result<Vec<Run>, Failure> {
        let calibration = self.calibrate()?;
        let run = |&(abscissa, before): &(f64, Flight)| {
            let contact = self.contact(solid, laws, &calibration, before.normal);
            Ok(Run {
                abscissa,
                contact,
                before,
                measured: contact.measured(before, steps)?,
                steps,
            })
        };
        self.impacts.iter().map(run).collect()
    }

    /// The same, with the results of the oracle.
    ///
    /// # Errors
    /// Scenes that cannot be run, collisions without an end.
    pub fn curve(&self, solid: Material, laws: Laws, steps: u64) -> Result<Vec<Point>, Failure> {
        let point = |run: Run| {
            Ok(Point {
                run,
                expected: run.contact.expected(run.before)?,
            })
        };
        let runs = self.runs(solid, laws, steps)?;
        runs.into_iter().map(point).collect()
    }
}

/// One impact of a curve, from the kernel.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    /// Abscissa.
    pub abscissa: f64,
    /// The contact.
    pub contact: OnPlane,
    /// Motion before the collision.
    pub before: Flight,
    /// Motion after it.
    pub measured: Flight,
    steps: u64,
}

/// One impact of a curve, with the expected result.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// The impact, from the kernel.
    pub run: Run,
    /// Motion after the impact, from the oracle.
    pub expected: Flight,
}

impl Run {
    /// Sliding velocity of the contact point in m/s.
    pub fn slip(&self, flight: &Flight) -> f64 {
        flight.along + self.contact.radius * flight.spin
    }
}

impl Point {
    /// Kernel against oracle, in units of the normal speed of impact.
    pub fn comparisons(&self) -> [Measurement; 3] {
        let Run {
            contact,
            before,
            measured,
            steps,
            ..
        } = self.run;
        let speed = before.normal;
        let impact = contact.impact();
        let step = contact.duration(speed) / steps as f64;
        let [normal, along] = step_errors(&impact, speed, self.run.slip(&before), step);
        let (a, b) = (self.expected, measured);
        let turning = speed / contact.radius;
        [
            Measurement::scaled(a.normal, b.normal, speed, normal),
            Measurement::scaled(a.along, b.along, speed, along),
            Measurement::scaled(a.spin, b.spin, turning, 2.5 * along),
        ]
    }
}

/// Largest errors of velocity Verlet, for the given time step, in the relative velocities along normal
/// and tangent, in units of the normal speed.
///
/// At a kink of the force, the error of the trapezoidal rule is at most an eighth of the jump of its
/// rate times dt^2; where the force begins like the square root of time, it is zeta(-1/2) = -0.2079
/// times its coefficient times dt^(3/2).
pub fn step_errors(impact: &Impact, speed: f64, slip: f64, step: f64) -> [f64; 2] {
    let mass = impact.mass;
    let [duration, _] = impact.normal.elastic(mass, speed);
    let slope = (PI / duration).powi(2);
    let (friction, stretch) = match impact.tangential {
        Tangential::Viscous([friction, _]) => (friction, 0.0),
        Tangential::Spring([friction, k]) => (friction, k / mass * slip.abs() / speed),
    };
    let beginning = match impact.normal {
        Normal::Linear(_) => 0.0,
        Normal::Hertzian([p, lambda]) => {
            ROOT * p / mass * lambda * speed.sqrt() * step * step.sqrt()
        }
    };
    let kinks = 0.125 * step * step;
    [
        2.0 * kinks * slope + beginning,
        MOST_KINKS * kinks * (stretch + friction * slope) + friction * beginning,
    ]
}

/// The Riemann zeta function at -1/2, without its sign.
const ROOT: f64 = 0.207_886_224_977_354_6;
/// Number of changes between sticking and sliding in a collision, including beginning and end, plus one
/// for the slow error of the oscillation itself.
const MOST_KINKS: f64 = 6.0;
